/// The values that somebody wants for parameters.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include <sbgc/client/parameters.hpp>

#include "parameters/parameter_messages.hpp"
#include "values/assignments.hpp"

namespace sbgc::tools {

/// The values to set in one message.
struct MessageValues {
  const ParameterMessage* message = nullptr;
  std::vector<FieldValue> values{};

  bool has_general() const {
    return std::ranges::any_of(values, [](const auto& value) { return is_general(value.field); });
  }
};

/// Returns the values by message. Reads each on a new message first, so that most mistakes are
/// found without a board. Throws ValueError.
std::vector<MessageValues> values_of(const std::vector<Assignment>& assignments, bool no_validate);

/// True if the block with this id gets some of the values.
bool concerns(const MessageValues& one, const ParametersId& id, std::uint8_t profile);

/// Returns the blocks of `present` with the values. Throws CommandError if the board lacks one of
/// them, or the value does not fit.
ParameterSet with_values(const ParameterSet& present, const std::vector<MessageValues>& values,
                         std::uint8_t profile, const Availability& versions);

}  // namespace sbgc::tools
