/// Rate limiting of log lines: anyone can trigger refused connections as fast as they like.
#pragma once

#include <chrono>
#include <functional>
#include <string>
#include <utility>

namespace sbgc::hosts {

/// Returns a function that passes on at most five texts per second. Not thread-safe; copies count
/// separately.
inline std::function<void(const std::string&)> with_fewer_reports(
    std::function<void(const std::string&)> report) {
  using Clock = std::chrono::steady_clock;
  constexpr int most = 5;
  return [report = std::move(report), begin = Clock::time_point{},
          reports = 0](const std::string& text) mutable {
    const auto now = Clock::now();
    if (now - begin > std::chrono::seconds(1)) {
      begin = now;
      reports = 0;
    }
    if (++reports <= most) report(text);
    if (reports == most) report("further refusals in this second are not reported");
  };
}

}  // namespace sbgc::hosts
