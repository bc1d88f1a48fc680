/// The search for the line settings at which a board responds.
#pragma once

#include <array>
#include <functional>
#include <mutex>
#include <optional>
#include <span>

#include <sbgc/detector.hpp>

#include "channel.hpp"

namespace sbgc::detail {

class LineSearch {
 public:
  struct Outcome {
    bool found = false;
    std::array<Trial, Detector::lines> trials{};
  };
  using Done = std::function<void(const Outcome&)>;

  /// Sets the receiver of the outcome. Thread-safe, like report() and so_far().
  void on_done(Done done);
  /// Reports the outcome, once.
  void report(const Outcome& outcome);
  /// The trials so far.
  Outcome so_far() const;

  // Only on the strand.

  void begin() { detector_.emplace(); }
  bool is_active() const noexcept { return detector_.has_value(); }
  void feed(std::span<const std::uint8_t> bytes) { detector_->feed(bytes); }
  /// Continues the search as far as possible. Returns true when it has ended.
  bool advance(Channel& channel, Instant now);
  /// Returns the outcome and ends the search.
  Outcome take_outcome();
  /// The settings found.
  const LineSettings& line() const noexcept { return line_; }

 private:
  DetectorStep next_step(Instant now);

  mutable std::mutex mutex_;
  Done done_;
  Outcome so_far_{};
  std::optional<Detector> detector_;
  bool found_ = false;
  LineSettings line_{};
};

}  // namespace sbgc::detail
