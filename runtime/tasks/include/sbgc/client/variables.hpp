/// Adjustable variables by name, in their units.
///
/// Setting a variable changes the parameters in the board's volatile memory at once;
/// save_variables() makes the change permanent. <sbgc/meta/variables.hpp> lists all variables with
/// their units and ranges.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <sbgc/client/task.hpp>
#include <sbgc/enums.hpp>
#include <sbgc/meta/variables.hpp>

namespace sbgc {

/// A variable and its value in the unit of the variable: {"LPF_FREQ_ROLL", 120} means 120 Hz.
struct VariableValue {
  std::string name{};  ///< as in the specification
  double value{};      ///< in the unit of the variable

  bool operator==(const VariableValue&) const = default;
};

/// Finds a variable by its name in the specification. Errors: `not_found`, which suggests similar
/// names.
Result<const VariableInfo*> find_variable(std::string_view name);

/// Converts a raw value to the unit of the variable on a board with these versions.
double variable_value(const VariableInfo& variable, std::int32_t raw,
                      const Availability& versions = {}) noexcept;

/// Converts a value to the nearest raw value. Errors: `invalid`, which reports the range, if
/// the variable cannot hold it.
Result<std::int32_t> variable_raw(const VariableInfo& variable, double value,
                                  const Availability& versions = {});

namespace tasks {

/// Returns the values of these variables, in the given order. Uses as few messages as possible. A
/// value is only as reliable as one answer; if much depends on it, read it twice. Errors: those of
/// Client::call(); `not_found` for a name; `mismatch` if the board sends other variables.
Task<Result<std::vector<double>>> get_variables(std::vector<std::string> names);
/// Returns the value of one variable. Errors: those of get_variables().
Task<Result<double>> get_variable(std::string name);

/// Sets variables until the board restarts, or until they are saved. Validates all values before
/// sending any. Variables that fit into one message change at the same moment. If the operation
/// fails, the error reports how many were set, in the given order.
///
/// While the board answers in the first framing, whose checksums miss some damage, the variables
/// are read back. If they differ, they are set once more; then the operation fails with
/// ErrorCode::mismatch. Errors: those of get_variables(), and `invalid` for a value.
Task<Result<void>> set_variables(std::vector<VariableValue> values);
/// Sets one variable. Errors: those of set_variables().
Task<Result<void>> set_variable(std::string name, double value);

/// Saves the board's volatile parameters, including all changed variables, to the active profile.
/// Errors: those of Client::call().
Task<Result<void>> save_variables();

}  // namespace tasks
}  // namespace sbgc
