/// Late replies: responses to requests that have ended.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include <sbgc/response_policy.hpp>
#include <sbgc/session/event.hpp>
#include <sbgc/session/ticks.hpp>

namespace sbgc::detail {

/// A request with late replies; the last one if the same frames match several.
struct LateRequest {
  Handle handle{};
  std::uint16_t host{};
  Responses responses{};
};

/// The late replies that may still arrive. They consume matching frames, so that no frame is
/// matched to a later request. With `has_hosts`, replies to several hosts are kept apart.
template <std::size_t capacity, bool has_hosts = false>
class LateReplies {
 public:
  struct Entry {
    LateRequest request{};
    Ticks left{};
    std::uint32_t frames{};  // 0: only duplicates
  };

  /// The entries that a frame matches.
  struct Match {
    Entry* entry{};  // the oldest, or null
    std::size_t count{};
  };

  constexpr std::size_t size() const noexcept { return size_; }

  /// Returns true if an entry could be added with `reserved` places left free.
  constexpr bool has_room(std::size_t reserved) const noexcept {
    return size_ + reserved < capacity;
  }

  /// Expects up to `frames` further frames for a request, for this long; with 0 frames, duplicates
  /// of those that have arrived. Without room, see has_room(), this replaces the entry that expires
  /// first.
  constexpr void add(Handle request, std::uint16_t host, const Responses& responses,
                     std::uint32_t frames, Ticks left) noexcept {
    std::size_t place = 0;
    while (place < size_ && !is_of(entries_[place], host, responses)) ++place;
    const bool is_new = place == size_;
    if (is_new) place = size_ < capacity ? size_++ : first_to_end();
    Entry& entry = entries_[place];
    if (is_new) {
      entry.request.host = host;
      entry.request.responses = responses;
      entry.frames = 0;
      entry.left = 0;
    }  // else the same frames match both
    entry.request.handle = request;
    entry.frames += frames;
    entry.left = longer(entry.left, left);
  }

  /// If this request was the last one added to an entry, keeps that entry at least this long.
  constexpr void extend(Handle request, Ticks left) noexcept {
    for (std::size_t i = 0; i < size_; ++i) {
      Entry& entry = entries_[i];
      if (entry.request.handle == request) entry.left = longer(entry.left, left);
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

  /// Returns the entries for which `fits(responses)` holds.
  template <class Fits>
  constexpr Match match(const Fits& fits) noexcept {
    Match found;
    for (std::size_t i = 0; i < size_; ++i) {
      Entry& entry = entries_[i];
      if (!fits(entry.request.responses)) continue;
      if (found.count++ == 0 || is_before(entry, *found.entry)) found.entry = &entry;
    }
    return found;
  }

  /// Consumes one frame of an entry. On a line that duplicates frames within `repeats`, if not 0,
  /// the entry stays at least that long.
  constexpr void take(Entry& entry, Ticks repeats) noexcept {
    if (entry.frames != 0) --entry.frames;
    if (repeats != 0) {
      entry.left = longer(entry.left, repeats);
    } else if (entry.frames == 0) {
      entry = entries_[--size_];
    }
  }

  /// Returns true if there is an entry for which `fits(request)` holds.
  template <class Fits>
  constexpr bool has(const Fits& fits) const noexcept {
    for (std::size_t i = 0; i < size_; ++i) {
      if (fits(entries_[i].request)) return true;
    }
    return false;
  }

  /// Returns the time until the first entry ends.
  constexpr Ticks next_end() const noexcept {
    Ticks left = never;
    for (std::size_t i = 0; i < size_; ++i) left = shorter(left, entries_[i].left);
    return left;
  }

  /// Makes all entries end after `most` at the latest.
  constexpr void limit(Ticks most) noexcept {
    for (std::size_t i = 0; i < size_; ++i) {
      entries_[i].left = shorter(entries_[i].left, most);
    }
  }

  constexpr void clear() noexcept { size_ = 0; }

 private:
  static constexpr bool is_of(const Entry& entry, std::uint16_t host,
                              const Responses& responses) noexcept {
    return (!has_hosts || entry.request.host == host) && entry.request.responses == responses;
  }

  static constexpr bool is_before(const Entry& entry, const Entry& other) noexcept {
    return capacity > 1 && entry.request.handle < other.request.handle;
  }

  constexpr std::size_t first_to_end() const noexcept {
    std::size_t first = 0;
    if constexpr (capacity == 1) return first;
    for (std::size_t i = 1; i < size_; ++i) {
      if (entries_[i].left < entries_[first].left) first = i;
    }
    return first;
  }

  constexpr void remove(std::size_t index) noexcept { entries_[index] = entries_[--size_]; }

  std::array<Entry, capacity> entries_{};
  std::size_t size_{};
};

}  // namespace sbgc::detail
