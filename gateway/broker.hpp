/// Connects the gimbals of a fleet to an MQTT broker: their reports, and their commands.
///
/// A command goes from the thread of the connection to that of the journal and, once it is on disk,
/// to the strand of its gimbal; its result takes the same way back. A stop goes to the strand at
/// once: only the thread of the journal waits for the journal.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "gateway/fleet.hpp"
#include "gateway/gimbal.hpp"
#include "gateway/outbox.hpp"

namespace sbgc::tools {

class Broker {
 public:
  struct Statistics : OutboxStatistics {
    bool is_connected{};
    bool has_failed{};  ///< see failure()
  };

  /// Registers its handlers: the gimbals must not have started. Commands that an earlier gateway
  /// had begun get the result `unknown`. Throws std::runtime_error.
  Broker(const Fleet& fleet, const std::vector<std::unique_ptr<Gimbal>>& gimbals);
  Broker(const Broker&) = delete;
  Broker& operator=(const Broker&) = delete;
  ~Broker();

  void start();
  /// Stops motion caused by commands, trying for at most 8 seconds, and reports that the gateway is
  /// offline.
  void close();
  /// True if it could not stop a gimbal. The journal records that.
  bool has_left_moving() const;

  Statistics statistics() const;
  /// The reason why this half has failed, such as a full disk; without metrics, it has requested
  /// the end of the process. "" if it works.
  std::string failure() const;
  /// True if the reason is another gateway of the same fleet.
  bool has_duplicate() const;

 private:
  class Impl;

  std::unique_ptr<Impl> impl_;
};

}  // namespace sbgc::tools
