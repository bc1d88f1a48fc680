/// Values as a user writes them on the command line.
///
///     20, 0x1F, -3             a number as the tool shows it: in the unit of the field, if it has
///     one -30deg, 12.6V, 5 deg/s   the same with its unit, which must be that of the field
///     raw:-1365                the number on the wire
///     MODE_ANGLE, angle        the name of a value, also without what all names begin with
///     FLAG_A|FLAG_B, 0x40      flags, also with commas; a packed value, part by part: mode:2
///     00ff12                   bytes in hex, also with spaces
///     600,700                  the elements of a list, or a value for each axis
///
/// A number without a unit means what the tool shows for the field, since that is what a user reads
/// and copies. One rule for all commands: `move --pitch -20`, `vars set`, `params set` and `send`.
/// Only JSON holds numbers of the wire.
///
/// A field whose steps are one unit or more takes only numbers that it has: 20.5 is an error for a
/// counter, 50.5Hz for steps of 1 Hz. Finer steps are odd fractions, such as 360/16384 deg, so a
/// number for them becomes the nearest step.
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

/// Returns the raw value nearest to a physical one, as described above. Throws ValueError if the
/// field cannot have it.
std::int64_t parse_quantity(const FieldType& type, const UnitInfo& unit, std::string_view text);

/// Returns the number of names: of an enum value, flags or a packed value. Throws ValueError.
std::int64_t parse_names(const FieldType& type, std::string_view text, std::uint64_t present);

}  // namespace sbgc::tools
