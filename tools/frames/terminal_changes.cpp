#include "frames/terminal_changes.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>

#include <fmt/format.h>

#include <sbgc/frame.hpp>
#include <sbgc/framing.hpp>

#include "frames/command_lookup.hpp"

namespace sbgc::tools {

namespace {

using ByteSpan = std::span<const std::uint8_t>;
using Header = std::array<std::uint8_t, frame_header_size>;

/// The bytes that a terminal of Linux removes: the characters for end of file, start, reprint, stop
/// and literal next. Others, such as erase, remove more than themselves.
constexpr std::array<std::uint8_t, 5> removed_bytes{0x04, 0x11, 0x12, 0x13, 0x16};
constexpr std::uint8_t carriage_return = 0x0D;
constexpr std::uint8_t line_feed = 0x0A;
/// The bytes of a header after the start byte, the size first: with the same sum, the id could be
/// missing as well, but few ids are among the removed bytes.
constexpr std::array<std::size_t, 3> places{frame_size_offset, frame_id_offset,
                                            frame_header_checksum_offset};
static_assert(places.size() + 1 == frame_header_size);

bool is_removed(std::uint8_t byte) {
  return std::find(removed_bytes.begin(), removed_bytes.end(), byte) != removed_bytes.end();
}

std::uint8_t sum_of(ByteSpan bytes) {
  return static_cast<std::uint8_t>(std::accumulate(bytes.begin(), bytes.end(), 0U));
}

const char* name_of(std::size_t place) {
  if (place == frame_id_offset) return "id";
  return place == frame_size_offset ? "size" : "header checksum";
}

/// Rates how well the header fits a command; 0 means that it is not valid, or that the command has
/// bodies of almost any size.
int fit(const Header& header, std::optional<Direction> direction) {
  const Verdict verdict = AllFrameFormats::inspect(header.data(), header.size()).verdict;
  if (verdict == Verdict::no_start || verdict == Verdict::bad_header) return 0;
  int best = 0;
  for (const Direction one : {Direction::to_board, Direction::from_board}) {
    if (direction && *direction != one) continue;
    best = std::max(best, body_fit(one, header[frame_id_offset], header[frame_size_offset]));
  }
  constexpr int documented = 3;
  return best < documented ? 0 : best;
}

}  // namespace

std::optional<ChangedHeader> changed_header(ByteSpan bytes, std::optional<Direction> direction) {
  if (bytes.size() + 1 < frame_header_size) return std::nullopt;
  std::optional<ChangedHeader> best;
  int best_fit = 0;
  const auto consider = [&](const Header& header, std::size_t place, const char* change) {
    const int fits = fit(header, direction);
    if (fits <= best_fit) return;
    best_fit = fits;
    best = {header[frame_id_offset], header[frame_size_offset],
            fmt::format("its {}, 0x{:02x}, {}: the port is not in raw mode", name_of(place),
                        header[place], change)};
  };
  for (const std::size_t place : places) {
    const auto position = static_cast<std::ptrdiff_t>(place);
    Header header{};
    std::copy_n(bytes.begin(), place, header.begin());
    std::copy_n(bytes.begin() + position, frame_header_size - 1 - place,
                header.begin() + position + 1);
    for (const std::uint8_t removed : removed_bytes) {
      header[place] = removed;
      consider(header, place, "is missing");
    }
    if (bytes.size() < frame_header_size || bytes[place] != line_feed) continue;
    std::copy_n(bytes.begin(), header.size(), header.begin());
    header[place] = carriage_return;
    consider(header, place, "has become 0x0a");
  }
  return best;
}

std::string remark_on_replaced(ByteSpan frame) {
  if (!has_only_sums(framing_of(frame.data()))) return "";
  const ByteSpan body = frame.subspan(frame_header_size, frame[frame_size_offset]);
  const std::uint8_t checksum = frame[frame_header_size + body.size()];
  const auto line_feeds = std::count(body.begin(), body.end(), line_feed);
  const auto explains = [&](std::uint8_t sent) {
    constexpr int difference = carriage_return - line_feed;
    const int missing = static_cast<std::uint8_t>(sent - sum_of(body));
    return missing % difference == 0 && missing / difference <= line_feeds;
  };
  if (!explains(checksum) && !(checksum == line_feed && explains(carriage_return))) return "";
  return "; it fits if 0x0d has become 0x0a, as on a port that is not in raw mode";
}

std::string remark_on_removed(ByteSpan rest) {
  if (!has_only_sums(framing_of(rest.data()))) return "";
  const ByteSpan body = rest.subspan(frame_header_size);
  if (is_removed(sum_of(body))) return ", as on a port that is not in raw mode";
  if (body.empty()) return "";
  const auto removed = static_cast<std::uint8_t>(body.back() - sum_of(body.first(body.size() - 1)));
  if (!is_removed(removed)) return "";
  return fmt::format(
      "; or it is there, and 0x{:02x} is missing in the body, as on a port that is not in raw mode",
      removed);
}

}  // namespace sbgc::tools
