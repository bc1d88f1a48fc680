/// Puts the gimbals of a fleet on an MQTT broker: what they report, and what they are told.
///
/// A command goes from the thread of the connection to that of the journal and, once it is on the
/// disk, to the strand of its gimbal; its result comes back the same way. A stop goes to the strand
/// at once: nothing waits for the journal but its own thread.
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

  /// Registers its handlers: the gimbals have not started. Commands that an earlier gateway had
  /// begun get the result `unknown`. Throws std::runtime_error.
  Broker(const Fleet& fleet, const std::vector<std::unique_ptr<Gimbal>>& gimbals);
  Broker(const Broker&) = delete;
  Broker& operator=(const Broker&) = delete;
  ~Broker();

  void start();
  /// Stops what commands have set in motion, for which it tries for at most 8 seconds, and reports
  /// that the gateway is offline.
  void close();
  /// True if it could not stop a gimbal. The journal keeps that.
  bool has_left_moving() const;

  Statistics statistics() const;
  /// Why this half cannot go on, such as a full disk; without metrics, it has asked the process to
  /// end. "" if it can.
  std::string failure() const;
  /// True if that is another gateway of the same fleet.
  bool has_duplicate() const;

 private:
  class Impl;

  std::unique_ptr<Impl> impl_;
};

}  // namespace sbgc::tools
