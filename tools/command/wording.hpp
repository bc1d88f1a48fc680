/// Wording of messages.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace sbgc::tools {

/// For example "1 byte" or "2 bytes".
std::string counted(std::uint64_t number, const char* thing);

/// Returns a message that quotes its input on one line, without control characters, and truncated
/// if it is long.
std::string clipped(std::string_view message);

/// Returns a text in which '?' stands for each control character but the line break, and for each
/// byte that is not UTF-8, so that what a file or a device says cannot control the terminal.
std::string printable(const std::string& text);

/// Returns the sentence without a period at its end, as part of a longer message.
std::string without_period(std::string sentence);

/// Returns the sentence as messages of the command are written, behind "sbgc: ": in lower case and
/// without the final period. A name at its beginning stays as it is.
std::string as_message(std::string sentence);

}  // namespace sbgc::tools
