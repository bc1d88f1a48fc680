/// Files that are there as a whole or not at all.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include <sbgc/client/backup.hpp>
#include <sbgc/client/result.hpp>

namespace sbgc::detail {

/// What a symbolic link leads to, also if nothing is there; other names as they are.
std::filesystem::path target_of(std::filesystem::path file);

/// Writes a file beside its place, brings it to the disk and moves it there in one step. What is
/// replaced is the target of a symbolic link, not the link; the new file has the mode of the old
/// one and, if that is allowed, its owner and group.
Result<void> write_file_atomically(const std::filesystem::path& name, std::string_view content,
                                   Existing existing);

/// Removes the files beside `file` that write_file_atomically() has left there when it was killed;
/// not those of one that is at work, nor anybody else's. What can not be removed stays.
void remove_leftovers(const std::filesystem::path& file);

/// The content of a file of at most `most` bytes.
Result<std::string> read_whole_file(const std::filesystem::path& file, std::size_t most);

}  // namespace sbgc::detail
