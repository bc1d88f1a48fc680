/// Live data of gimbals as metrics for Prometheus: polled regularly, and described by the model.
#pragma once

#include <chrono>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <asio/steady_timer.hpp>
#include <prometheus/client_metric.h>
#include <prometheus/histogram.h>
#include <prometheus/metric_family.h>

#include <sbgc/any.hpp>

#include "gateway/gimbal.hpp"

namespace sbgc::tools {

/// Metrics for Prometheus, by name.
class Families {
 public:
  using ClientMetric = prometheus::ClientMetric;
  using MetricType = prometheus::MetricType;

  ClientMetric& add(const std::string& name, const std::string& help, MetricType type,
                    std::vector<ClientMetric::Label> labels) {
    prometheus::MetricFamily& family = all_[name];
    family.name = name;
    family.help = help;
    family.type = type;
    ClientMetric& metric = family.metric.emplace_back();
    metric.label = std::move(labels);
    return metric;
  }
  void add_counter(const std::string& name, const std::string& help,
                   std::vector<ClientMetric::Label> labels, double value) {
    add(name, help, MetricType::Counter, std::move(labels)).counter.value = value;
  }
  void add_gauge(const std::string& name, const std::string& help,
                 std::vector<ClientMetric::Label> labels, double value) {
    add(name, help, MetricType::Gauge, std::move(labels)).gauge.value = value;
  }

  std::vector<prometheus::MetricFamily> take() {
    std::vector<prometheus::MetricFamily> result;
    result.reserve(all_.size());
    for (auto& [name, family] : all_) result.push_back(std::move(family));
    return result;
  }

 private:
  std::map<std::string, prometheus::MetricFamily> all_{};  // by name
};

/// Adds the values of the message that have one of these paths, with this label. Names and help
/// texts come from the model; units are converted to the base units of Prometheus: `current` in mA
/// becomes sbgc_current_amperes. Axes become labels, and each flag or enum value becomes 0 or 1.
void add_live_metrics(Families& families, const AnyMessage& message,
                      const std::set<std::string>& paths,
                      const prometheus::ClientMetric::Label& label);

/// Measures the response time, and keeps the last answer. Other requests are delayed by one frame
/// at most.
class Probe : public std::enable_shared_from_this<Probe> {
 public:
  Probe(Gimbal& gimbal, std::chrono::milliseconds interval);

  /// The first request is sent after `delay`, so that gimbals are not polled all at once.
  void start(std::chrono::milliseconds delay);
  void close();

  // On any thread.

  /// Empty unless it is newer than a few intervals.
  std::optional<AnyMessage> live_data() const;
  prometheus::ClientMetric latency() const { return latency_.Collect(); }
  /// The number of requests without an answer, by the name of the error.
  std::map<std::string, std::uint64_t> failures() const;

 private:
  void wait(std::chrono::milliseconds time);
  void ask();

  Gimbal& gimbal_;
  const std::chrono::milliseconds interval_;
  asio::steady_timer timer_;
  bool is_closing_ = false;  // on the strand
  prometheus::Histogram latency_;
  mutable std::mutex mutex_;
  std::optional<AnyMessage> live_data_{};
  std::chrono::steady_clock::time_point received_{};
  std::map<std::string, std::uint64_t> failures_{};
};

}  // namespace sbgc::tools
