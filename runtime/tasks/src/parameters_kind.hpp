/// The messages that hold parameters, and the operations on their bodies.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <sbgc/any.hpp>
#include <sbgc/availability.hpp>
#include <sbgc/client/options.hpp>
#include <sbgc/client/parameters.hpp>
#include <sbgc/client/task.hpp>

namespace sbgc::detail {

using Body = std::span<const std::uint8_t>;

/// A message that holds parameters, and the requests that read and store it.
struct ParametersKind {
  const MessageType* type;
  std::uint8_t copies;
  /// Has 1 bits where a body holds state of the board.
  std::vector<std::uint8_t> state_mask;
  /// Has 1 bits where a body holds general parameters.
  std::vector<std::uint8_t> general_mask;

  /// The requests, deprecated ones last.
  std::vector<const MessageType*> readers;
  std::vector<const MessageType*> writers;

  bool is_readable(const Availability& versions) const;
  bool is_writable(const Availability& versions) const;
  Task<Result<std::vector<std::uint8_t>>> read(std::uint8_t copy, CallOptions options) const;
  /// Returns whether the board has confirmed it.
  Task<Result<bool>> write(std::vector<std::uint8_t> body, CallOptions options) const;

  std::string name() const { return type->info->name; }
  /// Returns the reason why the body does not hold parameters of this copy; "" if it does.
  std::string problem(Body body, std::uint8_t copy) const;
  /// Returns the message with this body, for which problem() must return "".
  AnyMessage message(Body body) const;
};

/// All kinds, in the order of the families in the specification.
const std::vector<ParametersKind>& parameters_kinds();
/// Returns null if no message with this name holds parameters.
const ParametersKind* find_parameters_kind(std::string_view name);
/// Returns all parameters that a board of these versions has.
std::vector<ParametersId> readable_parameters(const Availability& versions);

/// Returns the body to write in place of `present`: `wanted`, with the state of the board and the
/// bytes past its end taken from `present`. Returns nothing if `wanted` is longer.
std::optional<std::vector<std::uint8_t>> merged(const ParametersKind& kind, Body wanted,
                                                Body present);
/// True if both bodies hold the same parameters.
bool are_equal(const ParametersKind& kind, Body a, Body b);
/// Returns the parameters in which the bodies differ, with their meaning on boards with these
/// versions.
std::vector<FieldChange> field_changes(const ParametersKind& kind, Body before, Body after,
                                       const Availability& versions,
                                       const Availability& versions_after);
/// Like field_changes(), but only for general parameters.
std::vector<FieldChange> general_changes(const ParametersKind& kind, Body before, Body after,
                                         const Availability& versions);

}  // namespace sbgc::detail
