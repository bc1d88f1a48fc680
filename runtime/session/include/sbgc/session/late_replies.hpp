/// Late replies: responses to requests that have ended.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include <sbgc/response_policy.hpp>
#include <sbgc/session/event.hpp>
#include <sbgc/session/ticks.hpp>

namespace sbgc::detail {

/// The request that a late reply answers.
struct LateRequest {
  Handle handle{};  // the last one, if there are several
  std::uint16_t host{};
  Responses responses{};
};

/// The late replies that may still arrive. They consume matching frames, so that no frame is
/// matched to a later request. During the last part of its time, the memory of the session, an
/// entry only tells whose request a frame answers.
template <std::size_t capacity>
class LateReplies {
 public:
  /// With the memory of a session.
  constexpr explicit LateReplies(Ticks memory = 0) noexcept : memory_(memory) {}

  constexpr std::size_t size() const noexcept { return size_; }

  /// Returns true if an entry could be added while `reserved` places stay free.
  constexpr bool has_room(std::size_t reserved) const noexcept {
    const auto any = [](const LateRequest&) { return true; };
    return count(any) + reserved < capacity;
  }

  /// Expects up to `frames` further frames for a request, for this long; with 0 frames, repetitions
  /// of those that have arrived. Without room, see has_room(), this replaces the entry that expires
  /// first.
  constexpr void add(const LateRequest& request, std::uint32_t frames, Ticks left) noexcept {
    std::size_t place = 0;
    while (place < size_ && !entries_[place].is_of(request)) ++place;
    if (place == size_) {
      place = size_ < capacity ? size_++ : first_to_end();
      entries_[place].left = 0;
    }  // else the same frames match both
    Entry& entry = entries_[place];
    if (is_only_remembered(entry)) entry.frames = 0;
    entry.request = request;
    entry.frames += frames;
    entry.left = longer(entry.left, left + memory_);
  }

  /// Keeps the entry to which this request was the last to add, if there is one, at least this
  /// long.
  constexpr void extend(Handle request, Ticks left) noexcept {
    for (std::size_t i = 0; i < size_; ++i) {
      if (entries_[i].request.handle == request)
        entries_[i].left = longer(entries_[i].left, left + memory_);
    }
  }

  constexpr void pass(Ticks elapsed) noexcept {
    for (std::size_t i = 0; i < size_; ++i) detail::pass(entries_[i].left, elapsed);
  }

  /// Removes the expired entries.
  constexpr void expire() noexcept {
    for (std::size_t i = size_; i-- > 0;) {
      if (entries_[i].left == 0) remove(i);
    }
  }

  /// Consumes one frame of the oldest entry for which `fits(request)` holds, or of the only one
  /// that is remembered, and sets `host` to that of its request; returns false if there is none. On
  /// a line that repeats frames within `repeats`, if not 0, the entry stays at least that long.
  template <class Fits>
  constexpr bool take(const Fits& fits, Ticks repeats, std::uint16_t& host) noexcept {
    std::size_t oldest = size_;
    std::size_t remembered = 0;
    for (std::size_t i = 0; i < size_; ++i) {
      const Entry& entry = entries_[i];
      if (!fits(entry.request)) continue;
      if (is_only_remembered(entry)) {
        if (remembered++ == 0 && oldest == size_) oldest = i;
      } else if (oldest == size_ || is_only_remembered(entries_[oldest]) ||
                 entry.request.handle < entries_[oldest].request.handle) {
        oldest = i;
      }
    }
    if (oldest == size_ || (remembered > 1 && is_only_remembered(entries_[oldest]))) return false;
    Entry& entry = entries_[oldest];
    host = entry.request.host;
    if (entry.frames != 0) --entry.frames;
    if (repeats != 0) {
      entry.left = longer(entry.left, repeats + memory_);
    } else if (entry.frames == 0) {
      remove(oldest);
    }
    return true;
  }

  /// Returns the number of entries, without those only remembered, for which `fits(request)` holds
  /// and that expect `frames` frames or more.
  template <class Fits>
  constexpr std::size_t count(const Fits& fits, std::uint32_t frames = 0) const noexcept {
    std::size_t result = 0;
    for (std::size_t i = 0; i < size_; ++i) {
      const Entry& entry = entries_[i];
      if (is_only_remembered(entry) || entry.frames < frames) continue;
      result += fits(entry.request) ? 1U : 0U;
    }
    return result;
  }

  /// Returns the time until the first entry is only remembered.
  constexpr Ticks next_end() const noexcept {
    Ticks left = never;
    for (std::size_t i = 0; i < size_; ++i) {
      if (!is_only_remembered(entries_[i])) left = shorter(left, entries_[i].left - memory_);
    }
    return left;
  }

  /// Makes all entries expire after `most` at the latest.
  constexpr void limit(Ticks most) noexcept {
    for (std::size_t i = 0; i < size_; ++i)
      entries_[i].left = shorter(entries_[i].left, most + memory_);
  }

  constexpr void clear() noexcept { size_ = 0; }

 private:
  struct Entry {
    LateRequest request{};
    Ticks left{};
    std::uint32_t frames{};

    constexpr bool is_of(const LateRequest& other) const noexcept {
      return request.host == other.host && request.responses == other.responses;
    }
  };

  constexpr bool is_only_remembered(const Entry& entry) const noexcept {
    return entry.left <= memory_;
  }

  constexpr std::size_t first_to_end() const noexcept {
    std::size_t first = 0;
    for (std::size_t i = 1; i < size_; ++i) {
      if (entries_[i].left < entries_[first].left) first = i;
    }
    return first;
  }

  constexpr void remove(std::size_t index) noexcept { entries_[index] = entries_[--size_]; }

  std::array<Entry, capacity> entries_{};
  std::size_t size_{};
  Ticks memory_;
};

}  // namespace sbgc::detail
