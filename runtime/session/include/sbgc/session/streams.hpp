/// The data streams that a session has started, and their bandwidth.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>

#include <sbgc/frame.hpp>
#include <sbgc/response_policy.hpp>
#include <sbgc/session/event.hpp>
#include <sbgc/session/ticks.hpp>

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

/// Tells whether a request may be sent while streams of its answer's message are running.
enum class Gate : std::uint8_t {
  open,
  wait,    ///< until after the next sample
  sample,  ///< not at all: the next sample answers it
  closed,  ///< the answer would always be indistinguishable from a sample
};

/// The sample times of a running stream, and an answer of the same size among the samples: it is
/// recognized by its time, before the next sample can arrive.
class SampleTimes {
 public:
  /// Starts with a new interval.
  constexpr void start(Ticks interval) noexcept {
    interval_ = interval;
    age_ = spread_ = 0;
    is_known_ = false;
  }

  constexpr void pass(Ticks elapsed) noexcept {
    age_ += shorter(elapsed, longest_age - age_);
    detail::pass(doubt_left_, elapsed);
  }

  /// Returns true if a sample has arrived.
  constexpr bool is_known() const noexcept { return is_known_; }
  /// Returns true if so many samples are missing that the board may have lost the stream.
  constexpr bool is_silent() const noexcept { return age_ > longest_silence(); }
  constexpr Ticks until_next() const noexcept { return age_ < interval_ ? interval_ - age_ : 0; }

  /// Returns whether a request that takes `needed`, with its answer, may be sent.
  constexpr Gate gate(Ticks needed) const noexcept {
    if (longest_gap() < needed) return Gate::closed;
    const bool fits = is_known_ && doubt_left_ == 0 && age_ + needed <= gap();
    return fits ? Gate::open : Gate::wait;
  }
  /// Returns when gate() can change without a sample.
  constexpr Ticks next_change() const noexcept {
    const Ticks silent = is_silent() ? never : longest_silence() - age_ + 1;
    return doubt_left_ != 0 ? shorter(doubt_left_, silent) : silent;
  }

  /// Expects an answer before the next sample; it is possible for this long.
  constexpr void expect(Ticks late_left) noexcept {
    doubt_left_ = late_left;
    frames_ = 0;
    is_answered_ = false;
  }
  /// Extends the time of the answer, because the request left late.
  constexpr void prolong(Ticks late_left) noexcept {
    if (doubt_left_ != 0) doubt_left_ = longer(doubt_left_, late_left);
  }
  /// Stops expecting an answer.
  constexpr void expect_none() noexcept { is_answered_ = true; }

  /// Classifies a frame that can be a sample.
  constexpr Sample take() noexcept {
    if (doubt_left_ != 0) {
      const Ticks samples = is_known_ ? (age_ + interval_ - gap()) / interval_ : never;
      if (samples == 0) return std::exchange(is_answered_, true) ? Sample::doubtful : Sample::no;
      if (!is_answered_) {
        // There is one more than there can be samples: the answer was among them.
        if (frames_ >= samples) doubt_left_ = 0;
        ++frames_;
        return Sample::doubtful;
      }
      doubt_left_ = 0;
    }
    if (is_silent()) start(interval_);
    // Lines delay samples unevenly. age_ counts from the earliest time at which the last sample can
    // have arrived; it forgets an eighth of each delay, because clocks differ.
    Ticks delay = age_ % interval_;
    const bool is_early = age_ < interval_ || delay > longest_gap();
    if (is_early) delay = is_known_ ? interval_ - delay : 0;
    age_ = is_early ? 0 : delay - delay / 8;
    spread_ = longer(delay, spread_ - spread_ / 16);
    is_known_ = true;
    return Sample::yes;
  }

 private:
  static constexpr Ticks longest_age = 600'000'000;

  constexpr Ticks longest_silence() const noexcept { return 2 * interval_ + 1'000'000; }
  /// The time after a sample in which none arrives, on a line with even delays. A quarter is kept
  /// free, also because a stream that follows the cycles of the board has samples after 0.8 of the
  /// interval.
  constexpr Ticks longest_gap() const noexcept { return interval_ - interval_ / 4; }
  constexpr Ticks gap() const noexcept { return longest_gap() - shorter(spread_, longest_gap()); }

  Ticks interval_{};
  Ticks age_{};
  Ticks spread_{};      // of the delays
  Ticks doubt_left_{};  // until the answer cannot come any more, or the next sample can
  Ticks frames_{};      // in doubt
  bool is_known_{};     // since a sample has arrived
  bool is_answered_{};
};

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

  /// Records a requested change that check() allows. Returns false if there is no room, which means
  /// that the change ends an unknown stream; settle() must not be called for it then.
  constexpr bool ask(const StreamChange& change) noexcept {
    const std::size_t place = find(change);
    if (place == capacity) return false;
    Stream& stream = streams_[place];
    if (place == size_) {
      stream = {.command = change.command,
                .size = change.size,
                .has_any_size = change.size == max_body_size,
                .config = change.config};
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
    if (done) {
      stream.load = stream_load(change, framing_);
      stream.times.start(change.interval_us);
    }
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

  constexpr void pass(Ticks elapsed) noexcept {
    for (std::size_t i = 0; i < size_; ++i) streams_[i].times.pass(elapsed);
  }

  /// Returns whether a request may be sent that takes `needed`, including its answer, and has this
  /// `timeout`.
  constexpr Gate gate(const ResponsePolicy& policy, Ticks needed, Ticks timeout) const noexcept {
    Gate gate = Gate::open;
    for (std::size_t i = 0; i < size_; ++i) {
      const Stream& stream = streams_[i];
      if (!stream.can_hide(policy)) continue;
      if (stream.is(policy.stream) && stream.times.until_next() <= timeout) return Gate::sample;
      const Gate own = stream.times.gate(needed);
      if (gate < own) gate = own;
    }
    return gate;
  }

  /// Returns when gate() can change without a sample.
  constexpr Ticks next_change() const noexcept {
    Ticks left = never;
    for (std::size_t i = 0; i < size_; ++i) left = shorter(left, streams_[i].times.next_change());
    return left;
  }

  /// Records that the request was sent; its answer is possible for this long.
  constexpr void expect(const ResponsePolicy& policy, Ticks late_left) noexcept {
    for (std::size_t i = 0; i < size_; ++i) {
      if (streams_[i].can_hide(policy)) streams_[i].times.expect(late_left);
    }
  }
  /// Extends the time of the answer, because the request left late.
  constexpr void prolong(const ResponsePolicy& policy, Ticks late_left) noexcept {
    for (std::size_t i = 0; i < size_; ++i) {
      if (streams_[i].can_hide(policy)) streams_[i].times.prolong(late_left);
    }
  }
  /// Records that the request has ended: no answer is expected any more.
  constexpr void expect_none(const ResponsePolicy& policy) noexcept {
    for (std::size_t i = 0; i < size_; ++i) {
      if (streams_[i].can_hide(policy)) streams_[i].times.expect_none();
    }
  }

  /// Classifies a frame; `no` if it does not have the size of a sample.
  constexpr Sample take(const Frame& frame) noexcept {
    taken_ = size_;
    for (std::size_t i = 0; i < size_; ++i) {
      const Stream& stream = streams_[i];
      if (!stream.is_running() || !stream.has_form_of(frame)) continue;
      if (taken_ == size_ || stream.times.until_next() < streams_[taken_].times.until_next()) {
        taken_ = i;
      }
    }
    return taken_ == size_ ? Sample::no : streams_[taken_].times.take();
  }
  /// Accepts a frame that take() has rejected, and that answers nothing: the first sample, with a
  /// size other than documented, or one after a silence.
  constexpr Sample adopt(const Frame& frame) noexcept {
    Stream* found = nullptr;
    for (std::size_t i = 0; i < size_; ++i) {
      Stream& stream = streams_[i];
      const bool is_of_message = stream.command == frame.id && stream.load != 0;
      if (is_of_message && (found == nullptr || stream.has_form_of(frame))) found = &stream;
    }
    if (found == nullptr) return Sample::yes;  // before the confirmation of its start
    if (found->has_any_size) return Sample::none;
    if (!found->times.is_known()) found->size = static_cast<std::uint8_t>(frame.body.size());
    return found->has_form_of(frame) ? found->times.take() : Sample::no;
  }
  /// Returns true if the frame of the last take() is a sample of this stream.
  constexpr bool has_taken(const StreamChange& key) const noexcept {
    return taken_ < size_ && streams_[taken_].is(key);
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
    bool has_any_size{};  // no document describes the message
    std::array<std::uint8_t, max_stream_config> config{};
    std::uint32_t load{};     // confirmed by the board
    std::uint32_t asked{};    // the maximum of the changes not settled
    std::uint32_t changes{};  // the number of changes not settled
    SampleTimes times{};

    constexpr bool is(const StreamChange& key) const noexcept {
      return command == key.command && config == key.config;
    }
    constexpr bool is_running() const noexcept { return load != 0 && !times.is_silent(); }
    constexpr bool has_form_of(const Frame& frame) const noexcept {
      return command == frame.id && size == frame.body.size();
    }
    /// Returns true if the answer to a request can have the form of its samples.
    constexpr bool can_hide(const ResponsePolicy& policy) const noexcept {
      const ResponseForm& answer = policy.responses.forms[0];
      return is_running() && answer.id == command && answer.min_size <= size && size <= answer.size;
    }
    constexpr std::uint32_t taken() const noexcept { return load < asked ? asked : load; }
  };

  /// Returns the index of the stream that a change concerns, else the first free one.
  constexpr std::size_t find(const StreamChange& change) const noexcept {
    std::size_t i = 0;
    while (i < size_ && !streams_[i].is(change)) ++i;
    return i;
  }

  std::array<Stream, capacity> streams_{};
  std::size_t size_{};
  std::size_t taken_{};  // the stream of the last sample
  Framing framing_ = basic_framing;
};

/// For a session that starts no streams.
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
  constexpr void pass(Ticks) noexcept {}
  constexpr std::uint32_t used() const noexcept { return 0; }
  constexpr void stop() noexcept {}
  constexpr void clear() noexcept {}
};

}  // namespace sbgc::detail
