/// Calibrating the sensors.
///
/// A calibration replaces the stored one, and can move the camera: hold it still, as the
/// calibration of its sensor demands, and see docs/2-safety.md.
#pragma once

#include <chrono>
#include <functional>
#include <optional>

#include <sbgc/client/task.hpp>
#include <sbgc/messages/calibration.hpp>

namespace sbgc {

/// What is calibrated.
enum class Sensor : std::uint8_t { accelerometer, gyroscope };

/// What is seen of a calibration.
struct CalibrationProgress {
  bool has_started{};                     ///< the board has confirmed the beginning
  std::optional<msg::CalibInfo> state{};  ///< what the board tells, if it can
  std::chrono::milliseconds elapsed{};
};

/// How a sensor is calibrated.
struct CalibrationOptions {
  msg::CalibImu imu = msg::CalibImu::active;
  /// Some actions only manage calibrations, and let the board restart: these end with their
  /// confirmation. All other ones are confirmed at the beginning and in the end.
  msg::CalibAction action = msg::CalibAction::regular;
  /// For all of it; without it, what the protocol says.
  std::optional<std::chrono::milliseconds> timeout{};
  /// How often the board is asked for its state while it calibrates, if there is a `progress`.
  std::chrono::milliseconds interval{500};
  /// Called when the calibration has begun and after each look at it. False ends the waiting with
  /// ErrorCode::cancelled; the board goes on, the protocol has no way to stop it.
  std::function<bool(const CalibrationProgress&)> progress{};
};

namespace tasks {

/// Calibrates a sensor and waits for the end. The camera must not move for a gyroscope, and must be
/// level for an accelerometer. A board that restarts meanwhile is an error. An error says whether
/// the calibration had begun.
Task<Result<void>> calibrate(Sensor sensor, CalibrationOptions options = {});

}  // namespace tasks
}  // namespace sbgc
