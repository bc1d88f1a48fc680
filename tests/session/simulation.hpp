/// A session and a scripted peer on an in-memory line, in virtual time.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <random>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sbgc/parser.hpp>
#include <sbgc/responses/all.hpp>
#include <sbgc/session.hpp>

namespace sbgc::test {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::SizeIs;
using ::testing::UnorderedElementsAre;

// Command ids of the protocol, as listed in the specification.
inline constexpr std::uint8_t read_params_3 = 21;
inline constexpr std::uint8_t write_params_3 = 22;
inline constexpr std::uint8_t realtime_data_4 = 25;
inline constexpr std::uint8_t i2c_read = 40;
inline constexpr std::uint8_t eeprom_write = 47;
inline constexpr std::uint8_t eeprom_read = 48;
inline constexpr std::uint8_t read_file = 53;
inline constexpr std::uint8_t write_file = 54;
inline constexpr std::uint8_t control = 67;
inline constexpr std::uint8_t confirm = 67;
inline constexpr std::uint8_t motors_on = 77;
inline constexpr std::uint8_t motors_off = 109;
inline constexpr std::uint8_t stream_interval = 85;
inline constexpr std::uint8_t board_info = 86;
inline constexpr std::uint8_t realtime_data_custom = 88;
inline constexpr std::uint8_t calib_gyro = 103;
inline constexpr std::uint8_t reset = 114;
inline constexpr std::uint8_t error = 255;

using Body = std::vector<std::uint8_t>;

inline constexpr Instant start_time = Instant{} + seconds(1000);

inline Body frame_of(std::uint8_t id, const Body& body, Framing framing = basic_framing) {
  Body frame(max_frame_size);
  frame.resize(write_frame(framing, id, body, frame).size);
  return frame;
}

/// Returns a body of `size` bytes that starts with `begin` and is padded with zeros.
inline Body body_of(std::size_t size, std::initializer_list<int> begin = {}) {
  Body body;
  for (const int byte : begin) body.push_back(static_cast<std::uint8_t>(byte));
  body.resize(size);
  return body;
}

/// Returns a request for a stream, or for its end.
template <class Command>
msg::DataStreamInterval stream_of(Command command, std::uint16_t interval_ms) {
  return {.cmd_id = static_cast<msg::CommandFromBoard>(command),
          .interval_ms = msg::Milliseconds(interval_ms)};
}

/// An event with a copy of its body.
struct Record {
  Event event;
  Body body;
  Instant at;
};

/// A frame written by the session.
struct Written {
  std::uint8_t id;
  Body body;
  Instant at;
  Framing framing = basic_framing;
};

/// Returns the ids of frames.
inline std::vector<std::uint8_t> ids(const std::vector<Written>& written) {
  std::vector<std::uint8_t> result;
  result.reserve(written.size());
  for (const Written& frame : written) result.push_back(frame.id);
  return result;
}

/// Runs a session until no more events are pending. Its frames go to `board`, which responds with
/// say(). Time passes only inside run() and run_for().
template <class Session = Session>
class Basic {
 public:
  explicit Basic(const SessionOptions& options = {}) : session(options) {}

  Session session;
  Instant now = start_time;
  std::function<void(const Written&)> board = [](const Written&) {};
  std::function<void(const Record&)> on_event = [](const Record&) {};
  std::vector<Record> events;
  std::vector<Written> written;
  Duration late{};  ///< how late the owner of the session is

  /// Delivers bytes of the peer after `delay`.
  void say_bytes(const Body& bytes, Duration delay = milliseconds(3)) {
    incoming_.emplace((now + delay).us, bytes);
  }
  void say(std::uint8_t id, const Body& body, Duration delay = milliseconds(3)) {
    say_bytes(frame_of(id, body), delay);
  }
  /// Sends a confirmation of `command`.
  void confirm(std::uint8_t command, Duration delay = milliseconds(3)) {
    say(67, {command}, delay);
  }

  /// Discards the peer's bytes that would arrive at `end` or later.
  void fall_silent_at(Instant end) {
    incoming_.erase(incoming_.lower_bound(end.us), incoming_.end());
  }

  template <class M>
  Handle send(const M& request, const SendOptions& options = {}) {
    const SendResult result = session.send(request, options);
    EXPECT_TRUE(result) << "the session rejected a request";
    return result.handle;
  }

  /// Sends a request and runs until no more events are pending; returns the outcome.
  template <class M>
  Outcome ask(const M& request, const SendOptions& options = {}) {
    const Handle handle = send(request, options);
    run();
    return outcome(handle);
  }

  /// Runs for `duration`.
  void run_for(Duration duration) { run_until(now + duration); }

  /// Runs until no more events are pending.
  void run() { run_until(Instant::never); }

  void run_until(Instant end) {
    for (std::size_t steps = 0; steps < 1'000'000; ++steps) {
      const Output output = session.poll(now, sink());
      if (!output.bytes.empty()) {
        write(output.bytes);
        continue;
      }
      ASSERT_GT(output.deadline, now) << "poll() would be called again and again";
      Instant next = output.deadline;
      if (!incoming_.empty()) next = earlier(next, {incoming_.begin()->first});
      if (next > end || next == Instant::never) {
        if (end != Instant::never) now = end;
        return;
      }
      now = earlier(next + late, end);
      while (!incoming_.empty() && incoming_.begin()->first <= now.us) {
        const Body bytes = incoming_.begin()->second;
        incoming_.erase(incoming_.begin());
        session.feed(bytes, now, sink());
      }
    }
    FAIL() << "no end";
  }

  /// Returns the outcome of a request; Outcome::none if it is open. Ending twice fails the test.
  Outcome outcome(Handle handle) const {
    const Record* const record = completion(handle);
    return record == nullptr ? Outcome::none : record->event.outcome;
  }

  /// Returns the `completed` event of a request, or null.
  const Record* completion(Handle handle) const {
    const Record* found = nullptr;
    for (const Record& record : events) {
      if (record.event.kind != EventKind::completed || record.event.handle != handle) {
        continue;
      }
      EXPECT_EQ(found, nullptr) << "completed twice";
      found = &record;
    }
    return found;
  }

  /// Returns the events of one kind.
  std::vector<Record> of(EventKind kind) const {
    std::vector<Record> found;
    for (const Record& record : events) {
      if (record.event.kind == kind) found.push_back(record);
    }
    return found;
  }

  /// Returns a sink that records events.
  auto sink() {
    return [this](const Event& event) {
      Record record{event, {event.frame.body.begin(), event.frame.body.end()}, now};
      record.event.frame.body = {};
      events.push_back(record);
      on_event(record);
    };
  }

 private:
  void write(std::span<const std::uint8_t> bytes) {
    std::optional<Written> frame;
    ParserOfAll parser;
    parser.feed(bytes, [&](const Frame& found) {
      frame = Written{found.id, {found.body.begin(), found.body.end()}, now, found.framing};
    });
    ASSERT_TRUE(frame) << "not exactly one complete frame";
    written.push_back(*frame);
    board(*frame);
  }

  std::multimap<std::int64_t, Body> incoming_;
};

using Simulation = Basic<>;

/// A test with a session and its peer.
class LineTest : public ::testing::Test {
 protected:
  /// From now on, the board confirms each request.
  void confirm_all() {
    line.board = [this](const Written& frame) { line.confirm(frame.id); };
  }

  /// Returns the time between the frame with this index and the one before.
  Duration gap(std::size_t index) const {
    return line.written.at(index).at - line.written.at(index - 1).at;
  }

  Simulation line;
};

}  // namespace sbgc::test
