/// A streaming parser that finds the frames in a byte stream.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>

#include <sbgc/frame.hpp>
#include <sbgc/framing.hpp>
#include <sbgc/internal/compiler.hpp>

namespace sbgc {

/// The aim for which a class is optimized. Both deliver the same frames; see BasicParser and
/// SessionCapacity.
enum class Optimize : std::uint8_t {
  speed,
  size,  ///< less code and RAM; counters and stream offsets have 32 bits, and wrap
};

/// The counters of a parser since its construction or reset().
struct ParserCounters {
  std::uint64_t frames{};         ///< delivered frames
  std::uint64_t skipped_bytes{};  ///< bytes in no delivered frame
  std::uint64_t header_errors{};  ///< start bytes not followed by a valid header
  std::uint64_t body_errors{};    ///< valid headers with a wrong body checksum
  std::uint64_t incomplete{};     ///< candidates discarded by flush()

  bool operator==(const ParserCounters&) const = default;
  friend constexpr ParserCounters operator+(const ParserCounters& a,
                                            const ParserCounters& b) noexcept {
    return {a.frames + b.frames, a.skipped_bytes + b.skipped_bytes,
            a.header_errors + b.header_errors, a.body_errors + b.body_errors,
            a.incomplete + b.incomplete};
  }
};

/// The streaming parser. It delivers the same frames however the stream is split into chunks: if
/// the checks of a candidate fail, only its start byte is skipped, and the search continues after
/// it. An incomplete candidate waits for more bytes until flush() discards it.
///
/// Frames go to a sink: anything callable with a `const Frame&`. The body is a view into the chunk
/// if the chunk contains the whole frame, else into the parser; the latter is valid only during the
/// call.
///
/// A sink must not feed, flush or reset the parser that calls it. If it throws, the exception
/// propagates, and the bytes after that frame, in the chunk and in the parser, are skipped.
///
/// No heap, no locks, constant size. The work per byte is bounded for any input: each byte of the
/// stream is inspected at most once as the start of a complete candidate, which costs at most the
/// length of one frame, and a few more times by its header alone.
///
/// `Formats` are the accepted framings, FrameFormats or SelectedFrameFormats; use Parser,
/// SmallParser or ParserOfAll, unless it should accept others or use another checksum table.
template <class Formats, Optimize optimize = Optimize::speed>
class BasicParser {
  static_assert(optimize == Optimize::speed, "include <sbgc/small_parser.hpp>");

 public:
  constexpr BasicParser() noexcept = default;
  /// Accepts the framings of `formats`.
  constexpr explicit BasicParser(const Formats& formats) noexcept : formats_(formats) {}

  /// The accepted framings. A change applies to the bytes that have not yet been inspected; the
  /// sink may make it.
  constexpr Formats& formats() noexcept { return formats_; }

  /// Consumes the next bytes of the stream and calls `sink` for each frame that they complete.
  template <class Sink>
  SBGC_ALWAYS_INLINE void feed(std::span<const std::uint8_t> chunk, Sink&& sink) noexcept(
      std::is_nothrow_invocable_v<Sink&, const Frame&>) {
    const std::size_t held = held_;  // a local, because copying to buffer_ could change held_
    // The fast paths: most small chunks do not complete the pending candidate, and most noise bytes
    // are not start bytes. The rest is marked as unlikely to keep them together.
    if (chunk.size() < sizeof buffer_ && held + chunk.size() < needed_) {
      copy(buffer_ + held, chunk.data(), chunk.size());
      held_ = held + chunk.size();
    } else if (chunk.size() == 1 && held == 0 && !formats_.is_start(chunk.front())) {
      ++taken_;
    } else [[unlikely]] {
      search(chunk.data(), chunk.data() + chunk.size(), sink);
    }
  }

  /// Discards the waiting candidate and calls `sink` for each frame among its bytes. Call it when
  /// nothing will complete the candidate, because the line is idle or the stream has ended.
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

  /// Returns the counters. Waiting bytes do not count as skipped. (During a call of the sink, all
  /// bytes after its frame do.)
  ParserCounters counters() const noexcept {
    return {frames_, taken_ - delivered_, header_errors_, body_errors_, incomplete_};
  }

  /// Returns the number of bytes that wait for the rest of their frame.
  std::size_t waiting_bytes() const noexcept { return held_; }

  /// Returns the parser to its initial state, with the same framings.
  void reset() noexcept { *this = BasicParser{formats_}; }

 private:
  constexpr Candidate inspect(const std::uint8_t* begin, const std::uint8_t* end) const noexcept {
    return formats_.inspect(begin, static_cast<std::size_t>(end - begin));
  }

  /// The slow path of feed(), for a chunk [begin, end) that can decide a candidate. Not inlined, to
  /// keep feed() small at each call.
  template <class Sink>
  SBGC_NOINLINE void search(const std::uint8_t* begin, const std::uint8_t* end, Sink& sink) {
    taken_ += static_cast<std::size_t>(end - begin);
    if (held_ != 0) begin = settle_held(begin, end, sink);
    begin = scan(begin, end, sink);
    if (begin != end) hold(begin, end, 0, inspect(begin, end).size);
  }

  /// Delivers the frames in [begin, end), which are the last bytes taken. Returns the start of the
  /// first incomplete candidate, or `end`.
  template <class Sink>
  const std::uint8_t* scan(const std::uint8_t* begin, const std::uint8_t* end, Sink& sink) {
    const std::uint64_t end_offset = taken_;
    while (begin != end) {
      // Frames are usually adjacent: inspect before searching.
      const Candidate candidate = inspect(begin, end);
      if (candidate.verdict == Verdict::frame) {
        deliver(begin, candidate.size, end_offset - static_cast<std::size_t>(end - begin), sink);
        begin += candidate.size;
        continue;
      }
      if (candidate.verdict == Verdict::incomplete) return begin;
      count_error(candidate.verdict);
      begin = formats_.find(begin + 1, end, header_errors_);
    }
    return end;
  }

  /// Inspects every candidate among the held bytes, completed with bytes of the chunk [begin, end).
  /// Returns where to continue in the chunk, or `end` if a candidate is still incomplete.
  template <class Sink>
  const std::uint8_t* settle_held(const std::uint8_t* begin, const std::uint8_t* end, Sink& sink) {
    const auto fresh = static_cast<std::size_t>(end - begin);
    std::size_t held = held_;
    release();
    const std::uint64_t chunk_offset = taken_ - fresh;
    for (;;) {
      Candidate candidate = formats_.inspect(buffer_, held);
      while (candidate.verdict == Verdict::incomplete) {
        const std::size_t lacking = candidate.size - held;
        if (lacking > fresh) {
          hold(begin, end, held, candidate.size);
          return end;
        }
        // Copied, but not taken: if the candidate fails, these bytes are inspected in the chunk.
        copy(buffer_ + held, begin, lacking);
        candidate = formats_.inspect(buffer_, candidate.size);
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
      const std::uint8_t* const next = formats_.find(buffer_ + done, held_end, header_errors_);
      if (next == held_end) return begin;
      held = static_cast<std::size_t>(held_end - next);
      detail::move_memory(buffer_, next, held);
    }
  }

  /// Stores [begin, end) after the first `held` bytes of the buffer. The candidate is undecided
  /// until `needed` bytes are available.
  void hold(const std::uint8_t* begin, const std::uint8_t* end, std::size_t held,
            std::size_t needed) noexcept {
    const auto size = static_cast<std::size_t>(end - begin);
    copy(buffer_ + held, begin, size);
    held_ = held + size;
    needed_ = needed;
    taken_ -= held_;
  }

  /// Removes the held bytes from the buffer, where they stay readable.
  void release() noexcept {
    taken_ += held_;
    held_ = needed_ = 0;
  }

  template <class Sink>
  void deliver(const std::uint8_t* bytes, std::size_t size, std::uint64_t offset, Sink& sink) {
    ++frames_;
    delivered_ += size;
    const Frame frame = frame_at(bytes, offset);
    sink(frame);
  }

  void count_error(Verdict verdict) noexcept {
    if (verdict == Verdict::bad_header) ++header_errors_;
    if (verdict == Verdict::bad_body) ++body_errors_;
  }

  static void copy(std::uint8_t* to, const std::uint8_t* from, std::size_t size) noexcept {
    if (size != 0) detail::copy_memory(to, from, size);
  }

  [[no_unique_address]] Formats formats_{};
  std::uint64_t taken_{};      // bytes fed and not held: delivered or skipped
  std::uint64_t delivered_{};  // bytes of delivered frames
  std::uint64_t frames_{};
  std::uint64_t header_errors_{};
  std::uint64_t body_errors_{};
  std::uint64_t incomplete_{};
  std::size_t held_{};    // bytes in the buffer, which precede the next chunk
  std::size_t needed_{};  // bytes needed to decide the candidate at buffer_[0]
  std::uint8_t buffer_[max_frame_size]{};
};

/// The parser for frames of the framing that every board understands.
using Parser = BasicParser<FrameFormats<CrcTable::slices, basic_framing>>;
/// The parser for frames of all framings in one stream.
using ParserOfAll = BasicParser<AllFrameFormats>;

static_assert(sizeof(Parser) <= 600, "a parser must fit into a small microcontroller");

}  // namespace sbgc
