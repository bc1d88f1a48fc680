/// Files that are there as a whole or not at all.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include <sbgc/client/backup.hpp>
#include <sbgc/client/result.hpp>

namespace sbgc::detail {

/// Writes a file beside its place, brings it to the disk and moves it there in one step.
Result<void> write_file_atomically(const std::filesystem::path& file, std::string_view content,
                                   Existing existing);

/// The content of a file of at most `most` bytes.
Result<std::string> read_whole_file(const std::filesystem::path& file, std::size_t most);

}  // namespace sbgc::detail
