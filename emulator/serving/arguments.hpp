/// The arguments of `sbgc emulate`. All functions throw std::invalid_argument with a sentence that
/// says what is wrong and what is expected.
#pragma once

#include <string>

#include <sbgc/emulator/disturbance.hpp>
#include <sbgc/emulator/line.hpp>
#include <sbgc/enums.hpp>

#include "serving/endpoint.hpp"

namespace sbgc::serving {

/// "5000", "0.0.0.0:5000", "[::1]:5000", "localhost:0"; no other names.
ListenAddress parse_listen(const std::string& text);

/// "0.01" or "1%".
double parse_share(const std::string& text);

/// "0.01" or "0.01:50", the time in milliseconds.
struct DelayFault {
  double share{};
  Duration delay = emulator::Faults{}.delay;
};
DelayFault parse_delay(const std::string& text);

/// "10:2.5", both in seconds.
emulator::Silence parse_silence(const std::string& text);

/// "12.5", in seconds.
Duration parse_seconds(const std::string& text);
/// "0.5", in seconds: an interval, at least a millisecond.
Duration parse_interval(const std::string& text);

/// "2.43b9".
msg::FirmwareVersion parse_firmware(const std::string& text);
/// Why a board with this firmware is not emulated; "" if it is. Later firmware has commands that
/// the emulated board does not know.
std::string problem_of(msg::FirmwareVersion version);
/// "3.0".
msg::BoardVersion parse_board(const std::string& text);

/// "rest", "handheld", "drone", "vehicle", or a file as read_motion() reads it.
emulator::Disturbance parse_motion(const std::string& text);

}  // namespace sbgc::serving
