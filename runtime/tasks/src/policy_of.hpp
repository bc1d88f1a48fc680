/// The response policy of a request whose type is known only at run time.
#pragma once

#include <sbgc/any.hpp>
#include <sbgc/response_policy.hpp>

namespace sbgc::detail {

/// Returns an empty policy for a message from the board.
ResponsePolicy policy_of(const AnyMessage& message);

}  // namespace sbgc::detail
