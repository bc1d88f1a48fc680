/// Telemetry: messages of one type from a gimbal at a rate.
#pragma once

#include <chrono>
#include <functional>
#include <optional>
#include <string_view>

#include <sbgc/any.hpp>
#include <sbgc/client/async_client.hpp>

#include "frames/stream_type.hpp"

namespace sbgc::tools {

/// A data stream, or if the board has none for the message, the request that it answers.
class TelemetrySource {
 public:
  /// The name is that of a message from the board, or of its command. `contents` selects the
  /// contents of the samples: flags or NAME=VALUE. Throws CommandError.
  static TelemetrySource find(std::string_view message, std::string_view contents);

  const MessageInfo& info() const { return stream_ ? stream_->info() : *answer_->info; }

  /// Null if the message is polled.
  const StreamType* stream() const { return stream_ ? &*stream_ : nullptr; }
  /// Null if it is streamed.
  const AnyMessage* request() const { return request_ ? &*request_ : nullptr; }

 private:
  TelemetrySource() = default;

  std::optional<StreamType> stream_{};
  const MessageType* answer_ = nullptr;
  std::optional<AnyMessage> request_{};
};

}  // namespace sbgc::tools
