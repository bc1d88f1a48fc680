/// The terminal settings of the kernel, behind an interface that Asio's headers can stand: theirs
/// include <termios.h>, which can not be had together with the kernel's termios2.
#pragma once

#include <optional>
#include <string>

#include <sbgc/io/error.hpp>
#include <sbgc/io/line.hpp>

namespace sbgc::io::detail {

bool is_terminal(int fd);

/// Makes the terminal transparent for bytes (raw, no echo, no flow control, 8 data bits, reads that
/// wait for at least one byte), sets the line, and reads everything back. `name` is for messages.
Error make_raw(int fd, const LineSettings& line, const std::string& name);

/// The settings in force; of a pseudo-terminal's master: those of its slave.
std::optional<LineSettings> line_of(int fd);

/// Discards what has been received but not read, and what was written but not sent.
void discard_input(int fd);
void discard_both(int fd);

/// Locks the terminal against opening by others, or not any more.
void set_exclusive(int fd, bool exclusive);

}  // namespace sbgc::io::detail
