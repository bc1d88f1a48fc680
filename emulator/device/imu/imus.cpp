#include "device/imu/imus.hpp"

#include <cstdint>

namespace sbgc::emulator {

double degrees_per_second(msg::GyroOffset offset) {
  return offset.gyro_units() * msg::GyroRate(1).degrees_per_second();
}

void Imus::correct(Gimbal& gimbal, const Memory& memory, const Parameters& parameters,
                   Instant now) const {
  const auto variable = parameters.variable(msg::VariableId::gyro_heading_correction);
  const double more =
      degrees_per_second(msg::GyroOffset(static_cast<std::int16_t>(variable.value_or(0))));
  for (const std::size_t imu : {0U, 1U}) {
    const double heading = headings[imu] + (imu == 0 ? more : 0);
    gimbal.correct_gyro(imu == 1, memory.imus[imu].gyro_offset, heading, now);
  }
}

}  // namespace sbgc::emulator
