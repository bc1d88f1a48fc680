// Old boards and firmware: what they do not know they ignore.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sbgc/availability.hpp>
#include <sbgc/dispatch.hpp>
#include <sbgc/meta/all.hpp>

#include "host.hpp"

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

TEST(Availability, AnOldBoardIgnoresWhatItDoesNotKnow) {
  Host host(versions(30, 2439));
  EXPECT_EQ(host.get<BoardInfo>(BoardInfoRequest{}).firmware_ver.raw(), 2439);
  EXPECT_THAT(host.ask(BeepSound{}), IsEmpty());
  EXPECT_THAT(host.ask(DataStreamInterval{}), IsEmpty());
  EXPECT_THAT(host.ask(RealtimeDataCustomRequest{}), IsEmpty());
  EXPECT_THAT(host.ask(ControlExt{}), IsEmpty()) << "a form that is newer than the command";
  EXPECT_THAT(host.ask(Control{}), SizeIs(1));
  EXPECT_EQ(host.board.counters().unknown, 4U);
}

TEST(Availability, OfEveryRequestIsThatOfTheModel) {
  for (const auto& options : {versions(10, 2200), versions(30, 2439), versions(30, 2590)}) {
    Host host(options);
    AllMessages::for_each([&]<class M>(Type<M>) {
      if constexpr (M::direction != Direction::from_board) {
        const auto unknown = host.board.counters().unknown;
        host.ask(M{}, milliseconds(2));
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
