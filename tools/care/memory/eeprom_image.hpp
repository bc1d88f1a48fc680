/// Files with bytes of an EEPROM: a line of JSON that describes them, then the bytes.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <sbgc/client/board_identity.hpp>

namespace sbgc::tools {

struct EepromImage {
  std::string model{};  ///< of the board, as BoardIdentity gives it
  std::string firmware{};
  std::uint32_t extra_id{};  ///< of special firmware
  std::string serial_number{};
  std::uint32_t address{};
  std::vector<std::uint8_t> data{};
};

/// Returns an image with bytes of this board.
EepromImage image_of(const BoardIdentity& board, std::uint32_t address,
                     std::vector<std::uint8_t> data);

/// Returns the content of the file.
std::string to_text(const EepromImage& image);

/// Parses an image; returns nothing if the file does not begin with such a line. Throws
/// CommandError if it was changed or is incomplete.
std::optional<EepromImage> parse_image(std::string_view content);

}  // namespace sbgc::tools
