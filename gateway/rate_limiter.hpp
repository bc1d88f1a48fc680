/// A bound on how often something happens.
#pragma once

#include <algorithm>
#include <chrono>

namespace sbgc::tools {

/// At most `most` at once, and afterwards `per_second`.
class RateLimiter {
 public:
  using Time = std::chrono::steady_clock::time_point;

  RateLimiter(double per_second, double most) : per_second_(per_second), most_(most), left_(most) {}

  /// Returns false if it is too often.
  bool take(Time now) {
    const std::chrono::duration<double> since = now - last_;
    left_ = std::min(most_, left_ + since.count() * per_second_);
    last_ = now;
    if (left_ < 1) return false;
    --left_;
    return true;
  }

 private:
  double per_second_;
  double most_;
  double left_;
  Time last_{};
};

}  // namespace sbgc::tools
