#include "motion/axis_values.hpp"

#include <charconv>
#include <cmath>
#include <limits>
#include <system_error>

#include <fmt/format.h>

#include "command/command_error.hpp"

namespace sbgc::tools {

namespace {

/// The value of the highest count of a quantity.
template <class Q>
constexpr Q highest{std::numeric_limits<typename Q::raw_type>::max()};

}  // namespace

CLI::Validator number_with_unit(const std::string& unit) {
  const auto take = [unit](std::string& text) -> std::string {
    std::string number = text;
    if (number.ends_with(unit)) number.resize(number.size() - unit.size());
    while (number.ends_with(' ')) number.pop_back();
    if (number.starts_with('+')) number.erase(0, 1);
    double value = 0;
    const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), value);
    const bool is_number = error == std::errc() && end == number.data() + number.size();
    if (!is_number || !std::isfinite(value)) {
      return fmt::format("must be a number in {}, not '{}'", unit, text);
    }
    text = number;
    return "";
  };
  return {take, "", "number"};
}

void add_axis_options(CLI::App& command, AxisNumbers& into, const std::string& what,
                      const std::string& unit) {
  for (std::size_t i = 0; i < axis_names.size(); ++i) {
    command
        .add_option(std::string("--") + axis_names[i], into[i],
                    fmt::format("{} of {}, in {}", what, axis_names[i],
                                unit == "deg" ? "degrees" : "degrees per second"))
        ->transform(number_with_unit(unit))
        ->type_name("NUMBER");
  }
}

void require_an_axis(const AxisNumbers& numbers) {
  if (!numbers.roll && !numbers.pitch && !numbers.yaw) {
    throw CommandError("say which axis: --roll, --pitch or --yaw", wrong_usage);
  }
}

msg::Angle14 to_angle(double degrees, std::string_view option) {
  if (const auto angle = msg::Angle14::from_degrees(degrees)) return *angle;
  throw CommandError(fmt::format("{}: {} deg is too far; the protocol has angles up to {:.0f} deg",
                                 option, degrees, highest<msg::Angle14>.degrees()),
                     wrong_usage);
}

msg::ControlSpeed to_speed(double degrees_per_second, std::string_view option) {
  const auto speed = msg::ControlSpeed::from_degrees_per_second(degrees_per_second);
  if (!speed) {
    throw CommandError(
        fmt::format("{}: {} deg/s is too fast; the protocol has speeds up to {:.0f} "
                    "deg/s",
                    option, degrees_per_second, highest<msg::ControlSpeed>.degrees_per_second()),
        wrong_usage);
  }
  if ((*speed).raw() == 0 && degrees_per_second != 0) {
    throw CommandError(fmt::format("{}: {} deg/s is too slow; the least is {:.2f} deg/s", option,
                                   degrees_per_second, msg::ControlSpeed(1).degrees_per_second()),
                       wrong_usage);
  }
  return *speed;
}

std::string axes_text(const AxisNumbers& numbers, std::string_view unit) {
  std::string result;
  for (std::size_t i = 0; i < axis_names.size(); ++i) {
    if (!numbers[i]) continue;
    result +=
        fmt::format("{}{} {} {}", result.empty() ? "" : ", ", axis_names[i], *numbers[i], unit);
  }
  return result;
}

}  // namespace sbgc::tools
