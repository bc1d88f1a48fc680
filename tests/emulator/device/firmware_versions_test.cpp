// Tests of the board with each of several firmware versions: it answers the requests that the
// firmware has, treats all others as unknown, and sends nothing that the firmware does not have.
// Outputs and variables of later firmware.

#include <sbgc/availability.hpp>
#include <sbgc/client/request.hpp>
#include <sbgc/message_infos.hpp>
#include <sbgc/meta/all.hpp>
#include <sbgc/meta/variables.hpp>
#include <sbgc/parameters.hpp>
#include <sbgc/roles.hpp>
#include <sbgc/text.hpp>
#include <sbgc/validate.hpp>

#include "device/device.hpp"
#include "host.hpp"

namespace sbgc::test {
namespace {

emulator::BoardOptions board_with(std::uint16_t firmware) {
  emulator::BoardOptions options;
  // Boards of version 3.6 came with later firmware.
  options.board = msg::BoardVersion(firmware < 2687 ? 30 : 36);
  options.firmware = msg::FirmwareVersion(firmware);
  return options;
}

/// Fails the test unless a board with these versions may send the packet.
void expect_sendable(const Packet& packet, const Availability& versions) {
  const MessageType* const type =
      find_message(Direction::from_board, packet.id, packet.body.size());
  ASSERT_NE(type, nullptr) << int{packet.id};
  SCOPED_TRACE(type->info->name);
  // Old requests have the responses of newer ones (E020, E120).
  EXPECT_TRUE(is_supported(*type->info, versions));
  AnyMessage message = type->make();
  ASSERT_TRUE(message.decode(packet.body));
  message.validate(versions,
                   [](const Violation& violation) { ADD_FAILURE() << to_string(violation); });
}

bool is_refusal(const Packets& packets, msg::BoardErrorCode reason) {
  const auto errors = all<msg::ErrorExt>(packets);
  return packets.size() == 1 && errors.size() == 1 && errors[0].error_code == reason;
}

class EachFirmware : public ::testing::TestWithParam<std::uint16_t> {
 protected:
  const emulator::BoardOptions options = board_with(GetParam());
  const Availability versions{options.firmware.raw(), options.board.raw()};
};

TEST_P(EachFirmware, AnswersWhatItKnowsAndNothingElse) {
  // A form of later firmware may also be an earlier one with surplus.
  emulator::BoardOptions strict = options;
  strict.is_strict = true;
  for (const MessageType* const type : message_types()) {
    if (!type->is_sent_to_board()) continue;
    SCOPED_TRACE(type->info->name);
    Host host(strict);
    const AnyMessage request = any_request(*type);
    const ResponsePolicy policy = detail::policy_of(request);
    const Packets packets = host.ask(request, milliseconds(60));
    const auto& counters = host.board.counters();
    if (!is_supported(*type->info, versions)) {
      EXPECT_EQ(counters.unknown, 1U);
      EXPECT_TRUE(is_refusal(packets, msg::BoardErrorCode::unknown_command) ||
                  is_refusal(packets, msg::BoardErrorCode::cmd_size));
      continue;
    }
    EXPECT_EQ(counters.unknown, 0U);
    for (const Packet& one : packets) expect_sendable(one, versions);
    // An answer that is certain comes, or the board says why not. There are no external motors in
    // the request.
    if (request.get_if<msg::ExtMotorsStateRequest>() != nullptr) continue;
    const bool is_refused = counters.refused != 0;
    bool is_answered = false;
    for (const Packet& one : packets) {
      is_answered = is_answered || policy.responses.form_of({one.id, one.body}) != nullptr;
    }
    if (policy.response_required && !is_refused) {
      EXPECT_TRUE(is_answered);
    }
  }
}

TEST_P(EachFirmware, SendsSamplesThatItHas) {
  Host host(options);
  for (const auto command :
       {msg::CommandFromBoard::realtime_data_3, msg::CommandFromBoard::realtime_data_4,
        msg::CommandFromBoard::realtime_data_custom, msg::CommandFromBoard::ext_motors_state,
        msg::CommandFromBoard::can_drv_telemetry, msg::CommandFromBoard::event}) {
    msg::DataStreamInterval request;
    request.cmd_id = command;
    request.interval_ms = msg::Milliseconds(10);
    // Every option has a value: the encoder takes those of the command.
    std::array<std::uint8_t, msg::DataStreamInterval::min_size> body{
        static_cast<std::uint8_t>(command), 10};
    ASSERT_TRUE(decode(std::span<const std::uint8_t>(body), request));
    host.ask(request);
  }
  host.ask(msg::ExecuteMenu{msg::MenuCommand::motor_off});
  const Packets packets = host.listen(milliseconds(200));
  for (const Packet& one : packets) expect_sendable(one, versions);
  const bool has_streams = is_supported<msg::DataStreamInterval>(versions);
  EXPECT_EQ(packets.empty(), !has_streams);
}

TEST_P(EachFirmware, HasFactoryParametersThatItKnows) {
  Host host(options);
  ParameterMessages::for_each([&]<class M>(Type<M>) {
    if (!is_supported<M>(versions)) return;
    M parameters{};
    ParametersOf<M>::Readers::for_each([&]<class Request>(Type<Request>) {
      if (is_supported<Request>(versions)) {
        parameters = host.get<typename Request::Response>(Request{});
      }
    });
    validate(parameters, versions, [](const Violation& violation) {
      ADD_FAILURE() << Meta<M>::info.name << ": " << to_string(violation);
    });
  });
}

TEST_P(EachFirmware, IsAsItIntroducesItself) {
  Host host(options);
  const auto info = host.get<msg::BoardInfo>(msg::BoardInfoRequest{});
  EXPECT_EQ(info.firmware_ver, options.firmware);
  const auto details = host.get<msg::BoardInfo3>(msg::BoardInfo3Request{});
  const auto has = [&](bool flag, auto request) {
    EXPECT_EQ(flag, is_supported<decltype(request)>(versions));
    if (!flag) return;
    EXPECT_TRUE(all<msg::ErrorExt>(host.ask(request)).empty());
  };
  has(info.board_features_ext.has(msg::BoardFeaturesExtBit::state_vars),
      msg::ReadStateVarsRequest{});
  has(info.board_features_ext.has(msg::BoardFeaturesExtBit::ext_imu),
      msg::ExtImuDebugInfoRequest{});
  has(details.board_features_ext2.has(msg::BoardFeaturesExt2Bit::ext_motors),
      msg::ExtMotorsStateRequest{.for_motors = msg::ExtMotor::motor1});
  has(details.board_features_ext2.has(msg::BoardFeaturesExt2Bit::quat_control),
      msg::ControlQuatStatusRequest{});
}

INSTANTIATE_TEST_SUITE_P(Firmware, EachFirmware,
                         ::testing::Values(2430, 2439, 2550, 2605, 2660, 2687, 2709, 2730, 2740),
                         [](const auto& one) { return std::to_string(one.param); });

TEST(FirmwareLimits, LaterBlocksAreLeftOut) {
  const msg::RealtimeDataCustomRequest request{.flags = msg::RealtimeDataCustomFlag::imu_angles |
                                                        msg::RealtimeDataCustomFlag::imu_quat};
  Host old(board_with(2729));
  EXPECT_EQ(old.ask(request).at(0).body.size(), 2U + 6);
  Host later(board_with(2730));
  EXPECT_EQ(later.ask(request).at(0).body.size(), 2U + 6 + 8);
}

TEST(Servos, OnlyTheSelectedOnesChange) {
  emulator::Device device(newest_board(), {}, {});
  msg::ServoOut first;
  first.servo_time = {msg::ServoPulse(1000), msg::ServoPulse(1100), msg::ServoPulse(-1),
                      msg::ServoPulse(-1),   msg::ServoPulse(-1),   msg::ServoPulse(-1),
                      msg::ServoPulse(-1),   msg::ServoPulse(-1)};
  ASSERT_TRUE(device.outputs.set_servos(device.parameters, first));
  msg::ServoOutExt request;
  request.servo_bits = msg::ServoOutput::servo2 | msg::ServoOutput::can_drv7_servo2;
  request.servo_time.push_back(msg::ServoPulse(1500));
  request.servo_time.push_back(msg::ServoPulse(1600));
  EXPECT_TRUE(device.outputs.set_servos(device.parameters, request));
  EXPECT_EQ(device.outputs.servo(0), msg::ServoPulse(1000));
  EXPECT_EQ(device.outputs.servo(1), msg::ServoPulse(1500));
  EXPECT_EQ(device.outputs.driver_servo(13), msg::ServoPulse(1600));
  request.servo_time[0] = msg::ServoPulse(20'000);
  EXPECT_FALSE(device.outputs.set_servos(device.parameters, request)) << "longer than the period";
  EXPECT_EQ(device.outputs.servo(1), msg::ServoPulse(1500));
}

TEST(VariablePages, ListEveryVariableOnce) {
  Host host(newest_board());
  const auto total = host.get<msg::BoardInfo3>(msg::BoardInfo3Request{}).adj_vars_total_num;
  EXPECT_EQ(total, std::size(variables));
  std::set<msg::VariableId> found;
  msg::AdjVarsInfoRequest request;
  for (int page = 0; page < 20 && found.size() < total; ++page) {
    const auto info = host.get<msg::AdjVarsInfo>(request);
    ASSERT_EQ(info.total_number, total);
    ASSERT_FALSE(info.vars.empty());
    for (const msg::AdjVarInfo& one : info.vars) {
      EXPECT_TRUE(found.insert(one.var_id).second);
      EXPECT_LE(one.name.size(), 16U);
      EXPECT_LE(one.range_min, one.range_max);
    }
    request.start_id = static_cast<msg::VariableId>(static_cast<unsigned>(*found.rbegin()) + 1);
  }
  EXPECT_EQ(found.size(), total);
}

}  // namespace
}  // namespace sbgc::test
