#include "serving/motion_file.hpp"

#include <array>
#include <cmath>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string_view>

#include <fmt/format.h>

#include <sbgc/internal/parse_number.hpp>
#include <sbgc/io/internal/own_file.hpp>

namespace sbgc::serving {

namespace {

/// A day at ten lines per second.
constexpr std::size_t largest_motion = std::size_t{64} << 20U;
constexpr double latest_second = 1e6;
constexpr double most_degrees = 1e5;

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view blanks = " \t\r";
  const std::size_t begin = text.find_first_not_of(blanks);
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(blanks) - begin + 1);
}

std::optional<double> number(std::string_view text) {
  const auto value = sbgc::detail::parse_number<double>(trimmed(text));
  return value && std::isfinite(*value) ? value : std::nullopt;
}

}  // namespace

std::vector<emulator::FrameAngles> read_motion(std::istream& text, const std::string& name) {
  std::vector<emulator::FrameAngles> result;
  std::int64_t begin_us = 0;
  std::size_t number_of_line = 0;
  const auto fail = [&](const std::string& what) {
    throw std::runtime_error(fmt::format("{}:{}: {}", name, number_of_line, what));
  };
  for (std::string line; std::getline(text, line);) {
    ++number_of_line;
    std::string_view rest = trimmed(line);
    if (rest.empty() || rest.front() == '#') continue;
    if (number_of_line == 1 && rest.find_first_of("0123456789") == std::string_view::npos) continue;
    std::array<double, 4> values{};
    for (std::size_t i = 0; i < values.size(); ++i) {
      const std::size_t comma = rest.find(',');
      if ((comma == std::string_view::npos) != (i + 1 == values.size())) {
        fail("expected four numbers: time,roll,pitch,yaw");
      }
      const std::string_view word = rest.substr(0, comma);
      const std::optional<double> value = number(word);
      if (!value) fail(fmt::format("'{}' is not a number", trimmed(word)));
      if (std::abs(*value) > (i == 0 ? latest_second : most_degrees)) {
        fail(fmt::format("{} is too large", *value));
      }
      values[i] = *value;
      rest.remove_prefix(comma == std::string_view::npos ? rest.size() : comma + 1);
    }
    const auto us = static_cast<std::int64_t>(std::llround(values[0] * 1e6));
    if (result.empty()) begin_us = us;
    const Instant at{us - begin_us};
    if (!result.empty() && at <= result.back().at)
      fail("the time must be later than in the previous line");
    result.push_back({at, {values[1], values[2], values[3]}});
  }
  if (text.bad()) throw std::runtime_error(name + " cannot be read");
  if (result.size() < 2) throw std::runtime_error(name + ": expected at least two lines");
  return result;
}

std::vector<emulator::FrameAngles> load_motion(const std::filesystem::path& file) {
  const Result<std::string> content = detail::read_text_file(file, largest_motion);
  if (!content) throw std::runtime_error(content.error().message);
  std::istringstream whole(*content);
  return read_motion(whole, file.string());
}

}  // namespace sbgc::serving
