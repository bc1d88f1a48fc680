/// The parser for small microcontrollers.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>

#include <sbgc/internal/compiler.hpp>
#include <sbgc/parser.hpp>

namespace sbgc {

/// Copies each byte into its buffer and decides a candidate when its last byte arrives. Half the
/// code size of the other parser; far slower on a PC, but fast enough for any UART. The body of a
/// frame is always a view into the parser, valid only during the call of the sink.
template <class Formats>
class BasicParser<Formats, Optimize::size> {
 public:
  constexpr BasicParser() noexcept = default;
  constexpr explicit BasicParser(const Formats& formats) noexcept : formats_(formats) {}

  constexpr Formats& formats() noexcept { return formats_; }

  template <class Sink>
  void feed(std::span<const std::uint8_t> chunk,
            Sink&& sink) noexcept(std::is_nothrow_invocable_v<Sink&, const Frame&>) {
    taken_ += static_cast<std::uint32_t>(chunk.size());
    const std::uint8_t* const end = chunk.data() + chunk.size();
    for (const std::uint8_t* byte = chunk.data(); byte != end;) {
      buffer_[held_++] = *byte++;
      if (held_ >= needed_) settle(static_cast<std::uint32_t>(end - byte), sink);
    }
  }

  template <class Sink>
  void flush(Sink&& sink) noexcept(std::is_nothrow_invocable_v<Sink&, const Frame&>) {
    while (held_ != 0) {
      ++incomplete_;
      remove(1);
      settle(0, sink);
    }
  }

  ParserCounters counters() const noexcept {
    return {frames_, taken_ - delivered_ - held_, header_errors_, body_errors_, incomplete_};
  }

  std::size_t waiting_bytes() const noexcept { return held_; }

  void reset() noexcept { *this = BasicParser{formats_}; }

 private:
  /// Delivers the frames among the held bytes; `following` bytes of the chunk come after them. Only
  /// an incomplete candidate remains.
  template <class Sink>
  SBGC_NOINLINE void settle(std::uint32_t following, Sink& sink) {
    while (held_ != 0 && needed_ <= held_) {
      const Candidate candidate = formats_.inspect(buffer_, held_);
      if (candidate.verdict == Verdict::incomplete) {
        needed_ = static_cast<std::uint16_t>(candidate.size);
        return;
      }
      std::size_t done = 1;
      if (candidate.verdict == Verdict::frame) {
        done = candidate.size;
        deliver(done, following, sink);
      }
      if (candidate.verdict == Verdict::bad_header) ++header_errors_;
      if (candidate.verdict == Verdict::bad_body) ++body_errors_;
      remove(done);
    }
  }

  template <class Sink>
  void deliver(std::size_t size, std::uint32_t following, Sink& sink) {
    ++frames_;
    delivered_ += static_cast<std::uint32_t>(size);
    const std::uint16_t held = held_;
    held_ = needed_ = 0;  // if the sink throws, the other bytes are skipped
    Frame frame = frame_at(buffer_, taken_ - following - held);
    if constexpr (Formats::is_one) frame.framing = Formats::first;
    sink(frame);
    held_ = held;
  }

  /// Removes the first `count` bytes, and further ones up to the next possible start of a frame.
  void remove(std::size_t count) noexcept {
    while (count < held_ && !formats_.is_start(buffer_[count])) ++count;
    held_ = static_cast<std::uint16_t>(held_ - count);
    needed_ = 0;
    detail::move_memory(buffer_, buffer_ + count, held_);
  }

  [[no_unique_address]] Formats formats_{};
  std::uint16_t held_{};       // bytes in the buffer
  std::uint16_t needed_{};     // bytes needed to decide the candidate at buffer_[0]
  std::uint32_t taken_{};      // bytes fed
  std::uint32_t delivered_{};  // bytes of delivered frames
  std::uint32_t frames_{};
  std::uint32_t header_errors_{};
  std::uint32_t body_errors_{};
  std::uint32_t incomplete_{};
  std::uint8_t buffer_[max_frame_size]{};
};

/// For frames of the framing that every board understands.
using SmallParser = BasicParser<FrameFormats<CrcTable::nibbles, basic_framing>, Optimize::size>;

}  // namespace sbgc
