// Tests of the client that connects again by itself.

#include <sbgc/client/reconnecting_client.hpp>
#include <sbgc/client/speed_control.hpp>

#include "testing.hpp"

namespace sbgc::test {
namespace {

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

class Reconnecting : public CableTest {
 protected:
  Client connect(const ReconnectOptions& options = quick_again()) {
    return watched(connect_over(cable(), options));
  }
  Client connect(const std::string& path, const ReconnectOptions& options) {
    return watched(Client::connect(path, options));
  }
  /// Waits until the board has received `count` requests for a stream.
  void wait_for_stream_requests(std::size_t count) {
    wait_for_requests<msg::DataStreamInterval>(count);
  }

  ReconnectOptions on_clock() {
    ReconnectOptions options = quick_again();
    options.clock = &clock;
    return options;
  }

  ManualClock clock;
  Subscription watching;

 private:
  Client watched(Result<Client> client) {
    client = checked(std::move(client));
    watching = client->on_change([this](const LinkChange& change) { watch(change); });
    return *std::move(client);
  }
};

TEST_F(Reconnecting, TheFirstConnectionMustSucceed) {
  is_plugged = false;
  EXPECT_THAT(connect_over(cable(), quick_again()), fails(ErrorCode::not_found));
  EXPECT_EQ(attempts, 1);
}

TEST_F(Reconnecting, ALineThatIsLostComesBack) {
  Client client = connect();
  EXPECT_TRUE(client.get_angles());
  pull();
  EXPECT_THAT(client.get_angles({}, {.timeout = std::chrono::hours(1)}),
              fails(ErrorCode::not_connected));
  EXPECT_FALSE(client.is_connected());
  plug();
  EXPECT_TRUE(client.get_angles());
  EXPECT_TRUE(client.is_connected());
  EXPECT_EQ(client.connections(), 2U);
  EXPECT_THAT(states(), ElementsAre(LinkState::lost, LinkState::searching, LinkState::connected));
}

TEST_F(Reconnecting, TheFormerNameDoesIt) {
  ReconnectingClient client = *reconnecting_over(cable(), quick_again());
  board.unplug();
  wait_until([&] { return client.connections() >= 2; });
}

TEST_F(Reconnecting, CallsCanWaitForTheConnection) {
  Client client = connect(quick_again(OutagePolicy::wait));
  pull();
  const auto begin = std::chrono::steady_clock::now();
  EXPECT_THAT(client.call(msg::GetAnglesRequest{}, {.timeout = Ms(30)}),
              fails(ErrorCode::not_connected));
  EXPECT_GE(std::chrono::steady_clock::now() - begin, Ms(30));
  std::thread plugging([this] {
    wait_until([&] { return attempts >= 10; });
    is_plugged = true;
  });
  EXPECT_TRUE(client.call(msg::GetAnglesRequest{}, {.timeout = std::chrono::seconds(60)}));
  plugging.join();
}

TEST_F(Reconnecting, AStreamThatWaitsForTheConnectionHasOneDeadline) {
  board.on_lost([](const Packet& request) { return is<msg::DataStreamInterval>(request); });
  Client client = connect(quick_again(OutagePolicy::wait));
  pull();
  std::thread plugging([this] {
    wait_until([&] { return attempts >= 10; });
    is_plugged = true;
  });
  const auto stream = client.stream<msg::RealtimeData4>(Ms(100), [](const auto&) {},
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
  auto first = stream_into(fast, client, Ms(20));
  auto second = stream_into(slow, client, Ms(100));
  const auto third = subscribe_into(angles, client);
  pull();
  board.clear_log();
  plug();
  wait_for_stream_requests(2);
  std::vector<std::pair<msg::CommandFromBoard, int>> wanted;
  for (const auto& one : board.requests<msg::DataStreamInterval>()) {
    wanted.emplace_back(static_cast<msg::CommandFromBoard>(one.cmd_id), one.interval_ms.raw());
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
  Collector<msg::RealtimeData4> samples;
  auto stream = stream_into(samples, client, Ms(5));
  pull();
  const std::size_t before = samples.wait_for(0).size();
  plug();
  samples.wait_for(before + 5);
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
  wait_until([&] { return commands() >= 2; });
  pull();
  EXPECT_THAT(control.set(speed), fails(ErrorCode::not_connected));
  plug();
  const std::size_t before = commands();
  std::this_thread::sleep_for(Ms(100));
  EXPECT_EQ(commands(), before) << "nothing turns unasked";
  EXPECT_FALSE(control.refresh()) << "also not by keeping what has ended";
  ASSERT_TRUE(control.set(speed));
  wait_until([&] { return commands() >= before + 2; });
  EXPECT_EQ(control.state(), SpeedControl::State::turning);
  EXPECT_TRUE(control.stop());
  EXPECT_TRUE(control.wait());
  EXPECT_EQ(control.state(), SpeedControl::State::idle);
}

TEST_F(Reconnecting, SubscriptionsDoNotWaitForStreams) {
  Client client = connect();
  Collector<msg::RealtimeData4> samples;
  const auto stream = stream_into(samples, client, Ms(20));
  Collector<msg::GetAngles> angles;
  const auto subscription = subscribe_into(angles, client);
  board.on_answer_lost(is<msg::DataStreamInterval>);  // starting the stream does not succeed
  pull();
  plug();
  EXPECT_TRUE(client.get_angles());
  angles.wait_for(1);
}

TEST_F(Reconnecting, ACancelledStreamStaysSo) {
  Client client = connect();
  std::atomic<int> cancelled_samples = 0;
  Collector<msg::RealtimeData3> kept;
  auto cancelled = client.stream<msg::RealtimeData4>(
      Ms(20), [&](const msg::RealtimeData4&) { ++cancelled_samples; });
  auto other = stream_into(kept, client, Ms(20));
  ASSERT_TRUE(cancelled);
  pull();
  cancelled->cancel();
  const int before = cancelled_samples;
  board.clear_log();
  plug();
  wait_for_stream_requests(1);
  board.skip(Ms(200));
  kept.wait_for(5);
  EXPECT_EQ(cancelled_samples, before);
  EXPECT_EQ(board.count<msg::DataStreamInterval>(), 1U);
}

TEST_F(Reconnecting, AnotherBoardIsRefusedOrAccepted) {
  for (const bool is_accepted : {false, true}) {
    changes.clear();
    ReconnectOptions options = quick_again();
    if (is_accepted) options.other_board = OtherBoard::accept;
    Client client = connect(options);
    const std::string number = client.identity().serial_number();
    const emulator::BoardOptions own = board.options();
    emulator::BoardOptions other = own;
    other.device_id[0] ^= 0xFF;
    pull();
    board.become(other);
    is_plugged = true;
    ASSERT_TRUE(wait_for(LinkState::other_board));
    if (is_accepted) {
      ASSERT_TRUE(wait_for(LinkState::connected));
      EXPECT_NE(client.identity().serial_number(), number);
      continue;
    }
    EXPECT_THAT(client.get_angles(), fails(ErrorCode::not_connected));
    is_plugged = false;
    board.become(own);
    plug();
    EXPECT_EQ(client.identity().serial_number(), number);
    EXPECT_TRUE(client.get_angles());
    EXPECT_THAT(states(), ElementsAre(LinkState::lost, LinkState::searching, LinkState::other_board,
                                      LinkState::connected));
    EXPECT_THAT(changes.wait_for(3)[2].message, HasSubstr(number));
  }
}

TEST_F(Reconnecting, ARestartEndsTheConnectionAndStreamsGoOn) {
  ReconnectOptions options = on_clock();
  Client client = connect(options);
  Collector<msg::RealtimeData4> samples;
  Collector<NoticeKind> notices;
  const auto noticing = client.on_notice([&](const Notice& notice) { notices.add(notice.kind); });
  auto stream = stream_into(samples, client, Ms(20));
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
  expect_samples(samples);
  EXPECT_THAT(notices.wait_for(1), Contains(NoticeKind::board_reset));
}

TEST_F(Reconnecting, AStreamThatFellSilentIsStartedAgain) {
  ReconnectOptions options = on_clock();
  options.longest_silence = std::chrono::seconds(3);
  Client client = connect(options);
  Collector<msg::RealtimeData4> samples;
  auto stream = stream_into(samples, client, Ms(20));
  board.restart();  // without a word, as when the power fails; the line stays
  board.skip(std::chrono::seconds(5));
  board.clear_log();
  while (board.count<msg::DataStreamInterval>() == 0) {
    clock.advance(Ms(200));
    std::this_thread::sleep_for(Ms(2));
  }
  expect_samples(samples);
  EXPECT_EQ(client.connections(), 1U);
}

TEST_F(Reconnecting, ASilentBoardIsLost) {
  ReconnectOptions options = on_clock();
  options.longest_silence = std::chrono::seconds(3);
  Client client = connect(options);
  Collector<msg::RealtimeData4> samples;
  const auto stream = stream_into(samples, client, Ms(20));
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
  Client client = connect(on_clock());  // a busy machine answers late
  const auto pass_until = [&](bool connected) {
    wait_until([&] {
      clock.advance(Ms(200));
      return client.is_connected() == connected;
    });
  };
  client.check();
  wait_until([&] { return board.count<msg::BoardInfoRequest>() >= 2; });
  EXPECT_TRUE(client.get_angles());
  EXPECT_EQ(client.connections(), 1U);
  board.on_lost([](const Packet&) { return true; });
  board.clear_log();
  auto asked = std::async(std::launch::async, [&] {
    return client.call(msg::GetAnglesRequest{}, {.timeout = std::chrono::hours(1)});
  });
  wait_for_requests<msg::GetAnglesRequest>(1);
  client.check();
  pass_until(false);
  ASSERT_TRUE(wait_for(LinkState::lost));
  EXPECT_THAT(changes.wait_for(1)[0].message, HasSubstr("does not respond"));
  EXPECT_THAT(asked.get(), fails(ErrorCode::link_lost, "does not respond"));
  board.on_lost({});
  pass_until(true);
}

TEST_F(Reconnecting, ThePausesDoubleAndTheAttemptsEnd) {
  ReconnectOptions options = on_clock();
  options.first_pause = Ms(100);
  options.longest_pause = Ms(300);
  options.attempts = 4;
  Client client = connect(options);
  pull();
  const auto wait_for_attempts = [&](int count) { wait_until([&] { return attempts >= count; }); };
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
  EXPECT_THAT(client.get_angles(), fails(ErrorCode::not_connected));
}

TEST_F(Reconnecting, DestructionEndsTheSearchAndAnAttempt) {
  for (const bool in_attempt : {false, true}) {
    ReconnectOptions options = quick_again();
    if (in_attempt) {
      options.connection.timeout = std::chrono::hours(1);
      options.connection.retries = 90;
    } else {
      options.first_pause = options.longest_pause = std::chrono::hours(1);
    }
    std::optional<Client> client(connect(options));
    if (in_attempt) board.on_lost([](const Packet&) { return true; });
    attempts = 1;
    is_plugged = in_attempt;
    board.unplug();
    wait_until([&] { return attempts >= 2; });
    const auto begin = std::chrono::steady_clock::now();
    client.reset();
    EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(10));
    is_plugged = true;
  }
}

TEST_F(Reconnecting, ClosingEndsCallsThatWait) {
  Client client = connect(quick_again(OutagePolicy::wait));
  pull();
  std::thread closing([&] {
    std::this_thread::sleep_for(Ms(10));
    client.close();
  });
  const auto call = client.call(msg::GetAnglesRequest{}, {.timeout = std::chrono::hours(1)});
  closing.join();
  EXPECT_THAT(call, fails(ErrorCode::not_connected));
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
    options = quick_again();
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
