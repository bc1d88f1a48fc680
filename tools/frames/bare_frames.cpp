#include "frames/bare_frames.hpp"

#include <algorithm>
#include <array>

#include <sbgc/framing.hpp>

#include "frames/command_lookup.hpp"

namespace sbgc::tools {

namespace {

/// Appends the frame at the begin of `bytes` and returns its size; 0 if there is none.
std::size_t take_frame(std::span<const std::uint8_t> bytes, std::uint64_t offset,
                       std::vector<BareFrame>& out) {
  std::size_t taken = 0;
  for (const Framing framing : framings) {
    std::array<std::uint8_t, max_frame_size> whole{};
    const std::size_t rest = std::min(bytes.size(), whole.size() - 1);
    whole[0] = with_framing(framing, [](auto f) { return FramingFacts<f()>::start; });
    std::copy_n(bytes.begin(), rest, whole.begin() + 1);
    const Candidate found = AllFrameFormats::inspect(whole.data(), rest + 1);
    if (rest + 1 < frame_header_size || found.verdict == Verdict::bad_header) return 0;
    const std::size_t size = whole[frame_size_offset];
    const std::size_t end = frame_header_size - 1 + size;
    const bool is_whole = found.verdict == Verdict::frame;
    const std::uint8_t id = whole[frame_id_offset];
    const bool is_known =
        has_command(Direction::to_board, id) || has_command(Direction::from_board, id);
    if (end > bytes.size() || !is_known) return 0;
    if (taken != 0 && !is_whole) continue;
    if (taken != 0) out.pop_back();
    out.push_back({{id, bytes.subspan(frame_header_size - 1, size), offset, framing}, is_whole});
    taken = is_whole ? found.size - 1 : end;
    if (is_whole) break;
  }
  return taken;
}

}  // namespace

std::vector<BareFrame> bare_frames(std::span<const std::uint8_t> bytes) {
  std::vector<BareFrame> result;
  for (std::size_t at = 0; at < bytes.size();) {
    const std::size_t size = take_frame(bytes.subspan(at), at, result);
    if (size == 0) return {};
    at += size;
  }
  return result;
}

std::string what_is_missing(const BareFrame& bare) {
  return bare.has_checksum ? "without its start byte"
                           : "without its start byte and the checksum behind its body";
}

}  // namespace sbgc::tools
