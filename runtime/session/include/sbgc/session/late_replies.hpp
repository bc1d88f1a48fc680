/// Replies to requests that are over.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>

#include <sbgc/response_policy.hpp>
#include <sbgc/time.hpp>

namespace sbgc::detail {

/// What may still come for requests that are over. A frame that fits is taken here, so that it does
/// not count as the answer to a later request, which waits until the late reply is due no more.
template <std::size_t capacity>
class LateReplies {
 public:
  constexpr std::size_t size() const noexcept { return size_; }

  /// Whether an entry for these responses could be added when `reserved` places stay free.
  constexpr bool has_room(const Responses& responses, std::size_t reserved) const noexcept {
    return size_ + reserved < capacity || find(responses) != size_;
  }

  /// Expects up to `frames` frames until `until`. The caller has made sure that there is room.
  constexpr void add(const Responses& responses, std::uint32_t frames, Instant until) noexcept {
    const std::size_t place = find(responses);
    if (place == capacity) return;
    Entry& entry = entries_[place];
    if (place == size_) {
      entry = {responses, frames, until};
      ++size_;
    } else {  // the same frames fit both
      const std::uint32_t room = std::numeric_limits<std::uint32_t>::max() - entry.frames;
      entry.frames += frames < room ? frames : room;
      entry.until = later(entry.until, until);
    }
  }

  /// Keeps the entry for these responses, if there is one, until `until` at least.
  constexpr void prolong(const Responses& responses, Instant until) noexcept {
    const std::size_t place = find(responses);
    if (place != size_) entries_[place].until = later(entries_[place].until, until);
  }

  /// Removes what is due no more.
  constexpr void expire(Instant now) noexcept {
    for (std::size_t i = size_; i-- > 0;) {
      if (entries_[i].until <= now) remove(i);
    }
  }

  /// Whether a late reply could be taken for one of these responses.
  constexpr bool can_be_confused_with(const Responses& responses) const noexcept {
    for (std::size_t i = 0; i < size_; ++i) {
      if (entries_[i].responses.can_be_confused_with(responses)) return true;
    }
    return false;
  }

  /// Takes one frame off the first entry for which `fits(responses)`; false if there is none. On a
  /// line that repeats frames, the entry stays until `repeated_until` at least.
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

  /// Whether a late reply to this command may come; 0 is any command.
  constexpr bool has_command(std::uint8_t command) const noexcept {
    for (std::size_t i = 0; i < size_; ++i) {
      if (command == 0 || entries_[i].responses.command == command) return true;
    }
    return false;
  }

  /// When the first entry ends.
  constexpr Instant next_end() const noexcept {
    Instant end = Instant::never;
    for (std::size_t i = 0; i < size_; ++i) end = earlier(end, entries_[i].until);
    return end;
  }

  /// Nothing comes any more after `end`.
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

  /// The place of the entry for these responses, else the first free one.
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
