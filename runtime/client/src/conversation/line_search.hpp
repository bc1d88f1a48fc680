/// The search for the settings of a line at which a board answers.
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

  /// Whom to tell the outcome. Thread-safe, as report().
  void on_done(Done done);
  /// Tells it, once.
  void report(const Outcome& outcome);

  // On the strand

  void begin() { detector_.emplace(); }
  bool is_active() const noexcept { return detector_.has_value(); }
  void feed(std::span<const std::uint8_t> bytes) { detector_->feed(bytes); }
  /// Goes on with the search as far as possible now; true when it is over.
  bool advance(Channel& channel, Instant now);
  /// What came out of it. Then it is not active any more.
  Outcome take_outcome();
  /// The settings that were found.
  const LineSettings& line() const noexcept { return line_; }

 private:
  std::mutex mutex_;
  Done done_;
  std::optional<Detector> detector_;
  bool found_ = false;
  LineSettings line_{};
};

}  // namespace sbgc::detail
