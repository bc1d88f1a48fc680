/// What input may be in which no frame was found.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

namespace sbgc::tools {

/// As many bytes of the input are enough for a guess.
inline constexpr std::size_t guess_size = 65536;

/// What the input may be, judging by its first bytes, and what to do then: "this looks like hex
/// text: use --hex". "" if nothing comes to mind. `is_hex`: they are what hex text said.
std::string guess_input(std::span<const std::uint8_t> begin, bool is_hex);

/// Whether this can not be text.
bool is_binary(std::span<const std::uint8_t> bytes);

}  // namespace sbgc::tools
