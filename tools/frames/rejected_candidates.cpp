#include "frames/rejected_candidates.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <optional>
#include <span>
#include <string>
#include <utility>

#include <fmt/format.h>

#include <sbgc/frame.hpp>
#include <sbgc/framing.hpp>
#include <sbgc/message.hpp>

#include "frames/command_lookup.hpp"

namespace sbgc::tools {

namespace {

/// A header before the driver of a serial port changed it. The driver removes some bytes and turns
/// 0x0d into 0x0a unless the port is in raw mode.
struct ChangedHeader {
  std::uint8_t id{};
  std::uint8_t size{};
  std::string change{};  ///< such as "its size, 0x12, is missing: the port is not in raw mode"
};

using ByteSpan = std::span<const std::uint8_t>;
using Header = std::array<std::uint8_t, frame_header_size>;

/// The bytes that a Linux terminal removes: the characters for end of file, start, reprint, stop
/// and literal next. Others, such as erase, remove more than themselves.
constexpr std::array<std::uint8_t, 5> removed_bytes{0x04, 0x11, 0x12, 0x13, 0x16};
constexpr std::uint8_t carriage_return = 0x0D;
constexpr std::uint8_t line_feed = 0x0A;
/// The bytes of a header after the start byte, the size first: with the same sum, the id could also
/// be missing, but few ids are among the removed bytes.
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

/// Rates how well the header fits a command; 0 means that it is invalid, or that the command has
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

/// Returns the original header that the driver may have changed to the invalid one after the start
/// byte `bytes[0]`, if it fits a command.
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

/// Return a remark, which continues a sentence, if the driver may have changed the body or the
/// trailer of a frame with a valid header; otherwise "". Detectable only in framings with sums.
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

/// `rest` is the frame without the removed byte.
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

const char* sender(Direction direction) {
  return direction == Direction::from_board ? "the board" : "the host";
}

/// Returns, for example, "CMD_CONTROL (67) from the host with a body of 15 bytes": the command that
/// fits this body size, or both commands if both directions have one.
std::string claimed(std::uint8_t id, std::size_t size, std::optional<Direction> sent) {
  std::vector<Direction> best;
  int best_fit = 0;
  for (const Direction direction : {Direction::to_board, Direction::from_board}) {
    if (sent && *sent != direction) continue;
    if (!has_command(direction, id)) continue;
    const int fits = body_fit(direction, id, size);
    if (fits < best_fit) continue;
    if (fits > best_fit) best.clear();
    best_fit = fits;
    best.push_back(direction);
  }
  const std::string bytes = fmt::format(" with a body of {} byte{}", size, size == 1 ? "" : "s");
  if (best.empty()) {
    const std::string name = command_name(
        id, sent && *sent == Direction::to_board ? Direction::to_board : Direction::from_board);
    return (name.empty() ? fmt::format("the unknown id {}", id)
                         : fmt::format("{} ({})", name, id)) +
           bytes;
  }
  std::string result;
  std::string last_name;
  for (const Direction direction : best) {
    const std::string name = command_name(id, direction);
    if (!result.empty()) result += " or ";
    if (name != last_name) result += fmt::format("{} ({}) from ", name, id);
    result += sender(direction);
    last_name = name;
  }
  result += bytes;
  if (best_fit != 0) return result;
  result += best.size() > 1 ? ", an invalid size for both" : ", an invalid size";
  const Direction other =
      best.front() == Direction::to_board ? Direction::from_board : Direction::to_board;
  if (best.size() == 1 && body_fit(other, id, size) != 0) {
    result += fmt::format(" (valid for {} from {})", command_name(id, other), sender(other));
  }
  return result;
}

/// The checksum in the trailer of a framing.
struct Trailer {
  std::size_t size{};
  bool is_crc{};

  explicit Trailer(Framing framing) {
    with_framing(framing, [this](auto f) {
      size = FramingFacts<f()>::trailer_size;
      is_crc = sbgc::is_crc(FramingFacts<f()>::trailer_checksum);
    });
  }

  std::string name(const char* body) const {
    return is_crc ? fmt::format("the CRC-{}", 8 * size)
                  : fmt::format("the checksum of its {}", body);
  }
  /// For example "0xbcdd".
  std::string value(const std::uint8_t* at) const {
    std::string digits;
    for (std::size_t i = size; i-- > 0;) digits += fmt::format("{:02x}", at[i]);
    return "0x" + digits;
  }
};

/// True if a frame seems to begin here.
bool is_next_frame(std::span<const std::uint8_t> bytes) {
  if (bytes.size() < frame_header_size) return false;
  const Verdict verdict = AllFrameFormats::inspect(bytes.data(), bytes.size()).verdict;
  return verdict != Verdict::no_start && verdict != Verdict::bad_header;
}

/// Returns the reason why the candidate with the start byte `bytes[0]` is not a frame.
std::string reason(Candidate candidate, std::span<const std::uint8_t> bytes,
                   std::optional<Direction> sent) {
  if (bytes.size() < frame_header_size) return "a start byte, but the bytes end within the header";
  const std::uint8_t id = bytes[frame_id_offset];
  const std::uint8_t size = bytes[frame_size_offset];
  // The correct frame; missing bytes are 0.
  std::array<std::uint8_t, max_frame_size> right{};
  std::copy_n(bytes.begin(), std::min(bytes.size(), right.size()), right.begin());
  const Framing framing = framing_of(bytes.data());
  AllFrameFormats::finish(framing, right.data(), id, size, right.data() + frame_header_size);
  if (candidate.verdict == Verdict::bad_header) {
    if (id == 0) return "a start byte, but no command has the id 0";
    constexpr std::size_t place = frame_header_checksum_offset;
    return fmt::format("a start byte, but the checksum of its header is 0x{:02x}, not 0x{:02x}",
                       bytes[place], right[place]);
  }
  std::string result = fmt::format("looks like {}, but ", claimed(id, size, sent));
  const Trailer trailer(framing);
  const std::size_t place = candidate.size - trailer.size;
  const std::string right_value = trailer.value(&right[place]);
  const std::string own_checksum =
      fmt::format("{}, {},", trailer.name(size == 0 ? "empty body" : "body"), right_value);
  if (candidate.verdict == Verdict::bad_body) {
    if (!is_next_frame(bytes.subspan(place))) {
      return result +
             fmt::format("{} is {}, not {}", trailer.name("body"), trailer.value(&bytes[place]),
                         right_value) +
             remark_on_replaced(bytes);
    }
    return result + own_checksum + " is missing: the next frame begins in its place" +
           remark_on_removed(bytes.first(place));
  }
  const std::size_t missing = candidate.size - bytes.size();
  if (missing == trailer.size) {
    return result + own_checksum + " is missing at the end" + remark_on_removed(bytes);
  }
  if (missing == 1) {
    return result + fmt::format("the last of its {} bytes is missing", candidate.size);
  }
  return result + fmt::format("the last {} of its {} bytes are missing", missing, candidate.size);
}

}  // namespace

std::vector<RejectedCandidate> rejected_candidates(std::span<const std::uint8_t> bytes,
                                                   std::size_t gap, std::size_t limit,
                                                   std::optional<Direction> direction) {
  std::vector<RejectedCandidate> result;
  for (std::size_t at = 0; at < gap && result.size() < limit; ++at) {
    const auto from = bytes.subspan(at);
    const Candidate candidate = AllFrameFormats::inspect(from.data(), from.size());
    if (candidate.verdict == Verdict::no_start) continue;
    if (candidate.verdict == Verdict::frame) continue;  // belongs to another candidate
    const bool has_header =
        candidate.verdict != Verdict::bad_header && from.size() >= frame_header_size;
    if (const auto changed = has_header ? std::nullopt : changed_header(from, direction)) {
      result.push_back(
          {at, candidate.verdict, true, true, 0, 0, 0,
           fmt::format("looks like {}, but {}", claimed(changed->id, changed->size, direction),
                       changed->change)});
      continue;
    }
    RejectedCandidate rejected{at, candidate.verdict, has_header, false};
    if (candidate.verdict == Verdict::bad_header) {
      const bool has_id = from[frame_id_offset] != 0;
      rejected.wrong = has_id ? frame_header_checksum_offset : frame_id_offset;
      rejected.wrong_size = 1;
    } else if (has_header) {
      rejected.size = candidate.size;
      const std::size_t trailer = Trailer(framing_of(from.data())).size;
      rejected.wrong = candidate.size - trailer;
      rejected.wrong_size = candidate.verdict == Verdict::bad_body ? trailer : 0;
    }
    rejected.text = reason(candidate, from, direction);
    result.push_back(std::move(rejected));
  }
  return result;
}

void GapExplainer::add(std::span<const std::uint8_t> bytes) {
  bytes_.erase(bytes_.begin(), bytes_.begin() + static_cast<std::ptrdiff_t>(used_));
  used_ = 0;
  bytes_.insert(bytes_.end(), bytes.begin(), bytes.end());
}

void GapExplainer::advance(std::uint64_t offset) {
  const std::uint64_t end = scanned_ + (bytes_.size() - used_);
  scan(std::min(offset, end - std::min<std::uint64_t>(rejection_reach, end)));
}

std::vector<RejectedCandidate> GapExplainer::end_gap(std::uint64_t end, std::uint64_t next) {
  scan(end);
  used_ += static_cast<std::size_t>(next - scanned_);
  scanned_ = next;
  return std::exchange(found_, {});
}

void GapExplainer::scan(std::uint64_t end) {
  if (end <= scanned_) return;
  const auto gap = static_cast<std::size_t>(end - scanned_);
  auto bytes = std::span<const std::uint8_t>(bytes_).subspan(used_);
  bytes = bytes.first(std::min(bytes.size(), gap + rejection_reach));
  // Noise contains many start bytes: of those without a valid header, report only the first, and
  // only if there is nothing better.
  constexpr std::size_t most = 3;
  for (RejectedCandidate& candidate : rejected_candidates(bytes, gap, gap, direction_)) {
    candidate.offset += scanned_;
    const bool is_only_noise_yet = found_.size() == 1 && !found_[0].has_header;
    if (candidate.has_header && is_only_noise_yet) found_.clear();
    if (found_.empty() || (candidate.has_header && found_.size() < most)) {
      found_.push_back(std::move(candidate));
    }
  }
  used_ += gap;
  scanned_ = end;
}

}  // namespace sbgc::tools
