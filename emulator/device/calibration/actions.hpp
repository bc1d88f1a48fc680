/// Operations on a sensor that requests of two families share.
#pragma once

#include <sbgc/enums.hpp>
#include <sbgc/time.hpp>

#include "device/calibration/calibration_parts.hpp"
#include "device/request_context.hpp"

namespace sbgc::emulator {

/// Executes an operation on the gyroscope of an IMU. A `length` of 0 is the usual duration.
Reaction calibrate_gyro(RequestContext& context, CalibrationParts& parts, msg::CalibImu which,
                        msg::CalibAction action, Duration length);

}  // namespace sbgc::emulator
