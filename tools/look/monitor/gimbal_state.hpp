/// The state of a gimbal in the monitor, and its history.
#pragma once

#include <array>
#include <chrono>
#include <deque>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include <sbgc/client/client.hpp>

#include "look/monitor/live_values.hpp"

namespace sbgc::tools {

/// A history of values. Keeps as many as a wide terminal can show.
class History {
 public:
  void add(double value) {
    values_.push_back(value);
    if (values_.size() > most) values_.pop_front();
  }
  std::vector<double> values() const { return {values_.begin(), values_.end()}; }

 private:
  static constexpr std::size_t most = 1000;
  std::deque<double> values_{};
};

struct LogEntry {
  std::chrono::system_clock::time_point time{};
  std::string text{};
};

/// A copy of everything that is shown.
struct GimbalSnapshot {
  std::optional<LiveMessage> message{};
  LiveValues values{};
  double rate{};  ///< messages per second
  std::array<History, 3> angles{};
  std::array<History, 3> powers{};
  History battery{};
  History current{};
  std::deque<LogEntry> log{};
  bool is_connected = true;
};

/// Collects the data that the gimbal sends. Thread-safe.
class GimbalState {
 public:
  void add(const LiveMessage& message);
  void add(const Notice& notice);
  void add(const LinkChange& change);
  void add(const ClientError& error);

  GimbalSnapshot snapshot() const;

 private:
  void log(std::string text);

  mutable std::mutex mutex_;
  GimbalSnapshot state_{};
  std::deque<std::chrono::steady_clock::time_point> arrivals_{};  // within the last seconds
  std::deque<PerAxis> rates_{};                                   // of the gyroscope, likewise
};

}  // namespace sbgc::tools
