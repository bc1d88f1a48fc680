/// Responses of a board to a request, for tests.
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>

#include <sbgc/messages.hpp>

#include "device/request_context.hpp"
#include "host.hpp"

namespace sbgc::test {

/// Returns the number of confirmations of M among the packets.
template <class M>
std::ptrdiff_t confirmations(const Packets& packets) {
  const auto all_of_them = all<msg::Confirm>(packets);
  return std::count_if(all_of_them.begin(), all_of_them.end(),
                       [](const msg::Confirm& one) { return one.cmd == M::command; });
}

/// Returns the reason if the packets are a single CMD_ERROR that names M.
template <class M>
std::optional<msg::BoardErrorCode> refusal(const Packets& packets) {
  const auto errors = all<msg::ErrorExt>(packets);
  if (packets.size() != 1 || errors.size() != 1 || errors[0].cmd_id != M::command) return {};
  return errors[0].error_code;
}

/// Returns true if the only response to the request is a confirmation.
template <Message M>
bool is_confirmed(Host& host, const M& request) {
  const Packets packets = host.ask(request);
  return packets.size() == 1 && confirmations<M>(packets) == 1;
}

/// Returns the reason why a request is rejected; nothing for any other response.
template <Message M>
std::optional<msg::BoardErrorCode> refusal(Host& host, const M& request) {
  return refusal<M>(host.ask(request));
}

}  // namespace sbgc::test
