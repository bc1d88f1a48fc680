/// Requests that move the camera, for tests.
#pragma once

#include <cstdint>

#include <sbgc/messages/control.hpp>

namespace sbgc::test {

/// Returns a request that moves only pitch.
inline msg::ControlExt one_axis(msg::ControlModeKind mode, std::int16_t speed, std::int16_t angle) {
  msg::ControlExt request;
  request.control_mode.pitch.set_mode(mode);
  request.axes.pitch = {msg::ControlSpeed(speed), msg::Angle14(angle)};
  return request;
}

}  // namespace sbgc::test
