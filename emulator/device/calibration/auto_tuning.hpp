/// Automatic tuning of the PID controllers.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include <sbgc/enums.hpp>
#include <sbgc/messages/calibration.hpp>
#include <sbgc/time.hpp>
#include <sbgc/types.hpp>

#include "device/calibration/calibrations.hpp"

namespace sbgc::emulator {

/// CMD_AUTO_PID: searches for gains in rounds while it shakes the camera, then stores the result.
class AutoTuning {
 public:
  /// Precondition: the profile exists, and `config` selects an axis. `port` receives progress
  /// reports if the flags request them. Returns false, without effect, if a calibration or tuning
  /// is in progress or the motors are off.
  bool start(CalibrationParts& parts, std::uint8_t profile, msg::AutoPidFlags config,
             std::uint8_t gain, std::optional<std::size_t> port, Instant now);
  /// Uses the configuration in the parameters (MENU_CMD_AUTO_PID). Also returns false if they
  /// select no axis.
  bool start(CalibrationParts& parts, Instant now);
  /// Discards the result.
  void stop();
  bool is_running() const { return run_.has_value(); }

  void drop_port(std::size_t port);

  Instant next() const;
  void advance(Instant now, CalibrationParts& parts);
  void restart(Instant now);

 private:
  /// The tuned values of one axis.
  struct Gains {
    double p{}, i{}, d{}, lpf{};
  };
  struct Run {
    std::optional<std::size_t> port{};
    std::uint8_t profile{};
    msg::AutoPidFlags config{};
    Axes<Gains> begin{}, goal{};
    Axes<double> error{};
    unsigned round{}, rounds{};
    Instant due{};
    Duration interval{};
  };

  Gains gains(const Run& run, std::size_t axis) const;
  void report(CalibrationParts& parts, const Run& run) const;
  void store(CalibrationParts& parts, const Run& run) const;

  std::optional<Run> run_{};
  std::uint64_t shakes_{};  ///< counter of the random numbers
};

}  // namespace sbgc::emulator
