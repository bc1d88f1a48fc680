/// Reading and writing parameters by name, as tasks.
#pragma once

#include <sbgc/client/task.hpp>
#include <sbgc/json_dom.hpp>

#include "gateway/orders.hpp"

namespace sbgc::tools {

/// Returns the parameters in the format of `sbgc params get --format json`.
Task<Result<Json>> get_parameters(GetOrder order);

/// Reads, changes, writes, reads back and compares. Returns the changes.
Task<Result<Json>> set_parameters(SetOrder order);

}  // namespace sbgc::tools
