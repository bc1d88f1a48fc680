/// Answers of the emulated board as the model says.
#pragma once

#include <sbgc/response_policy.hpp>

#include "host.hpp"

namespace sbgc::test {

/// The board's behavior where the model leaves it open.
enum class Comes : std::uint8_t {
  as_modelled,  ///< the model leaves nothing open
  confirmation,
  nothing,
};

/// Sends the bytes of a request and fails unless the responses are exactly those announced by its
/// policy.
void expect_as_modelled(Host& host, const ResponsePolicy& policy,
                        std::span<const std::uint8_t> frame, Comes comes);

/// The same for a message.
void expect_as_modelled(Host& host, const AnyMessage& request, Comes comes);

}  // namespace sbgc::test
