// Tests of the search for a board's line settings, in virtual time, with a simulated port.

#include <sbgc/detector.hpp>

#include "simulation.hpp"

namespace sbgc::test {
namespace {

/// A simulated port that receives the bytes returned by `hear`, and records the calls.
struct Port {
  std::function<Body(const LineSettings&, const Body& written)> hear =
      [](const LineSettings&, const Body&) { return Body{}; };
  std::function<bool(const LineSettings&)> can_be_set = [](const LineSettings&) { return true; };
  Duration delay = milliseconds(5);
  std::vector<LineSettings> visited;
  Instant now = start_time;
  Duration taken{};

  /// Runs the search and returns the kind of the last step.
  DetectorStep::Kind search(Detector& detector) {
    LineSettings line;
    Body heard;
    Instant heard_at = Instant::never;
    for (int steps = 0; steps < 100'000; ++steps) {
      const DetectorStep step = detector.next(now);
      switch (step.kind) {
        case DetectorStep::Kind::set_line:
          heard_at = Instant::never;
          if (!can_be_set(step.line)) {
            detector.refuse();
            break;
          }
          line = step.line;
          visited.push_back(line);
          break;
        case DetectorStep::Kind::write:
          heard = hear(line, Body(step.bytes.begin(), step.bytes.end()));
          heard_at = heard.empty() ? Instant::never : now + delay;
          break;
        case DetectorStep::Kind::wait:
          EXPECT_GT(step.until, now) << "no progress";
          EXPECT_NE(step.until, Instant::never);
          now = earlier(step.until, heard_at);
          if (now == heard_at) {
            detector.feed(heard);
            heard_at = Instant::never;
          }
          break;
        default: taken = now - start_time; return step.kind;
      }
    }
    ADD_FAILURE() << "no end";
    return DetectorStep::Kind::failed;
  }
};

/// A board with the given line settings; with any other settings it receives and sends garbage.
std::function<Body(const LineSettings&, const Body&)> board_at(const LineSettings& right,
                                                               unsigned seed = 0) {
  return [right, random = std::mt19937(seed), seed](const LineSettings& line,
                                                    const Body& written) mutable {
    if (line == right && written == frame_of(86, {})) return frame_of(86, body_of(18, {31, 0x7F}));
    Body garbage(seed == 0 ? 0 : random() % 200);
    for (std::uint8_t& byte : garbage) {
      byte = random() % 4 == 0 ? '>' : static_cast<std::uint8_t>(random());
    }
    return garbage;
  };
}

TEST(Detector, FindsTheBoardOnEveryLine) {
  for (const unsigned seed : {0U, 1U, 2U, 3U}) {
    for (const std::uint32_t rate : baud_rates) {
      for (const Parity parity : parities) {
        Port port;
        port.hear = board_at({rate, parity}, seed);
        Detector detector;
        ASSERT_EQ(port.search(detector), DetectorStep::Kind::found) << rate;
        EXPECT_EQ(detector.next(port.now).line, (LineSettings{rate, parity}));
        EXPECT_EQ(detector.introduction().id, 86);
        EXPECT_EQ(detector.introduction().offset, 0U);
        const auto body = detector.introduction().body;
        EXPECT_EQ(Body(body.begin(), body.end()), body_of(18, {31, 0x7F}));
        EXPECT_LT(port.taken, seconds(4)) << "in the first round";
      }
    }
  }
}

TEST(Detector, TriesTheLikelyFirst) {
  Port port;
  Detector detector;
  port.search(detector);
  EXPECT_EQ(port.visited[0], (LineSettings{115200, Parity::none}));
  const auto first_even =
      std::find_if(port.visited.begin(), port.visited.end(),
                   [](const auto& line) { return line.parity == Parity::even; });
  EXPECT_EQ(first_even - port.visited.begin(), 6) << "after the six rates of the protocol";
  EXPECT_EQ(port.visited[12].baud_rate, 230400U) << "others come last";
}

TEST(Detector, IsQuickWhereTheBoardIsLikelyToBe) {
  Port port;
  port.hear = board_at({115200, Parity::none});
  Detector detector;
  port.search(detector);
  EXPECT_EQ(port.taken, milliseconds(10 + 5)) << "until the request and until the response";
  EXPECT_THAT(port.visited, ::testing::SizeIs(1));
}

TEST(Detector, GivesUpSoonOnASilentLine) {
  Port port;
  Detector detector;
  EXPECT_EQ(port.search(detector), DetectorStep::Kind::failed);
  EXPECT_LT(port.taken, seconds(9));
  EXPECT_THAT(port.visited, ::testing::SizeIs(2 * Detector::lines));
  for (const Trial& trial : detector.trials()) {
    EXPECT_EQ(trial.probes, 4);
    EXPECT_EQ(trial.bytes, 0U);
  }
  EXPECT_EQ(detector.next(port.now).kind, DetectorStep::Kind::failed) << "for ever";
  EXPECT_EQ(detector.introduction().id, 0);
}

TEST(Detector, ReportsWhatItTried) {
  Port port;
  port.hear = [](const LineSettings& line, const Body&) {
    if (line == LineSettings{9600, Parity::none}) return Body{1, 2, '>', 3, 4, 5};
    if (line == LineSettings{9600, Parity::even}) return frame_of(23, body_of(63));
    return Body{};
  };
  Detector detector;
  EXPECT_EQ(port.search(detector), DetectorStep::Kind::failed);
  std::set<std::pair<std::uint32_t, Parity>> lines;
  for (const Trial& trial : detector.trials()) {
    lines.emplace(trial.line.baud_rate, trial.line.parity);
    const bool is_noisy = trial.line == LineSettings{9600, Parity::none};
    const bool is_heard = trial.line == LineSettings{9600, Parity::even};
    EXPECT_EQ(trial.probes, is_heard ? 15 : 6)
        << "more requests where other messages were received";
    EXPECT_EQ(trial.bytes, is_noisy ? 36U : is_heard ? 15U * 68 : 0U);
    EXPECT_EQ(trial.bad_frames, is_noisy ? 6U : 0U);
    EXPECT_EQ(trial.good_frames, is_heard ? 15U : 0U);
  }
  EXPECT_EQ(lines.size(), Detector::lines) << "each once";
}

TEST(Detector, CountsABadFrameWhereverItIs) {
  Port port;
  port.hear = [](const LineSettings& line, const Body&) {
    // Behind a header that announces 250 bytes, which do not come: only the end of the wait tells.
    if (line == LineSettings{9600, Parity::none}) return Body{'>', 9, 250, 3, '>', 3, 4, 5};
    if (line != LineSettings{9600, Parity::even}) return Body{};
    Body bytes = {'>', 3, 4, 5};
    const Body frame = frame_of(86, body_of(18));
    bytes.insert(bytes.end(), frame.begin(), frame.end());
    return bytes;
  };
  DetectorOptions options{.probes = 1};
  Detector detector(options);
  EXPECT_EQ(port.search(detector), DetectorStep::Kind::found);
  for (const Trial& trial : detector.trials()) {
    EXPECT_EQ(trial.bad_frames, trial.line.baud_rate == 9600 && trial.bytes != 0 ? 1U : 0U);
    if (trial.bytes != 0) EXPECT_EQ(trial.probes, 1);
  }
}

TEST(Detector, AsksAgainWhenQuestionsAreLost) {
  Port port;
  const auto board = board_at({57600, Parity::even});
  int heard = 0;
  port.hear = [&](const LineSettings& line, const Body& written) {
    const Body answer = board(line, written);
    return answer.empty() || ++heard < 5 ? Body{} : answer;
  };
  Detector detector;
  // All responses of both rounds are lost.
  EXPECT_EQ(port.search(detector), DetectorStep::Kind::failed);
  heard = 2;
  port.now = start_time;
  Detector again;
  EXPECT_EQ(port.search(again), DetectorStep::Kind::found);
}

TEST(Detector, WaitsForABoardThatIsSlow) {
  Port port;
  port.hear = board_at({115200, Parity::none});
  port.delay = milliseconds(100);
  Detector detector;
  EXPECT_EQ(port.search(detector), DetectorStep::Kind::found) << "in the second round";
}

TEST(Detector, FindsAnIntroductionAfterAFalseBeginning) {
  Port port;
  port.hear = [](const LineSettings&, const Body&) {
    Body bytes = {'>', 9, 250, 3};  // a header that announces 250 bytes
    const Body frame = frame_of(86, body_of(18));
    bytes.insert(bytes.end(), frame.begin(), frame.end());
    return bytes;
  };
  Detector detector;
  EXPECT_EQ(port.search(detector), DetectorStep::Kind::found);
  EXPECT_LT(port.taken, milliseconds(100));
}

TEST(Detector, LeavesOutWhatThePortCannotDo) {
  Port port;
  port.can_be_set = [](const LineSettings& line) { return line.baud_rate <= 115200; };
  Detector detector;
  EXPECT_EQ(port.search(detector), DetectorStep::Kind::failed);
  EXPECT_THAT(port.visited, ::testing::SizeIs(20));
  for (const Trial& trial : detector.trials()) {
    EXPECT_EQ(trial.is_refused, trial.line.baud_rate > 115200);
  }
  Port broken;
  broken.can_be_set = [](const LineSettings&) { return false; };
  Detector none;
  EXPECT_EQ(broken.search(none), DetectorStep::Kind::failed);
  EXPECT_EQ(broken.taken, Duration{});
}

/// Runs the search up to the first request at a rate.
DetectorStep request_at(Detector& detector, std::uint32_t baud_rate, Instant& now) {
  for (int steps = 0; steps < 100'000; ++steps) {
    const DetectorStep step = detector.next(now);
    if (step.kind == DetectorStep::Kind::wait) now = step.until;
    if (step.kind == DetectorStep::Kind::write && step.line.baud_rate == baud_rate) return step;
  }
  ADD_FAILURE() << "no request";
  return {};
}

TEST(Detector, WaitsAsLongAsTheLineNeeds) {
  Detector detector({.response_timeout = Duration{}});
  Instant now = start_time;
  request_at(detector, 9600, now);
  // 5 bytes of request, 23 of response, 10 bits each.
  EXPECT_EQ(detector.next(now).until, now + wire_time({9600, Parity::none}, 28));
}

TEST(Detector, AsksWhatItIsTold) {
  const auto question = frame_of(86, body_of(9));
  DetectorOptions options;
  options.question = question;
  Detector detector(options);
  Instant now = start_time;
  const DetectorStep step = request_at(detector, 115200, now);
  EXPECT_TRUE(std::ranges::equal(step.bytes, question));
  EXPECT_EQ(detector.next(now).until, now + wire_time(step.line, question.size() + frame_size(18)) +
                                          options.response_timeout);
}

TEST(Detector, WithoutRoundsDoesNothing) {
  DetectorOptions options{.rounds = 0};
  Detector detector(options);
  EXPECT_EQ(detector.next(start_time).kind, DetectorStep::Kind::failed);
  detector.feed(frame_of(86, body_of(18)));
  detector.refuse();
  EXPECT_EQ(detector.next(start_time).kind, DetectorStep::Kind::failed);
}

}  // namespace
}  // namespace sbgc::test
