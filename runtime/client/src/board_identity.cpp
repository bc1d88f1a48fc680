#include <array>
#include <cstdio>

#include <sbgc/client/board_identity.hpp>

#include "text.hpp"

namespace sbgc {

std::string BoardIdentity::firmware_version() const {
  return detail::firmware_text(versions().firmware);
}

std::string BoardIdentity::board_version() const { return detail::board_text(versions().board); }

std::string BoardIdentity::serial_number() const {
  std::string text;
  if (!details) return text;
  for (const std::uint8_t byte : details->device_id) {
    std::array<char, 3> digits{};
    std::snprintf(digits.data(), digits.size(), "%02x", byte);
    text += digits.data();
  }
  return text;
}

}  // namespace sbgc
