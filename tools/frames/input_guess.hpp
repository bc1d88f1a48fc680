/// Guesses about input in which no frame was found.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

namespace sbgc::tools {

/// The number of bytes that a guess examines.
inline constexpr std::size_t guess_size = 65536;

/// Returns true if the input, which begins with these bytes, is text that represents bytes, such as
/// hex text.
bool is_text_of_bytes(std::span<const std::uint8_t> begin);

/// Guesses the kind of the input from its first bytes and suggests a remedy: "this looks like JSON:
/// use sbgc encode"; "" without a guess. `is_text`: the bytes came from text.
std::string guess_input(std::span<const std::uint8_t> begin, bool is_text);

/// True if the bytes cannot be text.
bool is_binary(std::span<const std::uint8_t> bytes);

}  // namespace sbgc::tools
