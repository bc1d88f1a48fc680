// Fuzzes the streaming parser against the reference parser. The input is a sequence of steps, each
// an opcode byte and its operands, so a mutation moves chunk boundaries and flushes as easily as
// bytes:
//   0..239:   feed as many bytes as the opcode specifies
//   240..249: feed a frame from write_frame; operands: id, body size, space for the frame, body
//   250..254: flush
//   255:      feed the remaining bytes

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <span>
#include <vector>

#include <sbgc/frame.hpp>
#include <sbgc/parser.hpp>

#include "core/reference_parser.hpp"

namespace {

using sbgc::test::Bytes;
using sbgc::test::End;
using sbgc::test::ReferenceFrame;
using sbgc::test::ReferenceResult;

void require(bool condition) {
  if (!condition) std::abort();
}

class Checker {
 public:
  void feed(std::span<const std::uint8_t> bytes) {
    // On the heap and of exactly this size, so that a sanitizer detects a read out of bounds.
    const Bytes chunk(bytes.begin(), bytes.end());
    const std::uint64_t chunk_offset = segment_offset_ + segment_.size();
    segment_.insert(segment_.end(), chunk.begin(), chunk.end());
    parser_.feed(chunk, [&](const sbgc::Frame& frame) {
      keep(frame);
      if (frame.offset >= chunk_offset) {
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

 private:
  void keep(const sbgc::Frame& frame) {
    frames_.push_back({frame.id, {frame.body.begin(), frame.body.end()}, frame.offset});
  }

  void compare(End end) const {
    const ReferenceResult reference = sbgc::test::reference_parse(segment_, end, segment_offset_);
    require(frames_ == reference.frames);
    require(parser_.waiting_bytes() == reference.waiting_bytes);
    const sbgc::ParserCounters now = parser_.counters();
    require(now.frames - settled_.frames == reference.frames.size());
    require(now.skipped_bytes - settled_.skipped_bytes == reference.skipped_bytes);
    require(now.header_errors - settled_.header_errors == reference.header_errors);
    require(now.body_errors - settled_.body_errors == reference.body_errors);
    require(now.incomplete - settled_.incomplete == reference.incomplete);
  }

  sbgc::Parser parser_;
  sbgc::ParserCounters settled_;  // at the last flush
  Bytes segment_;                 // fed since the last flush
  std::uint64_t segment_offset_{};
  std::vector<ReferenceFrame> frames_;
};

/// Returns the frame of `body` under `id`, and checks the result of write_frame.
Bytes framed(std::uint8_t id, std::span<const std::uint8_t> body, std::size_t space) {
  Bytes out(space);
  const sbgc::WriteResult result = sbgc::write_frame(id, body, out);
  require(static_cast<bool>(result) == (id != 0 && body.size() <= 255 && space >= body.size() + 5));
  require(result ? result.size == body.size() + 5 : result.size == 0);
  out.resize(result.size);
  if (result) {
    const ReferenceResult reference = sbgc::test::reference_parse(out, End::final);
    require(reference.frames.size() == 1 && reference.skipped_bytes == 0);
    require(reference.frames[0].id == id && std::ranges::equal(reference.frames[0].body, body));
  }
  return out;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  // The reference parser runs after every step, so longer inputs are slow and find nothing new.
  if (size > 4096) return 0;
  std::span<const std::uint8_t> input(data, size);
  const auto take = [&input](std::size_t count) {
    const auto taken = input.first(std::min(count, input.size()));
    input = input.subspan(taken.size());
    return taken;
  };
  Checker checker;
  while (!input.empty()) {
    const std::uint8_t step = take(1)[0];
    if (step < 240) {
      checker.feed(take(step));
    } else if (step < 250) {
      const auto head = take(3);
      if (head.size() < 3) break;
      checker.feed(framed(head[0], take(head[1]), head[2] + std::size_t{step} - 240));
    } else if (step < 255) {
      checker.flush();
    } else {
      checker.feed(take(input.size()));
    }
  }
  checker.flush();
  return 0;
}
