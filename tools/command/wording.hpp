/// Wording of messages.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include <sbgc/internal/words.hpp>

namespace sbgc::tools {

/// For example "1 byte" or "2 bytes".
std::string counted(std::uint64_t number, const char* thing);

/// Returns a message that quotes its input on one line, as printable() does otherwise, and
/// truncated if it is long.
std::string clipped(std::string_view message);

/// Returns the text with "..." in place of its middle if it is longer than this.
std::string abridged(std::string_view text, std::size_t longest);

/// Returns a text in which '?' stands for each character but the line break that does not belong on
/// a terminal, and for each byte that is not UTF-8.
std::string printable(std::string_view text);

/// Returns the word as a command line has it, in quotes if a shell would read it otherwise.
std::string quoted_for_shell(const std::string& word);

using detail::without_period;

/// Returns the sentence as messages of the command are written, after "sbgc: ": in lower case and
/// without the final period. A name at its beginning stays as it is.
std::string as_message(std::string sentence);

}  // namespace sbgc::tools
