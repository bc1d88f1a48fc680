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

/// Checks a finite number, and removes the unit, "deg" or "deg/s", that may follow it. `hint` ends
/// the message about others.
CLI::Validator number_with_unit(const std::string& unit, const std::string& hint = "");

/// Adds the three options; `what` is the noun of their descriptions, such as "Angle", and the unit
/// "deg" or "deg/s". The descriptions say which way the numbers count. Other names of an axis, such
/// as
/// --tilt, take the direction in words: "30down".
void add_axis_options(CLI::App& command, AxisNumbers& into, const std::string& what,
                      const std::string& unit);

/// Throws CommandError unless an axis has a number.
void require_an_axis(const AxisNumbers& numbers);

/// Convert numbers in degrees and degrees per second. Throw CommandError, with the option's name,
/// if the protocol cannot express them; so does a speed that would become 0.
msg::Angle14 to_angle(double degrees, std::string_view option);
msg::ControlSpeed to_speed(double degrees_per_second, std::string_view option);

/// The value `number` of an axis in words: "20 deg up (pitch -20)"; "roll 5 deg" where the
/// direction is not known.
std::string axis_text(std::size_t axis, std::string_view number, std::string_view unit);

/// For example "20 deg up (pitch -20), 5 deg right (yaw 5)".
std::string axes_text(const AxisNumbers& numbers, std::string_view unit);

/// The directions of positive values: "positive pitch is down, positive yaw is right".
std::string directions_text();

}  // namespace sbgc::tools
