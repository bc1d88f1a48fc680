// Checks the streaming parser, with each combination of framings, against the reference parser. The
// input is a sequence of steps, each an opcode byte and its operands, so a mutation moves chunk
// boundaries and flushes as easily as bytes:
//   0..239:   feed as many bytes as the opcode specifies
//   240..249: feed a frame from write_frame, of the second framing if the opcode is odd; operands:
//             id, body size, space for the frame, body
//   250..254: flush
//   255:      feed the remaining bytes

#include <sbgc/frame.hpp>
#include <sbgc/parser.hpp>
#include <sbgc/small_parser.hpp>

#include "core/both_paths.hpp"
#include "core/reference_parser.hpp"
#include "input.hpp"

namespace {

using sbgc::CrcTable;
using sbgc::Framing;
using sbgc::fuzz::require;
using sbgc::test::Accepts;
using sbgc::test::Bytes;
using sbgc::test::End;
using sbgc::test::ReferenceFrame;
using sbgc::test::ReferenceResult;

/// Checks a parser that accepts these framings. A small one copies all frames.
template <class Parser, Accepts accepts, sbgc::Optimize optimize = sbgc::Optimize::speed>
class Checker {
 public:
  void feed(std::span<const std::uint8_t> bytes) {
    // On the heap and of exactly this size, so that a sanitizer detects a read out of bounds.
    const Bytes chunk(bytes.begin(), bytes.end());
    const std::uint64_t chunk_offset = segment_offset_ + segment_.size();
    segment_.insert(segment_.end(), chunk.begin(), chunk.end());
    parser_.feed(chunk, [&](const sbgc::Frame& frame) {
      keep(frame);
      if (optimize == sbgc::Optimize::speed && frame.offset >= chunk_offset) {
        require(frame.body.data() == chunk.data() + (frame.offset - chunk_offset) + 4);
      }
    });
    compare(End::open);
  }

  void flush() {
    parser_.flush([this](const sbgc::Frame& frame) { keep(frame); });
    compare(End::final);
    segment_offset_ += segment_.size();
    segment_.clear();
    frames_.clear();
    settled_ = parser_.counters();
  }

  /// Returns the frames since the last call: the offset, the id and the body of each.
  Bytes take_results() { return std::exchange(results_, {}); }

 private:
  void keep(const sbgc::Frame& frame) {
    for (int shift = 0; shift < 64; shift += 8) {
      results_.push_back(static_cast<std::uint8_t>(frame.offset >> shift));
    }
    results_.push_back(frame.id);
    results_.insert(results_.end(), frame.body.begin(), frame.body.end());
    frames_.push_back({frame.id,
                       {frame.body.begin(), frame.body.end()},
                       frame.offset,
                       frame.framing == sbgc::Framing::v2});
  }

  void compare(End end) const {
    const ReferenceResult reference =
        sbgc::test::reference_parse(segment_, end, segment_offset_, accepts);
    require(frames_ == reference.frames);
    require(parser_.waiting_bytes() == reference.waiting_bytes);
    const sbgc::ParserCounters now = parser_.counters();
    require(now.frames - settled_.frames == reference.frames.size());
    require(now.skipped_bytes - settled_.skipped_bytes == reference.skipped_bytes);
    require(now.header_errors - settled_.header_errors == reference.header_errors);
    require(now.body_errors - settled_.body_errors == reference.body_errors);
    require(now.incomplete - settled_.incomplete == reference.incomplete);
  }

  Parser parser_;
  sbgc::ParserCounters settled_;  // at the last flush
  Bytes segment_;                 // fed since the last flush
  std::uint64_t segment_offset_{};
  std::vector<ReferenceFrame> frames_;
  Bytes results_;
};

/// Parsers of both kinds and all combinations of framings.
class Checkers {
 public:
  void feed(std::span<const std::uint8_t> bytes) {
    v1_.feed(bytes);
    v2_.feed(bytes);
    both_.feed(bytes);
    small_.feed(bytes);
  }
  /// Returns all frames since the last call, and where they were.
  Bytes take_results() {
    Bytes results = v1_.take_results();
    for (const Bytes& others : {v2_.take_results(), both_.take_results(), small_.take_results()}) {
      results.insert(results.end(), others.begin(), others.end());
    }
    return results;
  }
  void flush() {
    v1_.flush();
    v2_.flush();
    both_.flush();
    small_.flush();
  }

 private:
  Checker<sbgc::Parser, Accepts::v1> v1_;
  Checker<sbgc::BasicParser<sbgc::FrameFormats<CrcTable::nibbles, Framing::v2>>, Accepts::v2> v2_;
  Checker<sbgc::BasicParser<sbgc::AnyFrameFormats>, Accepts::both> both_;
  Checker<sbgc::BasicParser<sbgc::AnyFrameFormats, sbgc::Optimize::size>, Accepts::both,
          sbgc::Optimize::size>
      small_;
};

/// Returns the frame of `body` under `id`, and checks the result of write_frame.
Bytes framed(Framing framing, std::uint8_t id, std::span<const std::uint8_t> body,
             std::size_t space) {
  Bytes out(space);
  const std::size_t size = body.size() + (framing == Framing::v1 ? 5 : 6);
  const sbgc::WriteResult result = sbgc::write_frame(framing, id, body, out);
  require(static_cast<bool>(result) == (id != 0 && body.size() <= 255 && space >= size));
  require(result.size == (result ? size : 0));
  out.resize(result.size);
  if (result) {
    const Accepts accepts = framing == Framing::v1 ? Accepts::v1 : Accepts::v2;
    const ReferenceResult reference = sbgc::test::reference_parse(out, End::final, 0, accepts);
    require(reference.frames.size() == 1 && reference.skipped_bytes == 0);
    require(reference.frames[0].id == id && std::ranges::equal(reference.frames[0].body, body));
  }
  return out;
}

}  // namespace

Bytes SBGC_FUZZ_RESULTS(std::span<const std::uint8_t> input) {
  // The reference parser runs after every step, so longer inputs are slow and find nothing new.
  if (input.size() > 4096) return {};
  const auto take = [&input](std::size_t count) {
    const auto taken = input.first(std::min(count, input.size()));
    input = input.subspan(taken.size());
    return taken;
  };
  Checkers checkers;
  Bytes results;
  while (!input.empty()) {
    const std::uint8_t step = take(1)[0];
    if (step < 240) {
      checkers.feed(take(step));
    } else if (step < 250) {
      const auto head = take(3);
      if (head.size() < 3) break;
      const Framing framing = step % 2 == 0 ? Framing::v1 : Framing::v2;
      const Bytes frame =
          framed(framing, head[0], take(head[1]), head[2] + std::size_t{step} - 240);
      results.insert(results.end(), frame.begin(), frame.end());
      checkers.feed(frame);
    } else if (step < 255) {
      checkers.flush();
    } else {
      checkers.feed(take(input.size()));
    }
  }
  checkers.flush();
  const Bytes frames = checkers.take_results();
  results.insert(results.end(), frames.begin(), frames.end());
  return results;
}
