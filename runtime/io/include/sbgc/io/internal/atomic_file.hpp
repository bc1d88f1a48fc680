/// Atomic file replacement.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include <sbgc/io/existing.hpp>
#include <sbgc/result.hpp>

namespace sbgc::detail {

/// Returns the target of a symbolic link, even if the target does not exist. Returns other paths
/// unchanged.
std::filesystem::path target_of(std::filesystem::path file);

/// True if the open file is regular and still has this path.
bool is_at(int descriptor, const std::filesystem::path& path);

/// Writes to a temporary file in the same directory, flushes it to disk and renames it. If `name`
/// is a symbolic link, its target is replaced. The new file keeps the mode of the old one and, if
/// permitted, its owner and group. A killed call leaves the old file and perhaps its temporary one,
/// NAME.<number>-<number>.sbgc-tmp, which the next call for any file of the directory removes.
Result<void> write_file_atomically(const std::filesystem::path& name, std::string_view content,
                                   Existing existing);

/// Removes temporary files that killed calls of write_file_atomically() left in a directory. Keeps
/// those of running calls and unrelated files. Ignores files that it cannot remove.
void remove_leftovers(const std::filesystem::path& folder);

/// Reads a file of at most `most` bytes.
Result<std::string> read_whole_file(const std::filesystem::path& file, std::size_t most);

}  // namespace sbgc::detail
