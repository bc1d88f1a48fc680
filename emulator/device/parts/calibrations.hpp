/// Calibrations that take time: one at once.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include <sbgc/emulator/board_options.hpp>
#include <sbgc/enums.hpp>
#include <sbgc/messages/calibration.hpp>
#include <sbgc/time.hpp>

namespace sbgc::emulator {

struct Device;

/// One calibration at a time: it measures, begins again when the gimbal moves meanwhile, and stores
/// what it has found. Progress shows in CMD_CALIB_INFO.
class Calibrations {
 public:
  enum class Kind : std::uint8_t {
    gyro,
    acc,
    gyro_temperature,
    acc_temperature,
    gyro_from_sensor,  ///< copies the factory calibration
    acc_from_sensor,
    gyro_to_sensor,  ///< makes the present calibration the sensor's own
    acc_to_sensor,
    mag,
    ext_gain,
    poles,
    encoder_offset,
    encoder_field,
  };

  /// Whom to tell when it is over: a confirmation of that command, or CMD_ERROR.
  struct Requester {
    std::size_t port{};
    std::uint8_t command{};
  };

  /// `imu` is 0 for the main IMU, 1 for that of the frame; for kinds without an IMU it is ignored.
  /// False, and nothing happens, if something else is being calibrated or tuned. Precondition: the
  /// board has that IMU, and encoders if it is about them.
  bool start(Device& device, Kind kind, std::size_t imu, std::optional<Requester> requester,
             Instant now);
  /// What is being calibrated.
  std::optional<Kind> under_way() const;
  /// What of CMD_CALIB_INFO concerns that IMU. Precondition: the board has it.
  msg::CalibInfo info(Device& device, std::size_t imu, Instant now) const;
  /// ERR_CALIB_ACC and ERR_CALIB_POLES, from a calibration that failed to one that succeeds.
  Flags<msg::SystemError> errors() const { return errors_; }

  /// CMD_CALIB_OFFSET: follow mode holds the present angles of the joints. False if one of them is
  /// beyond what the setting holds.
  static bool store_follow_offsets(Device& device, Instant now);
  /// What a real board needs `length` for, on a board with these options; at least one cycle.
  static Duration scaled(const BoardOptions& options, Duration length);

  /// The port closes: nothing more goes there.
  void forget_port(std::size_t port);

  Instant next() const;
  void advance(Device& device, Instant now);
  void restart(Device& device, Instant now);

 private:
  struct Run {
    Kind kind{};
    std::size_t imu{};
    std::uint8_t profile{};  ///< whose parameters it changes
    std::optional<Requester> requester{};
    Duration step{};          ///< between two looks at the sensors
    unsigned steps_needed{};  ///< at rest, one behind the other
    unsigned steps_at_rest{};
    unsigned steps_left{};  ///< until it gives up
    Instant due{};          ///< of the next step
    int temperature_min{}, temperature_max{};
  };

  bool store(Device& device, const Run& run, Instant now);
  void finish(Device& device, bool is_success, Instant now);

  std::optional<Run> run_{};
  std::uint8_t last_progress_{};  ///< percent, while nothing is under way
  Flags<msg::SystemError> errors_{};
};

}  // namespace sbgc::emulator
