/// Automatic tuning of the PID controllers.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include <sbgc/enums.hpp>
#include <sbgc/messages/calibration.hpp>
#include <sbgc/time.hpp>
#include <sbgc/types.hpp>

namespace sbgc::emulator {

struct Device;

/// CMD_AUTO_PID: searches for gains in rounds, shakes the camera meanwhile, and stores the result.
class AutoTuning {
 public:
  /// Precondition: the profile exists, `config` names an axis. `port` gets the progress, if the
  /// flags say so. False, without effect, if a calibration or tuning is in progress or the motors
  /// are off.
  bool start(Device& device, std::uint8_t profile, msg::AutoPidFlags config, std::uint8_t gain,
             std::optional<std::size_t> port, Instant now);
  /// The same with the configuration in the parameters (MENU_CMD_AUTO_PID). Also false if they name
  /// no axis.
  bool start(Device& device, Instant now);
  /// Discards the result.
  void stop();
  bool is_running() const { return run_.has_value(); }

  /// The port closes: send nothing more there.
  void forget_port(std::size_t port);

  Instant next() const;
  void advance(Device& device, Instant now);
  void restart(Device& device, Instant now);

 private:
  /// The values of one axis that it searches for.
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
  void report(Device& device, const Run& run) const;
  void store(Device& device, const Run& run, Instant now) const;

  std::optional<Run> run_{};
  std::uint64_t shakes_{};  ///< counter of the random numbers
};

}  // namespace sbgc::emulator
