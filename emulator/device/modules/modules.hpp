/// The modules on the board's CAN bus, and new firmware for them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include <sbgc/emulator/board_options.hpp>
#include <sbgc/messages/modules.hpp>
#include <sbgc/messages/realtime.hpp>
#include <sbgc/time.hpp>

namespace sbgc::emulator {

class ExternalMotors;
class Gimbal;

/// A module: an IMU of the camera or, if the board has one, of the frame, or a driver for an
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

/// CMD_MODULE_FLASH_*: accepts the parts of a file in order, for one module at a time. A module has
/// no firmware from the beginning of an update until its end. A restart of the board discards the
/// update. Assumption: the reasons of refusals.
class ModuleFlash {
 public:
  using Firmware = std::vector<std::uint8_t>;

  /// Each returns false, without effect, for invalid requests.
  bool start(const msg::ModuleFlashStart& request);
  bool write(const msg::ModuleFlashWrite& request);
  bool finish(const msg::ModuleFlashFinish& request);
  /// The number of the next part, modulo 256.
  std::uint8_t next_packet() const { return run_ ? run_->packet : std::uint8_t{0}; }

  /// The firmware that was loaded into a module; empty during or after an incomplete update.
  /// Nothing for a module with its first firmware.
  const std::map<msg::ModuleId, Firmware>& firmware() const { return firmware_; }

  Instant next() const { return Instant::never; }
  void advance(Instant /*now*/) {}
  void restart(Instant /*now*/) { run_.reset(); }

 private:
  struct Run {
    msg::ModuleId module{};
    std::size_t size{};
    std::uint8_t packet{};
    Firmware data{};
  };

  std::optional<Run> run_{};
  std::map<msg::ModuleId, Firmware> firmware_{};
};

}  // namespace sbgc::emulator
