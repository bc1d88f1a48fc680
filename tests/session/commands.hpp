/// Command ids of the protocol, as listed in the specification.
#pragma once

#include <cstdint>

namespace commands {

inline constexpr std::uint8_t read_params_3 = 21;
inline constexpr std::uint8_t write_params_3 = 22;
inline constexpr std::uint8_t realtime_data_4 = 25;
inline constexpr std::uint8_t i2c_read = 40;
inline constexpr std::uint8_t eeprom_write = 47;
inline constexpr std::uint8_t eeprom_read = 48;
inline constexpr std::uint8_t read_file = 53;
inline constexpr std::uint8_t write_file = 54;
inline constexpr std::uint8_t control = 67;
inline constexpr std::uint8_t confirm = 67;
inline constexpr std::uint8_t motors_on = 77;
inline constexpr std::uint8_t motors_off = 109;
inline constexpr std::uint8_t stream_interval = 85;
inline constexpr std::uint8_t board_info = 86;
inline constexpr std::uint8_t realtime_data_custom = 88;
inline constexpr std::uint8_t calib_gyro = 103;
inline constexpr std::uint8_t reset = 114;
inline constexpr std::uint8_t error = 255;

}  // namespace commands
