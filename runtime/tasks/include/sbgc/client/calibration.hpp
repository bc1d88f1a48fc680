/// Calibration of sensors, encoders and motors.
///
/// A calibration replaces the stored one and can move the camera. Hold the camera as the
/// calibration requires, see MessageInfo::preparation of its request, and read docs/2-safety.md.
#pragma once

#include <chrono>
#include <functional>
#include <optional>
#include <string>

#include <sbgc/client/task.hpp>
#include <sbgc/messages/calibration.hpp>
#include <sbgc/responses/calibration.hpp>

namespace sbgc {

/// The sensor to calibrate.
enum class Sensor : std::uint8_t { accelerometer, gyroscope };

/// The progress of a calibration.
struct CalibrationProgress {
  bool has_started{};                     ///< the board has confirmed the start
  std::optional<msg::CalibInfo> state{};  ///< reported by the board, if it can
  std::chrono::milliseconds elapsed{};    ///< since the start of the task
};

/// Options of calibrate().
struct CalibrationOptions {
  /// The sensor board: that of the camera, that of the frame, or the one in use.
  msg::CalibImu imu = msg::CalibImu::active;
  /// Actions that only manage calibrations and restart the board end with their confirmation. All
  /// others are confirmed at the start and at the end.
  msg::CalibAction action = msg::CalibAction::regular;
  /// The timeout of the whole operation; by default, the one that the protocol specifies.
  std::optional<std::chrono::milliseconds> timeout{};
  /// The interval for polling the board's state during calibration; only if `progress` is set.
  std::chrono::milliseconds interval{500};
  /// Called when the calibration has started and after each poll. Returning false ends the wait
  /// with ErrorCode::cancelled, but the board continues: the protocol cannot stop a calibration.
  std::function<bool(const CalibrationProgress&)> progress{};
};

/// The end of a calibration without errors.
enum class CalibrationEnd : std::uint8_t {
  finished,  ///< the board has reported the end
  accepted,  ///< the board has accepted it, and does not report the end
};

/// The calibrated directions of the accelerometer, such as "+X, -Z", or "none".
std::string calibrated_positions(const msg::CalibInfo& state);
/// The missing positions; "" if all six are calibrated.
std::string missing_positions(const msg::CalibInfo& state);

namespace detail {

/// Sends the request of a calibration; returns the id of the call.
using StartCalibration = std::function<CallId(TaskMachine& task)>;

Task<Result<CalibrationEnd>> run_calibration(StartCalibration start, bool reports_end,
                                             CalibrationOptions options);

}  // namespace detail

namespace tasks {

/// Calibrates a sensor and waits until the calibration ends. The camera must be still for a
/// gyroscope, and level for an accelerometer. Fails if the board restarts meanwhile, and with
/// ErrorCode::unconfirmed if it does not confirm the start. The error says whether the calibration
/// had started. Errors: those of Client::call(), and `cancelled` by CalibrationOptions::progress.
Task<Result<void>> calibrate(Sensor sensor, CalibrationOptions options = {});

/// The same with the request of any calibration, such as msg::CalibPoles{} or msg::CalibBat{}.
/// `options.imu` and `options.action` only select what is polled for the progress; the request
/// selects the calibration. Errors: those of calibrate().
template <Message M>
Task<Result<CalibrationEnd>> run_calibration(M request, const CalibrationOptions& options = {}) {
  return detail::run_calibration(
      [request](TaskMachine& task) {
        CallOptions call;
        call.expect_confirmation = true;
        return task.begin(request, call);
      },
      response_policy(request).is_certain(), options);
}
/// The same with a request of calibrations(), see <sbgc/client/calibrations.hpp>. Errors: those of
/// calibrate(), and `invalid` if it is none of them.
Task<Result<CalibrationEnd>> run_calibration(AnyMessage request, CalibrationOptions options = {});

}  // namespace tasks
}  // namespace sbgc
