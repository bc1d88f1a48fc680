/// Parsers for the arguments of `sbgc emulate`. All throw std::invalid_argument with a sentence
/// that states the error and the expected format.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include <sbgc/emulator/disturbance.hpp>
#include <sbgc/emulator/line.hpp>
#include <sbgc/enums.hpp>

#include "hosts/endpoint.hpp"

namespace sbgc::serving {

/// For example "5000", "0.0.0.0:5000", "[::1]:5000" or "localhost:0". Other host names are not
/// supported.
hosts::ListenAddress parse_listen(const std::string& text);

/// From 0 to 1.
double parse_share(const std::string& text);

/// For example "0.01" or "0.01:50", with the time in milliseconds.
struct DelayFault {
  double share{};
  Duration delay = emulator::Faults{}.delay;
};
DelayFault parse_delay(const std::string& text);

/// For example "10:2.5", both in seconds.
emulator::Silence parse_silence(const std::string& text);

/// For example "12.5", in seconds.
Duration parse_seconds(const std::string& text);
/// For example "0.5", in seconds; at least a millisecond.
Duration parse_interval(const std::string& text);

/// Returns the reason why a board with this firmware is not emulated; "" if it is. Later firmware
/// has commands that the emulated board does not support.
std::string problem_of(msg::FirmwareVersion version);
/// The oldest board that has all commands of a firmware; at least the one emulated by default.
msg::BoardVersion usual_board(msg::FirmwareVersion firmware);
/// For example "3.0".
msg::BoardVersion parse_board(const std::string& text);

/// "rest", "handheld", "drone", "vehicle", or the name of a file for load_motion().
emulator::Disturbance parse_motion(const std::string& text);

}  // namespace sbgc::serving
