#include "values/assignments.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <variant>

#include <fmt/format.h>

#include <sbgc/internal/parse_number.hpp>
#include <sbgc/internal/suggestions.hpp>
#include <sbgc/internal/words.hpp>
#include <sbgc/text.hpp>
#include <sbgc/value_text.hpp>

#include "command/wording.hpp"

namespace sbgc::tools {

namespace {

/// True if other values of the message can select the unit of this one.
bool is_in_unit(const FieldType& type) {
  const FieldType& element = type.innermost();
  const bool is_variable = element.info != nullptr && element.info->is_variable_value;
  return is_variable || element.unit != nullptr;
}

/// Throws ValueError if a value is for an element of a list beyond its end, and an earlier element
/// neither exists nor has a value: it would be sent with unintended zeros.
void reject_gaps(const AnyMessage& message, const std::vector<FieldValue>& values) {
  for (const FieldValue& value : values) {
    FieldSteps steps;
    for (const PathStep& step : value.field.steps) {
      const auto* const index = std::get_if<std::size_t>(&step);
      for (std::size_t i = 0; index != nullptr && i < *index; ++i) {
        FieldSteps element = steps;
        element.emplace_back(i);
        const bool has_value = std::ranges::any_of(values, [&](const FieldValue& other) {
          const FieldSteps& others = other.field.steps;
          return others.size() >= element.size() &&
                 std::equal(element.begin(), element.end(), others.begin());
        });
        if (has_value || message.has(steps_text(element))) continue;
        throw ValueError(fmt::format("{} has no value, but {} has one; elements count from 0",
                                     steps_text(element), steps_text(value.field.steps)));
      }
      steps.push_back(step);
    }
  }
}

/// Parses the number in "10%", "+10 %" or "-10%".
std::optional<double> percentage(std::string_view text) {
  if (!text.ends_with('%')) return std::nullopt;
  text.remove_suffix(1);
  if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
  const auto number = detail::parse_number<double>(detail::trimmed(text));
  return number && std::isfinite(*number) ? number : std::nullopt;
}

/// Parses an amount in the unit of a number. It may lie outside the range of the number.
double amount(const PresentNumber& present, const std::string& text) {
  constexpr std::int64_t most = std::int64_t{1} << 53;  // exact in a double
  const FieldType type{.shape = present.is_integer ? FieldShape::integer : FieldShape::real,
                       .lowest = -most,
                       .highest = most};
  const ParsedValue parsed = parse_value(type, &present.unit, text);
  if (!parsed) throw ValueError(parsed.problem);
  const auto* const raw = std::get_if<std::int64_t>(&parsed.value);
  return present.unit.real(raw != nullptr ? static_cast<double>(*raw)
                                          : std::get<double>(parsed.value));
}

}  // namespace

Assignment parse_assignment(std::string_view text) {
  const std::size_t sign = text.find('=');
  const bool has_name = sign != std::string_view::npos && sign != 0;
  const Change change = !has_name               ? Change::set
                        : text[sign - 1] == '+' ? Change::add
                        : text[sign - 1] == '-' ? Change::subtract
                                                : Change::set;
  const std::size_t end = change == Change::set ? sign : sign - 1;
  if (!has_name || end == 0) {
    throw ValueError(fmt::format("'{}' is not NAME=VALUE", clipped(text)));
  }
  const std::string_view name = detail::trimmed(text.substr(0, end));
  const std::string_view value = text.substr(sign + 1);
  // In "name = value", the blanks belong to neither.
  const bool is_spaced = text[end - 1] == ' ';
  Assignment result{std::string(name), std::string(is_spaced ? detail::trimmed(value) : value),
                    change};
  const bool has_sign = result.value.starts_with('+') || result.value.starts_with('-');
  if (change == Change::set && has_sign && percentage(result.value)) result.change = Change::add;
  return result;
}

std::vector<Assignment> parse_assignments(const std::vector<std::string>& texts) {
  std::vector<Assignment> result;
  result.reserve(texts.size());
  for (const std::string& text : texts) result.push_back(parse_assignment(text));
  return result;
}

std::vector<FieldValue> values_for(const std::vector<FoundField>& fields,
                                   const Assignment& assignment) {
  const std::string& text = assignment.value;
  const FieldType& type = *fields.front().type;
  const bool is_one_number = type.is_number() && type.names == nullptr && type.packed == nullptr;
  const auto commas = static_cast<std::size_t>(std::ranges::count(text, ','));
  const bool is_split = fields.size() > 1 && is_one_number && commas + 1 == fields.size();
  std::vector<FieldValue> result;
  std::size_t at = 0;
  for (const FoundField& field : fields) {
    const std::size_t end = is_split ? std::min(text.find(',', at), text.size()) : text.size();
    result.push_back({field, text.substr(at, end - at), assignment.change});
    if (is_split) at = end + 1;
  }
  return result;
}

std::string changed_value(const PresentNumber& present, Change change, const std::string& text) {
  const UnitInfo& unit = present.unit;
  const int sign = change == Change::subtract ? -1 : 1;
  const auto share = percentage(detail::trimmed(text));
  if (share && std::string_view(unit.name) == "%") {
    throw ValueError(
        fmt::format("its unit is %, so a change by {} has two meanings; write the new value, or += "
                    "and a number",
                    text));
  }
  const double change_by = share ? present.value * *share / 100 : amount(present, text);
  double after = present.value + sign * change_by;
  if (present.is_integer) {
    const double raw = std::round(unit.raw(after));
    if (change_by != 0 && raw == std::round(unit.raw(present.value))) {
      throw ValueError(fmt::format("a change by {} is less than its smallest step", text));
    }
    after = unit.real(raw);
    if (raw < present.lowest || raw > present.highest) {
      throw ValueError(fmt::format("{} would become {}, which does not fit: {} to {}",
                                   detail::unit_text(present.value, unit),
                                   detail::unit_text(after, unit),
                                   detail::unit_text(unit.real(present.lowest), unit),
                                   detail::unit_text(unit.real(present.highest), unit)));
    }
  }
  return fmt::format("{:.10g} {}", after, unit.name);
}

FieldValue changed_value(const AnyMessage& present, const FieldValue& value,
                         const Availability& versions) {
  const std::string path = steps_text(value.field.steps);
  std::string problem = "only numbers can be changed by an amount";
  FieldValue result{value.field};
  present.with_leaf(
      path,
      [&](const Leaf& leaf) {
        const bool is_integer = leaf.kind == LeafKind::integer;
        if (!is_integer && leaf.kind != LeafKind::real) return;
        if (leaf.names != nullptr || leaf.packed != nullptr) return;
        const UnitInfo unit = leaf.unit == nullptr ? UnitInfo() : *leaf.unit;
        const FieldType& type = value.field.type->innermost();
        const PresentNumber number{unit.real(leaf.number()), unit, is_integer,
                                   static_cast<double>(type.lowest),
                                   static_cast<double>(type.highest)};
        try {
          result.text = changed_value(number, value.change, value.text);
          problem.clear();
        } catch (const ValueError& error) {
          problem = error.what();
        }
      },
      versions);
  if (!problem.empty()) throw ValueError(path + ": " + problem);
  return result;
}

void add_value(std::vector<FieldValue>& values, FieldValue value) {
  const bool is_again = std::ranges::any_of(
      values, [&](const FieldValue& other) { return other.field.steps == value.field.steps; });
  if (is_again) throw ValueError(fmt::format("{} is set twice", steps_text(value.field.steps)));
  values.push_back(std::move(value));
}

std::vector<FieldValue> find_values(const MessageType& type,
                                    const std::vector<Assignment>& assignments) {
  std::vector<FieldValue> result;
  for (const Assignment& assignment : assignments) {
    if (assignment.change != Change::set) {
      throw ValueError(fmt::format("{}: a request has no present value to change; write {}=VALUE",
                                   clipped(assignment.name), clipped(assignment.name)));
    }
    const std::vector<FoundField> found = find_fields(type.fields(), assignment.name);
    if (found.empty()) {
      const FieldSource source{type.info->name, &type.fields()};
      const std::string name(type.info->name);
      throw ValueError(
          fmt::format("{} has no field '{}'{}", name, clipped(assignment.name),
                      detail::did_you_mean(similar_fields({source}, assignment.name),
                                           "`sbgc describe " + name + "` lists them")));
    }
    for (FieldValue& value : values_for(found, assignment)) {
      if (value.field.type->is_counter) {
        throw ValueError(
            fmt::format("{} follows from the number of elements", steps_text(value.field.steps)));
      }
      add_value(result, std::move(value));
    }
  }
  return result;
}

void set_values(AnyMessage& message, const std::vector<FieldValue>& values,
                const Availability& versions) {
  reject_gaps(message, values);
  for (const bool in_unit : {false, true}) {  // last the values whose unit others select
    for (const FieldValue& value : values) {
      if (is_in_unit(*value.field.type) != in_unit) continue;
      const std::string problem =
          message.assign(steps_text(value.field.steps), value.text, false, versions);
      if (!problem.empty()) throw ValueError(problem);
    }
  }
}

void assign(AnyMessage& message, const std::vector<Assignment>& assignments,
            const Availability& versions) {
  set_values(message, find_values(message.type(), assignments), versions);
}

void check_ranges(const AnyMessage& message, const std::vector<FieldValue>& values) {
  std::string problem;
  message.validate(newest, [&](const Violation& violation) {
    const bool is_range = violation.rule == Rule::minimum || violation.rule == Rule::maximum;
    if (!is_range || violation.other != nullptr || !problem.empty()) return;
    const std::string path = to_string(violation.path);
    const bool is_one = std::ranges::any_of(
        values, [&](const FieldValue& value) { return steps_text(value.field.steps) == path; });
    if (is_one) problem = to_string(violation);
  });
  if (!problem.empty()) throw ValueError(problem);
}

}  // namespace sbgc::tools
