/// Data streams that leave no room on the line.
#pragma once

#include <vector>

#include <sbgc/client/client.hpp>
#include <sbgc/messages/realtime.hpp>

namespace sbgc::tools {

/// Ends the data streams that run on the line, as an earlier host has left them, and starts them
/// again at the end of its life.
class PausedStreams {
 public:
  /// Listens to the line for half a second. Throws CommandError if a stream runs that cannot be
  /// started again, because its samples do not say how it was started.
  explicit PausedStreams(Client& client);
  PausedStreams(const PausedStreams&) = delete;
  PausedStreams& operator=(const PausedStreams&) = delete;
  ~PausedStreams();

 private:
  /// Starts the streams again that were running.
  void restart() const;

  Client& client_;
  std::vector<msg::DataStreamInterval> running_{};
};

}  // namespace sbgc::tools
