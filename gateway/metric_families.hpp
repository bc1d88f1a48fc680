/// Metrics on their way to Prometheus, by their names.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include <prometheus/metric_family.h>

namespace sbgc::tools {

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

}  // namespace sbgc::tools
