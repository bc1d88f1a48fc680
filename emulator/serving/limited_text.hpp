/// Text files that must not fill the memory.
#pragma once

#include <cstddef>
#include <istream>
#include <optional>
#include <string>

namespace sbgc::serving {

/// Reads to the end; nullopt if there are more than `most` bytes. Errors show in the stream.
inline std::optional<std::string> read_text(std::istream& stream, std::size_t most) {
  std::string text;
  char block[4096];
  do {
    stream.read(block, sizeof block);
    text.append(block, static_cast<std::size_t>(stream.gcount()));
    if (text.size() > most) return std::nullopt;
  } while (stream);
  return text;
}

}  // namespace sbgc::serving
