/// The path of a value in a message.
#pragma once

#include <cstddef>

namespace sbgc {

/// A path in a message: a chain of members and indices from the innermost to the outermost, kept on
/// the stack.
struct FieldPath {
  const FieldPath* parent{};  ///< the field that contains this one; null for a field of the message
  const char* name = "";      ///< of a member, or of an axis
  std::size_t index{};        ///< of an element, if `name` is ""

  /// Writes the path, such as "params[3].param_id", with a final NUL; truncates it if it does not
  /// fit. Returns the length without the NUL.
  constexpr std::size_t write(char* out, std::size_t space) const noexcept {
    std::size_t length = parent != nullptr ? parent->write(out, space) : 0;
    const auto add = [&](char c) {
      if (length + 1 < space) out[length++] = c;
    };
    if (*name != '\0') {
      if (length != 0) add('.');
      for (const char* c = name; *c != '\0'; ++c) add(*c);
    } else {
      add('[');
      std::size_t unit = 1;
      while (index / unit >= 10) unit *= 10;
      for (; unit != 0; unit /= 10) add(static_cast<char>('0' + index / unit % 10));
      add(']');
    }
    if (space != 0) out[length] = '\0';
    return length;
  }
};

}  // namespace sbgc
