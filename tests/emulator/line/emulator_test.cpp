// Tests of a board and its lines: rates, backpressure, restarts, and independence of the number of
// calls; of motion of the frame and faults that begin and end while it runs.

#include <sbgc/codec.hpp>
#include <sbgc/messages/parameters.hpp>
#include <sbgc/messages/system.hpp>

#include "emulator_rig.hpp"
#include "physics/noise.hpp"

namespace sbgc::emulator::test {
namespace {

TEST(Emulator, TheLineTakesItsTime) {
  Bench bench({.line = {.board = {.baud_rate = 9600}}});
  bench.send(frame_of(msg::BoardInfoRequest{}));
  // On the line, 5 bytes of request and 23 of response take 29 ms, regardless of the board.
  EXPECT_TRUE(bench.listen(milliseconds(6), milliseconds(1)).empty());
  const Bytes early = bench.listen(milliseconds(20), milliseconds(1));
  EXPECT_EQ(frames_in(early, msg::CommandFromBoard::board_info), 0U);
  Bytes all = early;
  const Bytes rest = bench.listen(milliseconds(60));
  all.insert(all.end(), rest.begin(), rest.end());
  EXPECT_EQ(frames_in(all, msg::CommandFromBoard::board_info), 1U);
}

TEST(Emulator, AStreamThatTheLineCarriesKeepsItsRate) {
  Bench bench({.line = {.board = {.baud_rate = 115200}}});
  bench.send(stream_of(20));
  EXPECT_NEAR(static_cast<double>(
                  frames_in(bench.listen(seconds(20)), msg::CommandFromBoard::realtime_data_4)),
              1000, 1);
}

TEST(Emulator, AStreamThatTheLineDoesNotCarryFillsIt) {
  Bench bench({.line = {.board = {.baud_rate = 9600}}});
  bench.send(stream_of(20));
  bench.listen(seconds(2));
  const Bytes got = bench.listen(seconds(60));
  EXPECT_NEAR(static_cast<double>(got.size()), 960 * 60, 200);
  EXPECT_NEAR(static_cast<double>(frames_in(got, msg::CommandFromBoard::realtime_data_4)),
              960.0 * 60 / sample_size, 3);
  EXPECT_GT(bench.emulator.board().counters().skipped, 2000U);
}

TEST(Emulator, AHostThatDoesNotListenHoldsTheBoardUp) {
  Bench bench;
  bench.send(stream_of(20));
  bench.now = bench.now + seconds(120);
  bench.emulator.advance(bench.now);
  EXPECT_LE(bench.emulator.to_host(bench.port).size(), Emulator::output_limit);
  EXPECT_GT(bench.emulator.to_host(bench.port).size(), Emulator::output_limit - 1000);
  EXPECT_GT(bench.emulator.board().counters().skipped, 5000U);
  // When it reads again, complete frames arrive as if nothing had happened.
  const Bytes got = bench.listen(seconds(1));
  EXPECT_GT(frames_in(got, msg::CommandFromBoard::realtime_data_4), 500U);
  Parser parser;
  parser.feed(got, [](const Frame&) {});
  EXPECT_EQ(parser.counters().skipped_bytes, 0U);
}

TEST(Emulator, AHostThatDoesNotListenMissesTextLines) {
  EmulatorOptions options;
  options.line.faults.text_every = milliseconds(1);
  for (const bool has_stream : {false, true}) {
    Bench bench(options);
    if (has_stream) bench.send(stream_of(20));
    bench.now = bench.now + seconds(60);
    bench.emulator.advance(bench.now);
    EXPECT_LE(bench.emulator.to_host(bench.port).size(), Emulator::output_limit + 1000);
    EXPECT_GT(bench.listen(milliseconds(10)).size(), Emulator::output_limit - 1000);
    EXPECT_GT(bench.listen(seconds(1)).size(), 10'000U) << "samples arrive again";
  }
}

TEST(Emulator, ToldWhenTheHostShouldWait) {
  Bench bench({.line = {.board = {.baud_rate = 9600}}});
  EXPECT_EQ(bench.emulator.room(bench.port), Emulator::input_limit);
  bench.send(Bytes(Emulator::input_limit, 0));
  EXPECT_EQ(bench.emulator.room(bench.port), 0U);
  bench.listen(seconds(1));
  EXPECT_NEAR(static_cast<double>(bench.emulator.room(bench.port)), 960, 2);
}

TEST(Emulator, RequestsThatWaitTakeUpRoom) {
  Bench bench;  // the line is perfect: the board causes the delay
  Bytes requests;
  while (requests.size() < Emulator::input_limit) {
    const Bytes one = frame_of(msg::BoardInfoRequest{});
    requests.insert(requests.end(), one.begin(), one.end());
  }
  bench.send(requests);
  EXPECT_LT(bench.emulator.room(bench.port), 20U);
  // A host that does not read delays their execution.
  bench.now = bench.now + seconds(60);
  bench.emulator.advance(bench.now);
  for (int i = 0; i < 20; ++i) bench.send(requests);
  bench.now = bench.now + seconds(60);
  bench.emulator.advance(bench.now);
  EXPECT_EQ(bench.emulator.room(bench.port), 0U);
  bench.listen(seconds(30));
  EXPECT_EQ(bench.emulator.room(bench.port), Emulator::input_limit);
}

TEST(Emulator, TheBoardsInputBufferCanBeFilled) {
  EmulatorOptions options;
  options.board.input_buffer = 2 * Emulator::input_limit;
  Bench bench(options);
  const Bytes request = frame_of(msg::BoardInfoRequest{});
  for (std::size_t sent = 0; sent <= options.board.input_buffer; sent += request.size()) {
    ASSERT_GT(bench.emulator.room(bench.port), 0U);
    bench.send(request);
  }
  EXPECT_GT(bench.emulator.board().counters().lost, 0U);
}

TEST(Emulator, BytesThatNeverArriveTakeTheirTime) {
  EmulatorOptions options;
  options.line.board.baud_rate = 9600;
  for (const bool is_lost : {true, false}) {
    options.line.faults.lost = is_lost ? 1 : 0;
    Bench bench(options);
    if (!is_lost) bench.emulator.set_host_line(bench.port, LineSettings{9601}, bench.now);
    bench.send(Bytes(Emulator::input_limit, 0xFF));
    EXPECT_LE(bench.emulator.room(bench.port), 1U);
    bench.listen(seconds(1));
    EXPECT_NEAR(static_cast<double>(bench.emulator.room(bench.port)), 960, 2);
  }
}

TEST(Emulator, IsQuietWhenAllThatWasAskedHasBeenTaken) {
  Bench bench({.line = {.board = {.baud_rate = 9600}}});
  EXPECT_TRUE(bench.emulator.is_quiet(bench.port));
  Bytes got;
  bench.send(frame_of(msg::BoardInfoRequest{}));
  while (!bench.emulator.is_quiet(bench.port)) {
    const Bytes more = bench.listen(microseconds(300), microseconds(300));
    got.insert(got.end(), more.begin(), more.end());
    ASSERT_LT(bench.now, Instant{} + seconds(5));
  }
  EXPECT_EQ(frames_in(got, msg::CommandFromBoard::board_info), 1U);
  // Bytes that have arrived but are not taken count as traffic.
  bench.send(frame_of(msg::BoardInfoRequest{}));
  bench.now = bench.now + seconds(1);
  bench.emulator.advance(bench.now);
  EXPECT_FALSE(bench.emulator.is_quiet(bench.port));
}

TEST(Emulator, StreamsAndTextEndWithTheInput) {
  EmulatorOptions options;
  options.line.board.baud_rate = 9600;
  options.line.faults.text_every = milliseconds(10);
  Bench bench(options);
  bench.send(stream_of(1));
  bench.listen(seconds(1));
  bench.send(stream_of(2));
  bench.send(frame_of(msg::BoardInfoRequest{}));
  EXPECT_FALSE(bench.emulator.is_quiet(bench.port));
  bench.emulator.end_input(bench.port, bench.now);
  Bytes got;
  while (!bench.emulator.is_quiet(bench.port)) {
    const Bytes more = bench.listen(milliseconds(10));
    got.insert(got.end(), more.begin(), more.end());
    ASSERT_LT(bench.now, Instant{} + seconds(10));
  }
  EXPECT_EQ(frames_in(got, msg::CommandFromBoard::board_info), 1U);
  EXPECT_EQ(frames_in(got, msg::CommandFromBoard::confirm), 1U);
  EXPECT_TRUE(bench.listen(seconds(10)).empty());
}

TEST(Emulator, IsNotQuietWhileAFrameHasBegun) {
  Bench bench;
  Bytes bytes = frame_of(msg::BoardInfoRequest{});
  bytes[2] = 200;  // more bytes than will arrive
  bytes[3] = static_cast<std::uint8_t>(bytes[1] + bytes[2]);
  bench.send(bytes);
  bench.send(frame_of(msg::BoardInfoRequest{}));
  bench.listen(milliseconds(50));
  EXPECT_FALSE(bench.emulator.is_quiet(bench.port));
  EXPECT_EQ(frames_in(bench.listen(milliseconds(100)), msg::CommandFromBoard::board_info), 1U);
  EXPECT_TRUE(bench.emulator.is_quiet(bench.port));
}

TEST(Emulator, ARestartInTheMiddleOfAFrameEndsItForTheLine) {
  EmulatorOptions options;
  options.line.board.baud_rate = 1200;
  options.line.faults.text_every = seconds(1);
  Bench bench(options);
  bench.listen(milliseconds(200));
  bench.send(frame_of(msg::BoardInfo3Request{}));
  bench.listen(milliseconds(200));  // part of the response's 74 bytes, which take 0.6 s
  bench.emulator.restart(bench.now);
  const auto texts = [&] {
    return bench.emulator.counters(bench.port, Line::Way::to_host).text_lines;
  };
  const auto before = texts();
  bench.listen(seconds(3));
  EXPECT_GE(texts(), before + 2) << "it goes on";
  bench.send(frame_of(msg::BoardInfo3Request{}));
  EXPECT_EQ(frames_in(bench.listen(seconds(3)), msg::CommandFromBoard::board_info_3), 1U)
      << "and in no frame";
}

TEST(Emulator, TheRateOfTheSettings) {
  Bench bench({.rate_from_parameters = true});
  EXPECT_NE(bench.emulator.board().baud_rate(), 0U);
  EXPECT_EQ(bench.emulator.line().baud_rate, bench.emulator.board().baud_rate());
  bench.emulator.set_host_line(bench.port, LineSettings{9600}, bench.now);
  bench.send(frame_of(msg::BoardInfoRequest{}));
  EXPECT_EQ(frames_in(bench.listen(seconds(1)), msg::CommandFromBoard::board_info), 0U);
  bench.emulator.set_host_line(bench.port, bench.emulator.line(), bench.now);
  bench.send(frame_of(msg::BoardInfoRequest{}));
  EXPECT_EQ(frames_in(bench.listen(seconds(1)), msg::CommandFromBoard::board_info), 1U);
}

TEST(Emulator, ANewRateOfTheSettingsHoldsFromTheNextStartOn) {
  Bench bench({.rate_from_parameters = true});
  const std::size_t usb = bench.emulator.connect(true, bench.now).value();
  bench.send(frame_of(msg::ReadParams3Request{}));
  msg::ReadParams3 settings;
  Parser parser;
  parser.feed(bench.listen(seconds(1)),
              [&](const Frame& frame) { EXPECT_TRUE(decode(frame.body, settings)); });
  settings.serial_speed = msg::SerialSpeed::baud_9600;
  bench.send(frame_of(msg::WriteParams3{settings}));
  bench.listen(seconds(1));
  EXPECT_EQ(bench.emulator.line().baud_rate, 115200U);
  bench.emulator.restart(bench.now);
  bench.listen(seconds(1));
  EXPECT_EQ(bench.emulator.line().baud_rate, 9600U);

  // A response takes 29 ms on the port with a rate, and one cycle on USB.
  bench.send(frame_of(msg::BoardInfoRequest{}));
  bench.emulator.from_host(usb, frame_of(msg::BoardInfoRequest{}), bench.now);
  EXPECT_EQ(frames_in(bench.listen(milliseconds(20)), msg::CommandFromBoard::board_info), 0U);
  const auto over_usb = bench.emulator.to_host(usb);
  EXPECT_EQ(frames_in({over_usb.begin(), over_usb.end()}, msg::CommandFromBoard::board_info), 1U);
}

TEST(Emulator, ConnectionsHaveFaultsOfTheirOwn) {
  Bench bench({.line = {.faults = {.lost = 0.5}}});
  const std::size_t other = bench.emulator.connect(false, bench.now).value();
  for (int i = 0; i < 100; ++i) {
    bench.send(Bytes(100, 0));
    bench.emulator.from_host(other, Bytes(100, 0), bench.now);
    const auto lost = [&](std::size_t port) {
      return bench.emulator.counters(port, Line::Way::to_board).lost;
    };
    if (lost(bench.port) != lost(other)) return;
  }
  FAIL() << "both lose the same bytes";
}

TEST(Emulator, RestartsWhenItIsTold) {
  Bench bench({.restart_at = milliseconds(1500)});
  EXPECT_EQ(bench.emulator.board().counters().restarts, 0U);
  bench.listen(milliseconds(499));
  EXPECT_EQ(bench.emulator.board().counters().restarts, 0U);
  bench.listen(milliseconds(2));
  EXPECT_EQ(bench.emulator.board().counters().restarts, 1U);
  bench.listen(seconds(5));
  EXPECT_EQ(bench.emulator.board().counters().restarts, 1U);
}

TEST(Emulator, PortsAreIndependent) {
  Emulator emulator({.board = {.start_time = {}}}, {}, Instant{});
  std::vector<std::size_t> ports;
  while (const auto port = emulator.connect(false, Instant{})) ports.push_back(*port);
  ASSERT_EQ(ports.size(), Board::max_ports);
  emulator.disconnect(ports[3], Instant{});
  EXPECT_EQ(emulator.connect(false, Instant{}), ports[3]);
  const Instant now = Instant{} + seconds(1);
  emulator.from_host(ports[2], frame_of(msg::BoardInfoRequest{}), now);
  emulator.advance(now + seconds(1));
  for (const std::size_t port : ports) {
    EXPECT_EQ(emulator.to_host(port).empty(), port != ports[2]);
  }
}

/// The live data that the board sends now.
msg::RealtimeData4 data_of(Bench& bench) {
  msg::RealtimeData4 data;
  bench.send(frame_of(msg::RealtimeData4Request{}));
  ParserOfAll parser;
  parser.feed(bench.listen(milliseconds(100)),
              [&](const Frame& frame) { EXPECT_TRUE(decode(frame.body, data)); });
  return data;
}

TEST(EmulatorChange, FaultsOfTheBoardBeginAndEnd) {
  Bench bench;
  EmulatorOptions options;
  options.board.faults.errors.set(msg::SystemError::no_sensor);
  options.board.faults.i2c_errors = 100;
  options.board.gimbal.battery = 13.8;
  bench.emulator.change(options, bench.now);
  bench.listen(seconds(2));
  const msg::RealtimeData4 faulty = data_of(bench);
  EXPECT_TRUE(faulty.system_error.has(msg::SystemError::no_sensor));
  EXPECT_NEAR(faulty.i2c_error_count, 200, 5) << "counted from the change on";
  EXPECT_LT(faulty.bat_level.volts(), 14);

  bench.emulator.change({}, bench.now);
  bench.listen(seconds(2));
  const msg::RealtimeData4 healthy = data_of(bench);
  EXPECT_EQ(healthy.system_error.raw(), 0);
  EXPECT_NEAR(healthy.i2c_error_count, 210, 15) << "a counter does not fall";
  EXPECT_GT(healthy.bat_level.volts(), 15);
}

TEST(EmulatorChange, TheFrameMovesAndTheCameraStays) {
  Bench bench;
  bench.emulator.change(
      {.board = {.gimbal = {.frame = {.kind = Disturbance::Kind::vehicle, .strength = 3}}}},
      bench.now);
  const auto largest = [&](auto angle_of) {
    double result = 0;
    for (int i = 0; i < 20; ++i) {
      bench.listen(milliseconds(100));
      result = std::max(result, std::abs(angle_of(data_of(bench))));
    }
    return result;
  };
  const auto frame = [](const msg::RealtimeData4& data) {
    return data.frame_imu_angle.pitch.degrees();
  };
  const auto camera = [](const msg::RealtimeData4& data) { return data.angle.pitch.degrees(); };
  const double most = largest(frame);
  EXPECT_GT(most, 1);
  EXPECT_LT(largest(camera), most / 3);
  bench.emulator.change({}, bench.now);
  bench.listen(seconds(1));
  EXPECT_LT(largest(frame), 0.5);
}

TEST(EmulatorChange, TheLineLosesBytesFromThenOn) {
  Bench bench;
  const auto lost = [&] { return bench.emulator.counters(bench.port, Line::Way::to_host).lost; };
  bench.send(stream_of(20));
  bench.listen(seconds(1));
  EXPECT_EQ(lost(), 0U);
  bench.emulator.change({.line = {.faults = {.lost = 0.1}}}, bench.now);
  bench.listen(seconds(1));
  const std::uint64_t some = lost();
  EXPECT_GT(some, 100U);
  bench.emulator.change({}, bench.now);
  bench.listen(seconds(1));
  EXPECT_EQ(lost(), some);
}

TEST(Emulator, CallingMoreOftenChangesNothing) {
  EmulatorOptions options;
  options.line.board.baud_rate = 57600;
  options.line.faults = {.bit_errors = 1e-4, .lost = 1e-3, .text_every = milliseconds(300)};
  options.board.gimbal.frame.kind = Disturbance::Kind::drone;
  const auto run = [&](std::uint64_t cutting) {
    Bench bench(options);
    bench.send(stream_of(20));
    Bytes result;
    for (std::uint64_t i = 0; i < 40; ++i) {
      if (i % 10 == 0) bench.send(frame_of(msg::BoardInfoRequest{}));
      const Duration step =
          cutting == 0
              ? milliseconds(100)
              : microseconds(static_cast<std::int64_t>(50 + random_bits(cutting, i) % 20000));
      const Bytes got = bench.listen(milliseconds(100), step);
      result.insert(result.end(), got.begin(), got.end());
    }
    return result;
  };
  const Bytes rarely = run(0);
  EXPECT_GT(rarely.size(), 15'000U);
  EXPECT_TRUE(run(1) == rarely);
  EXPECT_TRUE(run(2) == rarely);
}

}  // namespace
}  // namespace sbgc::emulator::test
