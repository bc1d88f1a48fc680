#include "care/memory/eeprom_image.hpp"

#include <utility>

#include <fmt/format.h>

#include <sbgc/internal/crc32.hpp>
#include <sbgc/internal/own_json.hpp>
#include <sbgc/io/internal/own_file.hpp>

#include "command/command_error.hpp"

namespace sbgc::tools {

namespace {

constexpr const char* image_format = "sbgc-eeprom";
constexpr std::string_view sum_key = R"(,"crc32":")";
constexpr std::size_t longest_image_line = 1024;

/// Returns the checksum of the preceding line and of the bytes.
std::string image_sum(std::string_view line, std::string_view data) {
  std::vector<std::uint8_t> bytes(line.begin(), line.end());
  bytes.insert(bytes.end(), data.begin(), data.end());
  return fmt::format("{:08x}", detail::crc32(bytes));
}

}  // namespace

EepromImage image_of(const BoardIdentity& board, std::uint32_t address,
                     std::vector<std::uint8_t> data) {
  return {board.board_version(),
          board.firmware_version(),
          board.info.frw_extra_id,
          board.serial_number(),
          address,
          std::move(data)};
}

std::string to_text(const EepromImage& image) {
  const Json facts{{"format", image_format},         {"version", 1},
                   {"model", image.model},           {"firmware", image.firmware},
                   {"frw_extra_id", image.extra_id}, {"serial_number", image.serial_number},
                   {"address", image.address},       {"size", image.data.size()}};
  std::string line = facts.dump();
  line.pop_back();  // the end of the object, which continues
  const std::string data(image.data.begin(), image.data.end());
  const std::string sum = image_sum(line, data);
  return fmt::format("{}{}{}\"}}\n{}", line, sum_key, sum, data);
}

std::optional<EepromImage> parse_image(std::string_view content) {
  const std::string_view start = content.substr(0, longest_image_line);
  const std::size_t end = start.find('\n');
  const std::size_t sum_at = start.find(sum_key);
  const bool has_line =
      start.find(image_format) != std::string_view::npos || sum_at != std::string_view::npos;
  if (!has_line) return std::nullopt;
  const auto damaged = [] {
    return CommandError("the EEPROM image was changed, or is incomplete");
  };
  if (end == std::string_view::npos || sum_at == std::string_view::npos || sum_at > end) {
    throw damaged();
  }
  const std::string_view line = content.substr(0, sum_at);
  const std::string_view data = content.substr(end + 1);
  if (content.substr(sum_at, end - sum_at) !=
      fmt::format("{}{}\"}}", sum_key, image_sum(line, data))) {
    throw damaged();
  }
  const Result<Json> facts =
      detail::parse_own_json(std::string(line) + '}', image_format, "an EEPROM image");
  if (!facts) throw CommandError(facts.error().message);
  if (facts->value("version", Json()) != 1) {
    throw CommandError("the EEPROM image is of a later version of sbgc");
  }
  try {
    if (facts->at("size").get<std::size_t>() != data.size() || data.empty()) throw damaged();
    return EepromImage{facts->at("model").get<std::string>(),
                       facts->at("firmware").get<std::string>(),
                       facts->at("frw_extra_id").get<std::uint32_t>(),
                       facts->at("serial_number").get<std::string>(),
                       facts->at("address").get<std::uint32_t>(),
                       {data.begin(), data.end()}};
  } catch (const Json::exception&) {
    throw damaged();
  }
}

}  // namespace sbgc::tools
