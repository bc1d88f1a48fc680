// Tests of invariants: random requests over a line that loses, delays, repeats and corrupts bytes.

#include <type_traits>

#include "simulation.hpp"

namespace sbgc::test {
namespace {

/// The error rates of a line, in percent.
struct Weather {
  int lost = 0;
  int slow = 0;  // responses delayed by up to 900 ms
  int garbled = 0;
  int repeated = 0;
  int noise = 0;  // bytes between frames
  int resets = 0;
  int errors = 0;
};

constexpr Weather bad = {.lost = 15, .slow = 25, .garbled = 5, .noise = 20, .errors = 5};

/// The smallest session, for a microcontroller.
using SmallSession =
    BasicSession<SessionCapacity{
                     .requests = 1, .late_replies = 1, .streams = 0, .optimize = Optimize::size},
                 FrameFormats<CrcTable::nibbles, Framing::v1>>;

/// Runs a test with each kind of session.
template <class Test>
void with_each_session(const Test& test) {
  test.template operator()<Session>();
  test.template operator()<SmallSession>();
}

/// A board that puts the number of the answered transmission into every response.
template <class Session>
class Chaos {
 public:
  Chaos(unsigned seed, const Weather& weather, const SessionOptions& options = {})
      : random_(seed), weather_(weather), line(options) {
    line.board = [this](const Written& frame) { hear(frame); };
    line.on_event = [this](const Record& record) { note(record); };
  }

  /// Sends `count` requests at random times and runs until all have ended.
  void run(int count) {
    while (count-- > 0) {
      ask();
      line.run_for(milliseconds(upto(longest_pause)));
      if (chance(3) && !open_.empty()) cancel();
    }
    line.run();
    EXPECT_EQ(line.session.open_requests(), 0U);
    EXPECT_EQ(ended_.size(), asked_.size()) << "each request ends once";
  }

  /// Returns the number of requests with this outcome.
  std::size_t count(Outcome outcome) const {
    std::size_t result = 0;
    for (const auto& [handle, how] : ended_) result += how == outcome ? 1 : 0;
    return result;
  }
  std::size_t asked() const { return asked_.size(); }
  std::size_t late_replies() const {
    std::size_t result = 0;
    for (const Record& record : line.events) result += record.event.is_late ? 1 : 0;
    return result;
  }

 private:
  /// In milliseconds. The small session is often full.
  static constexpr int longest_pause = std::is_same_v<Session, SmallSession> ? 4000 : 60;

  struct Asked {
    std::uint8_t command{};
    std::uint8_t tag{};  // in the body of the request, if it has one
    Instant at{};
  };

  int upto(int most) { return std::uniform_int_distribution<int>(0, most)(random_); }
  bool chance(int percent) { return upto(99) < percent; }

  void ask() {
    SendResult sent;
    const auto tag = static_cast<std::uint8_t>(upto(4));
    switch (upto(6)) {
      case 0: sent = line.session.send(msg::BoardInfoRequest{}); break;
      case 1: sent = line.session.send(msg::ReadParams3Request{.profile_id = tag}); break;
      case 2: {
        msg::WriteParams3 request;
        request.profile_id = tag;
        sent = line.session.send(request);
        break;
      }
      case 3: sent = line.session.send(msg::I2cReadRegBufRequest{}); break;
      case 4:
        sent = line.session.send(msg::ExecuteMenu{}, {.expect_confirmation = chance(50)});
        break;
      case 5: sent = line.session.send(msg::Control{}); break;
      default: sent = line.session.send(msg::CalibGyro{}); break;
    }
    if (!sent) {
      EXPECT_EQ(sent.status, SendStatus::queue_full);
      return;
    }
    asked_[sent.handle] = {0, tag, line.now};
    open_.insert(sent.handle);
  }

  void cancel() {
    auto chosen = open_.begin();
    std::advance(chosen, upto(static_cast<int>(open_.size()) - 1));
    EXPECT_TRUE(line.session.cancel(*chosen, line.sink()));
  }

  /// Receives a frame, unless it is lost.
  void hear(const Written& frame) {
    ++transmission_;
    sent_at_[transmission_] = line.now;
    if (chance(weather_.lost)) return;
    if (chance(weather_.resets)) {
      line.fall_silent_at(line.now + milliseconds(1000));  // restarted by then
      line.say(114, {}, milliseconds(0));
      return;
    }
    if (chance(weather_.errors)) {
      reply(255, {frame.id, 1, 0, 0, 0, 0});
      return;
    }
    // The number of the transmission follows the fields of the message.
    const auto low = static_cast<int>(transmission_ & 0xFF);
    const auto high = static_cast<int>(transmission_ >> 8);
    switch (frame.id) {
      case 86: reply(86, tagged(body_of(18), low, high)); break;
      case 21: reply(21, tagged(body_of(134, {frame.body[0]}), low, high)); break;
      case 40: reply(40, tagged({}, low, high)); break;
      case 22: reply(67, tagged({22}, low, high)); break;
      case 69:
      case 67:
        if (chance(60)) reply(67, tagged({frame.id}, low, high));
        break;
      default:
        reply(67, tagged({frame.id}, low, high));
        reply(67, tagged({frame.id}, low, high), milliseconds(1000 + upto(20000)));
        break;
    }
  }

  static Body tagged(Body body, int low, int high) {
    body.push_back(static_cast<std::uint8_t>(low));
    body.push_back(static_cast<std::uint8_t>(high));
    return body;
  }

  void reply(std::uint8_t id, const Body& body, Duration extra = {}) {
    if (chance(weather_.lost)) return;
    Body bytes = frame_of(id, body);
    if (chance(weather_.garbled)) {
      bytes[static_cast<std::size_t>(upto(static_cast<int>(bytes.size()) - 1))] ^= 0x55;
    }
    if (chance(weather_.noise)) {
      Body noise(static_cast<std::size_t>(upto(12)));
      for (std::uint8_t& byte : noise)
        byte = chance(30) ? '>' : static_cast<std::uint8_t>(upto(255));
      bytes.insert(bytes.begin(), noise.begin(), noise.end());
    }
    // A response is never later than the session allows for.
    const int late = chance(weather_.slow) ? 900 : 100;
    Duration delay = milliseconds(1 + upto(late)) + extra;
    if (extra == Duration{}) {  // a board answers in order, except for what takes long
      last_reply_ = later(last_reply_, line.now + delay);
      delay = last_reply_ - line.now;
    }
    line.say_bytes(bytes, delay);
    if (chance(weather_.repeated)) line.say_bytes(bytes, delay + milliseconds(upto(80)));
  }

  /// Returns the number of the transmission that a response or confirmation answers.
  std::size_t transmission_of(const Record& record) const {
    EXPECT_GE(record.body.size(), 2U);
    const std::size_t end = record.body.size();
    return record.body[end - 2] + (std::size_t{record.body[end - 1]} << 8);
  }

  /// True for what has an effect, and therefore waits neither until another calibration has ended
  /// nor until a frame cannot be repeated any more.
  bool may_be_confused(const Event& event) const {
    constexpr std::uint8_t calibration = 103;
    const bool is_confirmation = event.kind == EventKind::confirmation || event.frame.id == 67;
    return is_confirmation && (event.command == calibration || weather_.repeated != 0);
  }

  void note(const Record& record) {
    const Event& event = record.event;
    if (event.kind == EventKind::completed) {
      EXPECT_TRUE(asked_.contains(event.handle)) << "an unknown request";
      EXPECT_TRUE(ended_.emplace(event.handle, event.outcome).second) << "twice";
      open_.erase(event.handle);
    }
    const bool is_answer =
        event.kind == EventKind::completed &&
        (event.outcome == Outcome::answered || event.outcome == Outcome::confirmed);
    if (!is_answer && (event.kind != EventKind::confirmation || !event.handle)) return;
    // The central property: a request is answered only by a transmission sent after the request was
    // made.
    const std::size_t transmission = transmission_of(record);
    ASSERT_TRUE(sent_at_.contains(transmission));
    if (!may_be_confused(event)) {
      EXPECT_LE(asked_[event.handle].at, sent_at_[transmission])
          << "a request got the response to an earlier one";
    }
    if (event.command == 21) {
      EXPECT_EQ(record.body[0], asked_[event.handle].tag);
    }
    if (event.outcome == Outcome::none || may_be_confused(event)) return;
    const auto [place, is_new] = given_.emplace(transmission, event.handle);
    EXPECT_TRUE(is_new || place->second == event.handle) << "one response for two requests";
  }

  std::mt19937 random_;
  Weather weather_;
  std::size_t transmission_ = 0;
  Instant last_reply_{};
  std::map<std::size_t, Instant> sent_at_;
  std::map<std::size_t, Handle> given_;
  std::map<Handle, Asked> asked_;
  std::map<Handle, Outcome> ended_;
  std::set<Handle> open_;

 public:
  Basic<Session> line;
};

class Schedules : public ::testing::TestWithParam<unsigned> {};

TEST_P(Schedules, NoAnswerGoesToALaterRequest) {
  with_each_session([]<class Session>() {
    Chaos<Session> chaos(GetParam(), bad);
    chaos.run(400);
    EXPECT_GT(chaos.count(Outcome::answered), chaos.asked() / 10);
    EXPECT_GT(chaos.late_replies(), 0U);
  });
}

TEST_P(Schedules, NorOverALineThatRepeats) {
  with_each_session([]<class Session>() {
    Weather weather = bad;
    weather.repeated = 30;
    SessionOptions options{.duplicate_window = milliseconds(100)};
    Chaos<Session> chaos(GetParam(), weather, options);
    chaos.run(300);
    EXPECT_GT(chaos.count(Outcome::answered), 0U);
  });
}

TEST_P(Schedules, NorWhenTheBoardRestarts) {
  with_each_session([]<class Session>() {
    Weather weather;
    weather.resets = 5;
    Chaos<Session> chaos(GetParam(), weather);
    chaos.run(300);
    EXPECT_GT(chaos.count(Outcome::reset), 0U);
  });
}

TEST_P(Schedules, OverAGoodLineEverythingIsAnswered) {
  with_each_session([]<class Session>() {
    Chaos<Session> chaos(GetParam(), {});
    chaos.run(150);
    EXPECT_EQ(chaos.count(Outcome::timeout), 0U);
    EXPECT_LE(chaos.line.written.size(), chaos.asked()) << "a request was sent again";
  });
}

INSTANTIATE_TEST_SUITE_P(Seeds, Schedules, ::testing::Range(1U, 41U));

}  // namespace
}  // namespace sbgc::test
