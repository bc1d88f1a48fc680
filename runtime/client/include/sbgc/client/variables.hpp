/// Adjustable variables by name, in their units.
///
/// They change the parameters in the board's volatile memory at once; save_variables() makes that
/// last. What there is, with units and ranges, is in <sbgc/meta/variables.hpp>.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <sbgc/client/task.hpp>
#include <sbgc/enums.hpp>
#include <sbgc/meta/variables.hpp>

namespace sbgc {

/// A variable and its value in the variable's unit: {"LPF_FREQ_ROLL", 120} is 120 Hz.
struct VariableValue {
  std::string name{};
  double value{};

  bool operator==(const VariableValue&) const = default;
};

/// The variable with this name, as the specification writes it. ErrorCode::not_found with similar
/// names if there is none.
Result<const VariableInfo*> find_variable(std::string_view name);

/// The value in the unit of the variable for what stands on the wire.
double variable_value(const VariableInfo& variable, std::int32_t raw) noexcept;

/// What stands on the wire for a value, rounded to the nearest; ErrorCode::invalid with the range
/// if the variable can not have it.
Result<std::int32_t> variable_raw(const VariableInfo& variable, double value);

namespace tasks {

/// The values of these variables, in their order. Many are asked for with few messages.
Task<Result<std::vector<double>>> get_variables(std::vector<std::string> names);
/// The value of one variable.
Task<Result<double>> get_variable(std::string name);

/// Sets variables until the next start, or until they are saved. All are checked before the first
/// one is sent. As many as fit into a message change at the same moment; after a failure the error
/// says how many have been set, in the order given.
Task<Result<void>> set_variables(std::vector<VariableValue> values);
/// Sets one variable.
Task<Result<void>> set_variable(std::string name, double value);

/// Saves the board's volatile parameters, with all changes to variables, to the active profile.
Task<Result<void>> save_variables();

}  // namespace tasks
}  // namespace sbgc
