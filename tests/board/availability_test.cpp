// Old boards and firmware, and newer ones: what they do not know they refuse, or ignore if they
// have no words for it.

#include <type_traits>

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

board::Options versions(std::uint8_t board, std::uint16_t firmware) {
  board::Options options;
  options.board = BoardVersion(board);
  options.firmware = FirmwareVersion(firmware);
  return options;
}

TEST(Availability, AnOldBoardRefusesWhatItDoesNotKnow) {
  Host host(versions(30, 2439));
  EXPECT_EQ(host.get<BoardInfo>(BoardInfoRequest{}).firmware_ver.raw(), 2439);
  EXPECT_EQ(refusal(host, BeepSound{}), BoardErrorCode::unknown_command);
  EXPECT_EQ(refusal(host, DataStreamInterval{}), BoardErrorCode::unknown_command);
  EXPECT_EQ(refusal(host, RealtimeDataCustomRequest{}), BoardErrorCode::unknown_command);
  EXPECT_EQ(refusal(host, ControlExt{}), BoardErrorCode::cmd_size)
      << "a form that is newer than the command";
  EXPECT_THAT(host.ask(Control{}), SizeIs(1));
  EXPECT_EQ(host.board.counters().unknown, 4U);
}

TEST(Availability, AFormEndsWhereAnotherTakesItsPlace) {
  for (const std::uint16_t firmware : {std::uint16_t{2590}, std::uint16_t{2686}}) {
    Host host(versions(30, firmware));
    EXPECT_TRUE(is_confirmed(host, MotorsOff{}));
    EXPECT_EQ(refusal(host, MotorsOffExt{}), BoardErrorCode::cmd_size);
  }
  Host host(versions(30, 2687));
  EXPECT_EQ(refusal(host, MotorsOff{}), BoardErrorCode::cmd_size);
  for (const auto mode : {MotorsOffMode::normal, MotorsOffMode::brake, MotorsOffMode::safe_stop}) {
    host.ask(MotorsOn{});
    EXPECT_TRUE(is_confirmed(host, MotorsOffExt{mode}));
    EXPECT_FALSE(host.board.gimbal().motors_on());
  }
  EXPECT_EQ(refusal(host, MotorsOffExt{MotorsOffMode{3}}), BoardErrorCode::wrong_params);
}

TEST(Availability, OfEveryRequestIsThatOfTheModel) {
  for (const auto& options :
       {versions(10, 2200), versions(30, 2439), versions(30, 2590), versions(30, 2700)}) {
    Host host(options);
    AllMessages::for_each([&]<class M>(Type<M>) {
      if constexpr (M::direction != Direction::from_board) {
        const auto unknown = host.board.counters().unknown;
        M request{};
        if constexpr (std::is_same_v<M, ApiVirtChControl>) request.val_ch.push_back({});
        host.ask(request, milliseconds(2));
        const bool is_known =
            is_supported<M>(Availability{options.firmware.raw(), options.board.raw()});
        EXPECT_EQ(host.board.counters().unknown - unknown, is_known ? 0U : 1U)
            << Meta<M>::info.name;
        // It may have restarted.
        host.board.restart(host.now);
        host.listen(options.start_time + milliseconds(1));
      }
    });
  }
}

TEST(Availability, BeforeBoard3ThereAreNoErrors) {
  Host host(versions(10, 2200));
  EXPECT_THAT(host.ask(UseDefaults{.profile_id = 99}), IsEmpty());
  EXPECT_EQ(host.board.counters().refused, 1U);
}

TEST(Availability, OldRequestsHaveTheAnswersOfNewerOnes) {
  Host host(versions(10, 2200));
  host.board.gimbal().set_battery(12.3, host.now);
  EXPECT_NEAR(host.get<RealtimeData3>(RealtimeData{}).bat_level.volts(), 12.3, 0.01);
  EXPECT_THAT(host.ask(RealtimeData3Request{}), IsEmpty());
  EXPECT_EQ(host.get<ReadParams3>(ReadParams{.profile_id = 1}).profile_id, 1);
  EXPECT_THAT(host.ask(ReadParams3Request{}), IsEmpty());
}

TEST(Availability, AccelerationLimitsAreThoseThatTheFirmwareHas) {
  // The camera is as fast as the limit in force allows.
  const auto moved = [](std::uint16_t firmware) {
    Host host(versions(30, firmware));
    auto settings = host.get<ReadParams3>(ReadParams3Request{});
    settings.acc_limiter_all = AngularAcceleration(200);
    host.ask(WriteParams3{settings});
    auto more = host.get<ReadParamsExt2>(ReadParamsExt2Request{});
    more.acc_limiter3 = {AngularAcceleration(1), AngularAcceleration(1), AngularAcceleration(1)};
    host.ask(WriteParamsExt2{more});
    Control control;
    control.control_mode.set_mode(ControlModeKind::speed);
    control.axes.yaw.speed = ControlSpeed::from_degrees_per_second(60);
    host.ask(control, seconds(1));
    return host.get<GetAngles>(GetAnglesRequest{}).axes.yaw.imu_angle.degrees();
  };
  EXPECT_LT(moved(2590), 5);
  EXPECT_GT(moved(2560), 30);
}

}  // namespace
}  // namespace sbgc::test
