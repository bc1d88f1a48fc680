/// Calibrations that take time.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include <sbgc/emulator/board_options.hpp>
#include <sbgc/emulator/memory.hpp>
#include <sbgc/enums.hpp>
#include <sbgc/messages/calibration.hpp>
#include <sbgc/time.hpp>

namespace sbgc::emulator {

class AutoTuning;
class Calibrations;
class FrequencyResponse;
class Outputs;
class Parameters;
class Ports;
class Restarts;
struct Imus;

/// The parts that calibrations and the automatic tuning use.
struct CalibrationParts {
  const BoardOptions& options;
  Memory& memory;
  Parameters& parameters;
  Gimbal& gimbal;
  Imus& imus;
  Outputs& outputs;
  Ports& ports;
  Restarts& restarts;
  Calibrations& calibrations;
  AutoTuning& auto_tuning;
  FrequencyResponse& frequency_response;
};

/// Runs one calibration at a time: it measures, starts over if the gimbal moves, and stores the
/// result. CMD_CALIB_INFO reports the progress.
class Calibrations {
 public:
  enum class Kind : std::uint8_t {
    gyro,
    acc,
    gyro_temperature,
    acc_temperature,
    gyro_from_sensor,  ///< copies the factory calibration
    acc_from_sensor,
    gyro_to_sensor,  ///< stores the current calibration as the factory calibration
    acc_to_sensor,
    mag,
    ext_gain,
    poles,
    encoder_offset,
    encoder_field,
    orientation,    ///< of the main IMU on the camera
    cogging,        ///< of the motors
    acc_reference,  ///< of the accelerometer, by an external reference
    momentum,       ///< of the axes
  };

  /// The sender of a request, notified at the end by a confirmation of its command or CMD_ERROR.
  struct Requester {
    std::size_t port{};
    std::uint8_t command{};
  };

  /// `imu` is 0 for the main and 1 for the frame IMU; kinds without an IMU ignore it. Returns
  /// false, without effect, if a calibration or tuning is in progress. Precondition: the board has
  /// this IMU, and encoders if the kind needs them.
  /// `length` replaces the usual duration if it is not 0.
  bool start(CalibrationParts& parts, Kind kind, std::size_t imu,
             std::optional<Requester> requester, Instant now, Duration length = {});
  bool under_way() const { return run_.has_value(); }
  /// The calibration in progress.
  msg::CalibMode mode() const;
  /// Returns CMD_CALIB_INFO of this IMU. Precondition: the board has it.
  msg::CalibInfo info(const Memory& memory, Gimbal& gimbal, std::size_t imu, Instant now) const;
  /// ERR_CALIB_ACC and ERR_CALIB_POLES. A failed calibration sets its flag, a successful one clears
  /// it.
  Flags<msg::SystemError> errors() const { return errors_; }

  /// CMD_CALIB_OFFSET: makes follow mode hold the current joint angles. Returns false if one of
  /// them is out of range.
  static bool store_follow_offsets(Gimbal& gimbal, Parameters& parameters, Instant now);
  /// Scales a duration of a real board by these options; at least one cycle.
  static Duration scaled(const BoardOptions& options, Duration length);

  void drop_port(std::size_t port);

  Instant next() const;
  void advance(Instant now, CalibrationParts& parts);

 private:
  struct Run {
    Kind kind{};
    std::size_t imu{};
    std::uint8_t profile{};  ///< the profile whose parameters it changes
    std::optional<Requester> requester{};
    Duration step{};          ///< between two readings of the sensors
    unsigned steps_needed{};  ///< consecutive steps at rest
    unsigned steps_at_rest{};
    unsigned steps_left{};  ///< until it fails
    Instant due{};          ///< time of the next step
    int temperature_min{}, temperature_max{};
  };

  bool store(CalibrationParts& parts, const Run& run, Instant now);
  void finish(CalibrationParts& parts, bool is_success, Instant now);

  std::optional<Run> run_{};
  std::uint8_t last_progress_{};  ///< percent; used while no calibration is in progress
  Flags<msg::SystemError> errors_{};
};

}  // namespace sbgc::emulator
