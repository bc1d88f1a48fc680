/// Values of fields as people write them, for AnyMessage::assign().
///
///     20, 0x1F, -3             a number as the tool shows it: in the unit of the field, if it has
///     one -30deg, 12.6V, 5 deg/s   the same with its unit, which must be that of the field
///     raw:-1365                the number on the wire
///     MODE_ANGLE, angle        the name of a value, also without what all names begin with
///     FLAG_A|FLAG_B, 0x40      flags, also with commas; a packed value, part by part: mode:2
///     00ff12                   bytes in hex, also with spaces
///     600,700                  the elements of a list, or a value for each axis
///
/// A number without a unit means what to_string() and value_text() show for the field, since that
/// is what people read and copy. Only JSON holds numbers of the wire.
///
/// If the steps of a field are one unit or more, only exact values are accepted: 20.5 is an error
/// for a counter, 50.5Hz for steps of 1 Hz. Finer steps are odd fractions, such as 360/16384 deg,
/// so a number for them is rounded to the nearest step.
#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include <sbgc/field_type.hpp>
#include <sbgc/meta/units.hpp>
#include <sbgc/number.hpp>

namespace sbgc {

/// The value of a field: an integer of the wire, a real number, bytes, a text (any bytes), or a
/// number with its type.
using AnyValue = std::variant<std::int64_t, double, std::vector<std::uint8_t>, std::string, Number>;

/// A value, or the reason why the text is invalid.
struct ParsedValue {
  AnyValue value{};       ///< the value, if there is no problem
  std::string problem{};  ///< a sentence about the text; "" if it is valid

  /// True if the text is a value.
  explicit operator bool() const noexcept { return problem.empty(); }
};

/// Parses the value of a field that is not a group, axes or a list. `unit` is the one in effect,
/// which a flag may select; null if the field has none. `present` holds the present bits of the
/// field: parts of a packed value that `text` does not name stay unchanged. Whether the
/// specification allows the value is checked by validate(), not here.
ParsedValue parse_value(const FieldType& type, const UnitInfo* unit, std::string_view text,
                        std::uint64_t present = 0);

/// The same for a quantity outside a message, such as msg::ControlSpeed: an integer.
template <class Q>
ParsedValue parse_quantity(std::string_view text) {
  using Limits = std::numeric_limits<typename Q::raw_type>;
  const FieldType type{
      .shape = FieldShape::integer, .lowest = Limits::lowest(), .highest = Limits::max()};
  return parse_value(type, &UnitMeta<Q>::info, text);
}

/// Splits a text at its commas and trims spaces; returns no parts for an empty text.
std::vector<std::string_view> parse_elements(std::string_view text);

}  // namespace sbgc
