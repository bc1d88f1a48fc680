/// What an operation on untrusted bytes or values reports: a code, and where.
#pragma once

#include <cstddef>
#include <cstdint>

namespace sbgc {

/// Every way in which framing, decoding or encoding can end.
enum class Code : std::uint8_t {
  ok,
  too_short,           ///< the body ends before a field
  too_long,            ///< the body is longer than the message, or a frame, allows
  unknown_command,     ///< no command has this id in this direction
  unknown_form,        ///< the command has no form with a body of this size
  buffer_too_small,    ///< the output does not fit into the space given
  count_mismatch,      ///< a counting field and the number of elements disagree
  value_out_of_range,  ///< a value does not fit into its place on the wire
  presence_mismatch,   ///< a conditional field is there against its condition, or missing
  text_too_long,       ///< a text does not fit into its field
  invalid_id,          ///< no command has the id 0
};

/// The name of a code as it stands in JSON, e.g. "too_short".
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

/// A sentence about a code for a person.
constexpr const char* text(Code code) noexcept {
  switch (code) {
    case Code::ok: return "Everything is in order.";
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

/// How an operation ended; true in a condition when all went well.
struct Status {
  Code code{};             ///< what went wrong, or Code::ok
  std::uint16_t offset{};  ///< the byte of the body it concerns
  const char* field = "";  ///< the path of the field it concerns, "" when none; never null

  constexpr explicit operator bool() const noexcept { return code == Code::ok; }
};

/// What writing into a buffer reports: the bytes written (0 on failure) and how it ended.
struct WriteResult {
  std::size_t size{};
  Status status{};

  constexpr explicit operator bool() const noexcept { return static_cast<bool>(status); }
};

}  // namespace sbgc
