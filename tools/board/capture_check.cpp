#include "board/capture_check.hpp"

#include <filesystem>
#include <span>
#include <system_error>
#include <variant>
#include <vector>

#include <fmt/format.h>

#include <sbgc/io/capture.hpp>
#include <sbgc/io/open.hpp>
#include <sbgc/parser.hpp>

#include "command/command_error.hpp"
#include "command/input_output.hpp"
#include "command/wording.hpp"

namespace sbgc::tools {

namespace {

/// Receives the bytes of a capture.
class CaptureCheck {
 public:
  void feed(std::span<const std::uint8_t> bytes) {
    parser_.feed(bytes);
    take_items();
  }
  void finish() {
    parser_.finish();
    take_items();
  }

  bool has_bytes_of_board() const { return has_bytes_of_board_; }
  const std::string& damage() const { return damage_; }

 private:
  void take_items() {
    while (const auto item = parser_.next()) {
      if (const auto* const damage = std::get_if<io::CaptureDamage>(&*item)) {
        damage_ += (damage_.empty() ? "" : " ") + to_string(*damage);
      } else if (const auto* const record = std::get_if<io::CaptureRecord>(&*item)) {
        const bool is_of_board = record->kind == io::CaptureKind::from_board;
        has_bytes_of_board_ = has_bytes_of_board_ || (is_of_board && !record->bytes.empty());
      }
    }
  }

  io::CaptureParser parser_{};
  bool has_bytes_of_board_ = false;
  std::string damage_{};
};

/// True if a frame is among the bytes that begin with `begin`.
bool has_frame(Input& input, std::span<const std::uint8_t> begin) {
  ParserOfAll parser;
  bool is_found = false;
  const auto take = [&](const Frame&) { is_found = true; };
  for (auto block = begin; !block.empty() && !is_found; block = input.read()) {
    parser.feed(block, take);
  }
  parser.flush(take);
  return is_found;
}

}  // namespace

std::string check_capture(const std::string& file) {
  Input input(file, "a capture");
  std::span<const std::uint8_t> block = input.read();
  if (block.empty()) throw CommandError(fmt::format("{} is empty", file));
  if (!io::is_capture(block)) {
    if (has_frame(input, block)) return "";
    throw CommandError(fmt::format("{} is not a capture, and contains no frame", file));
  }
  CaptureCheck check;
  for (; !block.empty(); block = input.read()) check.feed(block);
  check.finish();
  const std::string damage = without_period(check.damage());
  if (!check.has_bytes_of_board()) {
    throw CommandError(
        fmt::format("{} has no bytes of a board{}{}", file, damage.empty() ? "" : ": ", damage));
  }
  if (damage.empty()) return "";
  return fmt::format("{} has damaged parts, which are left out: {}", file, damage);
}

std::string damage_at(const std::string& address) {
  const io::AddressResult parsed = io::parse_address(address);
  const auto* const capture = std::get_if<io::CaptureAddress>(&parsed.address);
  std::error_code ignored;
  const bool is_file =
      capture != nullptr && std::filesystem::is_regular_file(capture->file, ignored);
  return is_file ? check_capture(capture->file) : "";
}

}  // namespace sbgc::tools
