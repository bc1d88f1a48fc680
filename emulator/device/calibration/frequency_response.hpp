/// Recording of a frequency response, and the recorded system.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include <sbgc/enums.hpp>
#include <sbgc/messages/calibration.hpp>
#include <sbgc/time.hpp>

#include "device/calibration/calibrations.hpp"

namespace sbgc::emulator {

/// A camera on a motor that is not stiff, modeled as a filter of samples of 0.8 ms: two poles at
/// `resonance`, and one sample of delay. A controller multiplies by a constant. All of this is an
/// assumption; a real board has its own system.
class AxisResponse {
 public:
  static constexpr double sample_time = 0.0008;  ///< seconds
  static constexpr double gain = 0.003;          ///< at 0 Hz
  static constexpr double resonance = 40;        ///< Hz, without damping
  static constexpr double damping = 0.3;
  static constexpr double controller = 100;

  explicit AxisResponse(msg::BodeSystem system);

  /// Returns the next output.
  double operator()(double input);

 private:
  msg::BodeSystem system_;
  double first_, second_;  ///< the coefficients of the last two outputs
  double scale_;           ///< of the last input
  double input_ = 0;       ///< of the plant, in the previous sample
  double output_ = 0, earlier_output_ = 0;
};

/// CMD_BODE_TEST_START_STOP: shakes an axis and sends its input and output.
class FrequencyResponse {
 public:
  /// Precondition: the values of the request are valid. Returns false, without effect, if a
  /// recording, calibration or tuning is in progress or the motors are off.
  bool start(CalibrationParts& parts, const msg::BodeTestStartStopRequest& request,
             std::size_t port, Instant now);
  bool is_running() const { return run_.has_value(); }

  void drop_port(std::size_t port);

  Instant next() const;
  void advance(Instant now, CalibrationParts& parts);
  void restart(Instant now);

 private:
  struct Run {
    std::optional<std::size_t> port{};
    msg::BodeTestStartStopRequest request{};
    AxisResponse system;
    Instant start{};
    std::uint32_t samples{};  ///< so far
    double phase{};           ///< of a sweep, in turns
  };

  double stimulus(const CalibrationParts& parts, Run& run) const;
  void send_samples(CalibrationParts& parts, Run& run, std::uint32_t count) const;
  void finish(CalibrationParts& parts, std::uint16_t error);

  std::optional<Run> run_{};
};

}  // namespace sbgc::emulator
