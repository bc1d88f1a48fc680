/// The data streams that a session has started, and their bandwidth.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>

#include <sbgc/frame.hpp>
#include <sbgc/response_policy.hpp>
#include <sbgc/session/event.hpp>

namespace sbgc::detail {

/// Returns the bandwidth of a stream in bytes per second, including framing, rounded up; 0 for one
/// that ends.
constexpr std::uint32_t stream_load(const StreamChange& stream, Framing framing) noexcept {
  if (stream.interval_us == 0) return 0;
  static_assert(max_frame_size * std::uint64_t{1'000'000} <=
                std::numeric_limits<std::uint32_t>::max());
  const auto bytes = static_cast<std::uint32_t>(frame_size(framing, stream.size));
  return (bytes * 1'000'000 - 1) / stream.interval_us + 1;
}

/// Returns a + b, at most the largest number.
constexpr std::uint32_t saturated_sum(std::uint32_t a, std::uint32_t b) noexcept {
  const std::uint32_t room = std::numeric_limits<std::uint32_t>::max() - a;
  return b < room ? a + b : a + room;
}

/// The streams by command and config. From ask() until settle(), a change counts with the larger of
/// the bandwidths before and after it.
template <std::size_t capacity>
class Streams {
 public:
  /// Sets the framing of samples; bandwidths of earlier changes remain.
  constexpr void set_framing(Framing framing) noexcept { framing_ = framing; }

  /// Returns ok if a change fits, else over_budget or too_many_streams. `limit` 0 means no limit.
  constexpr SendStatus check(const StreamChange& change, std::uint32_t limit) const noexcept {
    const std::uint32_t load = stream_load(change, framing_);
    if (load == 0) return SendStatus::ok;
    const std::size_t place = find(change);
    if (place == capacity) return SendStatus::too_many_streams;
    const std::uint32_t before = place < size_ ? streams_[place].taken() : 0;
    // A decrease always fits.
    if (limit != 0 && load > before && saturated_sum(used() - before, load) > limit) {
      return SendStatus::over_budget;
    }
    return SendStatus::ok;
  }

  /// Records a requested change that check() allows. Returns false if there is no room, because the
  /// change ends an unknown stream; settle() must not be called for it then.
  constexpr bool ask(const StreamChange& change) noexcept {
    const std::size_t place = find(change);
    if (place == capacity) return false;
    Stream& stream = streams_[place];
    if (place == size_) {
      stream = {change.command, change.size, change.config};
      ++size_;
    }
    const std::uint32_t load = stream_load(change, framing_);
    if (stream.asked < load) stream.asked = load;
    ++stream.changes;
    return true;
  }

  /// Completes a change recorded by ask(); `done` is true if the board has made it.
  constexpr void settle(const StreamChange& change, bool done) noexcept {
    const std::size_t place = find(change);
    if (place == size_) return;
    Stream& stream = streams_[place];
    if (done) stream.load = stream_load(change, framing_);
    if (--stream.changes != 0) return;
    stream.asked = 0;
    if (stream.load == 0) stream = streams_[--size_];
  }

  /// Returns true if a stream that is running or being started consists of this message.
  constexpr bool has(std::uint8_t command) const noexcept {
    for (std::size_t i = 0; i < size_; ++i) {
      if (streams_[i].command == command) return true;
    }
    return false;
  }

  /// Returns true if the frame has exactly the size of a stream's samples.
  constexpr bool has_size_of_sample(const Frame& frame) const noexcept {
    for (std::size_t i = 0; i < size_; ++i) {
      if (streams_[i].command == frame.id && streams_[i].size == frame.body.size()) return true;
    }
    return false;
  }

  /// Returns the total bandwidth in bytes per second.
  constexpr std::uint32_t used() const noexcept {
    std::uint32_t sum = 0;
    for (std::size_t i = 0; i < size_; ++i) sum = saturated_sum(sum, streams_[i].taken());
    return sum;
  }

  /// Stops all streams. The board may still make the changes that are not settled.
  constexpr void stop() noexcept {
    for (std::size_t i = size_; i-- > 0;) {
      streams_[i].load = 0;
      if (streams_[i].changes == 0) streams_[i] = streams_[--size_];
    }
  }

  /// Removes all streams, including changes that are not settled.
  constexpr void clear() noexcept { size_ = 0; }

 private:
  struct Stream {
    std::uint8_t command{};
    std::uint8_t size{};
    std::array<std::uint8_t, max_stream_config> config{};
    std::uint32_t load{};     // confirmed by the board
    std::uint32_t asked{};    // the maximum of the changes not settled
    std::uint32_t changes{};  // the number of changes not settled

    constexpr std::uint32_t taken() const noexcept { return load < asked ? asked : load; }
  };

  /// Returns the index of the stream that a change concerns, else the first free one.
  constexpr std::size_t find(const StreamChange& change) const noexcept {
    std::size_t i = 0;
    while (i < size_ &&
           (streams_[i].command != change.command || streams_[i].config != change.config)) {
      ++i;
    }
    return i;
  }

  std::array<Stream, capacity> streams_{};
  std::size_t size_{};
  Framing framing_ = basic_framing;
};

/// Of a session that starts no streams.
template <>
class Streams<0> {
 public:
  constexpr void set_framing(Framing) noexcept {}
  constexpr SendStatus check(const StreamChange& change, std::uint32_t) const noexcept {
    return change.interval_us == 0 ? SendStatus::ok : SendStatus::too_many_streams;
  }
  constexpr bool ask(const StreamChange&) noexcept { return false; }
  constexpr void settle(const StreamChange&, bool) noexcept {}
  constexpr bool has(std::uint8_t) const noexcept { return false; }
  constexpr bool has_size_of_sample(const Frame&) const noexcept { return false; }
  constexpr std::uint32_t used() const noexcept { return 0; }
  constexpr void stop() noexcept {}
  constexpr void clear() noexcept {}
};

}  // namespace sbgc::detail
