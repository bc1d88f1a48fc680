#include "device/peripherals/i2c_bus.hpp"

#include <algorithm>
#include <optional>

#include "physics/quantities.hpp"

namespace sbgc::emulator {
namespace {

using Bus = I2cBus;

/// Sets a register of 16 bits, whose high byte is first. `value` saturates, as in a sensor.
void put(std::span<std::uint8_t> registers, std::size_t address, double value) {
  const auto bits = static_cast<std::uint16_t>(saturated_raw<std::int16_t>(value));
  registers[address] = static_cast<std::uint8_t>(bits >> 8U);
  registers[address + 1] = static_cast<std::uint8_t>(bits);
}

/// An IMU like the MPU-6050, with the ranges of the board: 16 g and 2000 deg/s.
namespace mpu {
constexpr std::size_t size = 128;
constexpr std::size_t gyro_config = 0x1B, acc_config = 0x1C, full_range = 0x18;
constexpr std::size_t first_measured = 0x3B, acc = 0x3B, temperature = 0x41, gyro = 0x43;
constexpr std::size_t last_measured = 0x48;
constexpr std::size_t identity = 0x75;
constexpr double per_g = 2048, per_degree_per_second = 16.4;
}  // namespace mpu

/// A magnetometer like the HMC5883L, in a field of 0.5 gauss.
namespace hmc {
constexpr std::size_t size = 13;
constexpr std::size_t measured = 3, status = 9, identity = 10;
constexpr double per_field = 545;
}  // namespace hmc

bool is_imu(std::uint8_t address) { return address == Bus::main_imu || address == Bus::frame_imu; }
bool is_eeprom(msg::I2cDevice chip) { return chip.port() == msg::I2cPort::second; }
std::size_t registers_of(std::uint8_t address) { return is_imu(address) ? mpu::size : hmc::size; }

bool can_be_written(std::uint8_t address, std::size_t reg) {
  if (is_imu(address)) {
    const bool is_measured = reg >= mpu::first_measured && reg <= mpu::last_measured;
    // Hosts cannot change the ranges, because the board measures with them.
    return !is_measured && reg != mpu::gyro_config && reg != mpu::acc_config &&
           reg != mpu::identity;
  }
  return reg < hmc::measured;
}

/// Returns all registers, without values written by hosts.
std::vector<std::uint8_t> measured(Gimbal& gimbal, std::uint8_t address, Instant now) {
  const Sample sample = gimbal.sample(now);
  std::vector<std::uint8_t> registers(registers_of(address));
  if (is_imu(address)) {
    const bool is_main = address == Bus::main_imu;
    const Vector& acceleration = is_main ? sample.acceleration : sample.frame_acceleration;
    const Vector& gyro = is_main ? sample.gyro : sample.frame_gyro;
    registers[mpu::gyro_config] = registers[mpu::acc_config] = mpu::full_range;
    for (std::size_t i = 0; i < 3; ++i) {
      put(registers, mpu::acc + std::size_t{2} * i, acceleration[i] * mpu::per_g);
      put(registers, mpu::gyro + 2 * i, gyro[i] * mpu::per_degree_per_second);
    }
    const double celsius = is_main ? sample.temperature : sample.frame_temperature;
    put(registers, mpu::temperature, (celsius - 36.53) * 340);
    registers[mpu::identity] = Bus::main_imu;  // both IMUs have this identity
  } else {
    // In the order X, Z, Y.
    put(registers, hmc::measured, sample.magnetic.x * hmc::per_field);
    put(registers, hmc::measured + 2, sample.magnetic.z * hmc::per_field);
    put(registers, hmc::measured + 4, sample.magnetic.y * hmc::per_field);
    registers[0] = 0x10;
    registers[1] = 0x20;
    registers[hmc::status] = 1;
    registers[hmc::identity] = 'H';
    registers[hmc::identity + 1] = '4';
    registers[hmc::identity + 2] = '3';
  }
  return registers;
}

/// True if a chip acknowledges this address.
bool answers(const BoardOptions& options, msg::I2cDevice chip) {
  const std::uint8_t address = chip.address();
  if (is_eeprom(chip)) return address == Bus::eeprom;
  return address == Bus::main_imu || address == Bus::magnetometer ||
         (address == Bus::frame_imu && options.has_frame_imu);
}

std::uint16_t key(std::uint8_t address, std::size_t reg) {
  return static_cast<std::uint16_t>(std::size_t{address} * 256 + reg);
}

/// Returns the EEPROM address of a register. Assumption: REG_ADDR is the high byte of the address,
/// so hosts can address blocks of 256 bytes.
std::size_t eeprom_address(const Eeprom& memory, std::uint8_t reg) {
  return reg * std::size_t{256} % memory.size();
}

}  // namespace

std::optional<std::vector<std::uint8_t>> I2cBus::read(const BoardOptions& options,
                                                      const Eeprom& memory, Gimbal& gimbal,
                                                      msg::I2cDevice chip, std::uint8_t address,
                                                      std::size_t size, Instant now) const {
  if (!answers(options, chip)) return {};
  std::vector<std::uint8_t> result;
  result.reserve(size);
  if (is_eeprom(chip)) {
    const std::size_t begin = eeprom_address(memory, address);
    for (std::size_t i = 0; i < size; ++i) {
      result.push_back(memory.bytes((begin + i) % memory.size(), 1).front());
    }
    return result;
  }
  const auto registers = measured(gimbal, chip.address(), now);
  for (std::size_t i = 0; i < size; ++i) {
    const std::size_t reg = (address + i) % registers.size();
    const auto written = written_.find(key(chip.address(), reg));
    result.push_back(written != written_.end() ? written->second : registers[reg]);
  }
  return result;
}

bool I2cBus::write(const BoardOptions& options, Eeprom& memory, msg::I2cDevice chip,
                   std::uint8_t address, std::span<const std::uint8_t> data) {
  if (!answers(options, chip)) return false;
  if (is_eeprom(chip)) {
    const std::size_t begin = eeprom_address(memory, address);
    const std::size_t before_end = std::min(data.size(), memory.size() - begin);
    if (before_end != 0) memory.write(begin, data.first(before_end));
    if (before_end != data.size()) memory.write(0, data.subspan(before_end));
    return true;
  }
  for (std::size_t i = 0; i < data.size(); ++i) {
    const std::size_t reg = (address + i) % registers_of(chip.address());
    if (can_be_written(chip.address(), reg)) written_[key(chip.address(), reg)] = data[i];
  }
  return true;
}

}  // namespace sbgc::emulator
