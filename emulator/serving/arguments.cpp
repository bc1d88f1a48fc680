#include "serving/arguments.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include <sbgc/emulator/board_options.hpp>
#include <sbgc/internal/parse_number.hpp>
#include <sbgc/message_infos.hpp>
#include <sbgc/protocol.hpp>
#include <sbgc/text.hpp>

#include "hosts/listen.hpp"
#include "serving/motion_file.hpp"
#include "serving/new_board.hpp"

namespace sbgc::serving {

namespace {

[[noreturn]] void refuse(const std::string& text, const char* wanted) {
  throw std::invalid_argument(fmt::format("'{}' is not {}", text, wanted));
}

/// Reads an unsigned number of at most `most`.
template <class Number>
bool read(std::string_view text, Number most, Number& number) {
  const auto read = sbgc::detail::parse_number<Number>(text);
  if (!read || text.front() == '-' || !(*read <= most)) return false;  // also for NaN
  number = *read;
  return true;
}

/// Returns the texts before and after the separator.
std::pair<std::string_view, std::string_view> split(std::string_view text, char separator) {
  const std::size_t at = std::min(text.find(separator), text.size());
  return {text.substr(0, at), text.substr(std::min(at + 1, text.size()))};
}

/// About 11 days: longer times are considered a mistake.
constexpr double most_seconds = 1e6;

bool read_duration(std::string_view text, double us_per_unit, Duration& duration) {
  double number = 0;
  if (!read(text, most_seconds * 1e6 / us_per_unit, number)) return false;
  duration = microseconds(std::llround(number * us_per_unit));
  return true;
}

}  // namespace

hosts::ListenAddress parse_listen(const std::string& text) {
  constexpr const char* wanted = "a port or HOST:PORT, such as 5000, 0.0.0.0:5000 or [::1]:5000";
  hosts::ListenAddress result;
  std::string_view port = text;
  if (const std::size_t colon = text.rfind(':'); colon != std::string::npos) {
    std::string_view host = std::string_view(text).substr(0, colon);
    port.remove_prefix(colon + 1);
    if (host.size() > 2 && host.front() == '[' && host.back() == ']') {
      host = host.substr(1, host.size() - 2);
    } else if (host.find_first_of(":[]") != std::string_view::npos) {
      refuse(text, wanted);
    }
    if (host.empty()) refuse(text, wanted);
    result.host = host;
  }
  if (!read(port, std::numeric_limits<std::uint16_t>::max(), result.port)) refuse(text, wanted);
  try {
    hosts::address_of(result);
  } catch (const std::runtime_error& error) {
    throw std::invalid_argument(error.what());
  }
  return result;
}

double parse_share(const std::string& text) {
  const auto share = read_share(text, 0, 1);
  if (!share) refuse(text, "a share from 0 to 1 (0% to 100%), such as 0.01 or 1%");
  return *share;
}

DelayFault parse_delay(const std::string& text) {
  DelayFault result;
  const auto [part, delay] = split(text, ':');
  const bool has_delay = part.size() < text.size();
  const auto share = read_share(part, 0, 1);
  if (!share || (has_delay && !read_duration(delay, 1e3, result.delay))) {
    refuse(text,
           "a share from 0 to 1 (0% to 100%), alone or with up to 1000000000 milliseconds, such as "
           "1% or 0.01:50");
  }
  result.share = *share;
  return result;
}

emulator::Silence parse_silence(const std::string& text) {
  emulator::Silence result;
  const auto [from, length] = split(text, ':');
  if (!read_duration(from, 1e6, result.from) || !read_duration(length, 1e6, result.length)) {
    refuse(text, "FROM:LENGTH in seconds, each up to 1000000, such as 10:2.5");
  }
  return result;
}

Duration parse_seconds(const std::string& text) {
  Duration result;
  if (!read_duration(text, 1e6, result)) refuse(text, "a time in seconds, up to 1000000");
  return result;
}

Duration parse_interval(const std::string& text) {
  Duration result;
  if (!read_duration(text, 1e6, result) || result < milliseconds(1)) {
    refuse(text, "a time in seconds from 0.001 to 1000000");
  }
  return result;
}

std::string problem_of(msg::FirmwareVersion version) {
  if (version.raw() <= newest_firmware) return {};
  return fmt::format(
      "firmware {} is not emulated, only up to {}: later firmware has commands and forms that "
      "the emulated board does not support",
      to_string(version), to_string(msg::FirmwareVersion(newest_firmware)));
}

msg::BoardVersion usual_board(msg::FirmwareVersion firmware) {
  msg::BoardVersion newest = emulator::BoardOptions{}.board;
  for (const MessageInfo* const info : message_infos) {
    const msg::BoardVersion needed(info->since.board);
    if (info->since.firmware <= firmware.raw()) newest = std::max(newest, needed);
  }
  return newest;
}

msg::BoardVersion parse_board(const std::string& text) {
  const auto [major, minor] = split(text, '.');
  unsigned whole = 0;
  unsigned tenth = 0;
  msg::BoardVersion version;
  if (!read(major, 24U, whole) || !read(minor, 9U, tenth) || !version.set_major(whole) ||
      !version.set_minor(tenth)) {
    refuse(text, "a board version, such as 3.0 or 3.2");
  }
  return version;
}

emulator::Disturbance parse_motion(const std::string& text) {
  if (const auto kind = motion_named(text)) return {.kind = *kind};
  try {
    return {.kind = emulator::Disturbance::Kind::recorded, .recording = load_motion(text)};
  } catch (const std::runtime_error& error) {
    throw std::invalid_argument(std::string(error.what()) +
                                " (instead of a file: rest, handheld, drone or vehicle)");
  }
}

}  // namespace sbgc::serving
