/// Fields, enums and versions in words.
#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <sbgc/availability.hpp>
#include <sbgc/enums.hpp>
#include <sbgc/field_type.hpp>
#include <sbgc/internal/parse_number.hpp>
#include <sbgc/meta.hpp>

namespace sbgc::tools {

/// For example "firmware 2.59, board 3.0"; "" without versions.
std::string versions_text(const Availability& since);

/// The facts about a value, each a phrase: "360/16384 deg each", "-720 to 720 deg", "255: the
/// active profile", "since firmware 2.61".
std::vector<std::string> field_facts(const FieldType& field);

/// For example "i16", "u8[3]", "bytes[8]", "text[48]".
std::string type_text(const FieldType& type);

/// For example "-720 to 719.978 deg"; "" if the field has no limits.
std::string range_text(const FieldType& field);

/// Returns names with their numbers: "MODE_NO_CONTROL 0, MODE_SPEED 1"; flags in hex.
std::string names_text(const EnumInfo& info);

/// For messages about an invalid version.
inline constexpr const char* firmware_example = "a firmware version, such as 2.59 or 2.43b9";

/// Parses a version such as "2.59", "2.43b9" or "2.74.5"; returns nothing for other texts.
inline std::optional<msg::FirmwareVersion> parse_firmware(std::string_view text) {
  if (text.ends_with('.') || text.ends_with('b')) return {};
  const auto take = [&](char end, std::size_t least, std::size_t most) -> std::optional<unsigned> {
    const std::size_t size = std::min(text.find(end), text.size());
    const auto value = detail::parse_number<unsigned>(text.substr(0, size));
    text.remove_prefix(std::min(size + 1, text.size()));
    return size >= least && size <= most ? value : std::nullopt;
  };
  const auto major = take('.', 1, 2);
  // Since 2.73, another point precedes the last number.
  const auto minor = take(text.find('b') == std::string_view::npos ? '.' : 'b', 2, 2);
  const auto last = text.empty() ? 0U : take('\0', 1, 1);
  msg::FirmwareVersion version;
  const bool fits = major && minor && last && version.set_major(*major) &&
                    version.set_minor(*minor) && version.set_beta(*last);
  return fits ? std::optional(version) : std::nullopt;
}

/// Returns the reason why a text is not a firmware version; "" if it is one.
inline std::string firmware_problem(const std::string& text) {
  return parse_firmware(text) ? "" : '\'' + text + "' is not " + firmware_example;
}

}  // namespace sbgc::tools
