/// The pending calls of a conversation, which threads share.
#pragma once

#include <utility>

#include "calls/pending_calls.hpp"
#include "guarded.hpp"

namespace sbgc::detail {

class SharedCalls : public Guarded<PendingCalls> {
 public:
  using Guarded::Guarded;

  /// Passes its result to the handler of a call that was taken out, or was never added. Must be
  /// called without the lock.
  void complete(const Call& call, Result<Reply> result) {
    if (!result) lock()->count_failed();
    call.handler(std::move(result));
  }
};

}  // namespace sbgc::detail
