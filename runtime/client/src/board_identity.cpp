#include <array>
#include <cstdio>

#include <sbgc/client/board_identity.hpp>
#include <sbgc/roles.hpp>
#include <sbgc/text.hpp>

namespace sbgc {

std::string BoardIdentity::firmware_version() const {
  return to_string(msg::FirmwareVersion(versions().firmware));
}

std::string BoardIdentity::board_version() const {
  return to_string(msg::BoardVersion(versions().board));
}

std::string BoardIdentity::serial_number() const {
  std::string text;
  if (!details) return text;
  for (const std::uint8_t byte : roles::serial_number(*details)) {
    std::array<char, 3> digits{};
    std::snprintf(digits.data(), digits.size(), "%02x", byte);
    text += digits.data();
  }
  return text;
}

}  // namespace sbgc
