/// The I2C buses of the board and the devices on them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <vector>

#include <sbgc/emulator/board_options.hpp>
#include <sbgc/enums.hpp>
#include <sbgc/time.hpp>

#include "device/storage/eeprom.hpp"

namespace sbgc::emulator {

/// The registers of the chips: two IMUs and a magnetometer on the sensor bus, the EEPROM on the
/// other one (assumption: real boards differ).
class I2cBus {
 public:
  static constexpr std::uint8_t main_imu = 0x68;
  static constexpr std::uint8_t frame_imu = 0x69;  ///< if the board has one
  static constexpr std::uint8_t magnetometer = 0x1E;
  static constexpr std::uint8_t eeprom = 0x50;  ///< on the second bus

  /// Returns nothing if no chip acknowledges the address. Register addresses increment and wrap
  /// after the last one.
  std::optional<std::vector<std::uint8_t>> read(const BoardOptions& options, const Eeprom& memory,
                                                Gimbal& gimbal, msg::I2cDevice chip,
                                                std::uint8_t address, std::size_t size,
                                                Instant now) const;
  /// Returns false if no chip acknowledges the address. Read-only registers keep their values.
  bool write(const BoardOptions& options, Eeprom& memory, msg::I2cDevice chip, std::uint8_t address,
             std::span<const std::uint8_t> data);

  /// The chips lose the values written by hosts.
  void power_off() { written_.clear(); }

 private:
  /// Register values written by hosts, keyed by device address and register.
  std::map<std::uint16_t, std::uint8_t> written_{};
};

}  // namespace sbgc::emulator
