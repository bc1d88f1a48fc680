/// The reason why JSON is rejected.
#pragma once

#include <cstddef>
#include <string>

#include <sbgc/internal/characters.hpp>

namespace sbgc {

/// The reason why JSON text is rejected.
struct JsonProblem {
  std::size_t line{};    ///< from 1
  std::size_t column{};  ///< in bytes, from 1
  std::string reason{};  ///< such as "the key 'id' occurs twice"
  std::string field{};   ///< of a message, such as "axes.roll.angle"; "" for the whole message
};

/// Formats a problem: "axes.roll.angle: an integer is needed (line 3, column 7)".
inline std::string to_string(const JsonProblem& problem) {
  return (problem.field.empty() ? "" : problem.field + ": ") + problem.reason + " (line " +
         std::to_string(problem.line) + ", column " + std::to_string(problem.column) + ")";
}

namespace detail {

/// Returns a key as shown in a message: on one line, truncated if long.
inline std::string shortened(const std::string& key) {
  constexpr std::size_t longest = 40;
  std::size_t size = key.size() < longest ? key.size() : longest;
  const auto inside_character = [&] {
    return size < key.size() && (static_cast<unsigned char>(key[size]) & 0xC0U) == 0x80U;
  };
  while (inside_character()) --size;
  return without_controls(key.substr(0, size)) + (size < key.size() ? "..." : "");
}

}  // namespace detail

}  // namespace sbgc
