/// Reading and writing the parameters of one message.
#pragma once

#include <sbgc/client/parameters.hpp>
#include <sbgc/client/task.hpp>

#include "parameters_kind.hpp"
#include "tasks/tools.hpp"

namespace sbgc::detail {

CallOptions parameters_options(const Deadline& deadline);

/// `deadline` is the deadline of the enclosing task.
Task<Result<Parameters>> read_one(const ParametersKind& kind, std::uint8_t copy,
                                  const Deadline& deadline);

}  // namespace sbgc::detail
