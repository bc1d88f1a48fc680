#include "text.hpp"

#include <array>
#include <cstdio>

#include <sbgc/enums.hpp>

namespace sbgc::detail {

std::string firmware_text(std::uint16_t version) {
  const msg::FirmwareVersion parts(version);
  std::array<char, 24> text{};
  std::snprintf(text.data(), text.size(), "%u.%02u", unsigned{parts.major()},
                unsigned{parts.minor()});
  std::string result = text.data();
  if (parts.beta() != 0) result += "b" + std::to_string(parts.beta());
  return result;
}

std::string board_text(std::uint8_t version) {
  const msg::BoardVersion parts(version);
  return std::to_string(parts.major()) + "." + std::to_string(parts.minor());
}

std::string number_text(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.10g", value);
  return text.data();
}

std::string status_text(const Status& status) {
  const std::string sentence = without_stop(text(status.code));
  return *status.field == '\0' ? sentence : std::string(status.field) + ": " + sentence;
}

std::string without_stop(std::string sentence) {
  if (sentence.ends_with('.')) sentence.pop_back();
  return sentence;
}

}  // namespace sbgc::detail
