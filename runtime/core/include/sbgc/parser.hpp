/// Finds the frames in a byte stream that arrives in pieces.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>

#include <sbgc/frame.hpp>
#include <sbgc/framing.hpp>

namespace sbgc {

/// What a parser has seen since its construction or reset().
struct ParserCounters {
  std::uint64_t frames{};         ///< delivered
  std::uint64_t skipped_bytes{};  ///< that ended up in no delivered frame
  std::uint64_t header_errors{};  ///< start bytes without a valid header behind them
  std::uint64_t body_errors{};    ///< valid headers whose body checksum was wrong
  std::uint64_t incomplete{};     ///< candidates that flush() gave up

  bool operator==(const ParserCounters&) const = default;
};

/// The streaming parser. It delivers the same frames whichever way the stream is cut into chunks:
/// a candidate whose checks fail gives up its start byte only, and the search goes on behind it. A
/// candidate that is still incomplete waits for more bytes, until flush() declares it false.
///
/// Frames go to a sink: anything that can be called with a `const Frame&`. The body is a view,
/// into the chunk if the frame lies whole inside it, else into the parser; the latter is valid
/// during the call only.
///
/// A sink must not feed, flush or reset the parser that calls it. If it throws, the exception
/// passes through, and the bytes behind that frame, in the chunk and in the parser, are skipped.
///
/// No heap, no locks, constant size. Work is bounded per byte whatever the input: each byte of the
/// stream is judged at most once as the start of a complete candidate, which costs at most the
/// length of one frame, and a few times more by its header alone.
///
/// `Rules` says what a frame is. Use `Parser`; tests have rules that count operations.
template <class Rules>
class BasicParser {
 public:
  /// Takes the next bytes of the stream and calls `sink` for each frame that they complete.
  template <class Sink>
  [[gnu::always_inline]] void feed(std::span<const std::uint8_t> chunk, Sink&& sink) noexcept(
      std::is_nothrow_invocable_v<Sink&, const Frame&>) {
    // Most small chunks end here: they do not complete what is waiting.
    if (chunk.size() < sizeof buffer_ && held_ + chunk.size() < needed_) {
      copy(buffer_ + held_, chunk.data(), chunk.size());
      held_ += chunk.size();
    } else {
      search(chunk.data(), chunk.data() + chunk.size(), sink);
    }
  }

  /// Says that nothing will complete what is waiting, because the line is idle or the stream has
  /// ended: the candidate is false, and `sink` gets the frames among the bytes it had swallowed.
  template <class Sink>
  void flush(Sink&& sink) noexcept(std::is_nothrow_invocable_v<Sink&, const Frame&>) {
    const std::uint8_t* begin = buffer_;
    const std::uint8_t* const end = buffer_ + held_;
    release();
    while ((begin = scan(begin, end, sink)) != end) {
      ++incomplete_;
      ++begin;
    }
  }

  /// What has been seen so far. Waiting bytes do not count as skipped. (Asked by a sink, all that
  /// lies behind its frame does.)
  ParserCounters counters() const noexcept {
    return {frames_, taken_ - delivered_, header_errors_, body_errors_, incomplete_};
  }

  /// The number of bytes that wait for the rest of their frame.
  std::size_t waiting_bytes() const noexcept { return held_; }

  /// Forgets everything, as if newly constructed.
  void reset() noexcept { *this = BasicParser{}; }

 private:
  static constexpr Candidate inspect(const std::uint8_t* begin, const std::uint8_t* end) noexcept {
    return Rules::inspect(begin, static_cast<std::size_t>(end - begin));
  }

  /// feed() for a chunk [begin, end) that decides something. Not inlined, so that feed() stays
  /// small wherever bytes come in.
  template <class Sink>
  [[gnu::noinline]] void search(const std::uint8_t* begin, const std::uint8_t* end, Sink& sink) {
    taken_ += static_cast<std::size_t>(end - begin);
    if (held_ != 0) begin = settle_held(begin, end, sink);
    begin = scan(begin, end, sink);
    if (begin != end) hold(begin, end, 0, inspect(begin, end).size);
  }

  /// Delivers the frames in [begin, end), the last bytes taken. Returns the start of the first
  /// incomplete candidate, or `end`.
  template <class Sink>
  const std::uint8_t* scan(const std::uint8_t* begin, const std::uint8_t* end, Sink& sink) {
    const std::uint64_t end_offset = taken_;
    while (begin != end) {
      // Frames mostly follow each other: look before searching.
      const Candidate candidate = inspect(begin, end);
      if (candidate.verdict == Verdict::frame) {
        deliver(begin, candidate.size, end_offset - static_cast<std::size_t>(end - begin), sink);
        begin += candidate.size;
        continue;
      }
      if (candidate.verdict == Verdict::incomplete) return begin;
      count_error(candidate.verdict);
      begin = Rules::find(begin + 1, end, header_errors_);
    }
    return end;
  }

  /// Judges every candidate among the held bytes, with the help of the chunk [begin, end).
  /// Returns where to go on in the chunk; `end` if a candidate still waits.
  template <class Sink>
  const std::uint8_t* settle_held(const std::uint8_t* begin, const std::uint8_t* end, Sink& sink) {
    const auto fresh = static_cast<std::size_t>(end - begin);
    std::size_t held = held_;
    release();
    const std::uint64_t chunk_offset = taken_ - fresh;
    for (;;) {
      Candidate candidate = Rules::inspect(buffer_, held);
      while (candidate.verdict == Verdict::incomplete) {
        const std::size_t lacking = candidate.size - held;
        if (lacking > fresh) {
          hold(begin, end, held, candidate.size);
          return end;
        }
        // Borrowed, not taken: if the candidate is false, these bytes are judged in the chunk.
        copy(buffer_ + held, begin, lacking);
        candidate = Rules::inspect(buffer_, candidate.size);
      }
      std::size_t done = 1;
      if (candidate.verdict == Verdict::frame) {
        done = candidate.size;
        deliver(buffer_, done, chunk_offset - held, sink);
      } else {
        count_error(candidate.verdict);
      }
      if (done >= held) return begin + (done - held);
      const std::uint8_t* const held_end = buffer_ + held;
      const std::uint8_t* const next = Rules::find(buffer_ + done, held_end, header_errors_);
      if (next == held_end) return begin;
      held = static_cast<std::size_t>(held_end - next);
      __builtin_memmove(buffer_, next, held);
    }
  }

  /// Keeps [begin, end) behind the first `held` bytes of the buffer; nothing can be said about
  /// them before there are `needed` bytes.
  void hold(const std::uint8_t* begin, const std::uint8_t* end, std::size_t held,
            std::size_t needed) noexcept {
    const auto size = static_cast<std::size_t>(end - begin);
    copy(buffer_ + held, begin, size);
    held_ = held + size;
    needed_ = needed;
    taken_ -= held_;
  }

  /// Takes the held bytes out of the buffer, where they stay readable.
  void release() noexcept {
    taken_ += held_;
    held_ = needed_ = 0;
  }

  template <class Sink>
  void deliver(const std::uint8_t* bytes, std::size_t size, std::uint64_t offset, Sink& sink) {
    ++frames_;
    delivered_ += size;
    const Frame frame{Rules::id(bytes), Rules::body(bytes), offset};
    sink(frame);
  }

  void count_error(Verdict verdict) noexcept {
    if (verdict == Verdict::bad_header) ++header_errors_;
    if (verdict == Verdict::bad_body) ++body_errors_;
  }

  static void copy(std::uint8_t* to, const std::uint8_t* from, std::size_t size) noexcept {
    if (size != 0) __builtin_memcpy(to, from, size);
  }

  std::uint64_t taken_{};      // bytes fed and not held: delivered or skipped
  std::uint64_t delivered_{};  // bytes of delivered frames
  std::uint64_t frames_{};
  std::uint64_t header_errors_{};
  std::uint64_t body_errors_{};
  std::uint64_t incomplete_{};
  std::size_t held_{};    // bytes in the buffer, all of them before the next chunk
  std::size_t needed_{};  // bytes without which the candidate at buffer_[0] cannot be judged
  std::uint8_t buffer_[max_frame_size]{};
};

/// The parser for the frames of the protocol.
using Parser = BasicParser<Framing>;

static_assert(sizeof(Parser) <= 600, "a parser must fit into a small microcontroller");

}  // namespace sbgc
