/// The status of an operation on untrusted bytes or values.
#pragma once

#include <cstddef>
#include <cstdint>

namespace sbgc {

/// The possible results of framing, decoding and encoding.
enum class Code : std::uint8_t {
  ok,
  too_short,           ///< the body ends before a field
  too_long,            ///< the body is longer than the message or a frame allows
  unknown_command,     ///< no command has this id in this direction
  unknown_form,        ///< the command has no form with a body of this size
  buffer_too_small,    ///< the output does not fit into the buffer
  count_mismatch,      ///< a count field and the number of elements disagree
  value_out_of_range,  ///< a value does not fit into its field
  presence_mismatch,   ///< a conditional field is present or missing contrary to its condition
  text_too_long,       ///< a text does not fit into its field
  invalid_id,          ///< no command has the id 0
};

/// Returns the name of a code as used in JSON, e.g. "too_short".
constexpr const char* name(Code code) noexcept {
  switch (code) {
    case Code::ok: return "ok";
    case Code::too_short: return "too_short";
    case Code::too_long: return "too_long";
    case Code::unknown_command: return "unknown_command";
    case Code::unknown_form: return "unknown_form";
    case Code::buffer_too_small: return "buffer_too_small";
    case Code::count_mismatch: return "count_mismatch";
    case Code::value_out_of_range: return "value_out_of_range";
    case Code::presence_mismatch: return "presence_mismatch";
    case Code::text_too_long: return "text_too_long";
    case Code::invalid_id: return "invalid_id";
  }
  return "unknown_code";
}

/// Returns a sentence that describes a code.
constexpr const char* text(Code code) noexcept {
  switch (code) {
    case Code::ok: return "No error.";
    case Code::too_short: return "The body ends before this field does.";
    case Code::too_long: return "The body is longer than allowed.";
    case Code::unknown_command: return "No known command has this id in this direction.";
    case Code::unknown_form: return "The command has no form with a body of this size.";
    case Code::buffer_too_small: return "The output does not fit into the buffer.";
    case Code::count_mismatch: return "The number of elements differs from the announced count.";
    case Code::value_out_of_range: return "The value does not fit into the field.";
    case Code::presence_mismatch:
      return "A conditional field is present although its condition is false, or the reverse.";
    case Code::text_too_long: return "The text is longer than its field.";
    case Code::invalid_id: return "The command id 0 does not exist.";
  }
  return "The status code is unknown.";
}

/// The status of an operation; true in a condition if the operation succeeded.
struct Status {
  Code code{};             ///< the error, or Code::ok
  std::uint16_t offset{};  ///< the offset of the error in the body
  const char* field = "";  ///< the path of the field in error, or ""; never null

  /// True without an error.
  constexpr explicit operator bool() const noexcept { return code == Code::ok; }
};

/// The result of writing into a buffer: the number of bytes written (0 on failure) and the status.
struct WriteResult {
  std::size_t size{};  ///< written bytes; 0 after an error
  Status status{};

  /// True without an error.
  constexpr explicit operator bool() const noexcept { return static_cast<bool>(status); }
};

}  // namespace sbgc
