// Tests of the core of the bridge, with a board's side that the tests play.

#include "share/bridge_ports.hpp"

#include <algorithm>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sbgc/message.hpp>
#include <sbgc/messages.hpp>
#include <sbgc/surplus.hpp>

namespace sbgc::tools {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::SizeIs;

using Bytes = std::vector<std::uint8_t>;

struct Sent {
  std::uint64_t tag{};
  RawRequest request{};
};

class Line final : public BridgeLine {
 public:
  void send(std::uint64_t tag, RawRequest request) override {
    sent.push_back({tag, std::move(request)});
  }
  void take_line() override { is_taken = true; }
  void write_raw(std::vector<std::uint8_t> bytes) override {
    raw.insert(raw.end(), bytes.begin(), bytes.end());
    waiting += bytes.size();
  }
  std::size_t raw_waiting() const override { return waiting; }
  void check() override { ++checks; }
  void take_over(OwedStop stop) override { stops.push_back(std::move(stop)); }
  void drop_stops() override { stops.clear(); }
  void give_line_back() override {
    is_taken = false;
    ++reopened;
  }
  void release_line() override { is_taken = false; }

  std::vector<Sent> sent;
  bool is_taken = false;
  int reopened = 0;
  Bytes raw;
  std::size_t waiting = 0;  // bytes that have not been sent; a test says when they are
  int checks = 0;
  std::vector<OwedStop> stops;
};

msg::Control turning(int speed) {
  msg::Control request;
  request.control_mode.set_mode(msg::ControlModeKind::speed);
  request.axes.yaw.speed = msg::ControlSpeed(static_cast<std::int16_t>(speed));
  return request;
}

template <class M>
Bytes frame_of(const M& message, Framing framing = basic_framing) {
  Bytes bytes(max_frame_size);
  bytes.resize(encode_frame(framing, message, bytes).size);
  return bytes;
}

msg::DataStreamInterval stream(std::uint16_t interval,
                               msg::CommandFromBoard what = msg::RealtimeData3::command) {
  msg::DataStreamInterval request;
  request.cmd_id = what;
  request.interval_ms = msg::Milliseconds(interval);
  return request;
}

/// A stream of RealtimeDataCustom with these contents.
msg::DataStreamInterval custom_stream(std::uint16_t interval, msg::RealtimeDataCustomFlag flag) {
  msg::DataStreamInterval request = stream(interval, msg::RealtimeDataCustom::command);
  request.config.flags = msg::RealtimeDataCustomFlags(flag);
  return request;
}

Bytes frame_with(std::uint8_t id, const Bytes& body) {
  Bytes bytes(max_frame_size);
  bytes.resize(write_frame(basic_framing, id, body, bytes).size);
  return bytes;
}

/// A frame with a body of zeros.
Bytes sample_of(msg::CommandFromBoard what, std::size_t size) {
  return frame_with(static_cast<std::uint8_t>(what), Bytes(size));
}

msg::Confirm confirmation_of(msg::CommandToBoard command) { return {.cmd = command}; }

msg::ErrorExt error_of(msg::CommandToBoard command, msg::BoardErrorCode code = {}) {
  msg::ErrorExt error;
  error.cmd_id = command;
  error.error_code = code;
  return error;
}

class Bridge : public ::testing::Test {
 protected:
  std::size_t join() {
    wakes.push_back(0);
    return *ports.connect(false, [this, index = wakes.size() - 1] { ++wakes[index]; });
  }
  static msg::Confirm confirmation_of_stream() {
    return confirmation_of(msg::DataStreamInterval::command);
  }
  template <class M>
  void ask(std::size_t port, const M& request, Framing framing = basic_framing) {
    ports.receive(port, frame_of(request, framing));
  }
  /// The board answers a request.
  template <class M>
  void answer(const Sent& sent, const M& message) {
    const Bytes bytes = frame_of(message);
    const Frame frame = frame_at(bytes.data());
    ports.answered(sent.tag, frame);
    ports.arrived({.frame = frame, .belongs_to_call = true});
    ports.ended(sent.tag);
  }
  /// The board sends a message by itself.
  template <class M>
  void send(const M& message) {
    const Bytes bytes = frame_of(message);
    ports.arrived({.frame = frame_at(bytes.data())});
  }
  Bytes read(std::size_t port) {
    const auto waiting = ports.output(port);
    Bytes bytes(waiting.begin(), waiting.end());
    ports.take(port, bytes.size());
    return bytes;
  }
  /// The intervals that the board was asked for, from the oldest.
  std::vector<int> intervals() {
    std::vector<int> result;
    for (const Sent& one : line.sent) {
      WithSurplus<msg::DataStreamInterval> request;
      if (decode({one.request.body.data(), one.request.body.size()}, request)) {
        result.push_back(request.interval_ms.raw());
      }
    }
    return result;
  }

  Line line;
  Instant time{1'000'000};
  std::vector<std::string> logged;
  BridgePorts ports{line, [this] { return time; },
                    [this](const std::string& text) { logged.push_back(text); }};
  std::vector<int> wakes;
};

class OneHost : public Bridge {
 protected:
  const std::size_t host = join();
};

class TwoHosts : public Bridge {
 protected:
  const std::size_t first = join();
  const std::size_t second = join();
};

TEST_F(OneHost, GoesOnWithTheStopOfAHostThatLeaves) {
  ask(host, turning(0));
  ports.disconnect(host);
  ASSERT_THAT(line.stops, SizeIs(1));
  EXPECT_FALSE(line.stops[0].turns_motors_off());
}

TEST_F(Bridge, GoesOnWithMotorsOffUntilTheyAreConfirmed) {
  const std::size_t first = join();
  ask(first, msg::MotorsOff{});
  ports.disconnect(first);
  ASSERT_THAT(line.stops, SizeIs(1));
  EXPECT_TRUE(line.stops[0].turns_motors_off());
  const std::size_t second = join();
  ask(second, msg::MotorsOff{});
  const msg::Confirm confirmation = confirmation_of(msg::MotorsOff::command);
  answer(line.sent.back(), confirmation);
  ports.disconnect(second);
  EXPECT_THAT(line.stops, SizeIs(1));
}

TEST_F(OneHost, AStopThatHasBeenSeenIsDone) {
  ask(host, turning(0));
  msg::GetAngles state;
  send(state);
  time = time + sbgc::milliseconds(400);
  state.axes.yaw.rc_speed = msg::ControlSpeed(1);
  send(state);
  state.axes.yaw.rc_speed = {};
  for (int i = 0; i < 2; ++i) {
    time = time + sbgc::milliseconds(500);
    send(state);
  }
  ports.disconnect(host);
  EXPECT_THAT(line.stops, IsEmpty());
}

TEST_F(Bridge, LaterMotionOfAnotherHostEndsAStop) {
  const std::size_t first = join();
  ask(first, turning(0));
  const std::size_t second = join();
  ask(second, turning(5));
  ports.disconnect(first);
  EXPECT_THAT(line.stops, IsEmpty());
  // Also one that the bridge goes on with.
  const std::size_t third = join();
  ask(third, turning(0));
  ports.disconnect(third);
  ASSERT_THAT(line.stops, SizeIs(1));
  ask(second, turning(5));
  EXPECT_THAT(line.stops, IsEmpty());
}

TEST_F(OneHost, UnknownRequestsPassToo) {
  const Bytes bytes = frame_with(249, {1, 2, 3});
  ports.receive(host, bytes);
  ASSERT_THAT(line.sent, SizeIs(1));
  EXPECT_EQ(line.sent[0].request.id, 249);
  EXPECT_FALSE(line.sent[0].request.policy.retry_is_safe);
  // Its response is whatever has the same id.
  ports.answered(line.sent[0].tag, frame_at(bytes.data()));
  EXPECT_EQ(read(host), bytes);
}

TEST_F(TwoHosts, UnknownMessagesGoToAllHosts) {
  const Bytes bytes = frame_with(200, {0x0e, 0x45});
  ports.arrived({.frame = frame_at(bytes.data())});
  EXPECT_EQ(read(first), bytes);
  EXPECT_EQ(read(second), bytes);
}

TEST_F(OneHost, ARequestThatFailsHasNoAnswer) {
  ask(host, msg::GetAnglesRequest{});
  EXPECT_FALSE(ports.is_quiet(host));
  ports.ended(line.sent.at(0).tag);
  EXPECT_THAT(read(host), IsEmpty());
  EXPECT_FALSE(ports.is_quiet(host)) << "the answer may be late";
  time = time + seconds(2);
  EXPECT_TRUE(ports.is_quiet(host));
}

TEST_F(TwoHosts, UnsolicitedMessagesGoToAll) {
  send(msg::Reset{});
  EXPECT_EQ(read(first), frame_of(msg::Reset{}));
  EXPECT_EQ(read(second), frame_of(msg::Reset{}));
}

TEST_F(TwoHosts, ALateAnswerGoesToTheOneWhoAsked) {
  ask(first, msg::Control{});
  ports.ended(line.sent.at(0).tag);  // its confirmation is not certain
  ask(second, msg::Control{});
  const msg::Confirm confirmation = confirmation_of(msg::Control::command);
  send(confirmation);
  EXPECT_EQ(read(first), frame_of(confirmation));
  EXPECT_THAT(read(second), IsEmpty());
}

TEST_F(TwoHosts, ALateAnswerOfAWrongSizeGoesToTheOneWhoAsked) {
  ask(first, msg::GetAnglesRequest{});
  ports.ended(line.sent[0].tag, ErrorCode::timeout);
  const Bytes broken = sample_of(msg::GetAngles::command, 5);
  time = time + milliseconds(400);
  ports.arrived({.frame = frame_at(broken.data())});
  EXPECT_EQ(read(first), broken);
  EXPECT_THAT(read(second), IsEmpty());
}

TEST_F(TwoHosts, AnAnswerIsNobodysAfterAMinute) {
  ask(first, msg::GetAnglesRequest{});
  answer(line.sent[0], msg::GetAngles{});
  read(first);
  time = time + seconds(59);
  send(msg::GetAngles{});
  EXPECT_EQ(read(first), frame_of(msg::GetAngles{}));
  EXPECT_THAT(read(second), IsEmpty());
  time = time + seconds(2);
  send(msg::GetAngles{});
  EXPECT_EQ(read(second), frame_of(msg::GetAngles{}));
}

TEST_F(OneHost, WhatAHostHasAskedForOnceDoesNotFillTheMemory) {
  ask(host, msg::GetAnglesRequest{});
  answer(line.sent[0], msg::GetAngles{});
  for (int i = 0; i < 10'000; ++i) send(msg::GetAngles{});
  EXPECT_LT(ports.output(host).size(), 2 * BridgePorts::max_output);
}

TEST_F(TwoHosts, SeveralAnswersGoToTheOneWhoAsked) {
  ask(second, msg::GetAnglesRequest{});
  answer(line.sent.back(), msg::GetAngles{});
  time = time + seconds(10);
  ask(first, msg::GetAnglesRequest{});
  answer(line.sent.back(), msg::GetAngles{});
  read(first);
  read(second);
  send(msg::GetAngles{});
  EXPECT_EQ(read(first), frame_of(msg::GetAngles{}));
  EXPECT_THAT(read(second), IsEmpty());
}

TEST_F(TwoHosts, AnErrorWithoutACommandIsForTheOnlyOneWhoAsks) {
  ask(first, msg::Control{});
  ports.ended(line.sent.back().tag);
  send(msg::Error{});
  EXPECT_EQ(read(first), frame_of(msg::Error{}));
  EXPECT_THAT(read(second), IsEmpty());
  ask(second, msg::Control{});
  ports.ended(line.sent.back().tag);
  send(msg::Error{});
  EXPECT_THAT(read(first), IsEmpty());
  EXPECT_THAT(read(second), IsEmpty());
}

TEST_F(TwoHosts, TheEndOfATaskIsForTheLastHostThatHasBegunOne) {
  msg::Control task;
  task.control_mode.set_mode(msg::ControlModeKind::angle);
  task.control_mode.set_flags(msg::ControlFlag::auto_task);
  const msg::Confirm confirmation = confirmation_of(msg::Control::command);
  const auto confirmed = [&] {
    send(confirmation);
    const std::size_t count = read(first).empty() ? 0 : 1;
    return read(second).empty() ? count : count + 10;
  };
  const auto begin = [&](std::size_t host, const msg::Control& request) {
    ask(host, request);
    ports.ended(line.sent.back().tag);
    time = time + milliseconds(100);
    return confirmed();
  };
  EXPECT_EQ(begin(first, task), 1U);
  EXPECT_EQ(begin(second, msg::Control{}), 10U);
  EXPECT_EQ(begin(second, msg::Control{}), 10U);
  time = time + seconds(11);
  EXPECT_EQ(confirmed(), 1U);
  EXPECT_EQ(begin(first, task), 1U);
  EXPECT_EQ(begin(second, task), 10U);
  EXPECT_EQ(confirmed(), 10U) << "the first task has no end";
}

TEST_F(TwoHosts, AStopThatDropsMotionIsAnErrorOfItsHost) {
  ask(first, msg::Control{});
  ports.ended(line.sent.back().tag, ErrorCode::superseded);
  const msg::ErrorExt error = error_of(msg::Control::command, msg::BoardErrorCode::wrong_state);
  EXPECT_EQ(read(first), frame_of(error));
  ask(second, msg::Control{});
  ports.ended(line.sent.back().tag);
  const msg::Confirm confirmation = confirmation_of(msg::Control::command);
  send(confirmation);
  EXPECT_THAT(read(first), IsEmpty());
  EXPECT_EQ(read(second), frame_of(confirmation));
}

TEST_F(Bridge, AnAnswerForAHostThatHasLeftIsNotForTheNext) {
  const std::size_t first = join();
  ask(first, msg::GetAnglesRequest{});
  ports.ended(line.sent.at(0).tag, ErrorCode::timeout);
  ports.disconnect(first);
  const std::size_t next = join();
  ASSERT_EQ(next, first);
  send(msg::GetAngles{});
  EXPECT_THAT(read(next), IsEmpty());
}

TEST_F(TwoHosts, AnAnswerThatSeveralHostsCouldHaveAskedForIsForNobody) {
  for (const std::size_t host : {first, second}) {
    ask(host, msg::GetAnglesRequest{});
    ports.ended(line.sent.back().tag, ErrorCode::timeout);
  }
  time = time + seconds(10);
  send(msg::GetAngles{});
  EXPECT_THAT(read(first), IsEmpty());
  EXPECT_THAT(read(second), IsEmpty());
}

TEST_F(TwoHosts, TheBoardGetsTheShortestInterval) {
  ask(first, stream(100));
  ask(second, stream(20));
  ask(first, stream(50));
  EXPECT_THAT(intervals(), ElementsAre(100, 20, 20));
  ask(second, stream(0));
  EXPECT_THAT(intervals(), ElementsAre(100, 20, 20, 50));
  ask(first, stream(0));
  EXPECT_THAT(intervals(), ElementsAre(100, 20, 20, 50, 0));
}

TEST_F(TwoHosts, ARequestWithSurplusIsARequestForAStream) {
  WithSurplus<msg::DataStreamInterval> request{stream(100)};
  ASSERT_TRUE(request.tail.push_back(7));
  ask(first, request);
  EXPECT_THAT(line.sent.back().request.body, SizeIs(msg::DataStreamInterval::max_size + 1));
  ask(second, stream(20));
  ask(first, request);
  EXPECT_THAT(intervals(), ElementsAre(100, 20, 20));
  ports.disconnect(second);
  EXPECT_THAT(intervals(), ElementsAre(100, 20, 20, 100));
}

TEST_F(TwoHosts, AHostThatLeavesEndsItsShare) {
  ask(first, stream(100));
  ask(second, stream(20));
  ports.disconnect(second);
  EXPECT_THAT(intervals(), ElementsAre(100, 20, 100));
  ports.disconnect(first);
  EXPECT_THAT(intervals(), ElementsAre(100, 20, 100, 0));
}

TEST_F(Bridge, EachHostGetsItsOwnRate) {
  const std::size_t fast = join();
  const std::size_t slow = join();
  const std::size_t other = join();
  ask(fast, stream(20));
  ask(slow, stream(50));
  for (int i = 0; i < 100; ++i) send(msg::RealtimeData3{});
  const std::size_t size = frame_of(msg::RealtimeData3{}).size();
  EXPECT_EQ(read(fast).size(), 100 * size);
  EXPECT_EQ(read(slow).size(), 40 * size);
  EXPECT_THAT(read(other), IsEmpty());
}

TEST_F(TwoHosts, AnIntervalOfOneIsEveryCycle) {
  ask(first, stream(1));
  ask(second, stream(20));
  for (int i = 0; i < 1250; ++i) send(msg::RealtimeData3{});  // in a second
  EXPECT_EQ(read(second).size(), 50 * frame_of(msg::RealtimeData3{}).size());
}

TEST_F(TwoHosts, AStreamHasOneConfigurationAtATime) {
  using Flag = msg::RealtimeDataCustomFlag;
  ask(first, custom_stream(20, Flag::imu_angles));
  ask(second, custom_stream(20, Flag::target_angles));
  EXPECT_THAT(line.sent, SizeIs(1));
  const msg::ErrorExt error =
      error_of(msg::DataStreamInterval::command, msg::BoardErrorCode::temporary);
  EXPECT_EQ(read(second), frame_of(error));
  ASSERT_THAT(logged, SizeIs(1));
  EXPECT_THAT(logged[0], testing::HasSubstr("another configuration"));
  answer(line.sent[0], confirmation_of_stream());
  read(first);
  // Both have a time and three angles.
  const Bytes sample = sample_of(msg::RealtimeDataCustom::command, 8);
  ports.arrived({.frame = frame_at(sample.data())});
  EXPECT_EQ(read(first), sample);
  EXPECT_THAT(read(second), IsEmpty());

  // The same configuration is shared.
  ask(second, custom_stream(40, Flag::imu_angles));
  EXPECT_THAT(intervals(), ElementsAre(20, 20));
  ask(second, custom_stream(0, Flag::imu_angles));
  answer(line.sent.back(), confirmation_of_stream());
  read(second);

  // When the first one has ended, another one may start; the last samples of the first are for
  // nobody.
  ports.disconnect(first);
  ask(second, custom_stream(20, Flag::target_angles));
  ports.arrived({.frame = frame_at(sample.data())});
  EXPECT_THAT(read(second), IsEmpty());
  answer(line.sent.back(), confirmation_of_stream());
  EXPECT_EQ(read(second), frame_of(confirmation_of_stream()));
  ports.arrived({.frame = frame_at(sample.data())});
  EXPECT_EQ(read(second), sample);
}

TEST_F(OneHost, AHostThatIsNotReadIsNotSilent) {
  while (ports.room(host) != 0) ask(host, msg::Control{});
  const std::size_t requests = line.sent.size();
  const Bytes frame = frame_of(msg::Control{});
  ports.receive(host, std::span(frame).first(3));
  for (int i = 0; i < 2; ++i) {
    time = time + seconds(1);
    ports.tick();
  }
  time = time + seconds(1);
  ports.ended(line.sent.front().tag);
  ports.tick();
  ports.receive(host, std::span(frame).subspan(3));
  EXPECT_THAT(line.sent, SizeIs(requests + 1));
}

TEST_F(OneHost, AStreamWhoseChangeIsRefusedGoesOn) {
  ask(host, stream(20));
  answer(line.sent.at(0), confirmation_of_stream());
  const msg::ErrorExt error = error_of(msg::DataStreamInterval::command);
  for (const std::uint16_t interval : {std::uint16_t{10}, std::uint16_t{0}}) {
    ask(host, stream(interval));
    answer(line.sent.back(), error);
    read(host);
    send(msg::RealtimeData3{});
    EXPECT_EQ(read(host), frame_of(msg::RealtimeData3{}));
  }
}

TEST_F(OneHost, AStreamThatEndsDoesNotComeBackWhenItsNextStartIsRefused) {
  ask(host, stream(20));
  answer(line.sent[0], confirmation_of_stream());
  ask(host, stream(0));
  ask(host, stream(40));
  answer(line.sent[1], confirmation_of_stream());
  const msg::ErrorExt error = error_of(msg::DataStreamInterval::command);
  answer(line.sent[2], error);
  for (int i = 0; i < 10; ++i) {
    time = time + seconds(1);
    ports.tick();
  }
  EXPECT_THAT(line.sent, SizeIs(3));
}

TEST_F(OneHost, AStreamForWhichTheLineHasNoRoomIsRefused) {
  ask(host, stream(20), Framing::v2);
  ports.ended(line.sent.at(0).tag, ErrorCode::overload);
  const msg::ErrorExt error =
      error_of(msg::DataStreamInterval::command, msg::BoardErrorCode::temporary);
  EXPECT_EQ(read(host), frame_of(error, Framing::v2));
  EXPECT_THAT(logged, ElementsAre(testing::HasSubstr("the line has no room for it")));
  time = time + seconds(10);
  ports.tick();
  EXPECT_THAT(line.sent, SizeIs(1)) << "it is not running";
}

TEST_F(OneHost, AConfigurationThatTheBoardRefusesIsNotRunning) {
  using Flag = msg::RealtimeDataCustomFlag;
  ask(host, custom_stream(20, Flag::imu_angles));
  const msg::ErrorExt error =
      error_of(msg::DataStreamInterval::command, msg::BoardErrorCode::wrong_params);
  answer(line.sent[0], error);
  EXPECT_EQ(read(host), frame_of(error));
  ask(host, custom_stream(20, Flag::target_angles));
  EXPECT_THAT(line.sent, SizeIs(2));
}

TEST_F(TwoHosts, StreamsAreStartedAgain) {
  ask(first, stream(100));
  ask(second, stream(20));
  ask(second, stream(30, msg::RealtimeData4::command));
  line.sent.clear();
  ports.restart_streams();
  EXPECT_THAT(intervals(), testing::UnorderedElementsAre(20, 30));
}

TEST_F(TwoHosts, AnAnswerThatMayBeASampleIsBoth) {
  ask(second, stream(20));
  ask(first, msg::RealtimeData3Request{});
  const Sent& sent = line.sent.back();
  const Bytes bytes = frame_of(msg::RealtimeData3{});
  ports.answered(sent.tag, frame_at(bytes.data()));
  ports.arrived({.frame = frame_at(bytes.data()), .belongs_to_call = true, .sample = Sample::yes});
  ports.ended(sent.tag);
  EXPECT_EQ(read(first), bytes);
  EXPECT_EQ(read(second), bytes);
}

TEST_F(TwoHosts, WhatIsNoSampleIsNotForThoseWhoStream) {
  ask(second, stream(20));
  ask(first, msg::RealtimeData3Request{});
  const Bytes bytes = frame_of(msg::RealtimeData3{});
  ports.arrived({.frame = frame_at(bytes.data()), .sample = Sample::doubtful});
  EXPECT_THAT(read(first), IsEmpty());
  ports.arrived({.frame = frame_at(bytes.data()), .is_late = true, .sample = Sample::no});
  EXPECT_EQ(read(first), bytes);
  EXPECT_THAT(read(second), IsEmpty());
  ports.arrived({.frame = frame_at(bytes.data()), .sample = Sample::yes});
  EXPECT_EQ(read(second), bytes);
  EXPECT_THAT(read(first), IsEmpty());
}

TEST_F(OneHost, ARequestForWhichTheStreamLeavesNoTimeIsRefused) {
  ask(host, msg::RealtimeDataCustomRequest{});
  ports.ended(line.sent.at(0).tag, ErrorCode::overload);
  const msg::ErrorExt error =
      error_of(msg::RealtimeDataCustomRequest::command, msg::BoardErrorCode::temporary);
  EXPECT_EQ(read(host), frame_of(error));
  EXPECT_THAT(logged, ElementsAre(testing::HasSubstr("leaves no time")));
}

TEST_F(TwoHosts, AHostThatDoesNotReadDisturbsNoOther) {
  ask(first, stream(20));
  ask(second, stream(20));
  const std::size_t size = frame_of(msg::RealtimeData3{}).size();
  for (int i = 0; i < 5000; ++i) {
    send(msg::RealtimeData3{});
    EXPECT_EQ(read(second).size(), size);
  }
  EXPECT_LE(ports.output(first).size(), BridgePorts::max_output);
  EXPECT_GT(ports.counters()[0].dropped, 4000U);
  EXPECT_EQ(ports.counters()[1].dropped, 0U);
  // It can still ask, and gets its answer.
  ask(first, msg::GetAnglesRequest{});
  const std::size_t before = ports.output(first).size();
  answer(line.sent.back(), msg::GetAngles{});
  EXPECT_EQ(ports.output(first).size(), before + frame_of(msg::GetAngles{}).size());
}

TEST_F(OneHost, AHostThatAsksAndDoesNotReadIsNotReadAnyMore) {
  int asked = 0;
  while (ports.room(host) != 0) {
    ask(host, msg::GetAnglesRequest{});
    answer(line.sent.back(), msg::GetAngles{});
    ASSERT_LT(++asked, 100000);
  }
  EXPECT_LE(ports.output(host).size(), BridgePorts::max_output + max_frame_size);
  read(host);
  EXPECT_NE(ports.room(host), 0U);
}

TEST_F(OneHost, AHostWhoseOutputIsFullIsNotReadAnyMore) {
  ask(host, msg::BootMode3{});
  ports.raw_arrived(Bytes(BridgePorts::max_output));
  ports.line_lost();
  ASSERT_EQ(ports.output(host).size(), BridgePorts::max_output);
  EXPECT_EQ(ports.room(host), 0U);
  ports.take(host, 1);
  EXPECT_NE(ports.room(host), 0U);
}

TEST_F(OneHost, AHostThatAsksTooFastIsReadLater) {
  const Bytes frame = frame_of(msg::GetAnglesRequest{});
  Bytes all;
  while (all.size() < 10000) all.insert(all.end(), frame.begin(), frame.end());
  for (std::size_t at = 0; ports.room(host) != 0;) {
    const std::size_t size = ports.room(host);
    ports.receive(host, std::span(all).subspan(at, size));
    at += size;
  }
  EXPECT_EQ(ports.room(host), 0U);
  EXPECT_THAT(line.sent, SizeIs(BridgePorts::max_requests));
  const int before = wakes[0];
  ports.ended(line.sent.front().tag);
  EXPECT_NE(ports.room(host), 0U);
  EXPECT_GT(wakes[0], before);
}

TEST_F(OneHost, TheAnswerForAHostThatHasLeftIsForNobody) {
  ask(host, msg::GetAnglesRequest{});
  ports.disconnect(host);
  const std::size_t next = join();
  EXPECT_EQ(next, host) << "this test needs the same port";
  answer(line.sent.at(0), msg::GetAngles{});
  EXPECT_THAT(read(next), IsEmpty());
  EXPECT_TRUE(ports.is_quiet(next));
}

TEST_F(TwoHosts, AHostThatRestartsTheBoardHasTheLineForItself) {
  ask(first, msg::GetAnglesRequest{});
  ask(second, msg::BootMode3{});
  EXPECT_FALSE(line.is_taken) << "another request has not ended";
  EXPECT_EQ(ports.room(second), 0U);
  EXPECT_EQ(ports.room(first), 0U);
  const int before = wakes[second];
  answer(line.sent.at(0), msg::GetAngles{});
  EXPECT_EQ(wakes[second], before + 1) << "it may send now";
  EXPECT_EQ(read(first), frame_of(msg::GetAngles{}));
  EXPECT_TRUE(line.is_taken);
  EXPECT_EQ(ports.exclusive_host(), second);
  EXPECT_EQ(line.raw, frame_of(msg::BootMode3{}));
  EXPECT_EQ(ports.room(first), 0U);
  line.raw.clear();
  const Bytes sync{0x7F, 0x00, '>', 0xFF};
  ports.receive(second, sync);
  EXPECT_EQ(line.raw, sync);
  const Bytes acknowledgement{0x79, 0x1F};
  ports.raw_arrived(acknowledgement);
  EXPECT_EQ(wakes[second], before + 2) << "it has bytes to read";
  EXPECT_EQ(read(second), acknowledgement);
  EXPECT_THAT(read(first), IsEmpty());
  // New firmware introduces itself, some seconds later.
  const Bytes introduction = frame_of(msg::BoardInfo{});
  ports.raw_arrived(introduction);
  ports.tick();
  EXPECT_TRUE(line.is_taken) << "that was the board before the restart";
  read(second);
  time = time + seconds(20);
  ports.raw_arrived(introduction);
  EXPECT_EQ(read(second), introduction);
  ports.tick();
  EXPECT_FALSE(line.is_taken);
  EXPECT_NE(ports.room(first), 0U);
}

TEST_F(OneHost, WhatArrivesTogetherWithARestartIsNotLost) {
  Bytes bytes = frame_of(msg::BootMode3{});
  const Bytes more = frame_of(msg::BoardInfoRequest{});
  bytes.insert(bytes.end(), more.begin(), more.end());
  ports.receive(host, bytes);
  EXPECT_EQ(ports.exclusive_host(), host);
  EXPECT_EQ(line.raw, bytes);
}

TEST_F(Bridge, AfterAPlainRestartALineThatWorksIsNotOpenedAgain) {
  for (const bool works : {true, false}) {
    const std::size_t host = join();
    line.waiting = 0;
    line.reopened = 0;
    ask(host, msg::ResetRequest{});
    EXPECT_TRUE(line.is_taken);
    line.raw.clear();
    line.waiting = 0;
    for (int i = 0; i < 49; ++i) {
      time = time + sbgc::milliseconds(100);
      ports.tick();
    }
    EXPECT_THAT(line.raw, IsEmpty()) << "no other host can be waiting";
    for (int i = 0; i < 60 && line.is_taken; ++i) {
      time = time + sbgc::milliseconds(100);
      ports.tick();
      line.waiting = 0;
      if (works && !line.raw.empty()) ports.raw_arrived(frame_of(msg::BoardInfo{}));
    }
    EXPECT_FALSE(line.is_taken);
    EXPECT_EQ(line.reopened, works ? 0 : 1);
    EXPECT_THAT(read(host), IsEmpty()) << "it has not asked";
    ports.disconnect(host);
  }
}

TEST_F(OneHost, NothingIsSentIntoRawBytesAfterARestart) {
  join();
  ask(host, msg::ResetRequest{});
  ports.receive(host, Bytes{0x7F});
  line.raw.clear();
  line.waiting = 0;
  for (int i = 0; i < 100; ++i) {
    time = time + sbgc::milliseconds(100);
    ports.tick();
  }
  EXPECT_THAT(line.raw, IsEmpty());
  EXPECT_TRUE(line.is_taken);
}

TEST_F(OneHost, ABootloaderMayTakeItsTime) {
  ask(host, msg::BootMode3{});
  ports.receive(host, Bytes{0x7F});
  time = time + seconds(50);
  ports.tick();
  EXPECT_TRUE(line.is_taken);
  time = time + seconds(20);
  ports.tick();
  EXPECT_FALSE(line.is_taken);
}

TEST_F(TwoHosts, TheLastSamplesOfAStreamAreForNobody) {
  ask(first, stream(20));
  ports.disconnect(first);
  send(msg::RealtimeData3{});
  EXPECT_THAT(read(second), IsEmpty());
}

TEST_F(OneHost, ASilentStreamIsStartedAgain) {
  ask(host, stream(20));
  time = time + seconds(2);
  send(msg::RealtimeData3{});
  time = time + seconds(2);
  ports.tick();
  EXPECT_THAT(intervals(), ElementsAre(20));
  time = time + seconds(2);
  ports.tick();
  ports.tick();
  EXPECT_THAT(intervals(), ElementsAre(20, 20));
}

TEST_F(OneHost, ABoardThatIsSilentAfterARestartOfItsStreamIsChecked) {
  ask(host, stream(20));
  for (int i = 0; i < 2; ++i) {
    EXPECT_EQ(line.checks, 0);
    time = time + seconds(4);
    ports.tick();
  }
  EXPECT_EQ(line.checks, 1);
}

TEST_F(OneHost, ABoardThatConfirmsASilentStreamIsNotChecked) {
  ask(host, stream(20));
  for (int i = 0; i < 5; ++i) {
    time = time + seconds(4);
    ports.tick();
    time = time + seconds(1);
    answer(line.sent.back(), confirmation_of_stream());
  }
  EXPECT_EQ(line.checks, 0);
}

TEST_F(OneHost, ABoardThatAnswersNoRequestIsChecked) {
  const auto ask_in_vain = [&] {
    ask(host, msg::GetAnglesRequest{});
    ports.ended(line.sent.back().tag, ErrorCode::timeout);
    ports.tick();
  };
  ask_in_vain();
  ask_in_vain();
  send(msg::Reset{});
  ask_in_vain();
  ask_in_vain();
  EXPECT_EQ(line.checks, 0);
  ask_in_vain();
  EXPECT_EQ(line.checks, 1);
}

TEST_F(OneHost, AHostWithTheLineForItselfSendsNoFasterThanTheLine) {
  ask(host, msg::BootMode3{});
  std::size_t sent = 0;
  for (; ports.room(host) != 0; sent += ports.room(host)) {
    ASSERT_LE(sent, 10'000U);
    ports.receive(host, Bytes(ports.room(host), 0x7F));
  }
  EXPECT_LE(line.waiting, BridgePorts::max_raw);
  const int before = wakes[0];
  line.waiting = 0;
  ports.raw_sent();
  EXPECT_NE(ports.room(host), 0U);
  EXPECT_GT(wakes[0], before);
}

TEST_F(OneHost, AHostWithTheLineForItselfLosesNoBytes) {
  ask(host, msg::BootMode3{});
  Bytes all;
  for (int i = 0; i < 300; ++i) {
    const Bytes piece(1000, static_cast<std::uint8_t>(i));
    ports.raw_arrived(piece);
    all.insert(all.end(), piece.begin(), piece.end());
  }
  EXPECT_EQ(read(host), all);
}

TEST_F(TwoHosts, AHostWithTheLineForItselfThatDoesNotReadMustLeave) {
  ask(first, msg::BootMode3{});
  std::size_t arrived = 0;
  for (; !ports.must_leave(first); arrived += 1000) {
    ASSERT_LE(arrived, 10'000'000U);
    ports.raw_arrived(Bytes(1000, 0x55));
  }
  EXPECT_FALSE(line.is_taken);
  EXPECT_THAT(logged, Contains("host 0 must leave: it does not read what the board sends"));
  EXPECT_NE(ports.room(second), 0U);
  EXPECT_EQ(ports.room(first), 0U);
  // It gets what came before the loss, and nothing after it.
  ports.raw_arrived(Bytes(1));
  send(msg::Reset{});
  EXPECT_EQ(read(first), Bytes(arrived - 1000, 0x55));
  ask(first, msg::GetAnglesRequest{});
  EXPECT_THAT(line.sent, IsEmpty());
  EXPECT_TRUE(ports.is_quiet(first)) << "its connection ends now";
}

TEST_F(OneHost, NoByteIsSentTwiceOfAHostWithTheLineForItself) {
  ask(host, msg::BootMode3{});
  line.raw.clear();
  // A false start of a frame, and a frame in its body.
  Bytes bytes{'>', 86, 200, 30};
  const Bytes inner = frame_of(msg::BoardInfoRequest{});
  bytes.insert(bytes.end(), inner.begin(), inner.end());
  ports.receive(host, bytes);
  time = time + seconds(1);
  ports.tick();
  EXPECT_EQ(line.raw, bytes);
  ports.receive(host, bytes);
  ports.line_lost();
  time = time + seconds(1);
  ports.tick();
  EXPECT_THAT(line.sent, IsEmpty()) << "raw bytes are no requests";
}

TEST_F(TwoHosts, AHostThatLeavesGivesTheLineBack) {
  ask(first, msg::BootMode3{});
  EXPECT_TRUE(line.is_taken);
  ports.disconnect(first);
  EXPECT_FALSE(line.is_taken);
  EXPECT_NE(ports.room(second), 0U);
}

TEST_F(TwoHosts, ALostLineIsNobodysAnyMore) {
  ask(first, msg::BootMode3{});
  const std::vector<int> before = wakes;
  ports.line_lost();
  EXPECT_THAT(wakes, ElementsAre(before[first] + 1, before[second] + 1));
  EXPECT_FALSE(ports.exclusive_host());
  EXPECT_NE(ports.room(second), 0U);
}

msg::BoardInfoRequestExt opening() {
  msg::BoardInfoRequestExt request;
  EXPECT_TRUE(request.password.emplace().assign(std::string_view("sesame")));
  return request;
}

TEST_F(OneHost, APasswordIsRefusedAndNotLogged) {
  ask(host, opening());
  msg::PassProtectWrite protect;
  EXPECT_TRUE(protect.new_password.assign(std::string_view("sesame")));
  ask(host, protect);
  EXPECT_THAT(line.sent, IsEmpty());
  msg::ErrorExt error;
  error.error_code = msg::BoardErrorCode::wrong_state;
  Bytes expected;
  for (const auto command : {opening().command, protect.command}) {
    error.cmd_id = command;
    const Bytes frame = frame_of(error);
    expected.insert(expected.end(), frame.begin(), frame.end());
  }
  EXPECT_EQ(read(host), expected);
  ASSERT_THAT(logged, SizeIs(2));
  for (const std::string& text : logged) {
    EXPECT_NE(text.find("--allow-passwords"), std::string::npos);
    EXPECT_EQ(text.find("sesame"), std::string::npos);
  }
  ask(host, msg::BoardInfoRequestExt{});
  protect.new_password.clear();
  ask(host, protect);
  EXPECT_THAT(line.sent, SizeIs(2)) << "neither has a password";
}

TEST_F(OneHost, APasswordDoesNotPassWithTheLineForItselfEither) {
  ask(host, msg::BootMode3{});
  const Bytes before = line.raw;
  const Bytes frame = frame_of(opening());
  ports.receive(host, frame);
  EXPECT_EQ(line.raw, before);
  // In two parts, the end is missing, so it is none for the board.
  ports.receive(host, std::span(frame).first(7));
  ports.receive(host, std::span(frame).subspan(7));
  Bytes start = before;
  start.insert(start.end(), frame.begin(), frame.begin() + 7);
  EXPECT_EQ(line.raw, start);
}

TEST_F(Bridge, AnAllowedPasswordPasses) {
  BridgePorts allowing{line, [this] { return time; }, {}, true};
  const auto host = allowing.connect(false, [] {});
  allowing.receive(*host, frame_of(opening()));
  EXPECT_THAT(line.sent, SizeIs(1));
}

TEST_F(Bridge, SilentHostsAreReplaced) {
  for (std::size_t i = 0; i < HostPlaces::max_hosts; ++i) join();
  ports.keep_place(0);
  const std::size_t reserved = join();
  EXPECT_FALSE(ports.must_leave(1)) << "it has just come";
  ask(2, msg::GetAnglesRequest{});
  answer(line.sent.back(), msg::GetAngles{});
  read(2);
  ports.receive(3, Bytes{'>', 1, 2});
  time = time + seconds(2);
  for (std::size_t port = 1; port < HostPlaces::max_hosts; ++port) {
    ask(join(), msg::GetAnglesRequest{});
    EXPECT_EQ(ports.must_leave(port), port != 2) << "it has sent a whole frame";
    ports.ended(line.sent.back().tag);
    if (port != 2) ports.disconnect(port);
  }
  EXPECT_FALSE(ports.must_leave(0)) << "a terminal stays";
  EXPECT_TRUE(ports.must_leave(reserved)) << "for the last one, all others have spoken";
}

TEST_F(Bridge, TheLongestSilentHostIsReplaced) {
  for (std::size_t i = 0; i < HostPlaces::max_hosts; ++i) {
    ask(join(), msg::GetAnglesRequest{});
    if (i != 1) ports.ended(line.sent.back().tag);
  }
  time = time + seconds(9);
  send(msg::Reset{});
  read(0);
  ask(2, msg::GetAnglesRequest{});
  ports.ended(line.sent.back().tag);
  time = time + seconds(1);
  for (std::size_t port = 3; port < HostPlaces::max_hosts; ++port) {
    join();
    EXPECT_TRUE(ports.must_leave(port));
  }
  join();
  EXPECT_FALSE(ports.must_leave(0)) << "it was sent something";
  EXPECT_FALSE(ports.must_leave(1)) << "it waits for its answer";
  EXPECT_FALSE(ports.must_leave(2)) << "it has sent something";
}

class FullBridge : public Bridge {
 protected:
  FullBridge() {
    for (std::size_t i = 0; i < HostPlaces::max_hosts; ++i) {
      ask(join(), stream(10));
      answer(line.sent.back(), confirmation_of_stream());
      read(i);
    }
    time = time + seconds(60);
  }
  template <class M>
  static Bytes refusal_of(const M&) {
    return frame_of(error_of(M::command, msg::BoardErrorCode::temporary));
  }
};

TEST_F(FullBridge, TheReservedPlaceServesAStop) {
  const std::size_t host = join();
  const std::size_t before = line.sent.size();
  ask(host, msg::BoardInfoRequest{});
  ask(host, msg::BoardInfo3Request{});
  ask(host, msg::GetAnglesRequest{});
  ask(host, msg::RealtimeData3Request{});
  ask(host, turning(0));
  ask(host, msg::MotorsOff{});
  EXPECT_THAT(line.sent, SizeIs(before + 6));
  ask(host, turning(5));
  EXPECT_EQ(read(host), refusal_of(msg::Control{}));
  ask(host, msg::MotorsOn{});
  EXPECT_EQ(read(host), refusal_of(msg::MotorsOn{}));
  ask(host, stream(10));
  EXPECT_EQ(read(host), refusal_of(msg::DataStreamInterval{}));
  ask(host, msg::Reset{});
  read(host);
  EXPECT_THAT(line.sent, SizeIs(before + 6));
  time = time + sbgc::milliseconds(14'999);
  ports.tick();
  EXPECT_FALSE(ports.must_leave(host));
  join();
  EXPECT_FALSE(ports.must_leave(host)) << "it has sent a stop";
  time = time + sbgc::milliseconds(1);
  ports.tick();
  EXPECT_TRUE(ports.must_leave(host));
  for (std::size_t port = 0; port < HostPlaces::max_hosts; ++port) {
    EXPECT_FALSE(ports.must_leave(port)) << "they have streams";
  }
}

TEST_F(FullBridge, OthersLearnThatThereIsNoPlace) {
  const std::size_t reserved = join();
  const std::size_t host = join();
  const std::size_t before = line.sent.size();
  ask(host, msg::BoardInfoRequest{});
  EXPECT_EQ(read(host), refusal_of(msg::BoardInfoRequest{}));
  EXPECT_TRUE(ports.must_leave(host));
  EXPECT_THAT(line.sent, SizeIs(before));
  const std::size_t mute = join();
  time = time + seconds(2);
  ports.tick();
  EXPECT_TRUE(ports.must_leave(mute));
  EXPECT_FALSE(ports.must_leave(reserved));
  const std::size_t later = join();
  EXPECT_TRUE(ports.must_leave(reserved));
  ask(later, turning(0));
  EXPECT_EQ(line.sent.back().request.id, static_cast<std::uint8_t>(msg::Control::command));
  std::size_t more = 0;
  while (ports.connect(false, {})) ASSERT_LT(++more, HostPlaces::max_ports);
  time = time + seconds(60);
  ports.disconnect(0);
  EXPECT_EQ(join(), 0U) << "whoever finds a place has a port";
}

TEST_F(OneHost, NoiseIsNoRequest) {
  Bytes bytes{0x7F, 0x00, '>', 1, 2, 3, 4};
  const Bytes frame = frame_of(msg::GetAnglesRequest{});
  bytes.insert(bytes.end(), frame.begin(), frame.end());
  ports.receive(host, bytes);
  EXPECT_THAT(line.sent, SizeIs(1));
}

TEST_F(OneHost, ARequestAfterABrokenOneIsFoundWhenTheHostIsSilent) {
  Bytes bytes = frame_of(msg::SetAdjVarsVal{});
  bytes.resize(4);  // its body is missing
  bytes[2] = 200;
  bytes[3] = static_cast<std::uint8_t>(bytes[1] + bytes[2]);
  const Bytes frame = frame_of(msg::GetAnglesRequest{});
  bytes.insert(bytes.end(), frame.begin(), frame.end());
  ports.receive(host, bytes);
  time = time + BridgePorts::idle;
  ports.tick();
  EXPECT_THAT(line.sent, IsEmpty()) << "the rest may still come";
  time = time + sbgc::milliseconds(1);
  ports.tick();
  EXPECT_THAT(line.sent, SizeIs(1));
  ports.receive(host, bytes);
  ports.end_input(host);
  EXPECT_THAT(line.sent, SizeIs(2)) << "it sends no more";
}

}  // namespace
}  // namespace sbgc::tools
