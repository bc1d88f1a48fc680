/// Late replies: responses to requests that have ended.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include <sbgc/response_policy.hpp>
#include <sbgc/session/event.hpp>
#include <sbgc/session/ticks.hpp>

namespace sbgc::detail {

/// The late replies that may still arrive. They consume matching frames, so that no frame is
/// matched to a later request. Such a request waits until the late reply has expired.
template <std::size_t capacity>
class LateReplies {
 public:
  constexpr std::size_t size() const noexcept { return size_; }

  /// Returns true if an entry for these responses could be added while `reserved` places stay free.
  constexpr bool has_room(const Responses& responses, std::size_t reserved) const noexcept {
    return size_ + reserved < capacity || find(responses) != size_;
  }

  /// Expects up to `frames` further frames for a request, for this long. Precondition: there is
  /// room, see has_room().
  constexpr void add(Handle request, const Responses& responses, std::uint32_t frames,
                     Ticks left) noexcept {
    const std::size_t place = find(responses);
    if (place == capacity) return;
    Entry& entry = entries_[place];
    if (place == size_) {
      ++size_;
      entry.responses = responses;
      entry.frames = 0;
      entry.left = 0;
    }  // else the same frames match both
    entry.request = request;
    entry.frames += frames;
    entry.left = longer(entry.left, left);
  }

  /// Keeps the entry to which this request was the last to add, if there is one, at least this
  /// long.
  constexpr void extend(Handle request, Ticks left) noexcept {
    for (std::size_t i = 0; i < size_; ++i) {
      if (entries_[i].request == request) entries_[i].left = longer(entries_[i].left, left);
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

  /// Consumes one frame of the first entry for which `fits(responses)` holds; returns false if
  /// there is none. On a line that repeats frames within `repeats`, if not 0, the entry stays at
  /// least that long.
  template <class Fits>
  constexpr bool take(const Fits& fits, Ticks repeats) noexcept {
    for (std::size_t i = 0; i < size_; ++i) {
      Entry& entry = entries_[i];
      if (!fits(entry.responses)) continue;
      if (repeats != 0) {
        entry.left = longer(entry.left, repeats);
      } else if (--entry.frames == 0) {
        remove(i);
      }
      return true;
    }
    return false;
  }

  /// Returns true if there is an entry for which `fits(responses)` holds.
  template <class Fits>
  constexpr bool has(const Fits& fits) const noexcept {
    for (std::size_t i = 0; i < size_; ++i) {
      if (fits(entries_[i].responses)) return true;
    }
    return false;
  }

  /// Returns the time until the first entry expires.
  constexpr Ticks next_end() const noexcept {
    Ticks left = never;
    for (std::size_t i = 0; i < size_; ++i) left = shorter(left, entries_[i].left);
    return left;
  }

  /// Makes all entries expire after `most` at the latest.
  constexpr void limit(Ticks most) noexcept {
    for (std::size_t i = 0; i < size_; ++i) entries_[i].left = shorter(entries_[i].left, most);
  }

  constexpr void clear() noexcept { size_ = 0; }

 private:
  struct Entry {
    Handle request{};  // the last one that added to it
    Ticks left{};
    std::uint32_t frames{};
    Responses responses{};
  };

  /// Returns the index of the entry for these responses, else the first free one.
  constexpr std::size_t find(const Responses& responses) const noexcept {
    std::size_t i = 0;
    while (i < size_ && entries_[i].responses != responses) ++i;
    return i;
  }

  constexpr void remove(std::size_t index) noexcept { entries_[index] = entries_[--size_]; }

  std::array<Entry, capacity> entries_{};
  std::size_t size_{};
};

}  // namespace sbgc::detail
