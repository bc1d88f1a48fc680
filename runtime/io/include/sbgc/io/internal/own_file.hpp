/// Files that users name: an error about a file of another program names its type.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include <sbgc/result.hpp>

namespace sbgc::detail {

/// Reads a text file of at most `most` bytes: without a byte order mark, lines end with '\n' alone.
/// Also fails with ErrorCode::bad_file if the content is of a foreign kind or has a NUL byte.
Result<std::string> read_text_file(const std::filesystem::path& file, std::size_t most);

}  // namespace sbgc::detail
