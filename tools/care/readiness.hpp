/// Checks of a gimbal before a calibration, with questions at the terminal.
#pragma once

#include <optional>
#include <vector>

#include <sbgc/client/client.hpp>
#include <sbgc/client/readiness.hpp>

namespace sbgc::tools {

/// Checks a gimbal before a calibration.
class ReadinessAtTerminal {
 public:
  struct Options {
    CalibrationConditions conditions{};
    bool of_frame = false;            ///< the IMU of the frame is calibrated
    std::optional<double> voltage{};  ///< of the battery, in volts
    bool can_ask = false;             ///< the user is at a terminal
    bool motors_off = false;          ///< turn the motors off
    bool checks = true;               ///< otherwise, nothing is checked
  };

  ReadinessAtTerminal(Client& client, const Options& options)
      : client_(client), options_(options) {}

  /// Throws CommandError that names the unmet condition. Asks the user about conditions that the
  /// board cannot report.
  void require();

 private:
  /// Returns only if the user answers yes.
  void ask(const Question& question) const;

  Client& client_;
  Options options_;
  std::vector<std::size_t> sides_{};  ///< that were up before
};

}  // namespace sbgc::tools
