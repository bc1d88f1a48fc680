/// Values of messages in their units, for tables and JSON.
#pragma once

#include <optional>
#include <string>

#include <sbgc/json_dom.hpp>
#include <sbgc/text/leaves.hpp>

namespace sbgc::tools {

/// Returns the value in its unit; nothing if it is a sentinel or not a number.
std::optional<double> real_value(const Leaf& leaf);

/// Returns the number in its unit as text, independent of the locale; "" if there is none.
std::string real_text(const Leaf& leaf);

/// Returns the cell of a CSV table: a number in its unit, a quoted text, hex bytes, or "".
std::string csv_cell(const Leaf& leaf);
/// Quotes a text for CSV if necessary. Characters that are unsafe on a terminal become escapes,
/// such as \x1b for an ASCII control or a stray byte, or \u009b for a character of several bytes.
std::string csv_text(std::string_view text);

/// Returns {"raw": …} with "real" and "unit" for a quantity, and "text" for a named value.
Json leaf_json(const Leaf& leaf);

}  // namespace sbgc::tools
