// Tests of the complete board: its behavior depends only on the bytes and their times. Restarts:
// their duration, what is lost, and the statistics of the board's whole life, which are kept.

#include "host.hpp"
#include "random_input.hpp"

namespace sbgc::test {
namespace {

TEST(Board, KnowsWhichPortsAreUsb) {
  Host host;
  host.port = host.board.open_port(true).value();
  EXPECT_TRUE(host.get<msg::BoardInfo>(msg::BoardInfoRequest{})
                  .connection_flags.has(msg::ConnectionFlag::usb));
}

TEST(Board, HasAsManyPortsAsItSays) {
  emulator::Board board({}, {}, {});
  for (std::size_t i = 0; i < emulator::Board::max_ports; ++i) EXPECT_TRUE(board.open_port());
  EXPECT_FALSE(board.open_port());
  board.close_port(3);
  EXPECT_EQ(board.open_port(), 3U);
}

TEST(Board, WorksOnAfterItHasBeenMoved) {
  emulator::Board first({}, {}, {});
  int told = 0;
  first.on_traffic = [&](const emulator::Board::Traffic&) { ++told; };
  const auto port = first.open_port().value();
  emulator::Board second = std::move(first);
  second.advance(Instant{} + seconds(1));
  second.receive(port, frame_of(86, {}), Instant{} + seconds(1));
  second.advance(Instant{} + seconds(2));
  EXPECT_EQ(second.output(port).size(), frame_of(86, Bytes(18)).size());
  EXPECT_EQ(told, 2);
}

/// At time `at`, bytes arrive and pending output is taken.
struct Event {
  Instant at{};
  Bytes bytes{};
};

std::vector<Event> random_events(std::uint32_t seed) {
  RandomRequests requests(seed);
  std::vector<Event> events;
  Instant at = Instant{} + milliseconds(600);
  Bytes stream;
  for (int i = 0; i < 300; ++i) {
    const Bytes next = requests.next();
    stream.insert(stream.end(), next.begin(), next.end());
  }
  while (!stream.empty()) {
    const auto size = std::min<std::size_t>(stream.size(), 1 + requests.up_to(60));
    const auto end = stream.begin() + static_cast<std::ptrdiff_t>(size);
    events.push_back({at, {stream.begin(), end}});
    stream.erase(stream.begin(), end);
    at = at + microseconds(requests.up_to(requests.up_to(30) == 0 ? 500'000 : 3'000));
  }
  events.push_back({at + seconds(8), {}});
  return events;
}

/// The times of the calls of advance() between events.
enum class Cut { never, as_next_says, at_random };

Bytes run(std::uint32_t seed, Cut cut, emulator::BoardOptions options = {}) {
  // The requests include many restarts.
  options.start_time = milliseconds(5);
  options.bootloader_time = milliseconds(20);
  emulator::Board board(options, {}, {});
  const auto port = board.open_port().value();
  RandomRequests cuts(seed + 1);
  Bytes output;
  Instant now{};
  for (const Event& event : random_events(seed)) {
    while (cut != Cut::never) {
      now =
          cut == Cut::at_random ? now + microseconds(cuts.up_to(20'000)) : later(now, board.next());
      if (now >= event.at) break;
      board.advance(now);
    }
    now = event.at;
    board.receive(port, event.bytes, now);
    const auto waiting = board.output(port);
    output.insert(output.end(), waiting.begin(), waiting.end());
    board.sent(port, waiting.size(), now);
  }
  return output;
}

TEST(Board, DoesTheSameHoweverTimeIsCut) {
  for (std::uint32_t seed = 1; seed <= 12; ++seed) {
    SCOPED_TRACE(seed);
    emulator::BoardOptions options = seed % 3 == 0 ? emulator::BoardOptions{} : newest_board();
    if (seed % 2 == 0) options.output_buffer = options.input_buffer = 300;
    const Bytes once = run(seed, Cut::never, options);
    EXPECT_FALSE(once.empty());
    EXPECT_EQ(run(seed, Cut::never, options), once);
    EXPECT_EQ(run(seed, Cut::as_next_says, options), once);
    EXPECT_EQ(run(seed, Cut::at_random, options), once);
  }
}

TEST(Board, SendsFramesOnlyWhateverItIsSent) {
  for (std::uint32_t seed = 100; seed < 120; ++seed) {
    SCOPED_TRACE(seed);
    Parser parser;
    const Bytes output =
        run(seed, Cut::never, seed % 2 == 0 ? emulator::BoardOptions{} : newest_board());
    std::size_t frames = 0;
    parser.feed(output, [&](const Frame& frame) {
      ++frames;
      const auto known = select(Direction::from_board, frame.id, frame.body.size(), [](auto) {});
      EXPECT_EQ(known, Code::ok) << int{frame.id};
    });
    EXPECT_GT(frames, 20U);
    EXPECT_EQ(parser.counters().skipped_bytes, 0U);
  }
}

/// A host receives the same responses in the same order, whenever the memory is saved.
TEST(Saving, ChangesNothingButWhen) {
  int waited = 0;
  for (std::uint32_t seed = 0; seed < 30; ++seed) {
    std::vector<Bytes> heard[2];
    for (const bool waits : {false, true}) {
      RandomRequests requests(seed);
      emulator::BoardOptions options = seed % 2 == 0 ? emulator::BoardOptions{} : newest_board();
      options.waits_for_saving = waits;
      options.output_buffer = 0;
      emulator::Board board(options, {}, Instant{});
      const std::vector<std::size_t> ports{board.open_port().value(), board.open_port().value()};
      heard[waits].resize(ports.size());
      Instant now = Instant{} + seconds(1);
      const auto collect = [&] {
        for (const std::size_t port : ports) {
          const auto bytes = board.output(port);
          heard[waits][port].insert(heard[waits][port].end(), bytes.begin(), bytes.end());
          board.sent(port, bytes.size(), now);
        }
      };
      for (int i = 0; i < 400; ++i) {
        const std::size_t port = requests.up_to(1);
        const Bytes bytes = requests.next();
        const std::uint32_t pause = requests.up_to(20);
        const bool is_saved = requests.up_to(3) == 0;
        board.receive(port, bytes, now);
        now = now + milliseconds(pause);
        board.advance(now);
        waited += board.memory().is_unsaved ? 1 : 0;
        if (is_saved) board.memory_saved(board.memory().revision, now);
        collect();
      }
      board.memory_saved(board.memory().revision, now);
      collect();
    }
    EXPECT_EQ(heard[0], heard[1]) << seed;
  }
  EXPECT_GT(waited, 100);
}

TEST(Board, TellsOfTraffic) {
  Host host;
  std::vector<emulator::Board::Traffic> traffic;
  host.board.on_traffic = [&](const emulator::Board::Traffic& one) { traffic.push_back(one); };
  host.ask(msg::BoardInfoRequest{});
  host.send_bytes(frame_of(200, {}));
  host.send_bytes(frame_of(67, Bytes(3)));
  host.ask(msg::UseDefaults{.profile_id = 99});
  ASSERT_EQ(traffic.size(), 8U);
  EXPECT_FALSE(traffic[0].reaction);
  EXPECT_EQ(traffic[1].reaction, emulator::Reaction::executed);
  EXPECT_FALSE(traffic[2].reaction);
  EXPECT_EQ(traffic[3].reaction, emulator::Reaction::unknown);
  EXPECT_FALSE(traffic[4].reaction);
  EXPECT_EQ(traffic[5].reaction, emulator::Reaction::malformed);
  EXPECT_FALSE(traffic[6].reaction);
  EXPECT_EQ(traffic[7].reaction, emulator::Reaction::refused);
  EXPECT_EQ(host.board.counters().requests, 4U);
  EXPECT_EQ(host.board.counters().unknown, 2U);
  EXPECT_EQ(host.board.counters().refused, 1U);
  EXPECT_EQ(host.board.counters().sent, 4U);
}

TEST(Board, ExecutesNothingBeforeItsPassword) {
  emulator::BoardOptions options = newest_board();
  options.password = "sesame";
  Host host(options);
  std::vector<emulator::Reaction> reactions;
  host.board.on_traffic = [&](const emulator::Board::Traffic& traffic) {
    if (traffic.reaction) reactions.push_back(*traffic.reaction);
  };
  ASSERT_TRUE(host.board.gimbal().motors_on());
  host.ask(msg::MotorsOff{});
  EXPECT_TRUE(host.board.gimbal().motors_on());
  EXPECT_EQ(reactions, std::vector{emulator::Reaction::locked});
}

TEST(Restart, PowerOffLosesWhatWaitsToBeSent) {
  Host host;
  host.send(msg::BoardInfoRequest{});
  host.board.advance(host.now + milliseconds(10));
  host.board.restart(host.now + milliseconds(10));
  EXPECT_TRUE(host.board.output(host.port).empty());
  EXPECT_TRUE(host.ask(msg::BoardInfoRequest{}, milliseconds(2)).empty());
}

msg::ReadStateVars statistics(Host& host) {
  return host.get<msg::ReadStateVars>(msg::ReadStateVarsRequest{});
}

TEST(StateVariables, CountTimeAndEnergy) {
  Host host(newest_board());
  const auto before = statistics(host);
  const double volts = host.board.gimbal().sample(host.now).battery;
  const double amperes = host.board.gimbal().sample(host.now).current;
  host.listen(seconds(3600));
  const auto after = statistics(host);
  EXPECT_NEAR((after.work_time.milliseconds() - before.work_time.milliseconds()) / 1000, 3600, 2);
  EXPECT_NEAR(after.energy.watt_hours() - before.energy.watt_hours(), volts * amperes,
              0.3 * volts * amperes);
  EXPECT_NEAR(after.avg_current.milliamperes(), 1000 * amperes, 300 * amperes);
  EXPECT_GT(after.imu_temp_max.raw(), 0);
  EXPECT_LE(after.imu_temp_min.raw(), after.imu_temp_max.raw());
  EXPECT_GE(after.max_current.milliamperes(), after.avg_current.milliamperes());
}

TEST(StateVariables, AreNotStoredIfTheParametersForbidIt) {
  Host host(newest_board());
  auto parameters = host.get<msg::ReadParamsExt2>(msg::ReadParamsExt2Request{});
  parameters.general_flags2.set(msg::GeneralFlags2Bit::save_system_stat, false);
  host.ask(msg::WriteParamsExt2{parameters});
  const auto revision = host.board.memory().revision;
  host.listen(seconds(600));
  EXPECT_EQ(host.board.memory().revision, revision);
}

}  // namespace
}  // namespace sbgc::test
