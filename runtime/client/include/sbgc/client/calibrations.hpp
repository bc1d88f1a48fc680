/// The calibrations that users can start, by name.
#pragma once

#include <vector>

#include <sbgc/meta.hpp>

namespace sbgc {

/// A request that starts a calibration.
struct CalibrationForm {
  const MessageInfo* info{};
  bool has_action{};  ///< what to do, and on which IMU
};

/// What a user calls a calibration, and its requests, the simplest first.
struct Calibration {
  const char* name = "";
  std::vector<CalibrationForm> forms{};
  bool needs_values = false;  ///< without them, the request means nothing

  const MessageInfo& info() const { return *forms.front().info; }
};

/// All calibrations, by name.
const std::vector<Calibration>& calibrations();

}  // namespace sbgc
