/// The functions of the operating system that the command needs besides the C++ library.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <span>

namespace sbgc::tools {

/// Prepares the standard files for bytes of the protocol. main() calls it first.
void prepare_standard_files();

/// Reads the available bytes, of which there may be fewer than `into` has room for. Returns their
/// number: 0 at the end, or -1 for an error in errno.
std::ptrdiff_t read_available(std::FILE* file, std::span<std::uint8_t> into);

/// True if `file` is a terminal.
bool is_terminal(std::FILE* file);

/// The key that ends what people type.
extern const char* const end_of_input;

/// The width of the terminal of standard output or standard error; 0 if it is none.
std::size_t width_of_terminal(std::FILE* file);

}  // namespace sbgc::tools
