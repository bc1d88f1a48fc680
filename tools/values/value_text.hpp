/// Values as a user writes them on the command line; see <sbgc/value_text.hpp>. One rule for all
/// commands: `move --pitch -20`, `vars set`, `params set` and `send`.
#pragma once

#include <string>
#include <string_view>

#include <sbgc/field_type.hpp>
#include <sbgc/json_dom.hpp>

#include "values/field_lookup.hpp"

namespace sbgc::tools {

/// Returns the JSON of a value. `unit` is the one in effect, which a flag may select; null if the
/// field has none. `present` is the value that the field has: parts of a packed value that `text`
/// does not name stay as they are. Throws ValueError.
Json parse_value(const FieldType& type, const UnitInfo* unit, std::string_view text,
                 const Json& present);

}  // namespace sbgc::tools
