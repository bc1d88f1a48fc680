/// Recording of a frequency response.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include <sbgc/messages/calibration.hpp>
#include <sbgc/time.hpp>

#include "device/calibration/calibrations.hpp"
#include "physics/axis_response.hpp"

namespace sbgc::emulator {

/// CMD_BODE_TEST_START_STOP: shakes an axis and sends what goes in and what comes out.
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
