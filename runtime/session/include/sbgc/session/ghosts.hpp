/// Requests that are over, but whose answers may still come.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>

#include <sbgc/exchange.hpp>
#include <sbgc/time.hpp>

namespace sbgc::detail {

/// What may still come for requests that are over. A frame that fits goes here, so that it is not
/// taken for the answer of a later request; that one waits until the ghost is gone.
template <std::size_t capacity>
class Ghosts {
 public:
  constexpr std::size_t size() const noexcept { return size_; }

  /// Whether a ghost with these replies could be added when `reserved` places are not to be taken.
  constexpr bool has_room(const Replies& replies, std::size_t reserved) const noexcept {
    return size_ + reserved < capacity || find(replies) != size_;
  }

  /// Expects up to `frames` frames until `until`. The caller has made sure that there is room.
  constexpr void add(const Replies& replies, std::uint32_t frames, Instant until) noexcept {
    const std::size_t place = find(replies);
    if (place == capacity) return;
    Ghost& ghost = ghosts_[place];
    if (place == size_) {
      ghost = {replies, frames, until};
      ++size_;
    } else {  // the same frames fit both
      const std::uint32_t room = std::numeric_limits<std::uint32_t>::max() - ghost.frames;
      ghost.frames += frames < room ? frames : room;
      ghost.until = later(ghost.until, until);
    }
  }

  /// Keeps the ghost with these replies, if there is one, until `until` at least.
  constexpr void prolong(const Replies& replies, Instant until) noexcept {
    const std::size_t place = find(replies);
    if (place != size_) ghosts_[place].until = later(ghosts_[place].until, until);
  }

  /// Removes what has had its time.
  constexpr void expire(Instant now) noexcept {
    for (std::size_t i = size_; i-- > 0;) {
      if (ghosts_[i].until <= now) remove(i);
    }
  }

  /// Whether a frame that may come for a ghost could be taken for one of these.
  constexpr bool can_be_confused_with(const Replies& replies) const noexcept {
    for (std::size_t i = 0; i < size_; ++i) {
      if (ghosts_[i].replies.can_be_confused_with(replies)) return true;
    }
    return false;
  }

  /// Takes one frame off the first ghost for which `fits(replies)`; false if there is none. On a
  /// line that repeats frames, the ghost stays until `repeated_until` at least.
  template <class Fits>
  constexpr bool take(Fits&& fits, bool is_repeating, Instant repeated_until) noexcept {
    for (std::size_t i = 0; i < size_; ++i) {
      Ghost& ghost = ghosts_[i];
      if (!fits(ghost.replies)) continue;
      if (is_repeating) {
        ghost.until = later(ghost.until, repeated_until);
      } else if (--ghost.frames == 0) {
        remove(i);
      }
      return true;
    }
    return false;
  }

  /// Whether a ghost has this command; 0 stands for any.
  constexpr bool has_command(std::uint8_t command) const noexcept {
    for (std::size_t i = 0; i < size_; ++i) {
      if (command == 0 || ghosts_[i].replies.command == command) return true;
    }
    return false;
  }

  /// When the first of them is gone.
  constexpr Instant next_end() const noexcept {
    Instant end = Instant::never;
    for (std::size_t i = 0; i < size_; ++i) end = earlier(end, ghosts_[i].until);
    return end;
  }

  /// Nothing comes any more after `end`.
  constexpr void limit(Instant end) noexcept {
    for (std::size_t i = 0; i < size_; ++i) ghosts_[i].until = earlier(ghosts_[i].until, end);
  }

  constexpr void clear() noexcept { size_ = 0; }

 private:
  struct Ghost {
    Replies replies{};
    std::uint32_t frames{};
    Instant until{};
  };

  /// The place of the ghost with these replies, else the first free one.
  constexpr std::size_t find(const Replies& replies) const noexcept {
    std::size_t i = 0;
    while (i < size_ && ghosts_[i].replies != replies) ++i;
    return i;
  }

  constexpr void remove(std::size_t index) noexcept { ghosts_[index] = ghosts_[--size_]; }

  std::array<Ghost, capacity> ghosts_{};
  std::size_t size_{};
};

}  // namespace sbgc::detail
