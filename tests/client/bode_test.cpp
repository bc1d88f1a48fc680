// Tests of recording a frequency response, in virtual time, and of its files.

#include <cmath>
#include <complex>

#include <sbgc/analysis/frequency_response.hpp>
#include <sbgc/client/bode.hpp>

#include "../emulator/device/recorded_axis.hpp"
#include "tasks/bode_collector.hpp"
#include "testing.hpp"
#include "virtual_client.hpp"

namespace sbgc::test {
namespace {

/// Loses, or repeats, messages of the board with samples: `copies(n)` of the nth arrive.
class SampleLine : public VirtualLine {
 public:
  explicit SampleLine(std::function<int(int)> copies) : copies_(std::move(copies)) {}

  void send(Way way, std::span<const std::uint8_t> bytes, Instant at) override {
    if (way == Way::to_board) return VirtualLine::send(way, bytes, at);
    parser_.feed(bytes, [&](const Frame& frame) {
      if (frame.id == 37 && loses_end) return;
      const int copies = frame.id == 38 ? copies_(++number_) : 1;
      for (int i = 0; i < copies; ++i) pass_on(frame.id, frame.body, frame.framing, at);
      if (number_ != 0) say_stray(frame.framing, at);
    });
  }

  bool loses_end = false;
  /// Arrives after the first samples, as the end of another recording does that was under way.
  std::optional<msg::BodeTestStartStop> stray{};

 private:
  void pass_on(std::uint8_t id, std::span<const std::uint8_t> body, Framing framing, Instant at) {
    std::array<std::uint8_t, max_frame_size> out{};
    const std::size_t size = write_frame(framing, id, body, out).size;
    VirtualLine::send(Way::to_host, std::span(out).first(size), at);
  }
  void say_stray(Framing framing, Instant at) {
    if (!stray) return;
    std::array<std::uint8_t, max_body_size> body{};
    const std::size_t size = encode(*stray, body).size;
    stray.reset();
    pass_on(37, std::span(body).first(size), framing, at);
  }

  std::function<int(int)> copies_;
  int number_ = 0;
  BasicParser<AnyFrameFormats> parser_{};
};

int all(int /*number*/) { return 1; }

emulator::EmulatorOptions board(bool is_confirmed = true, bool reports_index = false) {
  emulator::EmulatorOptions options;
  options.board.response.noise = 0;
  options.board.response.is_confirmed = is_confirmed;
  options.board.response.reports_last_index = reports_index;
  return options;
}

/// Records on a board whose motors are on.
Result<BodeRecording> record(VirtualClient& client, std::uint32_t samples = 5000,
                             const BodeOptions& options = {}) {
  client.gimbal().set_motors(true, client.now());
  return client.run(tasks::record_bode(recording(samples), options));
}

Result<BodeRecording> record_over(SampleLine& line, std::uint32_t samples = 5000) {
  VirtualClient client(board(), {}, &line);
  return record(client, samples);
}

TEST(Bode, HasEverySampleWhetherTheStartIsConfirmedOrNot) {
  for (const bool is_confirmed : {true, false}) {
    for (const bool reports_index : {true, false}) {
      VirtualClient client(board(is_confirmed, reports_index));
      const auto recorded = checked(record(client));
      EXPECT_EQ(recorded->input.size(), 5000U);
      EXPECT_EQ(recorded->output.size(), 5000U);
      EXPECT_EQ(recorded->lost, 0U);
      EXPECT_EQ(recorded->request, recording());
    }
  }
}

/// Checks each point of which the coherence is high against the plant; returns their number.
std::size_t check_against_plant(const BodeRecording& recorded, double from, double to) {
  std::size_t certain = 0;
  const auto response =
      analysis::frequency_response(recorded.input, recorded.output, 1250, from, to);
  EXPECT_GE(response.segments, 8U);
  for (const auto& point : response.points) {
    if (*point.coherence <= 0.99) continue;
    ++certain;
    const std::complex<double> truth = plant(point.frequency);
    EXPECT_NEAR(point.gain, 20 * std::log10(std::abs(truth)), 0.5) << point.frequency;
    const double off = point.phase - std::arg(truth) * 180 / std::numbers::pi;
    EXPECT_LT(std::abs(std::remainder(off, 360)), 3) << point.frequency;
  }
  return certain;
}

TEST(Bode, WithoutNoiseGainAndPhaseAreThoseOfThePlant) {
  VirtualClient client(board());
  const auto recorded = checked(record(client, 10'000));
  EXPECT_GT(check_against_plant(*recorded, 6, 200), 150U);  // of 159
}

TEST(Bode, LostMessagesLeaveAGapThatTheResponseLeavesOut) {
  SampleLine line([](int number) { return number == 1 || (number >= 60 && number < 70) ? 0 : 1; });
  const auto recorded = checked(record_over(line, 10'000));
  EXPECT_EQ(recorded->input.size(), 10'000U);
  EXPECT_EQ(recorded->lost, 11U * 20);
  for (const std::size_t lost : {0U, 19U, 59U * 20, 69U * 20 - 1}) {
    EXPECT_TRUE(std::isnan(recorded->input[lost]) && std::isnan(recorded->output[lost])) << lost;
  }
  EXPECT_FALSE(std::isnan(recorded->input[20]));
  EXPECT_FALSE(std::isnan(recorded->input[69U * 20]));
  EXPECT_GT(check_against_plant(*recorded, 6, 200), 140U);
}

TEST(Bode, ALossThatTheCounterCannotShowIsAnError) {
  SampleLine line([](int number) { return number >= 60 && number < 76 ? 0 : 1; });  // 320 samples
  EXPECT_THAT(record_over(line), fails(ErrorCode::bad_response, "320 of 5000 samples were lost"));
}

TEST(Bode, TheLastMessagesMayBeLostAndARepeatedOneCountsOnce) {
  SampleLine torn([](int number) { return number > 245 ? 0 : 1; });
  const auto recorded = checked(record_over(torn));
  EXPECT_EQ(recorded->input.size(), 5000U);
  EXPECT_EQ(recorded->lost, 100U);
  SampleLine repeating([](int number) { return number % 7 == 0 ? 2 : 1; });
  EXPECT_EQ(checked(record_over(repeating))->lost, 0U);
}

TEST(Bode, ASilentBoardIsAnErrorThatSaysWhetherItMoves) {
  for (const bool has_started : {false, true}) {
    VirtualClient client(board(false));
    client.gimbal().set_motors(true, client.now());
    if (!has_started) client.cut_the_line();
    const Instant start = client.now();
    bool has_restarted = !has_started;
    const auto recorded = client.run(tasks::record_bode(recording()), [&](TaskMachine&) {
      if (has_restarted || client.now() < start + seconds(1)) return;
      has_restarted = true;
      client.emulator().restart(client.now());
    });
    ASSERT_FALSE(recorded);
    EXPECT_THAT(recorded.error().message,
                HasSubstr(has_started ? "the recording has started" : "starting the recording"));
    EXPECT_LE(client.now() - start, seconds(4));
  }
}

TEST(Bode, ARefusalAndMotorsThatTurnOffAreErrors) {
  VirtualClient client(board());
  client.gimbal().set_motors(false, client.now());
  const auto refused = client.run(tasks::record_bode(recording()));
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().message, HasSubstr("starting the recording: "));

  BodeOptions options;
  options.progress = [&](const BodeProgress& seen) {
    if (seen.samples > 2000) client.gimbal().set_motors(false, client.now());
    return true;
  };
  EXPECT_THAT(record(client, 5000, options),
              fails(ErrorCode::board_error, "ended the recording with error 1 after 2"));
}

TEST(Bode, ProgressCanEndTheWait) {
  VirtualClient client(board());
  std::size_t last = 0;
  BodeOptions options;
  options.progress = [&](const BodeProgress& seen) {
    EXPECT_EQ(seen.total, 5000U);
    EXPECT_GE(seen.samples, last);
    last = seen.samples;
    return seen.samples < 1000;
  };
  EXPECT_THAT(record(client, 5000, options), fails(ErrorCode::cancelled));
  EXPECT_EQ(client.pending(), 0U);
  EXPECT_LT(last, 1500U);
  EXPECT_EQ(client.run(tasks::record_bode(recording(0))).error().code, ErrorCode::invalid);
}

TEST(Bode, ALostEndLosesNoSample) {
  for (const int lost : {0, 5}) {  // messages before the end
    SampleLine line([lost](int number) { return number > 250 - lost ? 0 : 1; });
    line.loses_end = true;
    VirtualClient client(board(), {}, &line);
    const auto recorded = checked(record(client));
    EXPECT_TRUE(recorded->is_end_lost);
    EXPECT_EQ(recorded->input.size(), 5000U);
    EXPECT_EQ(recorded->lost, 20U * static_cast<unsigned>(lost));
  }
}

TEST(Bode, WithoutTheEndALineThatFallsSilentBeforeItIsAnError) {
  SampleLine line([](int number) { return number > 125 ? 0 : 1; });
  line.loses_end = true;
  EXPECT_THAT(record_over(line),
              fails(ErrorCode::timeout, "the recording has started, but it failed"));
}

/// Starts a recording and forgets it, as a program that is killed.
void leave_a_recording(VirtualClient& client, std::uint32_t samples) {
  BodeOptions options;
  options.progress = [](const BodeProgress& seen) { return seen.samples == 0; };
  const auto left = record(client, samples, options);
  ASSERT_FALSE(left);
  ASSERT_EQ(left.error().code, ErrorCode::cancelled);
}

TEST(Bode, NothingStartsWhileTheBoardSendsAnEarlierRecording) {
  for (const bool is_confirmed : {true, false}) {
    SampleLine line(all);
    VirtualClient client(board(is_confirmed), {}, &line);
    leave_a_recording(client, 5000);
    bool was_sent = false;
    BodeOptions options;
    options.progress = [&](const BodeProgress& seen) {
      was_sent = was_sent || seen.is_sent || seen.has_started;
      return true;
    };
    const Instant start = client.now();
    EXPECT_THAT(record(client, 5000, options),
                fails(ErrorCode::board_error, "an earlier recording"));
    EXPECT_FALSE(was_sent);
    EXPECT_LT(client.now() - start, milliseconds(1300));
  }
}

TEST(Bode, TheRestOfAnEarlierRecordingIsNoneOfTheNext) {
  for (const bool is_confirmed : {true, false}) {
    SampleLine line(all);
    VirtualClient client(board(is_confirmed), {}, &line);
    leave_a_recording(client, 1000);  // 0.8 s, of which at least half a second is left
    const auto recorded = checked(record(client));
    EXPECT_EQ(recorded->input.size(), 5000U);
    EXPECT_EQ(recorded->lost, 0U);
    EXPECT_GT(check_against_plant(*recorded, 6, 200), 150U);
  }
}

TEST(Bode, AWaitForSilenceCanBeCancelled) {
  VirtualClient client(board());
  BodeOptions options;
  options.progress = [](const BodeProgress&) { return false; };
  EXPECT_THAT(record(client, 5000, options),
              fails(ErrorCode::cancelled, "no recording has started"));
  EXPECT_TRUE(record(client)) << "the board has started none";
}

TEST(Bode, TheEndOfAnotherRecordingIsAnErrorThatSaysThatTheCameraMoves) {
  SampleLine line(all);
  line.stray.emplace().samples_count = 1000;
  EXPECT_THAT(record_over(line), fails(ErrorCode::bad_response,
                                       AllOf(HasSubstr("the recording has started, but it failed"),
                                             HasSubstr("an end after 1000 of 5000 samples"))));
}

TEST(BodeCollector, ASampleThatIsNoNumberIsLost) {
  detail::BodeCollector collector(recording(2));
  msg::BodeTestData data{.input_max = 1, .output_max = std::numeric_limits<float>::quiet_NaN()};
  ASSERT_TRUE(data.samples.push_back({65534, 65534}) && data.samples.push_back({0, 0}));
  collector.add(data);
  EXPECT_EQ(collector.lost(), 2U);
  const auto recorded = std::move(collector).finish({.samples_count = 2});
  ASSERT_TRUE(recorded);
  EXPECT_TRUE(std::isnan(recorded->input[0]) && std::isnan(recorded->output[0]));
}

TEST(BodeCollector, ValuesAreBetweenTheLimitsOfTheMessage) {
  // The vendor's example: -1000.5 to 2000.75, and -50.25 to 60.5.
  detail::BodeCollector collector(recording(3));
  msg::BodeTestData data{
      .input_min = -1000.5F, .output_min = -50.25F, .input_max = 2000.75F, .output_max = 60.5F};
  for (const auto& [in, out] : {std::pair{0, 65534}, {32767, 0}, {65534, 32767}}) {
    ASSERT_TRUE(
        data.samples.push_back({static_cast<std::uint16_t>(in), static_cast<std::uint16_t>(out)}));
  }
  collector.add(data);
  const auto recorded = std::move(collector).finish({.samples_count = 2});  // the last index
  ASSERT_TRUE(recorded);
  EXPECT_THAT(recorded->input, ElementsAre(-1000.5, 500.125, 2000.75));
  EXPECT_THAT(recorded->output, ElementsAre(60.5, -50.25, 5.125));
}

TEST(BodeFile, IsThatOfTheVendor) {
  BodeRecording recorded;
  recorded.request = recording(3);
  recorded.input = {0, -12345.5, std::nan("")};
  recorded.output = {1e-7, 240.25, std::nan("")};
  const std::string text = to_csv(recorded);
  EXPECT_EQ(text, "%sbgc_test_data;70;0;1;3000;6;200\n0;1e-07\n-12345.5;240.25\nnan;nan\n");
  const auto read = checked(parse_bode_csv(text));
  EXPECT_EQ(read->request, recorded.request);
  EXPECT_EQ(read->input[1], -12345.5);
  EXPECT_FLOAT_EQ(static_cast<float>(read->output[0]), 1e-7F);
  EXPECT_EQ(read->lost, 1U);
  recorded.output[1] = static_cast<double>(0.1F);
  EXPECT_EQ(parse_bode_csv(to_csv(recorded))->output[1], recorded.output[1]) << "no digit is lost";
}

TEST(BodeFile, MayHaveAByteOrderMarkWindowsLineEndsAndTinyNumbers) {
  const auto read = checked(parse_bode_csv(
      "\xEF\xBB\xBF%sbgc_test_data;11;2;3;1;1;1\r\n1.5;2\r\n-3;4e2\r\n1e-60;-1e-42"));
  EXPECT_EQ(read->request.axis, msg::BodeAxis::yaw);
  EXPECT_EQ(read->request.system, msg::BodeSystem::overall);
  EXPECT_THAT(read->input, ElementsAre(1.5, -3, 0));
  EXPECT_THAT(read->output, ElementsAre(2, 400, static_cast<double>(-1e-42F)));
}

TEST(BodeFile, AnErrorNamesTheLine) {
  const auto error = [](const std::string& text) {
    const auto read = parse_bode_csv(text);
    return read ? "" : read.error().message;
  };
  const std::string title = "%sbgc_test_data;70;0;1;3000;6;200\n";
  EXPECT_THAT(error(""), HasSubstr("line 1: not a frequency response"));
  EXPECT_THAT(error("time;roll\n1;2\n"), HasSubstr("line 1: not a frequency response"));
  EXPECT_THAT(error("%sbgc_test_data;70;0;1;3000;6\n1;2\n"), HasSubstr("line 1: not"));
  EXPECT_THAT(error("%sbgc_test_data;70;0;1;3000;6;200;5\n1;2\n"), HasSubstr("line 1: not"));
  EXPECT_THAT(error("%sbgc_test_data;256;0;1;3000;6;200\n1;2\n"), HasSubstr("line 1: not"));
  EXPECT_THAT(error("%sbgc_test_data;70;0;1;3000;200;6\n1;2\n"), HasSubstr("above END_FREQ"));
  EXPECT_THAT(error(title), HasSubstr("line 2: no samples"));
  for (const char* row : {"1", "1;", "1;2;3", "1,5;2", "one;2", "inf;1", "1;1e39", " 1;2"}) {
    EXPECT_THAT(error(title + "1;2\n" + row + "\n"), HasSubstr("line 3: not two numbers")) << row;
  }
  EXPECT_THAT(error(title + "nan;2\n"), HasSubstr("line 2: half"));
  EXPECT_THAT(error(title + "1;2\n\n3;4\n"), HasSubstr("line 3: not two numbers"));
}

}  // namespace
}  // namespace sbgc::test
