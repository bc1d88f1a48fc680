/// Calibration of the sensors.
///
/// A calibration replaces the stored one and can move the camera. Hold the camera as the
/// calibration of the sensor requires, and see docs/2-safety.md.
#pragma once

#include <chrono>
#include <functional>
#include <optional>

#include <sbgc/client/task.hpp>
#include <sbgc/messages/calibration.hpp>

namespace sbgc {

/// The sensor to calibrate.
enum class Sensor : std::uint8_t { accelerometer, gyroscope };

/// The progress of a calibration.
struct CalibrationProgress {
  bool has_started{};                     ///< the board has confirmed the start
  std::optional<msg::CalibInfo> state{};  ///< reported by the board, if it can
  std::chrono::milliseconds elapsed{};
};

/// Options of calibrate().
struct CalibrationOptions {
  msg::CalibImu imu = msg::CalibImu::active;
  /// Actions that only manage calibrations and restart the board end with their confirmation. All
  /// others are confirmed at the start and at the end.
  msg::CalibAction action = msg::CalibAction::regular;
  /// For the whole operation; by default, the timeout that the protocol specifies.
  std::optional<std::chrono::milliseconds> timeout{};
  /// How often to poll the state of the board during calibration; only if `progress` is set.
  std::chrono::milliseconds interval{500};
  /// Called when the calibration has started and after each poll. Returning false ends the wait
  /// with ErrorCode::cancelled, but the board continues: the protocol cannot stop a calibration.
  std::function<bool(const CalibrationProgress&)> progress{};
};

namespace tasks {

/// Calibrates a sensor and waits until the calibration ends. The camera must be still for a
/// gyroscope, and level for an accelerometer. Fails if the board restarts meanwhile. The error says
/// whether the calibration had started.
Task<Result<void>> calibrate(Sensor sensor, CalibrationOptions options = {});

}  // namespace tasks
}  // namespace sbgc
