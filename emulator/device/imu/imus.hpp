/// The IMUs that the board uses, and corrections of their gyroscopes.
#pragma once

#include <array>
#include <cstddef>

#include <sbgc/emulator/gimbal.hpp>
#include <sbgc/enums.hpp>
#include <sbgc/time.hpp>

#include "device/parameters/parameters.hpp"

namespace sbgc::emulator {

struct Imus {
  bool has_frame = false;  ///< there is one on the frame and the parameters use it
  msg::SelectedImu selected = msg::SelectedImu::main;  ///< chosen by hosts
  /// Heading corrections of the main and frame IMU, deg/s, in addition to GYRO_HEADING_CORRECTION.
  /// Assumption: valid until the board restarts.
  std::array<double, 2> headings{};

  /// The index of the selected IMU in Memory::imus.
  std::size_t selected_index() const { return selected == msg::SelectedImu::frame ? 1 : 0; }
  /// Passes the gyroscope corrections to the gimbal. Call it after each change.
  void correct(Gimbal& gimbal, const Memory& memory, const Parameters& parameters,
               Instant now) const;
};

/// A gyroscope offset in deg/s. Assumption: its unit is that of the readings.
double degrees_per_second(msg::GyroOffset offset);

}  // namespace sbgc::emulator
