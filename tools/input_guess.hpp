/// Guesses what input is in which no frame was found.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

namespace sbgc::tools {

/// The number of bytes that a guess looks at.
inline constexpr std::size_t guess_size = 65536;

/// What the input may be, judging by its first bytes, and what to do about it: "this looks like hex
/// text: use --hex"; "" without a guess. `is_hex`: the bytes were written as hex text.
std::string guess_input(std::span<const std::uint8_t> begin, bool is_hex);

/// Whether the bytes cannot be text.
bool is_binary(std::span<const std::uint8_t> bytes);

}  // namespace sbgc::tools
