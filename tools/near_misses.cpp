#include "near_misses.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "decoded_frame.hpp"

namespace sbgc::tools {

namespace {

std::string claimed(std::uint8_t id) {
  std::string name = command_name(id, Direction::from_board);
  if (name.empty()) name = command_name(id, Direction::to_board);
  return name.empty() ? fmt::format("the unknown id {}", id) : fmt::format("{} ({})", name, id);
}

std::string checksum(const char* of, std::uint8_t found, std::uint8_t right) {
  return fmt::format("the checksum of its {} is 0x{:02x}, not 0x{:02x}", of, found, right);
}

/// Says why what begins with the start byte `bytes[0]` is no frame.
std::string reason(Candidate candidate, std::span<const std::uint8_t> bytes) {
  if (bytes.size() < frame_header_size) return "a start byte, but the bytes end within the header";
  const std::uint8_t id = bytes[1];
  const std::uint8_t size = bytes[2];
  // The frame as it should be; bytes that are not there are 0.
  std::array<std::uint8_t, max_frame_size> right{};
  std::copy_n(bytes.begin(), std::min(bytes.size(), right.size()), right.begin());
  Framing::finish(right.data(), id, size, right.data() + frame_header_size);
  if (candidate.verdict == Verdict::bad_header) {
    if (id == 0) return "a start byte, but no command has the id 0";
    constexpr std::size_t place = frame_header_size - 1;
    return "a start byte, but " + checksum("header", bytes[place], right[place]);
  }
  std::string result = fmt::format("looks like {} with a body of {} byte{}, but ", claimed(id),
                                   size, size == 1 ? "" : "s");
  if (candidate.verdict == Verdict::incomplete) {
    const std::size_t missing = candidate.size - bytes.size();
    result += fmt::format("the last {} of its {} bytes {} missing", missing, candidate.size,
                          missing == 1 ? "is" : "are");
  } else {
    const std::size_t place = candidate.size - 1;
    result += checksum("body", bytes[place], right[place]);
  }
  return result;
}

}  // namespace

std::vector<NearMiss> near_misses(std::span<const std::uint8_t> bytes,
                                  std::span<const std::uint8_t> rest, std::size_t limit) {
  std::vector<std::uint8_t> all(bytes.begin(), bytes.end());
  all.insert(all.end(), rest.begin(), rest.end());
  std::vector<NearMiss> result;
  for (std::size_t at = 0; at < bytes.size() && result.size() < limit; ++at) {
    if (all[at] != frame_start) continue;
    const auto from = std::span<const std::uint8_t>(all).subspan(at);
    const Candidate candidate = Framing::inspect(from.data(), from.size());
    if (candidate.verdict == Verdict::frame) continue;  // some other candidate has claimed it
    result.push_back({at, candidate.verdict, reason(candidate, from)});
  }
  return result;
}

}  // namespace sbgc::tools
