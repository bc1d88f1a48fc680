// Tests of the client that connects again by itself.

#include <atomic>
#include <chrono>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sbgc/client/client.hpp>
#include <sbgc/client/reconnecting_client.hpp>
#include <sbgc/client/speed_control.hpp>
#include <sbgc/messages.hpp>

#include "collector.hpp"
#include "emulated_board.hpp"
#include "manual_clock.hpp"
#include "scripted_board.hpp"

namespace sbgc::test {
namespace {

using std::chrono::steady_clock;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using Ms = std::chrono::milliseconds;

ReconnectOptions quick_reconnect() {
  ReconnectOptions options;
  options.connection = quick();
  options.connection.detect_line = false;
  options.first_pause = Ms(1);
  options.longest_pause = Ms(5);
  options.longest_silence = Ms(0);
  return options;
}

/// The ports of a machine, as a test sets them.
class Ports {
 public:
  void set(std::vector<io::PortInfo> ports) {
    const std::lock_guard lock(mutex_);
    ports_ = std::move(ports);
  }
  std::function<io::PortList()> lister() {
    return [this] {
      const std::lock_guard lock(mutex_);
      return io::PortList{ports_, {}};
    };
  }

 private:
  std::mutex mutex_;
  std::vector<io::PortInfo> ports_;
};

io::PortInfo usb_port(const std::string& name, const std::string& serial_number) {
  return {name, "adapter", io::UsbInfo{0x10c4, 0xea60, "", "adapter", serial_number}};
}

class Reconnecting : public ::testing::Test {
 protected:
  /// Returns lines to the board as long as the cable is plugged in.
  TransportFactory cable() {
    return [this, line = board.line()](const asio::any_io_executor& executor) {
      ++attempts;
      return is_plugged ? line(executor) : nullptr;
    };
  }
  Client connect(const ReconnectOptions& options = quick_reconnect()) {
    return watched(connect_over(cable(), options));
  }
  Client connect(const std::string& path, const ReconnectOptions& options) {
    return watched(Client::connect(path, options));
  }
  void pull() {
    is_plugged = false;
    board.unplug();
  }
  bool wait_for(LinkState state, std::size_t times = 1) {
    return changes.wait_until([&](const auto& all) {
      return std::ranges::count(all, state, &LinkChange::state) >= static_cast<long>(times);
    });
  }
  std::vector<LinkState> states() {
    std::vector<LinkState> result;
    for (const LinkChange& one : changes.wait_for(0)) result.push_back(one.state);
    return result;
  }
  /// Waits until the board has received `count` requests for a stream.
  void wait_for_stream_requests(std::size_t count) {
    while (board.count<msg::DataStreamInterval>() < count) std::this_thread::sleep_for(Ms(1));
  }

  EmulatedBoard board;
  std::atomic<bool> is_plugged = true;
  std::atomic<int> attempts = 0;
  Collector<LinkChange> changes;
  Subscription watching;

 private:
  Client watched(Result<Client> client) {
    if (!client) throw std::runtime_error(client.error().message);
    watching = client->on_change([this](const LinkChange& change) { changes.add(change); });
    return *std::move(client);
  }
};

TEST_F(Reconnecting, TheFirstConnectionMustSucceed) {
  is_plugged = false;
  const auto client = connect_over(cable(), quick_reconnect());
  ASSERT_FALSE(client);
  EXPECT_EQ(client.error().code, ErrorCode::not_found);
  EXPECT_EQ(attempts, 1);
}

TEST_F(Reconnecting, ALineThatIsLostComesBack) {
  Client client = connect();
  EXPECT_TRUE(client.get_angles());
  pull();
  ASSERT_TRUE(wait_for(LinkState::searching));
  const auto during = client.get_angles();
  ASSERT_FALSE(during);
  EXPECT_EQ(during.error().code, ErrorCode::not_connected);
  EXPECT_FALSE(client.is_connected());
  is_plugged = true;
  ASSERT_TRUE(wait_for(LinkState::connected));
  EXPECT_TRUE(client.get_angles());
  EXPECT_TRUE(client.is_connected());
  EXPECT_EQ(client.connections(), 2U);
  EXPECT_THAT(states(), ElementsAre(LinkState::lost, LinkState::searching, LinkState::connected));
}

TEST_F(Reconnecting, TheFormerNameDoesIt) {
  ReconnectingClient client = *reconnecting_over(cable(), quick_reconnect());
  pull();
  while (client.is_connected()) std::this_thread::sleep_for(Ms(1));
  is_plugged = true;
  while (client.connections() < 2) std::this_thread::sleep_for(Ms(1));
}

TEST_F(Reconnecting, CallsCanWaitForTheConnection) {
  ReconnectOptions options = quick_reconnect();
  options.calls = OutagePolicy::wait;
  Client client = connect(options);
  pull();
  ASSERT_TRUE(wait_for(LinkState::searching));
  const auto begin = steady_clock::now();
  const auto overdue = client.call(msg::GetAnglesRequest{}, {.timeout = Ms(30)});
  ASSERT_FALSE(overdue);
  EXPECT_EQ(overdue.error().code, ErrorCode::not_connected);
  EXPECT_GE(steady_clock::now() - begin, Ms(30));
  std::thread plugging([this] {
    while (attempts < 10) std::this_thread::sleep_for(Ms(1));
    is_plugged = true;
  });
  EXPECT_TRUE(client.call(msg::GetAnglesRequest{}, {.timeout = std::chrono::seconds(60)}));
  plugging.join();
}

TEST_F(Reconnecting, AStreamThatWaitsForTheConnectionHasOneDeadline) {
  board.on_lost([](const Packet& request) { return is<msg::DataStreamInterval>(request); });
  ReconnectOptions options = quick_reconnect();
  options.calls = OutagePolicy::wait;
  Client client = connect(options);
  pull();
  ASSERT_TRUE(wait_for(LinkState::searching));
  std::thread plugging([this] {
    while (attempts < 10) std::this_thread::sleep_for(Ms(1));
    is_plugged = true;
  });
  const auto stream = client.stream<msg::RealtimeData4>(Ms(100), [](const msg::RealtimeData4&) {},
                                                        {.timeout = Ms(3000), .retries = 0});
  plugging.join();
  ASSERT_FALSE(stream);
  EXPECT_THAT(stream.error().message, Not(HasSubstr("within 3000 ms")));
}

TEST_F(Reconnecting, StreamsAndSubscriptionsGoOn) {
  Client client = connect();
  Collector<msg::RealtimeData4> fast;
  Collector<msg::RealtimeData3> slow;
  Collector<msg::GetAngles> angles;
  auto first = client.stream<msg::RealtimeData4>(
      Ms(20), [&](const msg::RealtimeData4& sample) { fast.add(sample); });
  auto second = client.stream<msg::RealtimeData3>(
      Ms(100), [&](const msg::RealtimeData3& sample) { slow.add(sample); });
  ASSERT_TRUE(first && second);
  const auto third =
      client.subscribe<msg::GetAngles>([&](const msg::GetAngles& one) { angles.add(one); });
  pull();
  ASSERT_TRUE(wait_for(LinkState::searching));
  board.clear_log();
  is_plugged = true;
  ASSERT_TRUE(wait_for(LinkState::connected));
  wait_for_stream_requests(2);
  std::vector<std::pair<msg::CommandFromBoard, int>> wanted;
  for (const Packet& one : board.log()) {
    if (!is<msg::DataStreamInterval>(one)) continue;
    const auto request = message<msg::DataStreamInterval>(one);
    wanted.emplace_back(static_cast<msg::CommandFromBoard>(request.cmd_id),
                        request.interval_ms.raw());
  }
  EXPECT_THAT(wanted, ElementsAre(std::pair(msg::RealtimeData4::command, 20),
                                  std::pair(msg::RealtimeData3::command, 100)));
  const std::size_t fast_before = fast.wait_for(0).size();
  const std::size_t slow_before = slow.wait_for(0).size();
  board.skip(Ms(300));
  fast.wait_for(fast_before + 10);
  slow.wait_for(slow_before + 2);
  EXPECT_TRUE(client.get_angles());
  angles.wait_for(1);
}

TEST_F(Reconnecting, PollsOfOldFirmwareGoOn) {
  emulator::BoardOptions old = board.options();
  old.firmware = msg::FirmwareVersion(2439);
  board.become(old);
  Client client = connect();
  std::atomic<int> samples = 0;
  const auto stream =
      client.stream<msg::RealtimeData4>(Ms(5), [&](const msg::RealtimeData4&) { ++samples; });
  ASSERT_TRUE(stream) << stream.error().message;
  pull();
  ASSERT_TRUE(wait_for(LinkState::searching));
  const int before = samples;
  is_plugged = true;
  ASSERT_TRUE(wait_for(LinkState::connected));
  while (samples < before + 5) std::this_thread::sleep_for(Ms(1));
}

TEST_F(Reconnecting, ASpeedEndsWithItsLineAndCanBeSetAgain) {
  const auto commands = [&] { return board.count<msg::Control>(); };
  Client client = connect();
  SpeedControl control(client, {.silence = Ms(60'000), .repeat = Ms(20)});
  EXPECT_EQ(control.state(), SpeedControl::State::idle);
  EXPECT_FALSE(control.refresh());
  EXPECT_TRUE(control.stop());
  const Axes<msg::ControlSpeed> speed{.yaw = msg::ControlSpeed(50)};
  ASSERT_TRUE(control.set(speed));
  while (commands() < 2) std::this_thread::sleep_for(Ms(1));
  pull();
  ASSERT_TRUE(wait_for(LinkState::searching));
  const auto during = control.set(speed);
  ASSERT_FALSE(during);
  EXPECT_EQ(during.error().code, ErrorCode::not_connected);
  is_plugged = true;
  ASSERT_TRUE(wait_for(LinkState::connected));
  const std::size_t before = commands();
  std::this_thread::sleep_for(Ms(100));
  EXPECT_EQ(commands(), before) << "nothing turns unasked";
  EXPECT_FALSE(control.refresh()) << "also not by keeping what has ended";
  ASSERT_TRUE(control.set(speed));
  while (commands() < before + 2) std::this_thread::sleep_for(Ms(1));
  EXPECT_EQ(control.state(), SpeedControl::State::turning);
  EXPECT_TRUE(control.stop());
  EXPECT_TRUE(control.wait());
  EXPECT_EQ(control.state(), SpeedControl::State::idle);
}

TEST_F(Reconnecting, SubscriptionsDoNotWaitForStreams) {
  Client client = connect();
  auto stream = client.stream<msg::RealtimeData4>(Ms(20), [](const msg::RealtimeData4&) {});
  ASSERT_TRUE(stream);
  Collector<msg::GetAngles> angles;
  const auto subscription =
      client.subscribe<msg::GetAngles>([&](const msg::GetAngles& one) { angles.add(one); });
  board.on_answer_lost(is<msg::DataStreamInterval>);  // starting the stream does not succeed
  pull();
  ASSERT_TRUE(wait_for(LinkState::searching));
  is_plugged = true;
  ASSERT_TRUE(wait_for(LinkState::connected));
  EXPECT_TRUE(client.get_angles());
  angles.wait_for(1);
}

TEST_F(Reconnecting, ACancelledStreamStaysSo) {
  Client client = connect();
  std::atomic<int> cancelled_samples = 0;
  Collector<msg::RealtimeData3> kept;
  auto cancelled = client.stream<msg::RealtimeData4>(
      Ms(20), [&](const msg::RealtimeData4&) { ++cancelled_samples; });
  auto other = client.stream<msg::RealtimeData3>(
      Ms(20), [&](const msg::RealtimeData3& sample) { kept.add(sample); });
  ASSERT_TRUE(cancelled && other);
  pull();
  ASSERT_TRUE(wait_for(LinkState::searching));
  cancelled->cancel();
  const int before = cancelled_samples;
  board.clear_log();
  is_plugged = true;
  ASSERT_TRUE(wait_for(LinkState::connected));
  wait_for_stream_requests(1);
  board.skip(Ms(200));
  kept.wait_for(5);
  EXPECT_EQ(cancelled_samples, before);
  EXPECT_EQ(board.count<msg::DataStreamInterval>(), 1U);
}

TEST_F(Reconnecting, ACancelledStreamEndsOnTheBoard) {
  Client client = connect();
  auto stream = client.stream<msg::RealtimeData4>(Ms(20), [](const msg::RealtimeData4&) {});
  ASSERT_TRUE(stream);
  stream->cancel();
  wait_for_stream_requests(2);
  EXPECT_EQ(message<msg::DataStreamInterval>(board.log().back()).interval_ms.raw(), 0);
}

TEST_F(Reconnecting, AStreamDuringAnOutageIsRefused) {
  Client client = connect();
  pull();
  ASSERT_TRUE(wait_for(LinkState::searching));
  const auto stream = client.stream<msg::RealtimeData4>(Ms(20), [](const msg::RealtimeData4&) {});
  ASSERT_FALSE(stream);
  EXPECT_EQ(stream.error().code, ErrorCode::not_connected);
}

TEST_F(Reconnecting, AnotherBoardIsRefused) {
  Client client = connect();
  const std::string number = client.identity().serial_number();
  emulator::BoardOptions other = board.options();
  pull();
  ASSERT_TRUE(wait_for(LinkState::searching));
  const emulator::BoardOptions own = other;
  other.device_id[0] ^= 0xFF;
  board.become(other);
  is_plugged = true;
  ASSERT_TRUE(wait_for(LinkState::other_board));
  const auto during = client.get_angles();
  ASSERT_FALSE(during);
  EXPECT_EQ(during.error().code, ErrorCode::not_connected);
  is_plugged = false;
  board.become(own);
  is_plugged = true;
  ASSERT_TRUE(wait_for(LinkState::connected));
  EXPECT_EQ(client.identity().serial_number(), number);
  EXPECT_TRUE(client.get_angles());
  EXPECT_THAT(states(), ElementsAre(LinkState::lost, LinkState::searching, LinkState::other_board,
                                    LinkState::connected));
  EXPECT_THAT(changes.wait_for(3)[2].message, HasSubstr(number));
}

TEST_F(Reconnecting, AnotherBoardCanBeAccepted) {
  ReconnectOptions options = quick_reconnect();
  options.other_board = OtherBoard::accept;
  Client client = connect(options);
  const std::string number = client.identity().serial_number();
  emulator::BoardOptions other = board.options();
  other.device_id[0] ^= 0xFF;
  pull();
  ASSERT_TRUE(wait_for(LinkState::searching));
  board.become(other);
  is_plugged = true;
  ASSERT_TRUE(wait_for(LinkState::connected));
  EXPECT_NE(client.identity().serial_number(), number);
  EXPECT_TRUE(wait_for(LinkState::other_board));
}

TEST_F(Reconnecting, ARestartEndsTheConnectionAndStreamsGoOn) {
  ManualClock clock;
  ReconnectOptions options = quick_reconnect();
  options.clock = &clock;
  Client client = connect(options);
  Collector<msg::RealtimeData4> samples;
  Collector<NoticeKind> notices;
  const auto noticing = client.on_notice([&](const Notice& notice) { notices.add(notice.kind); });
  auto stream = client.stream<msg::RealtimeData4>(
      Ms(20), [&](const msg::RealtimeData4& sample) { samples.add(sample); });
  ASSERT_TRUE(stream);
  EXPECT_TRUE(client.reset_ext({.confirm = msg::ResetOption::notify}));
  ASSERT_TRUE(wait_for(LinkState::lost));
  EXPECT_EQ(client.connections(), 1U) << "the board has not restarted yet";
  board.skip(std::chrono::seconds(3));
  board.clear_log();
  while (!client.is_connected()) {
    clock.advance(Ms(100));
    std::this_thread::sleep_for(Ms(1));
  }
  wait_for_stream_requests(1);
  const std::size_t before = samples.wait_for(0).size();
  board.skip(Ms(200));
  samples.wait_for(before + 5);
  EXPECT_THAT(notices.wait_for(1), Contains(NoticeKind::board_reset));
}

TEST_F(Reconnecting, AStreamThatFellSilentIsStartedAgain) {
  ManualClock clock;
  ReconnectOptions options = quick_reconnect();
  options.clock = &clock;
  options.longest_silence = std::chrono::seconds(3);
  Client client = connect(options);
  Collector<msg::RealtimeData4> samples;
  auto stream = client.stream<msg::RealtimeData4>(
      Ms(20), [&](const msg::RealtimeData4& sample) { samples.add(sample); });
  ASSERT_TRUE(stream);
  board.restart();  // without a word, as when the power fails; the line stays
  board.skip(std::chrono::seconds(5));
  board.clear_log();
  while (board.count<msg::DataStreamInterval>() == 0) {
    clock.advance(Ms(200));
    std::this_thread::sleep_for(Ms(2));
  }
  const std::size_t before = samples.wait_for(0).size();
  board.skip(Ms(200));
  samples.wait_for(before + 5);
  EXPECT_EQ(client.connections(), 1U);
}

TEST_F(Reconnecting, ASilentBoardIsLost) {
  ManualClock clock;
  ReconnectOptions options = quick_reconnect();
  options.clock = &clock;
  options.longest_silence = std::chrono::seconds(3);
  Client client = connect(options);
  auto stream = client.stream<msg::RealtimeData4>(Ms(20), [](const msg::RealtimeData4&) {});
  ASSERT_TRUE(stream);
  board.restart();
  board.on_lost([](const Packet&) { return true; });
  std::thread time([&] {
    while (client.is_connected()) {
      clock.advance(Ms(200));
      std::this_thread::sleep_for(Ms(2));
    }
  });
  EXPECT_TRUE(wait_for(LinkState::lost));
  time.join();
  EXPECT_THAT(changes.wait_for(1)[0].message, HasSubstr("does not respond"));
}

TEST_F(Reconnecting, ACheckFindsASilentBoard) {
  Client client = connect();
  client.check();
  while (board.count<msg::BoardInfoRequest>() < 2) std::this_thread::sleep_for(Ms(1));
  EXPECT_TRUE(client.get_angles());
  EXPECT_EQ(client.connections(), 1U);
  board.on_lost([](const Packet&) { return true; });
  client.check();
  ASSERT_TRUE(wait_for(LinkState::lost));
  EXPECT_THAT(changes.wait_for(1)[0].message, HasSubstr("does not respond"));
  board.on_lost({});
  EXPECT_TRUE(wait_for(LinkState::connected));
}

TEST_F(Reconnecting, ThePausesDoubleAndTheAttemptsEnd) {
  ManualClock clock;
  ReconnectOptions options = quick_reconnect();
  options.clock = &clock;
  options.first_pause = Ms(100);
  options.longest_pause = Ms(300);
  options.attempts = 4;
  Client client = connect(options);
  pull();
  ASSERT_TRUE(wait_for(LinkState::searching));
  const auto wait_for_attempts = [&](int count) {
    while (attempts < count) std::this_thread::sleep_for(Ms(1));
  };
  wait_for_attempts(2);
  std::this_thread::sleep_for(Ms(20));  // let a wrong early attempt happen
  EXPECT_EQ(attempts, 2);
  Ms passed{};
  std::vector<Ms> pauses;
  for (int next = 3; next <= 5; ++next) {
    passed = {};
    while (attempts < next) {
      clock.advance(Ms(10));
      passed += Ms(10);
      std::this_thread::sleep_for(Ms(2));
    }
    pauses.push_back(passed);
  }
  ASSERT_TRUE(wait_for(LinkState::given_up));
  EXPECT_GE(pauses[0], Ms(90));
  EXPECT_GE(pauses[1], Ms(190));
  EXPECT_GE(pauses[2], Ms(290));
  EXPECT_EQ(client.state(), LinkState::given_up);
  const auto later = client.get_angles();
  ASSERT_FALSE(later);
  EXPECT_EQ(later.error().code, ErrorCode::not_connected);
}

TEST_F(Reconnecting, DestructionEndsTheSearch) {
  ReconnectOptions options = quick_reconnect();
  options.first_pause = options.longest_pause = std::chrono::hours(1);
  std::optional<Client> client(connect(options));
  pull();
  ASSERT_TRUE(wait_for(LinkState::searching));
  while (attempts < 2) std::this_thread::sleep_for(Ms(1));
  const auto begin = steady_clock::now();
  client.reset();
  EXPECT_LT(steady_clock::now() - begin, std::chrono::seconds(10));
}

TEST_F(Reconnecting, DestructionEndsAnAttempt) {
  ReconnectOptions options = quick_reconnect();
  options.connection.timeout = std::chrono::hours(1);
  options.connection.retries = 90;
  std::optional<Client> client(connect(options));
  board.on_lost([](const Packet&) { return true; });
  board.unplug();
  ASSERT_TRUE(wait_for(LinkState::searching));
  while (attempts < 2) std::this_thread::sleep_for(Ms(1));
  const auto begin = steady_clock::now();
  client.reset();
  EXPECT_LT(steady_clock::now() - begin, std::chrono::seconds(10));
}

TEST_F(Reconnecting, ClosingEndsCallsThatWait) {
  ReconnectOptions options = quick_reconnect();
  options.calls = OutagePolicy::wait;
  Client client = connect(options);
  pull();
  ASSERT_TRUE(wait_for(LinkState::searching));
  std::thread closing([&] {
    std::this_thread::sleep_for(Ms(10));
    client.close();
  });
  const auto call = client.call(msg::GetAnglesRequest{}, {.timeout = std::chrono::hours(1)});
  closing.join();
  ASSERT_FALSE(call);
  EXPECT_EQ(call.error().code, ErrorCode::not_connected);
  EXPECT_TRUE(wait_for(LinkState::closed));
}

TEST_F(Reconnecting, AHandlerMustNotWait) {
  Client client = connect();
  Collector<ErrorCode> errors;
  const auto asking = client.on_change([&](const LinkChange&) {
    const auto angles = client.get_angles();
    if (!angles) errors.add(angles.error().code);
  });
  pull();
  EXPECT_EQ(errors.wait_for(1).front(), ErrorCode::invalid);
}

TEST_F(Reconnecting, AHandlerMayCancelItself) {
  Client client = connect();
  Subscription stream;
  std::atomic<int> samples = 0;
  auto begun = client.stream<msg::RealtimeData4>(Ms(20), [&](const msg::RealtimeData4&) {
    ++samples;
    stream.cancel();
  });
  ASSERT_TRUE(begun);
  stream = *std::move(begun);
  board.skip(Ms(100));
  wait_for_stream_requests(2);
  EXPECT_EQ(samples, 1);
}

TEST_F(Reconnecting, RawRequestsGetTheirFrames) {
  Client client = connect();
  auto request = raw_request(static_cast<std::uint8_t>(msg::GetAnglesRequest::command), {});
  ASSERT_TRUE(request);
  Collector<Packet> frames;
  Collector<bool> all;
  request->on_frame = [&](const Frame& frame) {
    frames.add({frame.id, {frame.body.begin(), frame.body.end()}});
  };
  const auto watching_frames =
      client.on_frame([&](const BoardFrame& frame) { all.add(frame.belongs_to_call); });
  Collector<bool> ends;
  client.start_raw(*request, {}, [&](const Result<Reply>& reply) { ends.add(bool{reply}); });
  EXPECT_TRUE(ends.wait_for(1).front());
  EXPECT_TRUE(is<msg::GetAngles>(frames.wait_for(1).front()));
  EXPECT_THAT(all.wait_for(1), ElementsAre(true));
}

class Replugged : public Reconnecting {
 protected:
  void SetUp() override {
    path = board.serve_terminal();
    options = quick_reconnect();
    options.list_ports = ports.lister();
  }
  /// Plugs the adapter in as another port.
  void replug(const std::vector<io::PortInfo>& others = {}) {
    ports.set(others);
    const std::string before = path;
    path = board.serve_terminal();
    if (path == before) path = board.serve_terminal();
    ASSERT_NE(path, before);
  }

  Ports ports;
  std::string path;
  ReconnectOptions options;
};

TEST_F(Replugged, AnAdapterIsFoundUnderAnotherName) {
  ports.set({usb_port("/dev/nothing", "X"), usb_port(path, "A")});
  Client client = connect(path, options);
  replug({usb_port("/dev/nothing", "X")});
  ASSERT_TRUE(wait_for(LinkState::searching));
  ports.set({usb_port("/dev/nothing", "X"), usb_port(path, "A")});
  ASSERT_TRUE(wait_for(LinkState::connected));
  EXPECT_TRUE(client.get_angles());
  EXPECT_THAT(client.description(), HasSubstr(path));
}

TEST_F(Replugged, AnAdapterWithoutSerialNumberMustBeTheOnlyOne) {
  ports.set({usb_port(path, "")});
  Client client = connect(path, options);
  replug();
  ASSERT_TRUE(wait_for(LinkState::searching));
  ports.set({usb_port("/dev/nothing", ""), usb_port(path, "")});
  Collector<std::string> reasons;
  while (client.get_angles().error().message.find("2 adapters look like") == std::string::npos) {
    std::this_thread::sleep_for(Ms(1));
  }
  EXPECT_EQ(client.connections(), 1U);
  ports.set({usb_port(path, "")});
  ASSERT_TRUE(wait_for(LinkState::connected));
  EXPECT_TRUE(client.get_angles());
}

TEST_F(Replugged, AnotherAdapterUnderTheOldNameIsLeftAlone) {
  ports.set({usb_port(path, "A")});
  const std::string old = path;
  Client client = connect(path, options);
  replug();
  ASSERT_TRUE(wait_for(LinkState::searching));
  ports.set({usb_port(old, "B")});
  while (client.get_angles().error().message.find("not plugged in") == std::string::npos) {
    std::this_thread::sleep_for(Ms(1));
  }
  EXPECT_EQ(client.connections(), 1U);
}

}  // namespace
}  // namespace sbgc::test
