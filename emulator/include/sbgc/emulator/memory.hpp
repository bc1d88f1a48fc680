/// The nonvolatile memory of an emulated board.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <sbgc/types.hpp>

namespace sbgc::emulator {

/// The calibration of one IMU.
struct ImuCalibration {
  bool gyro_is_calibrated = true;
  std::uint8_t acc_limits = 0;  ///< calibrated directions; see CalibratedLimits
  bool gyro_temperature_enabled = false, acc_temperature_enabled = false;
  std::int8_t gyro_temperature_min = 0, gyro_temperature_max = 0;
  std::int8_t acc_temperature_min = 0, acc_temperature_max = 0;
  std::array<std::uint8_t, 6> acc_slots{};  ///< calibrated temperatures of +X, +Y, +Z, -X, -Y, -Z
  Xyz<double> gyro_offset{};                ///< deg/s, a manual correction

  bool operator==(const ImuCalibration&) const = default;
};

/// All persistent data of the board. As on a real board, parameters, names, user data and files are
/// in the EEPROM: writing to it changes them, but the active ones change only at the next start.
struct Memory {
  static constexpr std::size_t eeprom_size = 32768;  ///< bytes

  std::vector<std::uint8_t> eeprom = std::vector<std::uint8_t>(eeprom_size, 0xFF);
  std::array<ImuCalibration, 2> imus{};     ///< main, frame; in the main EEPROM of a real board
  std::array<ImuCalibration, 2> sensors{};  ///< factory calibrations, in the EEPROM of each sensor
  double battery_factor = 1;                ///< calibration of the voltage measurement
  std::uint8_t profile = 0;                 ///< the active one
  static constexpr std::size_t profile_set_slots = 6;  ///< the last one is the backup
  /// The parameters of all profiles in each slot; empty slots have no bytes.
  std::array<std::vector<std::uint8_t>, profile_set_slots> profile_sets{};
  std::uint8_t profile_set = 1;                 ///< the selected slot, counted from 1
  std::vector<std::uint8_t> state_variables{};  ///< body of CMD_READ_STATE_VARS; empty: none
  std::uint32_t pass_protect = 0;               ///< flags of CMD_PASS_PROTECT_WRITE
  std::uint32_t revision = 0;                   ///< grows with each change; not saved
  /// True if there may be unsaved changes; rewriting the same bytes then counts as a change. Only
  /// used with BoardOptions::waits_for_saving; not saved.
  bool is_unsaved = false;

  bool operator==(const Memory&) const = default;
};

}  // namespace sbgc::emulator
