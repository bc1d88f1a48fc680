/// Files that users name: what is not one of this project's is named for what it is.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include <sbgc/result.hpp>

namespace sbgc::detail {

/// Reads a text file of at most `most` bytes: without a byte order mark, lines end with '\n' alone.
/// Fails with ErrorCode::bad_file, too, if the content is of a foreign kind or has a NUL byte.
Result<std::string> read_text_file(const std::filesystem::path& file, std::size_t most);

}  // namespace sbgc::detail
