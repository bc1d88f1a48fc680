// Tests of the order in which requests with an effect are sent, and of stops.

#include "simulation.hpp"

namespace sbgc::test {
namespace {

using Order = LineTest;
using Stop = LineTest;

/// The longest pause after a small command, and the time of its frame on a line of the default
/// speed.
constexpr Duration pause = milliseconds(11);

msg::Control turn(int speed) {
  msg::Control request;
  request.control_mode.set_mode(msg::ControlModeKind::speed);
  request.axes.yaw.speed = msg::ControlSpeed(static_cast<std::int16_t>(speed));
  return request;
}

msg::WriteParams3 write(std::uint8_t profile) {
  msg::WriteParams3 request;
  request.profile_id = profile;
  return request;
}

TEST_F(Order, WhatHasAnEffectWaitsForNoResponse) {
  line.send(msg::MotorsOn{});
  line.send(msg::MotorsOn{});
  line.send(write(1));
  line.run_for(milliseconds(100));
  EXPECT_THAT(ids(line.written), ElementsAre(motors_on, motors_on, write_params_3));
  EXPECT_LE(gap(1), pause);
}

TEST_F(Order, NothingIsRepeatedAfterALaterRequest) {
  // whose board never responds
  const Handle on = line.send(msg::MotorsOn{});
  line.run_for(milliseconds(400));
  const Handle again = line.send(msg::MotorsOn{});
  line.run_for(milliseconds(50));
  const Handle off = line.send(msg::MotorsOff{});
  line.run();
  EXPECT_THAT(ids(line.written),
              ElementsAre(motors_on, motors_on, motors_off, motors_off, motors_off));
  for (const Handle handle : {on, again, off}) EXPECT_EQ(line.outcome(handle), Outcome::timeout);
}

TEST_F(Order, OfAnotherHostDoesNotMatter) {
  line.send(msg::MotorsOn{}, {.host = 1});
  line.send(write(1), {.host = 2});
  line.run();
  EXPECT_THAT(ids(line.written), UnorderedElementsAre(motors_on, write_params_3, motors_on,
                                                      write_params_3, motors_on, write_params_3));
}

TEST_F(Order, AReadDoesNotEndTheRepetitionOfAWrite) {
  line.board = [&](const Written& frame) {
    if (frame.id == board_info) line.say(board_info, body_of(18));
  };
  line.send(write(1));
  line.send(msg::BoardInfoRequest{});
  line.run();
  EXPECT_THAT(ids(line.written),
              ElementsAre(write_params_3, board_info, write_params_3, write_params_3));
}

TEST_F(Order, AReadAfterAWriteIsNotSentBefore) {
  std::uint8_t stored = 0;
  line.board = [&](const Written& frame) {
    if (frame.id == write_params_3) stored = frame.body[1];  // and all confirmations are lost
    if (frame.id == 21) line.say(21, body_of(134, {0, stored}));
  };
  auto request = write(0);
  for (const auto value : {std::uint8_t{1}, std::uint8_t{2}}) {
    request.axes.roll.p = value;
    line.send(request);
  }
  const Handle read = line.send(msg::ReadParams3Request{});
  line.run();
  ASSERT_EQ(line.outcome(read), Outcome::answered);
  EXPECT_EQ(line.completion(read)->body[1], 2);
  EXPECT_EQ(stored, 2);
}

TEST_F(Stop, IsSentNextAndSupersedesQueuedMotion) {
  std::vector<Handle> motions;
  for (int speed = 1; speed < 6; ++speed) motions.push_back(line.send(turn(speed)));
  line.run_for(Duration{});
  const Handle stop = line.send(turn(0));
  line.run();
  EXPECT_THAT(line.written, SizeIs(2));
  EXPECT_EQ(line.outcome(motions[0]), Outcome::sent);
  for (std::size_t i = 1; i < motions.size(); ++i) {
    EXPECT_EQ(line.outcome(motions[i]), Outcome::superseded);
  }
  EXPECT_EQ(line.outcome(stop), Outcome::sent);
  EXPECT_LE(gap(1), pause);
}

TEST_F(Stop, SupersedesMotionOfAllHostsAndNothingElse) {
  line.send(msg::BoardInfoRequest{}, {.host = 1});
  line.run_for(Duration{});
  const Handle beep = line.send(msg::BeepSound{}, {.host = 1});
  const Handle other = line.send(turn(7), {.host = 2});
  line.send(msg::MotorsOff{}, {.host = 1});
  const Handle later = line.send(turn(8), {.host = 1});
  line.run_for(milliseconds(200));
  ASSERT_GE(line.written.size(), 4U);
  EXPECT_EQ(line.written[1].id, motors_off);
  for (const Handle handle : {beep, later}) EXPECT_EQ(line.outcome(handle), Outcome::sent);
  EXPECT_EQ(line.outcome(other), Outcome::superseded);
}

TEST_F(Stop, IsNotSupersededByALaterOne) {
  line.send(turn(1));
  line.run_for(Duration{});
  line.send(msg::MotorsOff{});
  line.send(turn(0));
  line.run_for(milliseconds(100));
  EXPECT_THAT(ids(line.written), ElementsAre(control, motors_off, control));
}

TEST_F(Stop, DoesNotSupersedeWhatWasSentAndIsDueAgain) {
  // whose board never responds
  const Handle on = line.send(msg::MotorsOn{}, {.timeout = milliseconds(5)});
  line.run_for(milliseconds(7));  // it is to be sent again after the pause
  line.send(msg::MotorsOff{}, {.attempts = 1});
  line.run();
  EXPECT_THAT(ids(line.written), ElementsAre(motors_on, motors_off));
  EXPECT_EQ(line.outcome(on), Outcome::timeout);
}

TEST_F(Stop, IsNotHeldUpByAnything) {
  line.send(msg::I2cReadRegBufRequest{});
  line.send(msg::I2cReadRegBufRequest{});
  line.run_for(milliseconds(1));
  line.send(msg::MotorsOff{});
  line.run_for(milliseconds(30));
  EXPECT_THAT(ids(line.written), ElementsAre(i2c_read, motors_off));
}

TEST_F(Stop, ThatIsCancelledSupersedesNothing) {
  line.send(turn(1));
  line.run_for(Duration{});
  const Handle motion = line.send(turn(2));
  const Handle stop = line.send(msg::MotorsOff{});
  line.session.cancel(stop, line.sink());
  line.run();
  EXPECT_EQ(line.outcome(motion), Outcome::sent);
}

TEST(StopRules, IsWhatTheSpecificationSays) {
  const auto stops = [](const auto& request) { return response_policy(request).stops; };
  EXPECT_TRUE(stops(msg::MotorsOff{}));
  EXPECT_TRUE(stops(msg::MotorsOffExt{}));
  EXPECT_TRUE(stops(turn(0)));
  EXPECT_FALSE(stops(turn(1)));
  EXPECT_FALSE(stops(msg::Control{})) << "the axes are no longer controlled";
  msg::ControlExt extended;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    extended.control_mode[axis].set_mode(msg::ControlModeKind::speed);
  }
  EXPECT_TRUE(stops(extended));
  extended.control_mode.roll.set_mode(msg::ControlModeKind::angle);
  EXPECT_FALSE(stops(extended));
  EXPECT_TRUE(stops(msg::ExecuteMenu{.cmd_id = msg::MenuCommand::motor_off}));
  EXPECT_FALSE(stops(msg::ExecuteMenu{.cmd_id = msg::MenuCommand::motor_on}));
  EXPECT_FALSE(stops(msg::ControlExtCommand{}));
  EXPECT_TRUE(stops(msg::ControlQuatSpeed{}));
}

TEST(ControlRate, AStreamOfControlsIsSentAtItsRate) {
  Simulation line({.line = {115200, Parity::none}});  // its board confirms nothing
  constexpr int count = 500;
  std::mt19937 random(1);
  for (int i = 0; i < count; ++i) {
    line.send(turn(i + 1));
    // The thread that polls is up to 2 ms late.
    line.late = milliseconds(std::uniform_int_distribution<int>(0, 2)(random));
    line.run_until(start_time + milliseconds(10 * (i + 1)));
    ASSERT_GE(line.written.size(), static_cast<std::size_t>(i)) << "more than one frame late";
  }
  line.run();
  EXPECT_THAT(line.written, SizeIs(count));
}

TEST(ControlRate, ALineThatWasIdleIsNotLate) {
  Simulation line({.line = {115200, Parity::none}});
  const auto send_two = [&](int speed) {
    line.send(turn(speed));
    line.run_for(Duration{});
    line.send(turn(speed + 1));
    line.run();
    const std::size_t count = line.written.size();
    return line.written[count - 1].at - line.written[count - 2].at;
  };
  const Duration pause = send_two(1);
  line.run_for(milliseconds(100));
  EXPECT_EQ(send_two(3), pause);
}

/// The effect of a request on a board.
enum class Motion : std::uint8_t { unknown, on, off, turning, still };

Motion motion_of(const Written& frame) {
  if (frame.id == motors_on) return Motion::on;
  if (frame.id == motors_off) return Motion::off;
  if (frame.id != control) return Motion::unknown;
  return frame.body[9] == 0 && frame.body[10] == 0 ? Motion::still : Motion::turning;
}

/// A host whose line loses, delays and repeats the frames of the board.
class Host {
 public:
  explicit Host(unsigned seed) : random_(seed) {
    line.board = [this](const Written& frame) { hear(frame); };
  }

  /// Sends some requests, and checks that the board does what the last one said.
  void run_once() {
    for (int i = 0; i < 12; ++i) {
      ask();
      line.run_for(milliseconds(chance(20) ? upto(900) : upto(30)));
    }
    line.run();
    EXPECT_EQ(state_, asked_);
    EXPECT_EQ(line.session.open_requests(), 0U);
  }

  Simulation line{{.line = {115200, Parity::none}}};

 private:
  int upto(int most) { return std::uniform_int_distribution<int>(0, most)(random_); }
  bool chance(int percent) { return upto(99) < percent; }

  template <class M>
  void send(const M& request, Motion motion = Motion::unknown) {
    if (line.session.send(request) && motion != Motion::unknown) asked_ = motion;
  }

  void ask() {
    switch (upto(6)) {
      case 0: return send(msg::MotorsOn{}, Motion::on);
      case 1: return stop(msg::MotorsOff{}, Motion::off);
      case 2: return stop(turn(0), Motion::still);
      case 3: return send(turn(1 + upto(100)), Motion::turning);
      case 4: return send(msg::I2cReadRegBufRequest{});
      case 5: return send(msg::BoardInfoRequest{});
      default: return send(write(static_cast<std::uint8_t>(upto(4))));
    }
  }

  /// A stop is written within the time of a frame and the pause that the protocol asks for.
  template <class M>
  void stop(const M& request, Motion motion) {
    const std::size_t before = line.written.size();
    const Instant asked = line.now;
    if (!line.session.send(request)) return;
    asked_ = motion;
    line.run_for(milliseconds(40));
    ASSERT_GT(line.written.size(), before);
    EXPECT_EQ(motion_of(line.written[before]), motion) << "it is the next frame";
    constexpr int frame_of_parameters = 13;  // 139 bytes at 115200 baud
    EXPECT_LE(line.written[before].at - asked, milliseconds(frame_of_parameters + 20));
  }

  void hear(const Written& frame) {
    if (motion_of(frame) != Motion::unknown) state_ = motion_of(frame);
    for (int times = chance(10) ? 2 : 1; times > 0; --times) {
      if (chance(25)) continue;
      const Duration delay = milliseconds(1 + upto(chance(20) ? 900 : 20));
      switch (frame.id) {
        case board_info: line.say(board_info, body_of(18), delay); break;
        case i2c_read: line.say(i2c_read, body_of(4), delay); break;
        default: line.confirm(frame.id, delay); break;
      }
    }
  }

  std::mt19937 random_;
  Motion state_ = Motion::unknown;
  Motion asked_ = Motion::unknown;
};

class Lines : public ::testing::TestWithParam<unsigned> {};

TEST_P(Lines, TheBoardDoesWhatTheLastRequestSaid) {
  Host host(GetParam());
  for (int i = 0; i < 30; ++i) host.run_once();
}

INSTANTIATE_TEST_SUITE_P(Seeds, Lines, ::testing::Range(1U, 41U));

}  // namespace
}  // namespace sbgc::test
