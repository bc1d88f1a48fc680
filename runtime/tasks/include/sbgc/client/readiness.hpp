/// Checks that a gimbal is ready for a calibration.
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
  AskHandler ask{};                    ///< for questions that only a person can answer
};

/// The result of check_readiness().
struct Readiness {
  std::string problem{};              ///< a clause that describes the problem, or ""
  bool is_motion_known = true;        ///< false for a frame whose sensor does not report its motion
  std::optional<std::size_t> side{};  ///< of the sensor that is up, if the conditions want one
};

namespace tasks {

/// Checks the conditions of a calibration as far as the board can report them. If the motors must
/// be off, it turns them off after asking, and changes nothing else. Ends at the first problem.
/// Errors: those of Client::call(); an unmet condition is not an error.
Task<Result<Readiness>> check_readiness(ReadinessOptions options);

}  // namespace tasks
}  // namespace sbgc
