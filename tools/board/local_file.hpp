/// Local files, the sources and destinations of memory transfers.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace sbgc::tools {

/// Throws CommandError if the file exists and must not be replaced, or is "-".
void check_replaceable(const std::string& file, bool force);

/// Throws CommandError if it is foreseeable that write_local_file() will fail.
void check_writable(const std::string& file, bool force);

/// Writes a file atomically. Throws CommandError.
void write_local_file(const std::string& file, const std::vector<std::uint8_t>& data, bool force);

/// Reads a file of 1 to `most` bytes. Throws CommandError.
std::vector<std::uint8_t> read_local_file(const std::string& file, std::size_t most);

}  // namespace sbgc::tools
