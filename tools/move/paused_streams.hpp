/// Data streams that leave no room on the line.
#pragma once

#include <vector>

#include <sbgc/client/client.hpp>
#include <sbgc/messages/realtime.hpp>

namespace sbgc::tools {

/// Ends the data streams that run on the line, as an earlier host has left them, and starts them
/// again at the end of its life. No request lists them: what is known of them is what their samples
/// tell, and the user reads what is not.
class PausedStreams {
 public:
  /// Listens to the line for half a second. Throws CommandError if the board does not respond.
  explicit PausedStreams(Client& client);
  PausedStreams(const PausedStreams&) = delete;
  PausedStreams& operator=(const PausedStreams&) = delete;
  ~PausedStreams();

 private:
  /// Starts the streams again that were running.
  void restart() const;

  Client& client_;
  std::vector<msg::DataStreamInterval> paused_{};
};

}  // namespace sbgc::tools
