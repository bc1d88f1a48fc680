/// Refusals of commands whose answer is not waited for.
#pragma once

#include <mutex>
#include <optional>

#include <sbgc/client/client.hpp>
#include <sbgc/meta.hpp>

namespace sbgc::detail {

/// Collects the CMD_ERROR that a board sends about a command. A call of such a command is over when
/// it has been sent, so its refusal is seen only by the next look at take().
class Refusals {
 public:
  Refusals(Client& client, const MessageInfo& request);

  /// "CMD_CONTROL: the board refused: WRONG_STATE", once for the refusals since the last call.
  std::optional<ClientError> take();

 private:
  std::mutex mutex_{};
  std::optional<ClientError> last_{};
  Subscription subscription_;
};

}  // namespace sbgc::detail
