/// Asks a gimbal for live data again and again, for metrics.
#pragma once

#include <chrono>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include <asio/steady_timer.hpp>
#include <prometheus/histogram.h>

#include <sbgc/any.hpp>

#include "gateway/gimbal.hpp"

namespace sbgc::tools {

/// Measures how long the answer takes, and keeps the last one. Other requests wait no longer than
/// for one frame.
class Probe : public std::enable_shared_from_this<Probe> {
 public:
  Probe(Gimbal& gimbal, std::chrono::milliseconds interval);

  /// The first request is after `delay`, so that gimbals are not asked all at once.
  void start(std::chrono::milliseconds delay);
  void close();

  // On any thread.

  /// Empty unless it is newer than a few intervals.
  std::optional<AnyMessage> live_data() const;
  prometheus::ClientMetric latency() const { return latency_.Collect(); }
  /// Requests without an answer, by the name of the error.
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
