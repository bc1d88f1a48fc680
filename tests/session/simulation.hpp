/// A session and a scripted peer on an in-memory line, in virtual time.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <map>
#include <optional>
#include <span>
#include <vector>

#include <gtest/gtest.h>

#include <sbgc/frame.hpp>
#include <sbgc/parser.hpp>
#include <sbgc/session.hpp>

namespace simulation {

using Body = std::vector<std::uint8_t>;

inline constexpr sbgc::Instant start = sbgc::Instant{} + sbgc::seconds(1000);

inline Body frame_of(std::uint8_t id, const Body& body,
                     sbgc::Framing framing = sbgc::basic_framing) {
  Body frame(sbgc::max_frame_size);
  frame.resize(sbgc::write_frame(framing, id, body, frame).size);
  return frame;
}

/// Returns a body of `size` bytes that starts with `begin` and is padded with zeros.
inline Body body_of(std::size_t size, std::initializer_list<int> begin = {}) {
  Body body;
  for (const int byte : begin) body.push_back(static_cast<std::uint8_t>(byte));
  body.resize(size);
  return body;
}

/// An event with a copy of its body.
struct Record {
  sbgc::Event event;
  Body body;
  sbgc::Instant at;
};

/// A frame written by the session.
struct Written {
  std::uint8_t id;
  Body body;
  sbgc::Instant at;
  sbgc::Framing framing = sbgc::basic_framing;
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
template <class Session = sbgc::Session>
class Basic {
 public:
  explicit Basic(const sbgc::SessionOptions& options = {}) : session(options) {}

  Session session;
  sbgc::Instant now = start;
  std::function<void(const Written&)> board = [](const Written&) {};
  std::function<void(const Record&)> on_event = [](const Record&) {};
  std::vector<Record> events;
  std::vector<Written> written;
  sbgc::Duration late{};  ///< how late the owner of the session is

  /// Delivers bytes of the peer after `delay`.
  void say_bytes(const Body& bytes, sbgc::Duration delay = sbgc::milliseconds(3)) {
    incoming_.emplace((now + delay).us, bytes);
  }
  void say(std::uint8_t id, const Body& body, sbgc::Duration delay = sbgc::milliseconds(3)) {
    say_bytes(frame_of(id, body), delay);
  }
  /// Sends a confirmation of `command`.
  void confirm(std::uint8_t command, sbgc::Duration delay = sbgc::milliseconds(3)) {
    say(67, {command}, delay);
  }

  /// Discards the peer's bytes that would arrive at `end` or later.
  void fall_silent_at(sbgc::Instant end) {
    incoming_.erase(incoming_.lower_bound(end.us), incoming_.end());
  }

  template <class M>
  sbgc::Handle send(const M& request, const sbgc::SendOptions& options = {}) {
    const sbgc::SendResult result = session.send(request, options);
    EXPECT_TRUE(result) << "the session rejected a request";
    return result.handle;
  }

  /// Runs for `duration`.
  void run_for(sbgc::Duration duration) { run_until(now + duration); }

  /// Runs until no more events are pending.
  void run() { run_until(sbgc::Instant::never); }

  void run_until(sbgc::Instant end) {
    for (std::size_t steps = 0; steps < 1'000'000; ++steps) {
      const sbgc::Output output = session.poll(now, sink());
      if (!output.bytes.empty()) {
        write(output.bytes);
        continue;
      }
      ASSERT_GT(output.deadline, now) << "poll() would be called again and again";
      sbgc::Instant next = output.deadline;
      if (!incoming_.empty()) next = sbgc::earlier(next, {incoming_.begin()->first});
      if (next > end || next == sbgc::Instant::never) {
        if (end != sbgc::Instant::never) now = end;
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
  sbgc::Outcome outcome(sbgc::Handle handle) const {
    const Record* const record = completion(handle);
    return record == nullptr ? sbgc::Outcome::none : record->event.outcome;
  }

  /// Returns the `completed` event of a request, or null.
  const Record* completion(sbgc::Handle handle) const {
    const Record* found = nullptr;
    for (const Record& record : events) {
      if (record.event.kind != sbgc::EventKind::completed || record.event.handle != handle) {
        continue;
      }
      EXPECT_EQ(found, nullptr) << "completed twice";
      found = &record;
    }
    return found;
  }

  /// Returns the events of one kind.
  std::vector<Record> of(sbgc::EventKind kind) const {
    std::vector<Record> found;
    for (const Record& record : events) {
      if (record.event.kind == kind) found.push_back(record);
    }
    return found;
  }

  /// Returns a sink that records events.
  auto sink() {
    return [this](const sbgc::Event& event) {
      Record record{event, {event.frame.body.begin(), event.frame.body.end()}, now};
      record.event.frame.body = {};
      events.push_back(record);
      on_event(record);
    };
  }

 private:
  void write(std::span<const std::uint8_t> bytes) {
    std::optional<Written> frame;
    sbgc::ParserOfAll parser;
    parser.feed(bytes, [&](const sbgc::Frame& found) {
      frame = Written{found.id, {found.body.begin(), found.body.end()}, now, found.framing};
    });
    ASSERT_TRUE(frame) << "not exactly one complete frame";
    written.push_back(*frame);
    board(*frame);
  }

  std::multimap<std::int64_t, Body> incoming_;
};

using Simulation = Basic<>;

}  // namespace simulation
