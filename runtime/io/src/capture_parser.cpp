// Parses captures. Independent of the operating system, so that `sbgc decode` runs anywhere.

#include <algorithm>
#include <utility>

#include <sbgc/internal/crc32.hpp>
#include <sbgc/io/capture.hpp>
#include <sbgc/wire.hpp>

#include "capture_format.hpp"

namespace sbgc::io {

namespace {

using capture_format::checksum_size;
using capture_format::header_size;
using capture_format::magic;
using capture_format::record_head_size;
using capture_format::record_mark;
using capture_format::start_offset;
using capture_format::time_offset;
using capture_format::version;
using Reason = CaptureDamage::Reason;

std::uint64_t load64(const std::uint8_t* bytes) {
  return wire::load<std::uint32_t>(bytes) | std::uint64_t{wire::load<std::uint32_t>(bytes + 4)}
                                                << 32;
}

/// Loads a time of 62 bits: it is not negative, and the sum of two does not overflow.
std::chrono::microseconds load_time(const std::uint8_t* bytes) {
  constexpr std::uint64_t mask = (std::uint64_t{1} << 62) - 1;
  return std::chrono::microseconds(static_cast<std::int64_t>(load64(bytes) & mask));
}

/// Returns true if the checksum at the end of these bytes is correct.
bool is_sound(std::span<const std::uint8_t> bytes) {
  const std::size_t size = bytes.size() - checksum_size;
  return sbgc::detail::crc32(bytes.first(size)) == wire::load<std::uint32_t>(bytes.data() + size);
}

/// Returns the position of the magic in `bytes`, or of a prefix of it at their end; their size if
/// there is neither. If `or_record`, an earlier mark of a record counts as well.
std::size_t find_start(std::span<const std::uint8_t> bytes, bool or_record) {
  for (std::size_t at = 0; at < bytes.size(); ++at) {
    if (or_record && bytes[at] == record_mark) return at;
    const std::size_t size = std::min(magic.size(), bytes.size() - at);
    if (std::equal(magic.begin(), magic.begin() + static_cast<std::ptrdiff_t>(size),
                   bytes.begin() + static_cast<std::ptrdiff_t>(at))) {
      return at;
    }
  }
  return bytes.size();
}

/// Returns the size of the session header or record that begins with these bytes; nullopt if there
/// are too few of them.
std::optional<std::size_t> size_of_item(std::span<const std::uint8_t> begin) {
  if (begin.empty()) return std::nullopt;
  if (begin[0] != record_mark) return header_size;
  if (begin.size() < record_head_size) return std::nullopt;
  return record_head_size + wire::load<std::uint16_t>(begin.data() + 2) + checksum_size;
}

}  // namespace

std::string to_string(const CaptureDamage& damage) {
  const std::string place = std::to_string(damage.size) + (damage.size == 1 ? " byte" : " bytes") +
                            " from offset " + std::to_string(damage.offset);
  switch (damage.reason) {
    case Reason::not_a_capture: return "This is not a capture.";
    case Reason::newer_version:
      return place + " have a newer capture version than this program supports.";
    case Reason::torn: return "The last " + place + " on were not completely written.";
    case Reason::damaged: return place + " are damaged.";
  }
  return place + " cannot be read.";
}

bool is_capture(std::span<const std::uint8_t> begin) noexcept {
  return begin.size() >= magic.size() && std::equal(magic.begin(), magic.end(), begin.begin());
}

bool may_become_capture(std::span<const std::uint8_t> begin) noexcept {
  return begin.size() < magic.size() && std::equal(begin.begin(), begin.end(), magic.begin());
}

void CaptureParser::feed(std::span<const std::uint8_t> bytes) {
  buffer_.erase(buffer_.begin(), buffer_.begin() + static_cast<std::ptrdiff_t>(position_));
  checksums_.drop(position_);
  position_ = 0;
  buffer_.insert(buffer_.end(), bytes.begin(), bytes.end());
}

std::optional<CaptureItem> CaptureParser::next() {
  for (;;) {
    if (damage_) {
      if (auto item = find_item()) return item;
      return std::nullopt;
    }
    if (rest().empty()) return std::nullopt;
    const bool is_header = offset_ == 0 || rest()[0] == magic[0];
    const auto item = is_header ? session() : record();
    if (item || !damage_) return item;
  }
}

std::optional<CaptureItem> CaptureParser::session() {
  const auto bytes = rest();
  const std::size_t known = std::min(bytes.size(), magic.size());
  if (!std::equal(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(known),
                  magic.begin())) {
    begin_damage(offset_ == 0 ? Reason::not_a_capture : Reason::damaged);
    return std::nullopt;
  }
  if (bytes.size() < header_size) return incomplete();
  const auto header = bytes.first(header_size);
  has_session_ = false;
  if (!is_sound(header)) {
    begin_damage(Reason::damaged);
    return std::nullopt;
  }
  if (wire::load<std::uint16_t>(header.data() + 8) != version) {
    begin_damage(Reason::newer_version);
    return std::nullopt;
  }
  const CaptureSession result{
      std::chrono::sys_time<std::chrono::microseconds>(load_time(header.data() + start_offset)),
      offset_};
  advance(header_size);
  has_session_ = true;
  time_ = {};
  return result;
}

std::optional<CaptureItem> CaptureParser::record() {
  const auto bytes = rest();
  if (bytes[0] != record_mark) {
    begin_damage(Reason::damaged);
    return std::nullopt;
  }
  const auto size = size_of_item(bytes);
  if (!size || bytes.size() < *size) return incomplete();
  if (!is_sound(bytes.first(*size))) {
    begin_damage(Reason::damaged);
    return std::nullopt;
  }
  const std::size_t content = *size - record_head_size - checksum_size;
  const CaptureRecord result{static_cast<CaptureKind>(bytes[1]),
                             load_time(bytes.data() + time_offset),
                             bytes.subspan(record_head_size, content), offset_};
  time_ = result.time;
  advance(*size);
  return result;
}

std::optional<CaptureItem> CaptureParser::incomplete() {
  if (finished_) begin_damage(Reason::torn);
  return std::nullopt;
}

void CaptureParser::begin_damage(CaptureDamage::Reason reason) {
  damage_ = CaptureDamage{reason, offset_, {}};
  // A file that does not begin like a capture has no sessions.
  advance(reason == Reason::not_a_capture ? rest().size() : 1);
}

std::optional<CaptureItem> CaptureParser::find_item() {
  const bool hopeless = damage_->reason == Reason::not_a_capture;
  if (!hopeless) checksums_.append(std::span(buffer_).subspan(checksums_.size()));
  for (;;) {
    advance(hopeless ? rest().size() : find_start(rest(), has_session_));
    const auto bytes = rest();
    const auto size = size_of_item(bytes);
    if (size && bytes.size() >= *size) {
      if (is_sound_next(*size) && continues(bytes)) break;
    } else if (!finished_) {
      return std::nullopt;
    }
    if (bytes.empty()) break;
    advance(1);
  }
  // An incomplete item before others is damaged, not torn.
  if (damage_->reason == Reason::torn && !rest().empty()) damage_->reason = Reason::damaged;
  damage_->size = offset_ - damage_->offset;
  return *std::exchange(damage_, std::nullopt);
}

bool CaptureParser::is_sound_next(std::size_t size) const noexcept {
  const std::size_t content = size - checksum_size;
  return checksums_.of(position_, content) == wire::load<std::uint32_t>(rest().data() + content);
}

bool CaptureParser::continues(std::span<const std::uint8_t> item) noexcept {
  if (item[0] != record_mark) return true;
  // Threads may write their records slightly out of order.
  constexpr CaptureTime tolerance = std::chrono::seconds(1);
  has_session_ = load_time(item.data() + time_offset) + tolerance >= time_;
  return has_session_;
}

}  // namespace sbgc::io
