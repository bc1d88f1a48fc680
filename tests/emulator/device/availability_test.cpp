// Tests of older and newer boards and firmware: they reject unknown requests, or ignore them if
// they cannot report errors.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sbgc/availability.hpp>
#include <sbgc/dispatch.hpp>
#include <sbgc/meta/all.hpp>

#include "replies.hpp"

namespace sbgc::test {
namespace {

using ::testing::IsEmpty;
using ::testing::SizeIs;

emulator::BoardOptions versions(std::uint8_t board, std::uint16_t firmware) {
  emulator::BoardOptions options;
  options.board = msg::BoardVersion(board);
  options.firmware = msg::FirmwareVersion(firmware);
  return options;
}

TEST(Availability, AnOldBoardRefusesWhatItDoesNotKnow) {
  Host host(versions(30, 2439));
  EXPECT_EQ(host.get<msg::BoardInfo>(msg::BoardInfoRequest{}).firmware_ver.raw(), 2439);
  EXPECT_EQ(refusal(host, msg::BeepSound{}), msg::BoardErrorCode::unknown_command);
  EXPECT_EQ(refusal(host, msg::DataStreamInterval{}), msg::BoardErrorCode::unknown_command);
  EXPECT_EQ(refusal(host, msg::RealtimeDataCustomRequest{}), msg::BoardErrorCode::unknown_command);
  EXPECT_EQ(refusal(host, msg::AhrsHelperRequestWide{}), msg::BoardErrorCode::cmd_size)
      << "a form that is newer than the command";
  EXPECT_THAT(host.ask(msg::Control{}), SizeIs(1));
  EXPECT_EQ(host.board.counters().unknown, 4U);
}

TEST(Availability, AFormEndsWhereAnotherTakesItsPlace) {
  Host older(versions(30, 2694));
  older.get<msg::AhrsHelper>(msg::AhrsHelperRequest{});
  EXPECT_EQ(refusal(older, msg::AhrsHelperRequestWide{}), msg::BoardErrorCode::cmd_size);
  Host newer(versions(30, 2695));
  EXPECT_EQ(refusal(newer, msg::AhrsHelperRequest{}), msg::BoardErrorCode::cmd_size);
  newer.get<msg::AhrsHelper>(msg::AhrsHelperRequestWide{});
}

TEST(Availability, EveryFirmwareTurnsMotorsOffWithoutAMode) {
  for (const std::uint16_t firmware : {std::uint16_t{2200}, std::uint16_t{2686}, newest_firmware}) {
    Host host(versions(30, firmware));
    host.ask(msg::MotorsOn{});
    EXPECT_TRUE(is_confirmed(host, msg::MotorsOff{}));
    EXPECT_FALSE(host.board.gimbal().motors_on());
  }
  Host host(versions(30, 2687));
  for (const auto mode :
       {msg::MotorsOffMode::normal, msg::MotorsOffMode::brake, msg::MotorsOffMode::safe_stop}) {
    host.ask(msg::MotorsOn{});
    EXPECT_TRUE(is_confirmed(host, msg::MotorsOffExt{mode}));
    EXPECT_FALSE(host.board.gimbal().motors_on());
  }
  EXPECT_EQ(refusal(host, msg::MotorsOffExt{msg::MotorsOffMode{3}}),
            msg::BoardErrorCode::wrong_params);
}

TEST(Availability, OfEveryRequestIsThatOfTheModel) {
  for (auto options :
       {versions(10, 2200), versions(30, 2439), versions(30, 2590), versions(30, 2700)}) {
    options.is_strict = true;  // a later form may also be an earlier one with surplus
    Host host(options);
    AllMessages::for_each([&]<class M>(Type<M>) {
      if constexpr (M::direction != Direction::from_board) {
        const auto unknown = host.board.counters().unknown;
        const M request = any_request<M>();
        host.ask(request, milliseconds(2));
        const bool is_known =
            is_supported<M>(Availability{options.firmware.raw(), options.board.raw()});
        EXPECT_EQ(host.board.counters().unknown - unknown, is_known ? 0U : 1U)
            << Meta<M>::info.name;
        // The board may have restarted.
        host.board.restart(host.now);
        host.listen(options.start_time + milliseconds(1));
      }
    });
  }
}

TEST(Availability, BeforeBoard3ThereAreNoErrors) {
  Host host(versions(10, 2200));
  EXPECT_THAT(host.ask(msg::UseDefaults{.profile_id = 99}), IsEmpty());
  EXPECT_EQ(host.board.counters().refused, 1U);
}

TEST(Availability, OldRequestsHaveTheirAnswers) {
  Host host(versions(10, 2200));
  host.board.gimbal().set_battery(12.3, host.now);
  EXPECT_NEAR(host.get<msg::RealtimeData3>(msg::RealtimeData{}).bat_level.volts(), 12.3, 0.01);
  EXPECT_THAT(host.ask(msg::RealtimeData3Request{}), IsEmpty());
  EXPECT_EQ(host.get<msg::ReadParamsAnswer>(msg::ReadParams{.profile_id = 1}).profile_id, 1);
  EXPECT_THAT(host.ask(msg::ReadParams3Request{}), IsEmpty());
}

TEST(Availability, AccelerationLimitsAreThoseThatTheFirmwareHas) {
  // The camera accelerates as fast as the effective limit allows.
  const auto moved = [](std::uint16_t firmware) {
    Host host(versions(30, firmware));
    auto parameters = host.get<msg::ReadParams3>(msg::ReadParams3Request{});
    parameters.acc_limiter_all = msg::AngularAcceleration(200);
    host.ask(msg::WriteParams3{parameters});
    auto more = host.get<msg::ReadParamsExt2>(msg::ReadParamsExt2Request{});
    more.acc_limiter3 = {msg::AngularAcceleration(1), msg::AngularAcceleration(1),
                         msg::AngularAcceleration(1)};
    host.ask(msg::WriteParamsExt2{more});
    msg::Control control;
    control.control_mode.set_mode(msg::ControlModeKind::speed);
    control.axes.yaw.speed = 60_deg_per_s;
    host.ask(control, seconds(1));
    return host.get<msg::GetAngles>(msg::GetAnglesRequest{}).axes.yaw.imu_angle.degrees();
  };
  EXPECT_LT(moved(2590), 5);
  EXPECT_GT(moved(2560), 30);
}

}  // namespace
}  // namespace sbgc::test
