// For every request of the model: what the emulated board sends is what the model says, and the
// board's state has followed. A request without an entry here fails the test.

#include <array>
#include <cmath>
#include <functional>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sbgc/availability.hpp>
#include <sbgc/dispatch.hpp>
#include <sbgc/exchanges/all.hpp>
#include <sbgc/meta/all.hpp>
#include <sbgc/roles.hpp>
#include <sbgc/settings.hpp>
#include <sbgc/type_list.hpp>

#include "host.hpp"

namespace sbgc::test {
namespace {

using ::testing::Each;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::SizeIs;

/// What a board does where the model leaves it open.
enum class Comes {
  as_modelled,  ///< nothing is open
  confirmation,
  nothing,
};

/// Fails unless the packets are what exchange_of(request) announces, and nothing else.
void expect_as_modelled(const Exchange& exchange, const Packets& packets, Comes comes) {
  unsigned confirmations = 0, answers = 0;
  for (const Packet& one : packets) {
    const Frame frame{one.id, one.body};
    const AnswerForm* const answer = exchange.replies.answer(frame);
    if (answer != nullptr) {
      ++answers;
      EXPECT_FALSE(answer->is_error) << "it could have been carried out";
    } else if (roles::is_confirmation(frame)) {
      ++confirmations;
      EXPECT_TRUE(exchange.replies.is_confirmed_by(roles::confirmed_command(frame), frame));
      EXPECT_FALSE(exchange.result.is_failure(one.body));
    } else if (roles::is_reset(frame)) {
      EXPECT_TRUE(exchange.restarts_board) << "it restarts unasked";
    } else {
      ADD_FAILURE() << "command " << int{one.id} << " is no answer to it";
    }
  }
  EXPECT_EQ(answers, exchange.answer_required ? 1U : 0U);
  switch (exchange.replies.confirmed) {
    case Confirmed::never:
    case Confirmed::unlikely: EXPECT_EQ(confirmations, 0U); break;
    case Confirmed::always: EXPECT_EQ(confirmations, exchange.confirmations); break;
    case Confirmed::possible:
      ASSERT_NE(comes, Comes::as_modelled) << "say in the table what the emulated board does";
      EXPECT_EQ(confirmations, comes == Comes::confirmation ? exchange.confirmations : 0U);
      break;
  }
}

/// How long all that the model announces takes at most.
Duration patience(const Exchange& exchange) {
  return milliseconds(std::max(exchange.timeout_ms, exchange.finish_ms));
}

using Check = std::function<void()>;

/// Checks by name of the request.
class Table {
 public:
  static const std::multimap<std::string, Check>& checks() {
    static const Table table;
    return table.checks_;
  }

 private:
  Table();

  template <Message M>
  struct Entry {
    M request{};
    Comes comes = Comes::as_modelled;
    /// Brings the board into the state that the request needs.
    std::function<void(Host&)> before{};
    /// Looks at what came, and at the board.
    std::function<void(Host&, const Packets&)> after{};
    board::Options options{};
  };

  template <Message M>
  void add(Entry<M> entry) {
    checks_.emplace(Meta<M>::info.name, [entry = std::move(entry)] {
      Host host(entry.options);
      if (entry.before) entry.before(host);
      const Exchange exchange = exchange_of(entry.request);
      const std::uint64_t restarts = host.board.counters().restarts;
      const Packets packets = host.ask(entry.request, patience(exchange));
      expect_as_modelled(exchange, packets, entry.comes);
      if (exchange.restarts_board) host.listen(seconds(2));
      EXPECT_EQ(host.board.counters().restarts - restarts, exchange.restarts_board ? 1U : 0U);
      if (entry.after) entry.after(host, packets);
    });
  }

  void add_system();
  void add_settings();
  void add_live_data();
  void add_control();
  void add_calibration();
  void add_imu();
  void add_peripherals();
  void add_variables();
  void add_storage();
  void add_scripting_and_debug();

  std::multimap<std::string, Check> checks_;
};

Table::Table() {
  add_system();
  add_settings();
  add_live_data();
  add_control();
  add_calibration();
  add_imu();
  add_peripherals();
  add_variables();
  add_storage();
  add_scripting_and_debug();
}

/// The only message M of what came.
template <class M>
M only(const Packets& packets) {
  const auto found = all<M>(packets);
  EXPECT_EQ(found.size(), 1U);
  return found.empty() ? M{} : found.front();
}

void Table::add_system() {
  const auto introduces = [](Host& host, const Packets& packets) {
    const auto info = only<BoardInfo>(packets);
    EXPECT_EQ(info.board_ver, host.board.options().board);
    EXPECT_EQ(info.firmware_ver, host.board.options().firmware);
    EXPECT_EQ(info.board_features, host.board.options().features);
    EXPECT_FALSE(info.connection_flags.has(ConnectionFlag::usb));
  };
  add<BoardInfoRequest>({.after = introduces});
  add<BoardInfoRequestExt>({.request = {.cfg = Milliseconds(20)}, .after = introduces});
  add<BoardInfo3Request>({.after = [](Host& host, const Packets& packets) {
    const auto details = only<BoardInfo3>(packets);
    EXPECT_EQ(details.device_id, host.board.options().device_id);
    EXPECT_EQ(details.mcu_id, host.board.options().mcu_id);
    EXPECT_EQ(details.eeprom_size.raw(), host.board.memory().eeprom.size());
  }});
  add<ResetRequest>({});
  ResetRequestExt reset;
  reset.delay_ms = Milliseconds(300);
  add<ResetRequestExt>({.request = reset});
  reset.confirm = ResetOption::notify;
  add<ResetRequestExt>({.request = reset});
  add<BootMode3>({});
  BootMode3Ext boot;
  boot.delay_ms = Milliseconds(300);
  add<BootMode3Ext>({.request = boot});
  boot.confirm = ResetOption::notify;
  add<BootMode3Ext>({.request = boot});
  // Nothing is known of these.
  add<QueueParamsInfo3Request>({.comes = Comes::nothing});
  add<SystemStateRequest>({.comes = Comes::nothing});
  add<MavlinkInfoRequest>({.comes = Comes::nothing});
  add<MavlinkDebugRequest>({.comes = Comes::nothing});
}

void Table::add_settings() {
  // Every reader and writer of every message that holds settings, for the last copy of it: what
  // stood there is changed in every bit that is a setting, and comes back so.
  StoredMessages::for_each([this]<class M>(Type<M>) {
    using Settings = SettingsOf<M>;
    constexpr std::uint8_t copy = Settings::copies - 1;
    const auto read = [](Host& host) {
      M result{};
      Settings::Readers::for_each([&]<class Request>(Type<Request>) {
        Request request{};
        if constexpr (Settings::copies > 1) Settings::copy(request) = copy;
        result = host.get<M>(request);
      });
      return result;
    };
    Settings::Readers::for_each([&]<class Request>(Type<Request>) {
      Request request{};
      if constexpr (Settings::copies > 1) Settings::copy(request) = copy;
      add<Request>({.request = request, .after = [](Host&, const Packets& packets) {
                      const auto settings = only<M>(packets);
                      if constexpr (Settings::copies > 1) {
                        EXPECT_EQ(Settings::copy(settings), Settings::copies - 1);
                      }
                    }});
    });
    Settings::Writers::for_each([&]<class Request>(Type<Request>) {
      M wanted{};
      std::array<std::uint8_t, max_body_size> body{};
      for (std::size_t i = 0; i < M::min_size; ++i) body[i] = static_cast<std::uint8_t>(i * 37 + 5);
      ASSERT_TRUE(decode(std::span(body).first(M::min_size), wanted));
      if constexpr (Settings::copies > 1) Settings::copy(wanted) = copy;
      add<Request>({.request = Request{wanted},
                    .comes = Comes::confirmation,
                    .after = [wanted, read](Host& host, const Packets&) mutable {
                      M found = read(host);
                      Meta<M>::visit(found, [&](const FieldInfo& field, auto&& member) {
                        if (field.role != FieldRole::state) return;
                        Meta<M>::visit(wanted, [&](const FieldInfo& other, auto&& value) {
                          if constexpr (std::is_same_v<decltype(member), decltype(value)>) {
                            if (&other == &field) value = member;
                          }
                        });
                      });
                      EXPECT_EQ(found, wanted);
                    }});
    });
  });
  add<SaveParams3>({.comes = Comes::confirmation,
                    .before =
                        [](Host& host) {
                          SetAdjVarsVal change;
                          change.params.push_back({VariableId::p_roll, 77});
                          host.ask(change);
                        },
                    .after =
                        [](Host& host, const Packets&) {
                          host.board.restart(host.now);
                          host.listen(seconds(2));
                          EXPECT_EQ(host.get<ReadParams3>(ReadParams3Request{}).axes.roll.p, 77);
                        }});
  add<UseDefaults>({.comes = Comes::confirmation,
                    .before =
                        [](Host& host) {
                          auto settings = host.get<ReadParams3>(ReadParams3Request{});
                          settings.gyro_trust = static_cast<std::uint8_t>(settings.gyro_trust + 1);
                          host.ask(WriteParams3{settings});
                        },
                    .after =
                        [](Host& host, const Packets&) {
                          Host fresh;
                          EXPECT_EQ(host.get<ReadParams3>(ReadParams3Request{}),
                                    fresh.get<ReadParams3>(ReadParams3Request{}));
                        }});
}

void Table::add_live_data() {
  const auto is_alive = [](Host& host, const auto& data) {
    EXPECT_EQ(data.cur_imu, SelectedImu::main);
    EXPECT_NEAR(data.axes.yaw.acc_data.real(), 1.0, 0.05) << "gravity, level and at rest";
    EXPECT_GT(data.bat_level.raw(), 1000);
    EXPECT_EQ(data.other_flags.has(OtherFlag::motors_on), host.board.gimbal().motors_on());
    EXPECT_EQ(data.system_error.raw(), 0);
  };
  const auto of_data_3 = [is_alive](Host& host, const Packets& packets) {
    is_alive(host, only<RealtimeData3>(packets));
  };
  add<RealtimeData>({.after = of_data_3});
  add<RealtimeData3Request>({.after = of_data_3});
  add<RealtimeData4Request>({.after = [is_alive](Host& host, const Packets& packets) {
    const auto data = only<RealtimeData4>(packets);
    is_alive(host, data);
    EXPECT_GT(data.current.raw(), 0);
    EXPECT_GT(data.imu_temperature.raw(), 10);
  }});
  const RealtimeDataCustomFlags flags =
      RealtimeDataCustomFlag::imu_angles | RealtimeDataCustomFlag::z1_h1_vectors;
  const auto has_the_blocks = [flags](Host&, const Packets& packets) {
    ASSERT_THAT(packets, SizeIs(1));
    RealtimeDataCustom data;
    ASSERT_TRUE(decode(std::span(packets[0].body), data, {.flags = flags}));
    ASSERT_TRUE(data.imu_angles && data.z1_vector);
    EXPECT_NEAR(static_cast<double>(data.z1_vector->z), 1.0, 0.01);
    EXPECT_FALSE(data.acc_data);
  };
  add<RealtimeDataCustomRequest>({.request = {.flags = flags}, .after = has_the_blocks});
  DataStreamInterval stream;
  stream.cmd_id = CommandId::realtime_data_3;
  stream.interval_ms = Milliseconds(0);
  add<DataStreamInterval>(
      {.request = stream,
       .before =
           [](Host& host) {
             DataStreamInterval begin;
             begin.cmd_id = CommandId::realtime_data_3;
             begin.interval_ms = Milliseconds(10);
             EXPECT_THAT(all<RealtimeData3>(host.ask(begin, milliseconds(1005))), SizeIs(100));
           },
       .after = [](Host& host,
                   const Packets&) { EXPECT_THAT(host.listen(seconds(1)), IsEmpty()); }});
}

/// Lets the board move the camera to a pitch, and looks where it is 5 s later.
template <Message M>
M to_pitch(double degrees) {
  M request{};
  if constexpr (std::is_same_v<M, Control>) {
    request.control_mode.set_mode(ControlModeKind::angle);
  } else {
    request.control_mode.pitch.set_mode(ControlModeKind::angle);
  }
  request.axes.pitch.angle = *Angle14::from_degrees(degrees);
  return request;
}

void Table::add_control() {
  const auto has_arrived = [](Host& host, const Packets&) {
    host.listen(seconds(5));
    const auto angles = host.get<GetAngles>(GetAnglesRequest{});
    EXPECT_NEAR(angles.axes.pitch.imu_angle.degrees(), -30, 0.5);
    EXPECT_NEAR(angles.axes.pitch.rc_target_angle.degrees(), -30, 0.03);
    EXPECT_EQ(angles.axes.pitch.rc_speed.raw(), 0);
  };
  const auto tells_angles = [](Host& host, const Packets& packets, const auto& angles) {
    EXPECT_THAT(packets, SizeIs(1));
    const auto truth = host.board.gimbal().sample(host.now);
    EXPECT_NEAR(angles.axes.pitch.imu_angle.degrees(), truth.angles.pitch, 0.5);
  };
  const auto moved = [](Host& host) {
    host.send(to_pitch<Control>(20));
    host.listen(seconds(5));
  };
  add<Control>(
      {.request = to_pitch<Control>(-30), .comes = Comes::confirmation, .after = has_arrived});
  add<ControlExt>(
      {.request = to_pitch<ControlExt>(-30), .comes = Comes::confirmation, .after = has_arrived});
  add<GetAnglesRequest>({.before = moved, .after = [=](Host& host, const Packets& packets) {
                           tells_angles(host, packets, only<GetAngles>(packets));
                         }});
  add<GetAnglesExtRequest>({.before = moved, .after = [=](Host& host, const Packets& packets) {
                              tells_angles(host, packets, only<GetAnglesExt>(packets));
                            }});
  const auto on = [](Host& host) { host.ask(MotorsOn{}); };
  const auto off = [](Host& host) { host.ask(MotorsOff{}); };
  const auto is_on = [](Host& host, const Packets&) {
    EXPECT_TRUE(host.board.gimbal().motors_on());
  };
  const auto is_off = [](Host& host, const Packets&) {
    EXPECT_FALSE(host.board.gimbal().motors_on());
  };
  add<MotorsOn>({.before = off, .after = is_on});
  add<MotorsOff>({.before = on, .after = is_off});
  add<MotorsOffExt>({.before = on, .after = is_off});
  add<ExecuteMenu>({.request = {.cmd_id = MenuCommand::motor_toggle},
                    .comes = Comes::confirmation,
                    .before = on,
                    .after = is_off});
  add<ExecuteMenuExt>({.request = {.cmd_id = MenuCommand::profile3},
                       .comes = Comes::confirmation,
                       .after = [](Host& host, const Packets&) {
                         EXPECT_EQ(host.get<RealtimeData3>(RealtimeData3Request{}).cur_profile, 2);
                       }});
  add<HelperData>({});
  add<HelperDataExt>({.request = {.coord_sys = CoordinateSystem::ground_yaw_rotated}});
}

void Table::add_calibration() {
  add<CalibAcc>({});
  add<CalibGyro>({});
  for (const CalibAction action :
       {CalibAction::regular, CalibAction::reset, CalibAction::temperature,
        CalibAction::enable_temperature, CalibAction::disable_temperature,
        CalibAction::restore_factory, CalibAction::store_in_sensor}) {
    add<CalibAccExt>({.request = {.imu_idx = CalibImu::main, .action = action}});
    add<CalibGyroExt>({.request = {.imu_idx = CalibImu::frame, .action = action}});
  }
  add<CalibMag>({.comes = Comes::confirmation});
  add<CalibExtGain>({});
  add<CalibPoles>({});
  add<CalibOffset>({.comes = Comes::confirmation});
  add<CalibBat>({.request = {.actual_voltage = Voltage(1500)},
                 .comes = Comes::confirmation,
                 .after = [](Host& host, const Packets&) {
                   const auto data = host.get<RealtimeData3>(RealtimeData3Request{});
                   EXPECT_NEAR(data.bat_level.real(), 15.0, 0.1);
                 }});
  add<CalibInfoRequest>({.request = {.imu_type = SelectedImu::main},
                         .before = [](Host& host) { host.ask(CalibGyro{}, milliseconds(500)); },
                         .after =
                             [](Host&, const Packets& packets) {
                               const auto info = all<CalibInfo>(packets);
                               ASSERT_THAT(info, SizeIs(1));
                               EXPECT_GT(info[0].progress.raw(), 0);
                               EXPECT_LT(info[0].progress.raw(), 100);
                             }});
  add<CalibMotorMagLinkRequest>({.comes = Comes::nothing});
  add<EncodersCalibOffset4>({.comes = Comes::confirmation});
  add<EncodersCalibFldOffset4>({.comes = Comes::confirmation});
  add<AutoPidRequest>({.request = {.profile_id = 1, .cfg_flags = AutoPidFlag::roll},
                       .comes = Comes::confirmation,
                       .after = [](Host& host, const Packets&) {
                         EXPECT_EQ(host.get<RealtimeData3>(RealtimeData3Request{}).cur_profile, 1);
                       }});
}

void Table::add_imu() {
  const auto is_selected = [](Host& host, const Packets&) {
    EXPECT_EQ(host.get<RealtimeData3>(RealtimeData3Request{}).cur_imu, SelectedImu::frame);
  };
  add<SelectImu3>({.request = {.imu_type = SelectedImu::frame},
                   .comes = Comes::confirmation,
                   .after = is_selected});
  add<SelectImu3Ext>({.request = {.imu_type = SelectedImu::frame},
                      .comes = Comes::confirmation,
                      .after = is_selected});
  const auto points_up = [](Host&, const Packets& packets) {
    const auto attitude = only<AhrsHelper>(packets);
    EXPECT_NEAR(static_cast<double>(attitude.z1_vector.z), 1, 0.01);
    EXPECT_NEAR(std::hypot(static_cast<double>(attitude.h1_vector.x),
                           static_cast<double>(attitude.h1_vector.y),
                           static_cast<double>(attitude.h1_vector.z)),
                1, 1e-5);
  };
  add<AhrsHelperRequest>({.after = points_up});
  add<AhrsHelperRequestExt>({.after = points_up});
  AhrsHelperRequestExt set;
  set.mode = AhrsHelperModeBit::set;
  set.z1_vector = {0, 0, 1};
  set.h1_vector = {0, 1, 0};
  add<AhrsHelperRequestExt>({.request = set});
  add<GyroCorrection>({.comes = Comes::confirmation});
}

void Table::add_peripherals() {
  BeepSound beep;
  beep.mode = BeepMode::custom_melody;
  beep.note_length = NoteLength(5);
  beep.note_freq_hz.push_back(NoteFrequency(1000));
  add<BeepSound>({.request = beep, .comes = Comes::confirmation});
  add<TriggerPin>({.request = {.pin_id = OutputPin::pin_aux1, .state = PinState::high},
                   .comes = Comes::confirmation});
  ServoOut servos;
  servos.servo_time.fill(ServoPulse(-1));
  servos.servo_time[3] = ServoPulse(1500);
  add<ServoOut>({.request = servos, .comes = Comes::confirmation});
  // The first register that can be written and read back.
  I2cDevice imu;
  imu.set_port(I2cPort::main);
  imu.set_address(0x68);
  I2cWriteRegBuf write;
  write.device_addr = imu;
  write.reg_addr = 0x1B;
  write.data.push_back(0x18);
  const auto is_written = [](Host&, const Packets& packets) {
    const auto data = all<I2cReadRegBuf>(packets);
    ASSERT_THAT(data, SizeIs(1));
    EXPECT_THAT(data[0].data, ElementsAre(0x18));
  };
  const I2cReadRegBufRequest read{
      .device_addr = imu, .reg_addr = 0x1B, .data_len = SmallByteCount(1)};
  add<I2cWriteRegBuf>({.request = write, .after = [=](Host& host, const Packets&) {
                         is_written(host, host.ask(read));
                       }});
  add<I2cReadRegBufRequest>(
      {.request = read, .before = [=](Host& host) { host.ask(write); }, .after = is_written});
  add<ApiVirtChControl>({});
}

void Table::add_variables() {
  SetAdjVarsVal set;
  set.params.push_back({VariableId::p_roll, 42});
  set.params.push_back({VariableId::rc_trim_yaw, -5});
  GetAdjVarsVal get;
  get.param_id.push_back(VariableId::rc_trim_yaw);
  get.param_id.push_back(VariableId::p_roll);
  const auto are_set = [](Host&, const Packets& packets) {
    const auto values = all<SetAdjVarsVal>(packets);
    ASSERT_THAT(values, SizeIs(1));
    EXPECT_THAT(values[0].params, ElementsAre(AdjVarValue{VariableId::rc_trim_yaw, -5},
                                              AdjVarValue{VariableId::p_roll, 42}));
  };
  add<SetAdjVarsVal>({.request = set, .after = [=](Host& host, const Packets&) {
                        are_set(host, host.ask(get));
                        EXPECT_EQ(host.get<ReadParams3>(ReadParams3Request{}).axes.roll.p, 42);
                      }});
  add<GetAdjVarsVal>(
      {.request = get, .before = [=](Host& host) { host.ask(set); }, .after = are_set});
  add<AdjVarsStateRequest>({.request = {.trigger_slot = 9, .analog_slot = 14}});
  board::Options later;
  later.firmware = FirmwareVersion(AdjVarsStateRequestExt::since.firmware);
  add<AdjVarsStateRequestExt>({.options = later});
}

void Table::add_storage() {
  EepromWrite write;
  write.addr = 64 * 40;
  ASSERT_TRUE(write.data.resize(64));
  std::fill(write.data.begin(), write.data.end(), std::uint8_t{0xA5});
  const EepromReadRequest read{.addr = write.addr, .size = ByteCount(64)};
  const auto is_written = [=](Host&, const Packets& packets) {
    const auto data = all<EepromRead>(packets);
    ASSERT_THAT(data, SizeIs(1));
    EXPECT_EQ(data[0].addr, write.addr);
    EXPECT_THAT(data[0].data, SizeIs(64));
    EXPECT_THAT(data[0].data, Each(0xA5));
  };
  add<EepromWrite>({.request = write, .after = [=](Host& host, const Packets&) {
                      is_written(host, host.ask(read));
                    }});
  add<EepromReadRequest>(
      {.request = read, .before = [=](Host& host) { host.ask(write); }, .after = is_written});

  WriteFile file;
  file.file_id = 300;
  file.file_size = ByteCount(3);
  for (const std::uint8_t byte : std::array<std::uint8_t, 3>{1, 2, 3}) file.data.push_back(byte);
  const ReadFileRequest look{.file_id = 300, .max_data_size = ByteCount(100)};
  const auto is_there = [](Host&, const Packets& packets) {
    const auto part = all<ReadFile>(packets);
    ASSERT_THAT(part, SizeIs(1));
    EXPECT_EQ(part[0].file_size.raw(), 3);
    EXPECT_THAT(part[0].data, ElementsAre(1, 2, 3));
  };
  add<WriteFile>({.request = file,
                  .after = [=](Host& host, const Packets&) { is_there(host, host.ask(look)); }});
  add<ReadFileRequest>(
      {.request = look, .before = [=](Host& host) { host.ask(file); }, .after = is_there});
  add<FsClearAll>({.before = [=](Host& host) { host.ask(file); },
                   .after =
                       [=](Host& host, const Packets&) {
                         EXPECT_EQ(host.get<ReadFileError>(look).err_code,
                                   FileError::file_not_found);
                       }});
}

void Table::add_scripting_and_debug() {
  add<RunScript>({.request = {.mode = ScriptMode::start, .slot = 0},
                  .comes = Comes::confirmation,
                  .before = [](Host& host) {
                    WriteFile script;
                    const std::string_view text = "one\ntwo\n";
                    script.file_size = ByteCount(static_cast<std::uint16_t>(text.size()));
                    for (const char c : text) script.data.push_back(static_cast<std::uint8_t>(c));
                    host.ask(script);
                  }});
  add<DebugVarsInfo3Request>({.after = [](Host&, const Packets& packets) {
    EXPECT_GT(only<DebugVarsInfo3>(packets).vars.size(), 5U);
  }});
  add<DebugVars3Request>(
      {.after = [](Host&, const Packets& packets) { EXPECT_THAT(packets, SizeIs(1)); }});
}

std::vector<std::string> requests() {
  std::vector<std::string> names;
  AllMessages::for_each([&]<class M>(Type<M>) {
    if constexpr (M::direction != Direction::from_board) names.emplace_back(Meta<M>::info.name);
  });
  return names;
}

class Answers : public ::testing::TestWithParam<std::string> {};

TEST_P(Answers, AreWhatTheModelSays) {
  const auto [begin, end] = Table::checks().equal_range(GetParam());
  ASSERT_NE(begin, end) << "a request without a check: add it to the table";
  for (auto check = begin; check != end; ++check) {
    SCOPED_TRACE("check " + std::to_string(std::distance(begin, check) + 1));
    check->second();
  }
}

INSTANTIATE_TEST_SUITE_P(Requests, Answers, ::testing::ValuesIn(requests()),
                         [](const auto& one) { return one.param; });

TEST(Answers, EveryCheckIsOfARequest) {
  const auto names = requests();
  const std::set<std::string> known(names.begin(), names.end());
  for (const auto& [name, check] : Table::checks()) EXPECT_TRUE(known.contains(name)) << name;
}

TEST(Answers, AnOldBoardIgnoresWhatItDoesNotKnow) {
  board::Options old;
  old.board = BoardVersion(30);
  old.firmware = FirmwareVersion(2439);
  const Availability versions{2439, 30};
  AllMessages::for_each([&]<class M>(Type<M>) {
    if constexpr (M::direction != Direction::from_board) {
      if (is_supported<M>(versions)) return;
      SCOPED_TRACE(Meta<M>::info.name);
      Host host(old);
      EXPECT_THAT(host.ask(M{}, seconds(1)), IsEmpty());
    }
  });
}

}  // namespace
}  // namespace sbgc::test
