// A host at the bridge gets what it would get alone: the same bytes in the same order, for every
// request of the model, valid or not.

#include <algorithm>
#include <array>
#include <cstdint>
#include <deque>
#include <filesystem>
#include <fstream>
#include <functional>
#include <random>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sbgc/client/conversation.hpp>
#include <sbgc/emulator/emulator.hpp>
#include <sbgc/message_infos.hpp>
#include <sbgc/messages.hpp>
#include <sbgc/parser.hpp>

#include "conversation/dialogue.hpp"
#include "share/bridge_ports.hpp"

namespace sbgc::tools::transparency {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::Ge;
using ::testing::IsEmpty;
using ::testing::SizeIs;

using Bytes = std::vector<std::uint8_t>;

emulator::EmulatorOptions still_board(std::uint16_t firmware) {
  emulator::EmulatorOptions options;
  options.board.firmware = msg::FirmwareVersion(firmware);
  if (firmware == newest_firmware) options.board.board = msg::BoardVersion(36);
  options.board.gimbal.noise = 0;
  options.line.board.baud_rate = 0;
  return options;
}

/// An emulated board that has just started, in virtual time, and what connects its hosts to it.
class Site {
 public:
  explicit Site(std::uint16_t firmware) : device(still_board(firmware), {}, clock) {}
  Site(const Site&) = delete;
  Site& operator=(const Site&) = delete;
  virtual ~Site() = default;

  virtual void send(const Bytes& bytes) = 0;
  /// Returns the bytes that the host has received since the last call.
  virtual Bytes received() = 0;

  Instant now() const { return clock; }
  void run_for(Duration time) {
    const Instant end = clock + time;
    while (clock < end) {
      const Instant next = step();
      clock = std::clamp(next, clock + microseconds(1), end);
    }
    step();
  }

  Bytes ask(const Bytes& request, Duration patience) {
    send(request);
    run_for(patience);
    return received();
  }

 protected:
  /// Does what is due; returns when to call it again.
  virtual Instant step() = 0;
  Bytes take_output(std::size_t port) {
    const auto waiting = device.to_host(port);
    Bytes bytes(waiting.begin(), waiting.end());
    device.take(port, bytes.size(), clock);
    return bytes;
  }

  Instant clock{1'000'000};
  emulator::Emulator device;
};

class DirectSite final : public Site {
 public:
  explicit DirectSite(std::uint16_t firmware = newest_firmware)
      : Site(firmware), port_(device.connect(false, clock).value()) {
    run_for(seconds(1));
  }

  void send(const Bytes& bytes) override { device.from_host(port_, bytes, clock); }
  Bytes received() override { return std::exchange(received_, {}); }

 private:
  Instant step() override {
    device.advance(clock);
    const Bytes bytes = take_output(port_);
    received_.insert(received_.end(), bytes.begin(), bytes.end());
    return device.next();
  }

  std::size_t port_;
  Bytes received_;
};

/// As `sbgc bridge`, without its threads. There is a second host.
class BridgedSite final : public Site, private BridgeLine {
 public:
  explicit BridgedSite(std::uint16_t firmware = newest_firmware)
      : Site(firmware), port_(device.connect(false, clock).value()) {
    for (Host& host : hosts_) host.port = *ports_.connect(false, [] {});
    run_for(seconds(1));
  }

  void send(const Bytes& bytes) override { hosts_[0].to_bridge = bytes; }
  void send_from_other(const Bytes& bytes) { hosts_[1].to_bridge = bytes; }
  Bytes received() override { return take_from(hosts_[0].port); }
  Bytes overheard() { return take_from(hosts_[1].port); }
  /// Returns how often the line was opened again.
  int reopened() const { return reopened_; }
  /// Delays the board's bytes by varying times, up to this, from now on.
  void delay_up_to(Duration longest) { longest_delay_ = longest; }

 private:
  struct Host {
    std::size_t port{};
    Bytes to_bridge{};
  };

  Bytes take_from(std::size_t host) {
    const auto waiting = ports_.output(host);
    Bytes bytes(waiting.begin(), waiting.end());
    ports_.take(host, bytes.size());
    return bytes;
  }

  Instant step() override {
    if (clock >= next_tick_) {
      ports_.tick();
      next_tick_ = clock + milliseconds(100);
    }
    do {
      feed_bridge();
      exchange_bytes();
    } while (run_posted());
    const Instant next = earlier(earlier(deadline_, device.next()), next_tick_);
    return under_way_.empty() ? next : earlier(next, under_way_.front().first);
  }

  void feed_bridge() {
    for (auto& [port, bytes] : hosts_) {
      const std::size_t size = std::min(bytes.size(), ports_.room(port));
      if (size == 0) continue;
      const auto end = bytes.begin() + static_cast<std::ptrdiff_t>(size);
      const Bytes part(bytes.begin(), end);
      bytes.erase(bytes.begin(), end);
      ports_.receive(port, part);
    }
  }

  void exchange_bytes() {
    const sbgc::Output output = dialogue_.advance(clock, true);
    deadline_ = output.deadline;
    if (!output.bytes.empty()) {
      if (!is_taken_) device.from_host(port_, output.bytes, clock);
      dialogue_.written(clock);
    }
    device.from_host(port_, std::exchange(raw_, {}), clock);
    device.advance(clock);
    const Bytes answers = delayed(take_output(port_));
    if (answers.empty()) return;
    if (is_taken_) return ports_.raw_arrived(answers);
    dialogue_.feed(answers, clock);
    deadline_ = clock;
  }

  Bytes delayed(Bytes sent) {
    if (longest_delay_ == Duration{}) return sent;
    if (!sent.empty()) {
      const auto most = static_cast<int>(longest_delay_.us);
      const Instant at = clock + microseconds(std::uniform_int_distribution<int>(0, most)(random_));
      const Instant before = under_way_.empty() ? at : under_way_.back().first;
      under_way_.emplace_back(std::max(at, before), std::move(sent));
    }
    Bytes arrived;
    while (!under_way_.empty() && under_way_.front().first <= clock) {
      const Bytes& bytes = under_way_.front().second;
      arrived.insert(arrived.end(), bytes.begin(), bytes.end());
      under_way_.pop_front();
    }
    return arrived;
  }

  /// Returns true if the dialogue may have more to do.
  bool run_posted() {
    const bool has_any = !posted_.empty();
    while (!posted_.empty()) {
      const auto next = std::move(posted_.front());
      posted_.pop_front();
      next();
    }
    return has_any;
  }

  /// Hands a copy of the frame over to the bridge.
  void post(const Frame& frame, std::function<void(const Frame&)> use) {
    posted_.emplace_back(
        [id = frame.id, body = Bytes(frame.body.begin(), frame.body.end()), framing = frame.framing,
         use = std::move(use)] { use({.id = id, .body = body, .framing = framing}); });
  }

  void send(std::uint64_t tag, RawRequest request) override {
    request.on_frame = [this, tag](const Frame& frame) {
      post(frame, [this, tag](const Frame& copy) { ports_.answered(tag, copy); });
    };
    const auto call = detail::make_call(
        detail::next_call_id(), detail::Conversation::prepare(std::move(request)), {.retries = 0},
        {}, clock, [this, tag](const Result<Reply>& reply) {
          const auto failure = reply ? std::nullopt : std::optional(reply.error().code);
          posted_.emplace_back([this, tag, failure] { ports_.ended(tag, failure); });
        });
    ASSERT_FALSE(calls_.begin(call));
  }
  void take_line() override { is_taken_ = true; }
  void write_raw(Bytes bytes) override { raw_.insert(raw_.end(), bytes.begin(), bytes.end()); }
  std::size_t raw_waiting() const override { return raw_.size(); }
  void release_line() override { is_taken_ = false; }
  void give_line_back() override {
    ++reopened_;
    is_taken_ = false;
    static_cast<void>(ports_.line_lost());
    ports_.restart_streams();
  }
  void check() override {}
  void take_over(OwedStop) override {}
  void drop_stops() override {}

  std::size_t port_;
  Duration longest_delay_{};
  std::deque<std::pair<Instant, Bytes>> under_way_;
  std::mt19937 random_{7};
  Bytes raw_;
  bool is_taken_ = false;
  int reopened_ = 0;
  std::deque<std::function<void()>> posted_;
  BridgePorts ports_{*this, [this] { return clock; }, {}, true};  // passwords pass as well
  std::array<Host, 2> hosts_{};
  Instant next_tick_{};
  Instant deadline_ = Instant::never;
  detail::SharedCalls calls_{std::size_t{512}};
  detail::Delivery delivery_;
  detail::Dialogue dialogue_{{}, calls_, delivery_};
  Subscription frames_{delivery_.on_frame([this](const BoardFrame& arrived) {
    post(arrived.frame, [this, message = arrived](const Frame& copy) mutable {
      message.frame = copy;
      ports_.arrived(message);
    });
  })};
};

struct Request {
  std::string name{};
  std::uint8_t id{};
  Bytes body{};

  Bytes bytes(Framing framing = basic_framing) const {
    Bytes frame(max_frame_size);
    frame.resize(write_frame(framing, id, body, frame).size);
    return frame;
  }
  ResponsePolicy policy() const { return raw_request(id, body)->policy; }
  Duration patience() const {
    return milliseconds(std::max(policy().timeout_ms, policy().finish_ms)) + milliseconds(200);
  }
};

std::string text_between(const std::string& line, const std::string& before, char after) {
  const std::size_t begin = line.find(before) + before.size();
  return line.substr(begin, line.find(after, begin) - begin);
}

Bytes from_hex(const std::string& text) {
  Bytes bytes;
  for (std::size_t i = 0; i < text.size(); i += 2) {
    bytes.push_back(static_cast<std::uint8_t>(std::stoul(text.substr(i, 2), nullptr, 16)));
  }
  return bytes;
}

/// Every request of the model: with typical values, with zeros, with values that are mostly
/// invalid, with a byte less, with a byte more.
std::vector<Request> all_requests() {
  std::vector<Request> requests;
  for (const auto& file : std::filesystem::directory_iterator(SBGC_GENERATED "/vectors")) {
    std::ifstream lines(file.path());
    for (std::string line; std::getline(lines, line);) {
      const bool is_chosen = line.find(R"("direction":"to_board")") != std::string::npos &&
                             line.find(R"("why":"typical values")") != std::string::npos;
      if (!is_chosen) continue;
      const auto id = static_cast<std::uint8_t>(std::stoi(text_between(line, R"("id":)", ',')));
      const std::string name = text_between(line, R"("message":")", '"');
      const Bytes typical = from_hex(text_between(line, R"("hex":")", '"'));
      requests.push_back({name, id, typical});
      requests.push_back({name + ", zeros", id, Bytes(typical.size())});
      requests.push_back({name + ", ones", id, Bytes(typical.size(), 0xFF)});
      if (!typical.empty()) {
        requests.push_back({name + ", short", id, {typical.begin(), typical.end() - 1}});
      }
      Bytes longer = typical;
      longer.push_back(1);
      if (longer.size() <= max_body_size) requests.push_back({name + ", long", id, longer});
    }
  }
  requests.push_back({"no command", 249, {1, 2, 3}});
  return requests;
}

TEST(BridgeTransparency, EachRequestOfTheModelIsTested) {
  std::set<std::string> names;
  for (const Request& request : all_requests()) names.insert(request.name);
  for (const MessageInfo* const info : message_infos) {
    if (info->direction != Direction::from_board) EXPECT_THAT(names, Contains(info->name));
  }
}

TEST(BridgeTransparency, EachRequestAloneIsAnsweredWithTheSameBytes) {
  for (const std::uint16_t firmware : {std::uint16_t{2590}, std::uint16_t{newest_firmware}}) {
    int answered = 0;
    for (const Request& request : all_requests()) {
      SCOPED_TRACE(request.name);
      DirectSite direct(firmware);
      BridgedSite bridged(firmware);
      const Bytes expected = direct.ask(request.bytes(), request.patience());
      answered += expected.empty() ? 0 : 1;
      EXPECT_EQ(bridged.ask(request.bytes(), request.patience()), expected);
      EXPECT_THAT(bridged.overheard(), IsEmpty());
    }
    EXPECT_GT(answered, 400);
  }
}

/// The ids of the frames, and what is confirmed or refused: contents may depend on the time.
std::vector<std::string> outline_of(const Bytes& bytes) {
  std::vector<std::string> outline;
  ParserOfAll parser;
  parser.feed(bytes, [&](const Frame& frame) {
    std::string text = std::to_string(frame.id);
    if (frame.framing != basic_framing) text += " v2";
    if (roles::is_confirmation(frame))
      text += " confirms " + std::to_string(roles::confirmed_command(frame));
    if (roles::is_error(frame)) text += " refuses " + std::to_string(roles::failed_command(frame));
    outline.push_back(text);
  });
  return outline;
}

template <class M>
Bytes frame_of(const M& message, Framing framing = basic_framing) {
  Bytes bytes(max_frame_size);
  bytes.resize(encode_frame(framing, message, bytes).size);
  return bytes;
}

Bytes operator+(Bytes a, const Bytes& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

TEST(BridgeTransparency, RequestsInOneWriteAreAnsweredInTheirOrderAndFraming) {
  const Bytes info = frame_of(msg::BoardInfoRequest{});
  for (const Request& request : all_requests()) {
    // The only exception, because it is safer: a stop overtakes what waits.
    if (request.policy().stops) continue;
    SCOPED_TRACE(request.name);
    DirectSite direct;
    BridgedSite bridged;
    const Bytes bytes = request.bytes() + info + request.bytes(Framing::v2) + info;
    const auto expected = outline_of(direct.ask(bytes, request.patience() * 2));
    EXPECT_EQ(outline_of(bridged.ask(bytes, request.patience() * 2)), expected);
  }
}

msg::DataStreamInterval stream(msg::CommandFromBoard what, std::uint16_t interval) {
  msg::DataStreamInterval request;
  request.cmd_id = what;
  request.interval_ms = msg::Milliseconds(interval);
  return request;
}

TEST(BridgeTransparency, StreamsStartAndStopAsTheBoardSays) {
  DirectSite direct;
  BridgedSite bridged;
  const auto ask = [&](const Bytes& bytes) {
    auto expected = outline_of(direct.ask(bytes, milliseconds(500)));
    EXPECT_EQ(outline_of(bridged.ask(bytes, milliseconds(500))), expected);
    return expected;
  };
  Bytes starts, stops;
  for (const auto what : {msg::RealtimeData3::command, msg::RealtimeData4::command}) {
    starts = starts + frame_of(stream(what, 50));
    stops = stops + frame_of(stream(what, 0));
  }
  EXPECT_THAT(ask(starts), SizeIs(Ge(2 + 16)));
  EXPECT_THAT(ask(stops), Contains("23")) << "a sample that comes before the confirmation";
  EXPECT_THAT(ask(stops), SizeIs(2));
  EXPECT_THAT(ask(starts + stops + starts), SizeIs(Ge(6 + 16)));
}

std::size_t equal_bytes(const Bytes& a, const Bytes& b) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < a.size() && i < b.size(); ++i) count += a[i] == b[i] ? 1 : 0;
  return count;
}

/// True if a body is like one and not like another, unless these are alike.
bool is_rather(const Bytes& body, const Bytes& one, const Bytes& other) {
  if (body.size() != one.size()) return false;
  const bool are_alike = one.size() == other.size() && 2 * equal_bytes(one, other) > one.size();
  return are_alike || body.size() != other.size() ||
         equal_bytes(body, one) > equal_bytes(body, other);
}

std::vector<Bytes> bodies_with(std::uint8_t id, const Bytes& bytes) {
  std::vector<Bytes> bodies;
  ParserOfAll parser;
  parser.feed(bytes, [&](const Frame& frame) {
    if (frame.id == id) bodies.emplace_back(frame.body.begin(), frame.body.end());
  });
  return bodies;
}

/// A stream of a message, and a request for the same message.
struct Pair {
  std::uint8_t message{};
  std::array<std::uint8_t, max_stream_config> config{};
  Request request{};

  Bytes stream(std::uint16_t interval) const {
    Request start{.id = static_cast<std::uint8_t>(msg::DataStreamInterval::command),
                  .body = Bytes(21)};
    start.body[0] = message;
    start.body[1] = static_cast<std::uint8_t>(interval);
    start.body[2] = static_cast<std::uint8_t>(interval >> 8);
    std::ranges::copy(config, start.body.begin() + 3);
    return start.bytes();
  }
};

/// All requests for messages that boards also stream, with streams of the same and of other
/// content.
std::vector<Pair> all_pairs() {
  std::set<std::uint8_t> streamed;
  roles::StreamMessages::for_each(
      [&]<class M>(Type<M>) { streamed.insert(static_cast<std::uint8_t>(M::command)); });
  std::vector<Pair> pairs;
  for (const Request& request : all_requests()) {
    const ResponsePolicy policy = request.policy();
    const std::uint8_t message = policy.responses.forms[0].id;
    const bool is_typical = request.name.find(',') == std::string::npos;
    if (!is_typical || policy.has_effect || !streamed.contains(message)) continue;
    pairs.push_back({message, policy.stream.config, request});
    // Other IMUs or motors, and other blocks of the same size and of another one.
    for (const int other : {0, 1, 2, 8, 0x20, 0x40}) {
      Pair pair{message, {static_cast<std::uint8_t>(other)}, request};
      if (pair.config != policy.stream.config) pairs.push_back(pair);
    }
    Pair acceleration{message, {0, 2}, request};  // ACC_DATA
    pairs.push_back(acceleration);
  }
  return pairs;
}

TEST(BridgeTransparency, ASingleAnswerIsOnlyForTheHostThatAsked) {
  std::mt19937 random(1);
  const auto upto = [&](int most) { return std::uniform_int_distribution<int>(0, most)(random); };
  // A camera that stands still sends the same values again.
  constexpr Duration settling = seconds(6);
  constexpr std::array intervals{2, 15, 20, 50, 100, 400, 1500};
  std::set<std::uint8_t> tested;
  int answers = 0;
  int told = 0;
  int refusals = 0;
  for (const Pair& pair : all_pairs()) {
    DirectSite direct;
    static_cast<void>(direct.ask({}, settling));
    const auto asked =
        bodies_with(pair.message, direct.ask(pair.request.bytes(), milliseconds(100)));
    const auto streamed = bodies_with(pair.message, direct.ask(pair.stream(20), seconds(3)));
    if (streamed.size() < 4 || asked.size() != 1) continue;  // this board has no such stream
    tested.insert(pair.message);
    // Values that change all the time do not show whose they are.
    const bool can_tell = std::ranges::all_of(streamed, [&](const Bytes& body) {
      return is_rather(body, streamed[0], asked[0]) && !is_rather(body, asked[0], streamed[0]);
    });
    for (int run = 0; run < 4; ++run) {
      const int interval = intervals[static_cast<std::size_t>(upto(std::ssize(intervals) - 1))];
      const bool is_even = upto(1) == 0;
      SCOPED_TRACE(pair.request.name + " " + std::to_string(pair.config[0]) + " every " +
                   std::to_string(interval) + (is_even ? "" : ", delayed"));
      BridgedSite site;
      if (!is_even) site.delay_up_to(microseconds(interval * 150));
      site.run_for(settling);
      const Instant start = site.now();
      site.send_from_other(pair.stream(static_cast<std::uint16_t>(interval)));
      site.run_for(milliseconds(50 + upto(interval)));
      Bytes overheard;
      int given = 0;
      constexpr int questions = 4;
      for (int i = 0; i < questions; ++i) {
        const Bytes bytes =
            site.ask(pair.request.bytes(), milliseconds(200 + 2 * interval + upto(interval)));
        const auto bodies = bodies_with(pair.message, bytes);
        const auto count = std::ssize(outline_of(bytes));
        EXPECT_LE(count, 1);
        for (const Bytes& body : bodies) {
          EXPECT_TRUE(!can_tell || is_rather(body, asked[0], streamed[0]));
          told += can_tell ? 1 : 0;
        }
        given += static_cast<int>(count);
        answers += static_cast<int>(bodies.size());
        refusals += static_cast<int>(count - std::ssize(bodies));
        overheard = overheard + site.overheard();
      }
      const auto samples = bodies_with(pair.message, overheard);
      for (const Bytes& body : samples) {
        EXPECT_TRUE(!can_tell || is_rather(body, streamed[0], asked[0]));
      }
      const auto time = (site.now() - start).us / 1000;
      EXPECT_LE(std::ssize(samples), time / interval);
      if (!is_even) continue;
      EXPECT_EQ(given, questions);
      EXPECT_GE(std::ssize(samples), (time - 20) / interval - 1);
    }
  }
  EXPECT_THAT(tested, SizeIs(Ge(5U)));
  EXPECT_GT(answers, 3 * refusals);
  EXPECT_GT(refusals, 0);
  EXPECT_GT(told, answers / 4);
}

TEST(BridgeTransparency, TheEndOfATaskIsConfirmedToTheHostThatBeganIt) {
  msg::Control turn;
  turn.control_mode.set_mode(msg::ControlModeKind::angle);
  turn.control_mode.set_flags(msg::ControlFlag::auto_task);
  turn.axes.pitch.angle = 20_deg;
  msg::SelectImu3Calibrate calibrate;
  calibrate.imu_type = msg::CalibImu::main;
  calibrate.action = msg::CalibAction::regular;
  msg::SelectImu3 select;
  select.imu_type = msg::SelectedImu::main;
  struct Case {
    Bytes before, task, other;
  };
  const std::array<Case, 2> cases{
      {{frame_of(msg::MotorsOn{}), frame_of(turn), frame_of(msg::Control{})},
       {frame_of(msg::MotorsOff{}), frame_of(calibrate), frame_of(select)}}};
  for (const auto& [before, task, other] : cases) {
    BridgedSite site;
    site.ask(before, seconds(1));
    site.send(task);
    site.run_for(milliseconds(50));
    for (int i = 0; i < 3; ++i) {
      site.send_from_other(other);
      site.run_for(milliseconds(20));
    }
    site.run_for(seconds(30));
    EXPECT_THAT(outline_of(site.received()), SizeIs(2));
    EXPECT_THAT(outline_of(site.overheard()), SizeIs(3));
  }
}

TEST(BridgeTransparency, AfterARestartOthersAreServedAsSoonAsTheBoardAnswers) {
  const Bytes question = frame_of(msg::GetAnglesRequest{});
  msg::ResetRequestExt later;
  later.delay_ms = msg::Milliseconds(1000);
  for (const Bytes& reset : {frame_of(msg::ResetRequest{}), frame_of(later)}) {
    for (const int at : {10, 300, 700, 900, 1300, 1900, 5100}) {
      SCOPED_TRACE(std::to_string(reset.size()) + " bytes, " + std::to_string(at) + " ms");
      // Directly, the host asks until the board answers.
      DirectSite direct;
      direct.send(reset);
      direct.run_for(milliseconds(at));
      int expected = at;
      while (outline_of(direct.ask(question, milliseconds(20))).empty()) expected += 20;
      BridgedSite site;
      site.send_from_other(frame_of(stream(msg::RealtimeData3::command, 50)));
      site.run_for(milliseconds(200));
      static_cast<void>(site.overheard());
      site.send(reset);
      site.run_for(milliseconds(at));
      static_cast<void>(site.overheard());
      site.send_from_other(question);
      int passed = at;
      std::vector<std::string> answers;
      const auto is_sample = [](const std::string& one) { return one == "23"; };
      while (answers.empty() && passed < 10'000) {
        site.run_for(milliseconds(20));
        passed += 20;
        answers = outline_of(site.overheard());
        std::erase_if(answers, is_sample);
      }
      EXPECT_LE(passed, expected + 500);
      EXPECT_THAT(answers, SizeIs(1));
      site.run_for(seconds(6));
      EXPECT_THAT(outline_of(site.received()), IsEmpty()) << "it has asked for nothing";
      EXPECT_THAT(outline_of(site.overheard()), Contains("23")) << "the stream goes on";
      EXPECT_EQ(site.reopened(), 0);
    }
  }
}

TEST(BridgeTransparency, AResetWaitsForNoCalibration) {
  for (const auto calibration : {msg::CalibPoles::command, msg::CalibGyro::command}) {
    DirectSite direct;
    BridgedSite bridged;
    const Bytes begin = Request{.id = static_cast<std::uint8_t>(calibration)}.bytes();
    msg::ResetRequestExt reset;
    reset.confirm = msg::ResetOption::notify;
    for (Site* const site : {static_cast<Site*>(&direct), static_cast<Site*>(&bridged)}) {
      site->ask(begin, milliseconds(100));
      EXPECT_THAT(outline_of(site->ask(frame_of(reset), milliseconds(20))), ElementsAre("114"));
    }
  }
}

TEST(BridgeTransparency, ConfirmationsAndErrorsGoToThoseWhoAsked) {
  BridgedSite site;
  const Bytes valid = Request{.id = 67, .body = Bytes(13)}.bytes();
  const Bytes invalid = Request{.id = 67, .body = Bytes(12)}.bytes(Framing::v2);
  const Bytes other = Request{.id = 140, .body = {}}.bytes();
  for (int i = 0; i < 50; ++i) {
    site.send(valid);
    site.send_from_other(invalid + other);
    site.run_for(milliseconds(100));
    EXPECT_THAT(outline_of(site.received()), ElementsAre("67 confirms 67"));
    EXPECT_THAT(outline_of(site.overheard()), ElementsAre("255 v2 refuses 67", "255 refuses 140"));
  }
}

}  // namespace
}  // namespace sbgc::tools::transparency
