/// Violations, which validate() reports.
#pragma once

#include <cstdint>

#include <sbgc/field_path.hpp>
#include <sbgc/meta.hpp>

namespace sbgc {

/// The rule that a value violates.
enum class Rule : std::uint8_t {
  minimum,    ///< below `limit`
  maximum,    ///< above `limit`
  alignment,  ///< not a multiple of `limit`
  count,      ///< fewer or more than `limit` elements
  order,      ///< above the field `other`, which is `limit`, or equal to it
  firmware,   ///< exists only since firmware version `limit`, such as 2590
  board,      ///< exists only since board version `limit`, such as 30
  feature,    ///< exists only on boards with the feature whose mask is `limit`
};

/// Returns the name of a rule, e.g. "minimum".
constexpr const char* name(Rule rule) noexcept {
  switch (rule) {
    case Rule::minimum: return "minimum";
    case Rule::maximum: return "maximum";
    case Rule::alignment: return "alignment";
    case Rule::count: return "count";
    case Rule::order: return "order";
    case Rule::firmware: return "firmware";
    case Rule::board: return "board";
    case Rule::feature: return "feature";
  }
  return "unknown_rule";
}

/// A value that the specification does not allow. `path` is valid only during the report.
/// to_string() of <sbgc/text.hpp> formats it as a sentence.
struct Violation {
  const FieldPath& path;
  const FieldInfo& field;
  double value{};  ///< raw, as on the wire
  double limit{};  ///< the bound that it breaks, raw
  Rule rule{};
  const UnitInfo* unit{};    ///< of `value`; null if it has none or if it depends on a flag
  const ValueInfo* named{};  ///< the enum value or flag that does not exist yet, or null
  const FieldInfo* other{};  ///< the field that the value must not exceed, or null
};

}  // namespace sbgc
