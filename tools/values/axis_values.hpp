/// Options with a number for each axis: --roll, --pitch, --yaw.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include <CLI/CLI.hpp>

#include <sbgc/internal/words.hpp>
#include <sbgc/types.hpp>
#include <sbgc/units.hpp>

namespace sbgc::tools {

using sbgc::detail::axis_names;

using AxisNumbers = Axes<std::optional<double>>;

/// Checks a finite number, and removes an optional unit, "deg" or "deg/s". `hint` ends the error
/// message.
CLI::Validator number_with_unit(const std::string& unit, const std::string& hint = "");

/// Adds the three options; `what` is the noun of their descriptions, such as "Angle", and the unit
/// "deg" or "deg/s". The descriptions state the sign convention. Synonyms of an axis, such as
/// --tilt, accept the direction in words: "30down".
void add_axis_options(CLI::App& command, AxisNumbers& into, const std::string& what,
                      const std::string& unit);

/// Throws CommandError unless an axis has a number.
void require_an_axis(const AxisNumbers& numbers);

/// Convert numbers in degrees and degrees per second. Throw CommandError, with the option's name,
/// if the protocol cannot express them, or if a nonzero speed would become 0.
msg::Angle14 to_angle(double degrees, std::string_view option);
msg::ControlSpeed to_speed(double degrees_per_second, std::string_view option);

/// Describes the value `number` of an axis: "20 deg up (pitch -20)"; "roll 5 deg" if the direction
/// is not known.
std::string axis_text(std::size_t axis, std::string_view number, std::string_view unit);

/// For example "20 deg up (pitch -20), 5 deg right (yaw 5)".
std::string axes_text(const AxisNumbers& numbers, std::string_view unit);

/// Returns the sign conventions: "positive pitch is down, positive yaw is right".
std::string directions_text();

}  // namespace sbgc::tools
