#include "values/axis_values.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <variant>
#include <vector>

#include <fmt/format.h>

#include <sbgc/axis_directions.hpp>
#include <sbgc/internal/parse_number.hpp>
#include <sbgc/internal/suggestions.hpp>
#include <sbgc/internal/words.hpp>
#include <sbgc/value_text.hpp>

#include "command/command_error.hpp"
#include "values/search_words.hpp"

namespace sbgc::tools {

namespace {

template <class Q>
Q to_quantity(const std::string& text, std::string_view option) {
  const ParsedValue parsed = parse_quantity<Q>(text);
  if (!parsed) throw CommandError(fmt::format("{}: {}", option, parsed.problem), wrong_usage);
  return Q(static_cast<typename Q::raw_type>(std::get<std::int64_t>(parsed.value)));
}

/// For example "positive is down".
std::string direction_text(const AxisDirection& direction) {
  if (*direction.positive == '\0') return "it is not known which way is positive";
  return fmt::format("positive is {}", direction.positive);
}

/// Returns the number before a unit, which may be missing: 30 for "30 deg", "30°" and "30". Returns
/// other texts unchanged.
std::string without_unit(std::string_view text, std::string_view unit) {
  const std::size_t size = text.find_last_of("0123456789.") + 1;
  const std::string_view rest = detail::trimmed(text.substr(size));
  return std::string(rest.empty() || means_same(rest, unit) ? text.substr(0, size) : text);
}

/// For example "30down or 30up".
std::string examples_of(const AxisDirection& ways) {
  return fmt::format("30{} or 30{}", ways.positive, ways.negative);
}

/// Parses "30down", "30 deg down" or 0 into a number.
CLI::Validator number_with_direction(const std::string& unit, const AxisDirection& ways) {
  const auto take = [unit, ways](std::string& text) -> std::string {
    const std::string lower = detail::lower_case(text);
    const bool is_positive = lower.ends_with(ways.positive);
    const std::string_view way = is_positive                      ? ways.positive
                                 : lower.ends_with(ways.negative) ? ways.negative
                                                                  : "";
    const std::string before = lower.substr(0, lower.size() - way.size());
    const std::string number = without_unit(detail::trimmed(before), unit);
    const auto value = detail::parse_number<double>(number);
    const bool is_sure = value && std::isfinite(*value) && !std::signbit(*value) &&
                         (way.empty() ? *value == 0 : true);
    if (!is_sure) return fmt::format("must say which way: {}, not '{}'", examples_of(ways), text);
    text = (is_positive || *value == 0 ? "" : "-") + number;
    return "";
  };
  return {take, "", "number"};
}

/// Returns the options with the synonyms of an axis, such as "--tilt". Their numbers include the
/// direction.
std::vector<std::string> named_options(std::size_t axis) {
  std::vector<std::string> result;
  if (*axis_directions[axis].positive == '\0') return result;
  const std::string_view own = axis_names[axis];
  for (const auto& group : synonyms) {
    if (std::ranges::find(group, own) == group.end()) continue;
    for (const char* const word : group) {
      if (word != own) result.push_back(std::string("--") + word);
    }
  }
  return result;
}

void add_named_directions(CLI::App& command, CLI::Option& signed_option, std::size_t axis,
                          std::optional<double>& into, const std::string& unit) {
  const AxisDirection& ways = axis_directions[axis];
  for (const std::string& name : named_options(axis)) {
    command.add_option(name, into, "The same with the direction in words: " + examples_of(ways))
        ->transform(number_with_direction(unit, ways))
        ->type_name(fmt::format("NUMBER{}|NUMBER{}", ways.positive, ways.negative))
        ->excludes(&signed_option);
  }
}

/// Returns a hint at the options for a number with a direction: "; --tilt takes 30down or 30up".
std::string hint_of_names(std::size_t axis) {
  std::string result;
  for (const std::string& name : named_options(axis)) {
    result += fmt::format("; {} takes {}", name, examples_of(axis_directions[axis]));
  }
  return result;
}

}  // namespace

CLI::Validator number_with_unit(const std::string& unit, const std::string& hint) {
  const auto take = [unit, hint](std::string& text) -> std::string {
    std::string number = without_unit(text, unit);
    if (number.starts_with('+')) number.erase(0, 1);
    const auto value = detail::parse_number<double>(number);
    if (!value || !std::isfinite(*value)) {
      return fmt::format("must be a number in {}, not '{}'{}", unit, text, hint);
    }
    text = number;
    return "";
  };
  return {take, "", "number"};
}

void add_axis_options(CLI::App& command, AxisNumbers& into, const std::string& what,
                      const std::string& unit) {
  for (std::size_t i = 0; i < axis_names.size(); ++i) {
    CLI::Option* const option =
        command
            .add_option(std::string("--") + axis_names[i], into[i],
                        fmt::format("{} of {}, in {}: {}", what, axis_names[i],
                                    unit == "deg" ? "degrees" : "degrees per second",
                                    direction_text(axis_directions[i])))
            ->transform(number_with_unit(unit, hint_of_names(i)))
            ->type_name("NUMBER");
    add_named_directions(command, *option, i, into[i], unit);
  }
}

void require_an_axis(const AxisNumbers& numbers) {
  if (!numbers.roll && !numbers.pitch && !numbers.yaw) {
    std::vector<std::string> options;
    for (std::size_t i = 0; i < axis_names.size(); ++i) {
      options.push_back(std::string("--") + axis_names[i]);
      for (const std::string& name : named_options(i)) options.push_back(name);
    }
    throw CommandError("say which axis: " + detail::alternatives(options, false), wrong_usage);
  }
}

msg::Angle14 to_angle(double degrees, std::string_view option) {
  return to_quantity<msg::Angle14>(fmt::format("{}", degrees), option);
}

msg::ControlSpeed to_speed(double degrees_per_second, std::string_view option) {
  // With a unit, what would become 0 is a mistake.
  return to_quantity<msg::ControlSpeed>(fmt::format("{} deg/s", degrees_per_second), option);
}

std::string axis_text(std::size_t axis, std::string_view number, std::string_view unit) {
  const bool is_negative = number.starts_with('-');
  const AxisDirection& ways = axis_directions[axis];
  const std::string_view way = is_negative ? ways.negative : ways.positive;
  const std::string_view size = number.substr(is_negative ? 1 : 0);
  const bool is_zero = size.find_first_of("123456789") == std::string_view::npos;
  if (way.empty() || is_zero) {
    return fmt::format("{} {} {}", axis_names[axis], is_zero ? size : number, unit);
  }
  return fmt::format("{} {} {} ({} {})", size, unit, way, axis_names[axis], number);
}

std::string axes_text(const AxisNumbers& numbers, std::string_view unit) {
  std::string result;
  for (std::size_t i = 0; i < axis_names.size(); ++i) {
    if (!numbers[i]) continue;
    if (!result.empty()) result += ", ";
    result += axis_text(i, fmt::format("{}", *numbers[i]), unit);
  }
  return result;
}

std::string directions_text() {
  std::string result;
  for (std::size_t i = 0; i < axis_names.size(); ++i) {
    const std::string_view positive = axis_directions[i].positive;
    if (positive.empty()) continue;
    result +=
        fmt::format("{}positive {} is {}", result.empty() ? "" : ", ", axis_names[i], positive);
  }
  return result;
}

}  // namespace sbgc::tools
