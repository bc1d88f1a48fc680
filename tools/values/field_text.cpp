#include "values/field_text.hpp"

#include <bit>

#include <fmt/format.h>

#include <sbgc/axis_directions.hpp>
#include <sbgc/text.hpp>

#include "command/wording.hpp"

namespace sbgc::tools {

namespace {

std::string in_unit_of(double raw, const UnitInfo* unit) {
  return detail::text_of([&](TextOutput& out) { detail::put_limit(out, raw, unit); });
}

/// Returns the physical size of one count: "0.0219727 deg each".
std::string scale_text(const UnitInfo& unit) {
  if (unit.is_plain()) return "";
  const double step = unit.numerator / unit.denominator;
  if (unit.growth != 0) {
    return fmt::format("{:g} * {:g}^raw, from {}", step, unit.growth,
                       detail::unit_text(unit.offset, unit));
  }
  std::string result = detail::unit_text(step, unit) + " each";
  if (step == 1) result = *unit.name == '\0' ? "" : unit.name;
  if (unit.offset != 0) {
    result += fmt::format(", from {}", detail::unit_text(unit.offset, unit));
  }
  return result;
}

std::string part_bits(const PartInfo& part) {
  const int low = std::countr_zero(part.mask);
  const int high = 63 - std::countl_zero(part.mask);
  return low == high ? fmt::format("bit {}", low) : fmt::format("bits {} to {}", low, high);
}

/// Returns the sign convention: "positive: pitch down, yaw right, roll unknown".
std::string positive_text(const FieldType& type) {
  const auto word = [](const AxisDirection& direction) {
    return *direction.positive == '\0' ? "unknown" : direction.positive;
  };
  switch (type.info->directed) {
    case Directed::no: return "";
    case Directed::unknown: break;
    case Directed::roll: return fmt::format("positive: {}", word(axis_directions.roll));
    case Directed::pitch: return fmt::format("positive: {}", word(axis_directions.pitch));
    case Directed::yaw: return fmt::format("positive: {}", word(axis_directions.yaw));
    case Directed::by_axis:
      if (!type.is_of_axis) break;
      return fmt::format("positive: pitch {}, yaw {}, roll {}", word(axis_directions.pitch),
                         word(axis_directions.yaw), word(axis_directions.roll));
  }
  return fmt::format("positive: {}", word({}));
}

constexpr std::size_t most_names = 16;

std::string names_or_reference(const EnumInfo& info) {
  if (info.values.size() <= most_names) return names_text(info);
  return fmt::format("{} names, see `sbgc describe {}`", info.values.size(), info.name);
}

/// Returns a field's later meaning: "from firmware 2.73.1 on: 5 * 1.01562^raw, from -5".
std::string later_text(const FieldType& type, const LaterMeaning& later) {
  const std::string since = versions_text(later.since);
  const FieldInfo info{.range = later.range != nullptr ? later.range : type.info->range};
  const FieldType meant{.info = &info, .shape = type.shape, .unit = later.unit};
  std::string what = later.unit != nullptr ? scale_text(*later.unit) : "";
  if (later.names != nullptr) what = names_or_reference(*later.names);
  if (later.packed != nullptr) what = later.packed->name;
  const auto add = [&](const std::string& fact) {
    if (!fact.empty()) what += (what.empty() ? "" : "; ") + fact;
  };
  add(range_text(meant));
  if (std::string_view(later.summary) != type.info->summary) add(later.summary);
  return fmt::format("from {} on: {}", since, what.empty() ? "a plain number" : what);
}

}  // namespace

std::string versions_text(const Availability& since) {
  std::string result;
  if (since.firmware != 0) result = "firmware " + to_string(msg::FirmwareVersion(since.firmware));
  if (since.board != 0) {
    result += (result.empty() ? "board " : ", board ") + to_string(msg::BoardVersion(since.board));
  }
  if (since.features != 0) {
    result += (result.empty() ? "feature " : ", feature ") + feature_names(since.features);
  }
  return result;
}

std::string names_text(const EnumInfo& info) {
  std::string result;
  for (const ValueInfo& value : info.values) {
    result += result.empty() ? "" : ", ";
    result += info.is_flags ? fmt::format("{} {:#x}", value.name, value.value)
                            : fmt::format("{} {}", value.name, value.value);
  }
  return result;
}

std::string type_text(const FieldType& type) {
  switch (type.shape) {
    case FieldShape::group: return "";
    case FieldShape::axes: return type_text(type.members.front());
    case FieldShape::list:
      return fmt::format("{}[{}]", type_text(type.members.front()),
                         type.has_count ? std::to_string(type.count) : "");
    case FieldShape::integer:
    case FieldShape::real: return type.type;
    case FieldShape::bytes:
      return type.has_count ? fmt::format("bytes[{}]", type.count) : std::string("bytes");
    case FieldShape::text:
      return type.has_count ? fmt::format("text[{}]", type.count) : std::string("string");
    case FieldShape::announced: return "number";
  }
  return "";
}

std::string range_text(const FieldType& field) {
  const FieldType& type = field.innermost();
  if (type.info == nullptr || type.info->range == nullptr) return "";
  const Range& range = *type.info->range;
  const UnitInfo* const unit = type.unit;
  const std::string high = in_unit_of(range.highest, unit);
  if (unit == nullptr || *unit->name == '\0') {
    return fmt::format("{} to {}", in_unit_of(range.lowest, unit), high);
  }
  const double lowest = unit->real(range.lowest);
  return fmt::format("{} to {}",
                     detail::text_of([&](TextOutput& out) { detail::put_general(out, lowest); }),
                     high);
}

std::vector<std::string> field_facts(const FieldType& field) {
  const FieldType& type = field.innermost();
  std::vector<std::string> facts;
  const auto add = [&](const std::string& fact) {
    if (!fact.empty()) facts.push_back(fact);
  };
  if (type.unit != nullptr) add(scale_text(*type.unit));
  add(range_text(type));
  if (type.info != nullptr) {
    add(positive_text(type));
    for (const Special& special : type.info->special) {
      add(fmt::format("{}: {}", special.value, special.meaning));
    }
    const AlternativeUnit* const other = type.info->alternative;
    if (other != nullptr) {
      add(fmt::format("with {:#x} in {}: {}", other->mask, other->of, scale_text(*other->unit)));
    }
    for (const LaterMeaning& later : type.info->later) add(later_text(type, later));
    if (type.info->is_variable_value) add("in the unit of the variable");
    if (type.info->align != 1) add(fmt::format("a multiple of {}", type.info->align));
    if (type.info->role == FieldRole::general) add("general: the same in all profiles");
    if (type.info->role == FieldRole::state) add("reports a state, is not a parameter");
  }
  if (field.shape == FieldShape::list && !field.has_count) {
    const std::size_t least = field.info == nullptr ? 0 : field.info->min_count;
    const std::size_t most =
        field.info != nullptr && field.info->max_count != 0 ? field.info->max_count : field.count;
    add(fmt::format("{} to {}", least, counted(most, "element")));
  }
  if (type.names != nullptr) {
    add(std::string(type.names->is_flags ? "flags " : "") + names_or_reference(*type.names));
  }
  if (type.packed != nullptr) {
    if (type.packed->names != nullptr) add(names_or_reference(*type.packed->names));
    for (const PartInfo& part : type.packed->parts) {
      const std::string names = part.values == nullptr ? "" : names_or_reference(*part.values);
      add(fmt::format("{} ({}){}{}", part.name, part_bits(part), names.empty() ? "" : ": ", names));
    }
  }
  if (type.info != nullptr) {
    const std::string since = versions_text(type.info->since);
    if (!since.empty()) add("since " + since);
    if (type.info->unconfirmed) add("unconfirmed");
  }
  return facts;
}

}  // namespace sbgc::tools
