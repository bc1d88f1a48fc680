// The emulated board of the module `gimbal`: what `sbgc emulate` does, in the time of the page.
//
// board_start() and board_change() read lines NAME=VALUE: the EmulatorOptions of src/modules.ts,
// with faults as `sbgc emulate --fault` takes them. Their output is a sentence that says what is
// wrong, or nothing. Times are microseconds.

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>

#include <sbgc/emulator/emulator.hpp>
#include <sbgc/internal/parse_number.hpp>

#include "modules/exchange.hpp"
#include "modules/times.hpp"
#include "serving/faults.hpp"
#include "serving/new_board.hpp"

namespace sbgc::web {

namespace {

struct Powered {
  emulator::Emulator emulator;
  std::size_t port;
};

std::optional<Powered>& board() {
  static std::optional<Powered> powered;
  return powered;
}

using emulator::EmulatorOptions;

/// Reads a number from 0 to `most`.
template <class Number>
std::string read_number(std::string_view name, std::string_view text, Number most, Number& into) {
  const auto number = detail::parse_number<Number>(text);
  if (!number || !(*number >= 0 && *number <= most)) {
    return std::string(name) + " is not a number of its range: '" + std::string(text) + "'";
  }
  into = *number;
  return "";
}

std::string read_option(std::string_view name, std::string_view value, EmulatorOptions& options) {
  emulator::Faults& line = options.line.faults;
  emulator::Disturbance& frame = options.board.gimbal.frame;
  if (name == "seed") {
    std::string problem = read_number(name, value, std::numeric_limits<std::uint32_t>::max(),
                                      options.board.gimbal.seed);
    options.line.seed = options.board.gimbal.seed;
    return problem;
  }
  if (name == "board" || name == "firmware") {
    std::uint16_t version = 0;
    std::string problem =
        read_number(name, value, std::numeric_limits<std::uint16_t>::max(), version);
    if (version > 255 && name == "board") return "there is no such board";
    if (name == "board")
      options.board.board = msg::BoardVersion(static_cast<std::uint8_t>(version));
    if (name == "firmware") options.board.firmware = msg::FirmwareVersion(version);
    return problem;
  }
  if (name == "motion") {
    const auto motion = serving::motion_named(value);
    if (!motion) return "there is no motion '" + std::string(value) + "'";
    frame.kind = *motion;
    return "";
  }
  if (name == "faults") {
    return value.empty() ? "" : serving::add_faults(std::string(value), options.board);
  }
  if (name == "strength") return read_number(name, value, 100.0, frame.strength);
  if (name == "bitErrors") return read_number(name, value, 1.0, line.bit_errors);
  if (name == "lostBytes") return read_number(name, value, 1.0, line.lost);
  if (name == "duplicatedBytes") return read_number(name, value, 1.0, line.duplicated);
  if (name == "delayedBytes") return read_number(name, value, 1.0, line.delayed);
  return "there is no option '" + std::string(name) + "'";
}

/// Returns the first problem.
std::string read_options(EmulatorOptions& options) {
  std::string problem;
  for_each_setting(input_text(), [&](std::string_view name, std::string_view value) {
    if (problem.empty()) problem = read_option(name, value, options);
  });
  return problem;
}

}  // namespace

SBGC_EXPORT(board_start) void board_start(double now) {
  EmulatorOptions options;
  std::string& problem = tools::exchange().output = read_options(options);
  if (!problem.empty()) return;
  auto& made = board().emplace(Powered{{options, serving::new_memory(options.board), at(now)}, 0});
  made.port = made.emulator.connect(true, at(now)).value_or(0);
}

SBGC_EXPORT(board_change) void board_change(double now) {
  EmulatorOptions options;
  std::string& problem = tools::exchange().output = read_options(options);
  if (problem.empty() && board()) board()->emulator.change(options, at(now));
}

/// Passes the input to the board.
SBGC_EXPORT(board_receive) void board_receive(double now) {
  if (board()) board()->emulator.from_host(board()->port, tools::exchange().input, at(now));
}

/// The output is what has arrived at the host.
SBGC_EXPORT(board_advance) void board_advance(double now) {
  std::string& output = tools::exchange().output;
  output.clear();
  if (!board()) return;
  auto& [emulator, port] = *board();
  emulator.advance(at(now));
  const auto bytes = emulator.to_host(port);
  output.assign(bytes.begin(), bytes.end());
  emulator.take(port, bytes.size(), at(now));
}

SBGC_EXPORT(board_next) double board_next() {
  return board() ? in_us(board()->emulator.next()) : in_us(Instant::never);
}

}  // namespace sbgc::web
