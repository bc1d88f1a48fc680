/// The calibrations that users can start, by name.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include <sbgc/any.hpp>
#include <sbgc/client/calibration.hpp>
#include <sbgc/client/client.hpp>
#include <sbgc/meta.hpp>

namespace sbgc::tools {

/// A request that starts a calibration.
struct CalibrationForm {
  using Run = std::function<Result<CalibrationEnd>(Client&, const AnyMessage& request,
                                                   const CalibrationOptions&)>;

  const MessageInfo* info{};
  Run run{};
  bool has_action{};  ///< what to do, and on which IMU
};

/// What a user calls a calibration, and its requests, the simplest first.
struct Calibration {
  std::string name{};
  std::vector<CalibrationForm> forms{};
  bool needs_values = false;  ///< without them, the request means nothing

  const MessageInfo& info() const { return *forms.front().info; }
};

const std::vector<Calibration>& calibrations();

}  // namespace sbgc::tools
