/// Refusals of commands whose answer is not waited for.
#pragma once

#include <cstdint>
#include <mutex>
#include <optional>
#include <utility>

#include <sbgc/client/client.hpp>
#include <sbgc/enums.hpp>

namespace sbgc::detail {

/// Collects the errors that the board reports about a command. A call of such a command is over
/// when it has been sent, so its refusal is seen only by the next look at take().
class Refusals {
 public:
  Refusals(Client& client, msg::CommandToBoard command)
      : subscription_(client.on_notice([this, command](const Notice& notice) {
          const bool is_about_it = notice.kind == NoticeKind::board_error &&
                                   notice.command == static_cast<std::uint8_t>(command);
          if (!is_about_it) return;
          const std::scoped_lock lock(mutex_);
          last_ = {ErrorCode::board_error, notice.message, notice.detail};
        })) {}

  /// "CMD_CONTROL: the board refused: WRONG_STATE", once for the refusals since the last call.
  std::optional<ClientError> take() {
    const std::scoped_lock lock(mutex_);
    return std::exchange(last_, std::nullopt);
  }

 private:
  std::mutex mutex_{};
  std::optional<ClientError> last_{};
  Subscription subscription_;
};

}  // namespace sbgc::detail
