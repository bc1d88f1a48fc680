#include "serving/new_memory.hpp"

#include <cstdint>

#include <sbgc/meta/enums.hpp>

namespace sbgc::serving {

emulator::Memory new_memory(const emulator::BoardOptions& board) {
  emulator::Memory memory;
  if (board.faults.errors.has(msg::SystemError::calib_acc)) return memory;
  for (emulator::ImuCalibration& imu : memory.imus) {
    for (const ValueInfo& position : EnumMeta<msg::CalibratedLimit>::info.values) {
      imu.acc_limits |= static_cast<std::uint8_t>(position.value);
    }
  }
  return memory;
}

}  // namespace sbgc::serving
