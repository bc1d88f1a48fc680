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

/// The same, but a value changed by an undetected line error is not accepted; see
/// read_until_two_agree(). `seen` are answers that are known already.
Task<Result<Parameters>> read_verified(const ParametersKind& kind, std::uint8_t copy,
                                       const Deadline& deadline, std::vector<Parameters> seen = {});

}  // namespace sbgc::detail
