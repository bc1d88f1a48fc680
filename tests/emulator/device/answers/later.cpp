// Checks of the commands of later firmware. They run on the newest board.

#include <cstdint>

#include <gmock/gmock.h>

#include <sbgc/dispatch.hpp>

#include "table.hpp"

namespace sbgc::test {
namespace {

using ::testing::SizeIs;

msg::ExtMotorTargets all_motors() { return msg::ExtMotorTargets(0xFF); }

}  // namespace

/// Requests whose effect no source describes have no response.
void Table::add_undocumented() {
  AllMessages::for_each([this]<class M>(Type<M>) {
    if constexpr (M::direction != Direction::from_board) {
      if (Meta<M>::info.effects.has(Effect::unknown)) add<M>({.comes = Comes::nothing});
    }
  });
}

void Table::add_later_control() {
  msg::ControlExtCommand move;
  move.data_set = msg::ControlExtField::pitch_angle;
  move.axes.pitch.mode = msg::ControlMode(msg::ControlModeKind::angle);
  move.axes.pitch.flags = msg::ControlExtFlags{};
  move.axes.pitch.angle = -30_deg;
  add<msg::ControlExtCommand>(
      {.request = move, .comes = Comes::confirmation, .after = [](Host& host, const Packets&) {
         host.listen(seconds(5));
         EXPECT_NEAR(host.board.gimbal().sample(host.now).targets.pitch, -30, 0.1);
       }});
  msg::BodeTestStartStopRequest recording;
  recording.stimulus_type = msg::BodeStimulus::white_noise;
  recording.stimulus_gain = 1;
  recording.system = msg::BodeSystem::overall;
  recording.samples_num = 5000;
  add<msg::BodeTestStartStopRequest>({.request = recording, .comes = Comes::confirmation});
  add<msg::ControlConfig>({.request = {.timeout_ms = msg::Milliseconds(500)}});
  const auto is_in = [](msg::ControlQuatMode mode) {
    return [mode](Host& host, const Packets&) {
      const auto status = host.get<msg::ControlQuatStatus>(
          msg::ControlQuatStatusRequest{.data_set = msg::ControlQuatStatusField::mode});
      EXPECT_EQ(status.mode, mode);
    };
  };
  using Mode = msg::ControlQuatMode;
  const msg::ControlQuatFlags confirm = msg::ControlQuatFlag::confirm;
  const std::array<float, 4> level{1, 0, 0, 0};
  const msg::PackedQuaternion packed_level;
  add<msg::ControlQuatDisabled>({.request = {.flags = confirm}, .after = is_in(Mode::disabled)});
  add<msg::ControlQuatSpeed>({.request = {.flags = confirm}, .after = is_in(Mode::speed)});
  add<msg::ControlQuatAttitude>(
      {.request = {.flags = confirm, .target_attitude = level}, .after = is_in(Mode::attitude)});
  // Without options there is no confirmation, with AUTO_TASK one at the end.
  add<msg::ControlQuatAttitude>({.request = {.target_attitude = level}});
  add<msg::ControlQuatAttitude>(
      {.request = {.flags = msg::ControlQuatFlag::auto_task, .target_attitude = level}});
  add<msg::ControlQuatAttitude>(
      {.request = {.flags = confirm | msg::ControlQuatFlag::auto_task, .target_attitude = level}});
  add<msg::ControlQuatAttitudePacked>(
      {.request = {.flags = confirm, .target_attitude = packed_level},
       .after = is_in(Mode::attitude)});
  add<msg::ControlQuatSpeedAttitude>({.request = {.flags = confirm, .target_attitude = level},
                                      .after = is_in(Mode::speed_attitude)});
  add<msg::ControlQuatSpeedAttitudePacked>(
      {.request = {.flags = confirm, .target_attitude = packed_level},
       .after = is_in(Mode::speed_attitude)});
  add<msg::ControlQuatStatusRequest>(
      {.request = {.data_set = msg::ControlQuatStatusFields(0x3FF)},
       .after = [](Host&, const Packets& packets) {
         EXPECT_EQ(only<msg::ControlQuatStatus>(packets).actual_attitude.has_value(), true);
       }});
  add<msg::SyncMotors>({.request = {.axis = msg::SyncMotorAxis::pitch,
                                    .power = 100,
                                    .time_ms = msg::Milliseconds(200)},
                        .after = [](Host& host, const Packets&) {
                          EXPECT_FALSE(host.board.gimbal().motors_on()) << "the time is over";
                        }});
  using Flag = msg::ExecuteMenuFlag;
  for (const msg::ExecuteMenuFlags flags :
       {msg::ExecuteMenuFlags(Flag::confirm), msg::ExecuteMenuFlags(Flag::confirm_on_finish),
        Flag::confirm | Flag::confirm_on_finish}) {
    add<msg::ExecuteMenuExt>({.request = {.cmd_id = msg::MenuCommand::calib_gyro, .param = flags}});
  }
}

void Table::add_external_motors() {
  msg::ExtMotorTargets quiet(0x7F);
  add<msg::ExtMotorsAction>(
      {.request = {.for_motors = all_motors(), .action = msg::ExtMotorActionKind::on}});
  add<msg::ExtMotorsAction>(
      {.request = {.for_motors = quiet, .action = msg::ExtMotorActionKind::on}});
  add<msg::ExtMotorsControl>({.request = any_request<msg::ExtMotorsControl>()});
  add<msg::ExtMotorsControlConfig>({.request = {.for_motors = all_motors()}});
  add<msg::ExtMotorsControlConfig>({.request = {.for_motors = quiet}});
  add<msg::ExtMotorsStateRequest>({.request = {.for_motors = msg::ExtMotor::motor3,
                                               .data_set = msg::ExtMotorsStateFields(0xFFFFF)},
                                   .after = [](Host&, const Packets& packets) {
                                     EXPECT_EQ(only<msg::ExtMotorsState>(packets).motor_id, 2);
                                   }});
}

void Table::add_later_parameters() {
  add<msg::WriteParamsSet>({.request = {.action = msg::WriteParamsAction::start}});
  add<msg::ProfileSet>({.request = {.slot = 5, .action = msg::ProfileSetAction::save},
                        .after = [](Host& host, const Packets&) {
                          const auto info = host.get<msg::BoardInfo3>(msg::BoardInfo3Request{});
                          EXPECT_EQ(info.profile_set_slots, msg::StoredProfileSet::set5);
                        }});
  msg::SetAdjVarsValF set;
  set.params.push_back({msg::VariableId::p_roll, 42});
  msg::GetAdjVarsValF get;
  get.id.push_back(msg::VariableId::p_roll);
  const auto is_set = [](Host&, const Packets& packets) {
    const auto values = only<msg::SetAdjVarsValF>(packets);
    ASSERT_THAT(values.params, SizeIs(1));
    EXPECT_EQ(values.params[0].value, 42);
  };
  add<msg::SetAdjVarsValF>(
      {.request = set, .after = [=](Host& host, const Packets&) { is_set(host, host.ask(get)); }});
  add<msg::GetAdjVarsValF>(
      {.request = get, .before = [=](Host& host) { host.ask(set); }, .after = is_set});
  const auto begins_with = [](msg::VariableId first) {
    return [first](Host&, const Packets& packets) {
      const auto info = only<msg::AdjVarsInfo>(packets);
      ASSERT_FALSE(info.vars.empty());
      EXPECT_EQ(info.vars[0].var_id, first);
    };
  };
  add<msg::AdjVarsInfoRequest>({.request = {.start_id = msg::VariableId::p_yaw},
                                .after = begins_with(msg::VariableId::p_yaw)});
  add<msg::AdjVarsInfoRequestAll>({.after = begins_with(msg::VariableId::p_roll)});
}

void Table::add_later_devices() {
  add<msg::ReadStateVarsRequest>({.after = [](Host&, const Packets& packets) {
    EXPECT_EQ(only<msg::ReadStateVars>(packets).startup_cnt, 1);
  }});
  add<msg::WriteStateVars>({.options = newest_board()});
  for (const auto action : {msg::CalibAction::regular, msg::CalibAction::reset}) {
    add<msg::CalibMagExt>({.request = {.imu_idx = msg::CalibImu::main, .action = action},
                           .comes = Comes::confirmation});
  }
  add<msg::AutoPid2>({.request = {.action = msg::AutoPid2Action::read}});
  msg::CalibCogging cogging;
  cogging.action = msg::CoggingAction::calibrate;
  cogging.iterations_num = 2;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    cogging.motors[axis].angle = msg::WideDegrees(90);
  }
  add<msg::CalibCogging>({.request = cogging});
  for (const auto action : {msg::CalibAction::regular, msg::CalibAction::reset}) {
    add<msg::SelectImu3Calibrate>({.request = {.imu_type = msg::CalibImu::main, .action = action},
                                   .comes = Comes::confirmation});
    add<msg::SelectImu3CalibrateShort>(
        {.request = {.imu_type = msg::CalibImu::main, .action = action},
         .comes = Comes::confirmation});
  }
  msg::ExtImuCmd command;
  command.cmd_id = 7;
  add<msg::ExtImuCmd>(
      {.request = command,
       .comes = Comes::confirmation,
       .after = [](Host&,
                   const Packets& packets) { EXPECT_EQ(only<msg::ExtImuCmd>(packets).cmd_id, 7); },
       .options = newest_board()});
  add<msg::ExtSensCmdRequest>({.request = {.cmd_id = msg::ExtSensCommand::get_device_info},
                               .comes = Comes::confirmation,
                               .after = [](Host&, const Packets& packets) {
                                 EXPECT_EQ(only<msg::ExtSensCmd>(packets).cmd_id,
                                           msg::ExtSensCommand::device_info);
                               }});
  msg::DebugVars3RequestSelected selected;
  selected.selected_mask.push_back(3);
  add<msg::DebugVars3RequestSelected>(
      {.request = selected,
       .after = [](Host&, const Packets& packets) { EXPECT_THAT(packets, SizeIs(1)); }});
  add<msg::ServoOutExt>({.request = any_request<msg::ServoOutExt>()});
  msg::I2cDevice imu;
  imu.set_port(msg::I2cPort::main);
  imu.set_address(0x68);
  add<msg::I2cReadRegBufRequestNoRegister>(
      {.request = {.device_addr = imu, .data_len = msg::SmallByteCount(1)}});
  add<msg::I2cReadRegBufRequestWideRegister>(
      {.request = {.device_addr = imu, .data_len = msg::SmallByteCount(1)}});
  msg::ApiVirtChHighRes channels;
  channels.val_ch.push_back(msg::FineRcSignal(100));
  add<msg::ApiVirtChHighRes>({.request = channels});
  // Two IMUs and seven drivers.
  add<msg::ModuleListRequest>({.after =
                                   [](Host&, const Packets& packets) {
                                     EXPECT_THAT(only<msg::ModuleList>(packets).modules, SizeIs(9));
                                   },
                               .options = newest_board()});
  add<msg::CanDeviceScanRequest>({.after =
                                      [](Host&, const Packets& packets) {
                                        EXPECT_THAT(only<msg::CanDeviceScan>(packets).devices,
                                                    SizeIs(9));
                                      },
                                  .options = newest_board()});
  const auto driver = msg::ModuleId::can_drv1;
  msg::ModuleFlashStart begin{.device_id = driver};
  begin.firmware_size = msg::WordCount(2);
  const auto started = [begin](Host& host) { host.ask(begin); };
  add<msg::ModuleFlashStart>({.request = begin, .options = newest_board()});
  msg::ModuleFlashWrite part{.device_id = driver, .data_crc32 = 0x3FCA88C5};
  for (std::uint8_t byte = 1; byte <= 8; ++byte) part.data.push_back(byte);
  add<msg::ModuleFlashWrite>({.request = part, .before = started, .options = newest_board()});
  add<msg::ModuleFlashFinish>({.request = {.device_id = driver, .file_crc32 = 0x3FCA88C5},
                               .before =
                                   [started, part](Host& host) {
                                     started(host);
                                     host.ask(part);
                                   },
                               .after =
                                   [driver](Host& host, const Packets&) {
                                     EXPECT_THAT(host.board.module_firmware().at(driver),
                                                 SizeIs(8));
                                   },
                               .options = newest_board()});
  // There are no uDrv modules.
  add<msg::UdrvDeviceScan>({.after = [](Host&, const Packets& packets) {
    EXPECT_THAT(only<msg::CanDeviceScan>(packets).devices, SizeIs(0));
  }});
  add<msg::SetTranspProxy>({.request = {.port2 = 2}});
  const msg::PassProtectFlags port = msg::PassProtectFlag::channel_2_enabled;
  add<msg::PassProtectWrite>({.request = {.flags = port}});
  add<msg::PassProtectReadRequest>(
      {.before = [=](Host& host) { host.ask(msg::PassProtectWrite{.flags = port}); },
       .after =
           [=](Host&, const Packets& packets) {
             EXPECT_EQ(only<msg::PassProtectRead>(packets).flags, port);
           }});
  add<msg::RealtimeDataCustom2Request>(
      {.request = {.flags = msg::RealtimeDataCustom2Flag::pin_state}});
  add<msg::TriggerPin>(
      {.request = {.pin_id = msg::OutputPin::pin_aux1, .state = msg::PinState::input_pull_up},
       .comes = Comes::confirmation,
       .after =
           [](Host&, const Packets& packets) {
             const auto confirmation = only<msg::Confirm>(packets);
             EXPECT_EQ(confirmation.pin_id, msg::OutputPin::pin_aux1);
             EXPECT_EQ(confirmation.pin_state, 1);
           },
       .options = newest_board()});
  add<msg::SetDebugPortRequest>({.request = {.action = msg::DebugPortAction::start}});
}

}  // namespace sbgc::test
