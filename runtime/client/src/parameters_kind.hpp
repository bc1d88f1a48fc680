/// Messages that hold parameters, without their types: what can be done with the body of each.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <sbgc/availability.hpp>
#include <sbgc/client/options.hpp>
#include <sbgc/client/parameters.hpp>
#include <sbgc/client/task.hpp>
#include <sbgc/json.hpp>

#include "leaves.hpp"

namespace sbgc::detail {

using Body = std::span<const std::uint8_t>;

/// One message that holds parameters, and the requests that read and store it.
struct ParametersKind {
  std::string_view name;
  const char* summary;
  std::uint8_t copies;
  /// 1 bits where a body holds state of the board.
  std::vector<std::uint8_t> state_mask;
  /// 1 bits where it holds general parameters.
  std::vector<std::uint8_t> general_mask;

  bool (*is_readable)(const Availability& versions);
  bool (*is_writable)(const Availability& versions);
  Task<Result<std::vector<std::uint8_t>>> (*read)(std::uint8_t copy, CallOptions options);
  Task<Result<void>> (*write)(std::vector<std::uint8_t> body, CallOptions options);
  /// Why the body is no parameters of this copy; "" if it is.
  std::string (*problem)(Body body, std::uint8_t copy);
  std::vector<LeafText> (*leaves)(Body body);
  Json (*to_json)(Body body);
  /// Calls `report(path, text)` for every value that these versions do not allow.
  void (*violations)(Body body, const Availability& versions,
                     const std::function<void(std::string_view, std::string)>& report);
};

/// All of them, in the order of the specification's families.
const std::vector<ParametersKind>& parameters_kinds();
/// Null if no message of this name holds parameters.
const ParametersKind* find_parameters_kind(std::string_view name);

/// The wanted body as it has to be written over the present one: with the state of the board, and
/// the bytes behind the end of the wanted body, as they are. Nothing if the wanted one is longer.
std::optional<std::vector<std::uint8_t>> merged(const ParametersKind& kind, Body wanted,
                                                Body present);
/// Whether both hold the same parameters.
bool are_equal(const ParametersKind& kind, Body a, Body b);
/// The parameters in which they differ.
std::vector<FieldChange> field_changes(const ParametersKind& kind, Body before, Body after);
/// The general ones among those.
std::vector<FieldChange> general_changes(const ParametersKind& kind, Body before, Body after);

}  // namespace sbgc::detail
