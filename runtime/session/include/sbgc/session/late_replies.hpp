/// Late replies: responses to requests that have ended.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>

#include <sbgc/response_policy.hpp>
#include <sbgc/time.hpp>

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

  /// Expects up to `frames` frames until `until`. Precondition: there is room, see has_room().
  constexpr void add(const Responses& responses, std::uint32_t frames, Instant until) noexcept {
    const std::size_t place = find(responses);
    if (place == capacity) return;
    Entry& entry = entries_[place];
    if (place == size_) {
      entry = {responses, frames, until};
      ++size_;
    } else {  // the same frames match both
      const std::uint32_t room = std::numeric_limits<std::uint32_t>::max() - entry.frames;
      entry.frames += frames < room ? frames : room;
      entry.until = later(entry.until, until);
    }
  }

  /// Keeps the entry for these responses, if there is one, at least until `until`.
  constexpr void extend(const Responses& responses, Instant until) noexcept {
    const std::size_t place = find(responses);
    if (place != size_) entries_[place].until = later(entries_[place].until, until);
  }

  /// Removes the expired entries.
  constexpr void expire(Instant now) noexcept {
    for (std::size_t i = size_; i-- > 0;) {
      if (entries_[i].until <= now) remove(i);
    }
  }

  /// Returns true if a late reply could be confused with one of these responses.
  constexpr bool can_be_confused_with(const Responses& responses) const noexcept {
    for (std::size_t i = 0; i < size_; ++i) {
      if (entries_[i].responses.can_be_confused_with(responses)) return true;
    }
    return false;
  }

  /// Consumes one frame of the first entry for which `fits(responses)` holds; returns false if
  /// there is none. On a line that repeats frames, the entry stays at least until `repeated_until`.
  template <class Fits>
  constexpr bool take(Fits&& fits, bool is_repeating, Instant repeated_until) noexcept {
    for (std::size_t i = 0; i < size_; ++i) {
      Entry& entry = entries_[i];
      if (!fits(entry.responses)) continue;
      if (is_repeating) {
        entry.until = later(entry.until, repeated_until);
      } else if (--entry.frames == 0) {
        remove(i);
      }
      return true;
    }
    return false;
  }

  /// Returns true if a late reply to this command may arrive; 0 is any command.
  constexpr bool has_command(std::uint8_t command) const noexcept {
    for (std::size_t i = 0; i < size_; ++i) {
      if (command == 0 || entries_[i].responses.command == command) return true;
    }
    return false;
  }

  /// Returns the time at which the first entry expires.
  constexpr Instant next_end() const noexcept {
    Instant end = Instant::never;
    for (std::size_t i = 0; i < size_; ++i) end = earlier(end, entries_[i].until);
    return end;
  }

  /// Makes all entries expire at `end` at the latest.
  constexpr void limit(Instant end) noexcept {
    for (std::size_t i = 0; i < size_; ++i) entries_[i].until = earlier(entries_[i].until, end);
  }

  constexpr void clear() noexcept { size_ = 0; }

 private:
  struct Entry {
    Responses responses{};
    std::uint32_t frames{};
    Instant until{};
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
