/// The pending calls of a conversation, which threads may share.
#pragma once

#include <cstddef>
#include <optional>
#include <utility>

#include "calls/pending_calls.hpp"
#include "guarded.hpp"

namespace sbgc::detail {

class SharedCalls : public Guarded<PendingCalls> {
 public:
  explicit SharedCalls(std::size_t most_waiting, LockPointer lock = nullptr)
      : Guarded(std::move(lock), most_waiting) {}

  /// Passes its result to the handler of a call that was taken out, or was never added. Must be
  /// called without the lock.
  void complete(const Call& call, Result<Reply> result) {
    if (!result) lock()->count_failed();
    call.handler(std::move(result));
  }

  /// Adds a call, ends what it supersedes, and tells the tasks. Returns the reason for rejecting
  /// it.
  std::optional<ClientError> begin(const CallPointer& call) {
    PendingCalls::Superseded superseded;
    auto refusal = lock()->add(call, superseded);
    for (const auto& tell : superseded.tasks) tell();
    for (const CallPointer& one : superseded.calls) complete(*one, superseded_error(*one));
    return refusal;
  }
};

}  // namespace sbgc::detail
