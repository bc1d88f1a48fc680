/// The metrics of a gateway, for Prometheus.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "gateway/broker.hpp"
#include "gateway/fleet.hpp"
#include "gateway/gimbal.hpp"

namespace sbgc::tools {

/// Serves http://ADDRESS/metrics while it lives.
class Metrics {
 public:
  /// The gimbals, and the broker if there is one, must outlive it. Throws CommandError if it cannot
  /// listen.
  Metrics(const MetricsSettings& settings, const std::vector<std::unique_ptr<Gimbal>>& gimbals,
          const Broker* broker);
  Metrics(const Metrics&) = delete;
  Metrics& operator=(const Metrics&) = delete;
  ~Metrics();

  /// Begins to poll the gimbals.
  void start();

  /// For example "http://127.0.0.1:9110/metrics".
  std::string address() const;
  /// True if other machines can connect.
  bool is_open() const;

 private:
  class Collector;
  class Server;

  const std::string listen_;
  std::shared_ptr<Collector> collector_;
  std::unique_ptr<Server> server_;
};

}  // namespace sbgc::tools
