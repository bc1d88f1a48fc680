/// The terminal settings of the kernel, with an interface that is compatible with Asio, whose
/// headers include <termios.h>, which conflicts with the kernel's termios2.
#pragma once

#include <optional>
#include <string>

#include <sbgc/io/error.hpp>
#include <sbgc/io/line.hpp>

namespace sbgc::io::detail {

bool is_terminal(int fd);

/// Puts the terminal in raw mode (no echo, no flow control, 8 data bits, reads that wait for at
/// least one byte), sets the line, and verifies all settings. `name` is for messages.
Error make_raw(int fd, const LineSettings& line, const std::string& name);

/// Returns the current settings; for the master of a pseudo-terminal, those of its slave.
std::optional<LineSettings> line_of(int fd);

/// Discards bytes received but not read.
void discard_input(int fd);
/// Also discards bytes written but not sent.
void discard_both(int fd);

/// Prevents other processes from opening the terminal, or allows them to again.
void set_exclusive(int fd, bool exclusive);

}  // namespace sbgc::io::detail
