/// Whether a gimbal is as a calibration expects it.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <sbgc/client/calibrations.hpp>
#include <sbgc/client/question.hpp>

namespace sbgc {

/// Options of check_readiness().
struct ReadinessOptions {
  CalibrationConditions conditions{};  ///< what to check
  bool of_frame = false;               ///< the IMU of the frame is calibrated
  std::optional<double> voltage{};     ///< of the battery, in volts
  std::vector<std::size_t> sides{};    ///< of the sensor that were up before
  AskHandler ask{};                    ///< for what only a person can tell
};

/// The result of check_readiness().
struct Readiness {
  std::string problem{};        ///< a clause that says what is not as it should be; "" if nothing
  bool is_motion_known = true;  ///< false for a frame whose sensor does not say how it moves
  std::optional<std::size_t> side{};  ///< of the sensor that is up, if the conditions want one
};

namespace tasks {

/// Checks what the board can tell of the conditions of a calibration. If the motors must be off, it
/// turns them off after asking, and changes nothing else. Ends at the first problem.
/// Errors: those of Client::call(); a condition that does not hold is none.
Task<Result<Readiness>> check_readiness(ReadinessOptions options);

}  // namespace tasks
}  // namespace sbgc
