/// A line that treats each frame as the fuzzer's input says.
#pragma once

#include <deque>
#include <functional>

#include <sbgc/parser.hpp>

#include "client/virtual_client.hpp"
#include "input.hpp"

namespace sbgc::fuzz {

/// Frames stay in order, as on a UART. A fair line loses and delays whole frames; a foul one also
/// changes, repeats and forges them, which 8-bit checksums do not always reveal.
class HostileLine final : public test::VirtualLine {
 public:
  /// Lets `script` control the line from now on; without a script, the line is good.
  void follow(Input* script, bool is_foul) {
    script_ = script;
    is_foul_ = is_foul;
    cut_until_ = Instant{};
  }
  /// Called if the script wants the board to lose its power.
  std::function<void()> on_power_cut{};

  struct Delivered {
    std::uint8_t id{};
    Bytes body{};

    bool operator==(const Delivered&) const = default;
  };
  /// Returns what has arrived at the host since the last call. Foul lines are not recorded.
  std::vector<Delivered> take_delivered() { return std::exchange(delivered_, {}); }

  void send(Way way, std::span<const std::uint8_t> bytes, Instant now) override {
    ParserOfAll parser;
    parser.feed(bytes, [&](const Frame& frame) {
      Bytes whole(max_frame_size);
      whole.resize(write_frame(frame.framing, frame.id, frame.body, whole).size);
      send_frame(way, std::move(whole), frame, now);
    });
    require(parser.counters().skipped_bytes == 0);
  }

  Bytes receive(Way way, Instant now) override {
    Bytes result;
    std::deque<Arrival>& line = under_way(way);
    while (!line.empty() && line.front().at <= now) {
      const Bytes& bytes = line.front().bytes;
      result.insert(result.end(), bytes.begin(), bytes.end());
      if (way == Way::to_host && !is_foul_) record(bytes);
      line.pop_front();
    }
    return result;
  }

  Instant next() const override {
    Instant result = Instant::never;
    for (const auto& line : under_way_) {
      if (!line.empty()) result = earlier(result, line.front().at);
    }
    return result;
  }

 private:
  struct Arrival {
    Instant at{};
    Bytes bytes{};
  };

  std::deque<Arrival>& under_way(Way way) { return under_way_[way == Way::to_board ? 0 : 1]; }

  void send_frame(Way way, Bytes bytes, const Frame& frame, Instant now) {
    const std::uint8_t fate = script_ != nullptr ? script_->byte() : 0;
    if (now < cut_until_) return;
    switch (fate % 16) {
      case 7: return;
      case 8: return arrive(way, std::move(bytes), now + milliseconds(byte() % 201));
      case 9: cut_until_ = now + milliseconds(10) * byte(); return;
      case 10:
        if (on_power_cut) on_power_cut();
        break;
      case 11:
      case 12:
      case 13:
      case 14:
      case 15:
        if (is_foul_) return foul(fate, way, std::move(bytes), frame, now);
        break;
      default: break;
    }
    arrive(way, std::move(bytes), now);
  }

  void foul(int fate, Way way, Bytes bytes, const Frame& frame, Instant now) {
    switch (fate % 16) {
      case 11:  // twice
        arrive(way, bytes, now);
        return arrive(way, std::move(bytes), now + milliseconds(byte() % 201));
      case 12: {  // a changed byte, perhaps with checksums that hide it
        const std::size_t at = byte() % bytes.size();
        bytes[at] = static_cast<std::uint8_t>(bytes[at] ^ byte());
        if (fate < 128) break;
        const auto body = std::span(bytes).subspan(frame_header_size, frame.body.size());
        static_cast<void>(write_frame(frame.framing, frame.id, body, bytes));
        break;
      }
      case 13: bytes.resize(byte() % bytes.size()); break;
      case 14: {  // noise before it
        const auto noise = script_->bytes(byte());
        bytes.insert(bytes.begin(), noise.begin(), noise.end());
        break;
      }
      default: forge(frame, now); break;
    }
    arrive(way, std::move(bytes), now);
  }

  /// A frame that the board never sent, perhaps like a response to the present request.
  void forge(const Frame& frame, Instant now) {
    const std::uint8_t kind = byte();
    const std::uint8_t id = kind < 128 ? frame.id : byte();
    Bytes body;
    if ((kind & 1) != 0) body.assign(frame.body.begin(), frame.body.end());
    const auto rest = script_->bytes(byte());
    if (body.size() + rest.size() <= max_body_size) {
      body.insert(body.end(), rest.begin(), rest.end());
    }
    Bytes whole(max_frame_size);
    whole.resize(write_frame(frame.framing, id, body, whole).size);
    arrive(Way::to_host, std::move(whole), now);
  }

  void arrive(Way way, Bytes bytes, Instant at) {
    std::deque<Arrival>& line = under_way(way);
    if (!line.empty()) at = later(at, line.back().at);
    line.push_back({at, std::move(bytes)});
  }

  void record(const Bytes& bytes) {
    const Frame frame = frame_at(bytes.data());
    delivered_.push_back({frame.id, {frame.body.begin(), frame.body.end()}});
  }

  std::uint8_t byte() { return script_->byte(); }

  Input* script_ = nullptr;
  bool is_foul_ = false;
  Instant cut_until_{};
  std::array<std::deque<Arrival>, 2> under_way_{};
  std::vector<Delivered> delivered_{};
};

}  // namespace sbgc::fuzz
