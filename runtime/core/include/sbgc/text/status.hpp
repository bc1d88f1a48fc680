/// Human-readable text of statuses. Requires a hosted standard library.
#pragma once

#include <string>

#include <sbgc/printable.hpp>
#include <sbgc/status.hpp>

namespace sbgc {

template <>
inline constexpr bool is_printable<Code> = true;
template <>
inline constexpr bool is_printable<Status> = true;

/// Returns the name of the code.
inline std::string to_string(Code code) { return name(code); }

/// Formats a status without a final period: "note_length: The value does not fit into the field".
inline std::string to_string(const Status& status) {
  std::string sentence = text(status.code);
  sentence.pop_back();
  return *status.field == '\0' ? sentence : std::string(status.field) + ": " + sentence;
}

}  // namespace sbgc
