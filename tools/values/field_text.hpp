/// Fields, enums and versions in words.
#pragma once

#include <string>
#include <vector>

#include <sbgc/availability.hpp>
#include <sbgc/field_type.hpp>
#include <sbgc/meta.hpp>

namespace sbgc::tools {

/// For example "firmware 2.59, board 3.0"; "" without versions.
std::string versions_text(const Availability& since);

/// The facts about a value, each a phrase: "360/16384 deg each", "-720 to 720 deg", "255: the
/// active profile", "since firmware 2.61".
std::vector<std::string> field_facts(const FieldType& field);

/// For example "i16", "u8[3]", "bytes[8]", "text[48]".
std::string type_text(const FieldType& type);

/// For example "-720 to 719.978 deg"; "" if the field has no limits of its own.
std::string range_text(const FieldType& field);

/// Names with their numbers: "MODE_NO_CONTROL 0, MODE_SPEED 1"; flags in hex.
std::string names_text(const EnumInfo& info);

}  // namespace sbgc::tools
