/// The modules on the board's CAN bus.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <sbgc/emulator/board_options.hpp>
#include <sbgc/messages/modules.hpp>
#include <sbgc/messages/realtime.hpp>
#include <sbgc/time.hpp>

namespace sbgc::emulator {

class ExternalMotors;
class Gimbal;

/// A module: IMUs of the camera and, if the board has one, of the frame, and a driver for each
/// external motor. Assumption: a board with a CAN bus has all of them there.
struct Module {
  msg::ModuleId id{};
  msg::CanDeviceId can_id{};
  msg::CanDeviceKind kind{};
  msg::TransparentDevice transparent{};  ///< 0: unreachable by CMD_TRANSPARENT_SAPI
  std::uint16_t firmware{};
};

/// The number of drivers.
std::size_t can_drivers(const BoardOptions& options);
std::vector<Module> modules_of(const BoardOptions& options);

/// Live data of a driver. Precondition: it exists.
msg::CanDrvTelemetry telemetry(const BoardOptions& options, ExternalMotors& external_motors,
                               Gimbal& gimbal, std::size_t driver, msg::CanDrvTelemetryFlags fields,
                               msg::MillisecondClock time, Instant now);

}  // namespace sbgc::emulator
