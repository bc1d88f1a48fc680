#include "device/device.hpp"

#include <cmath>
#include <utility>

#include "device/parameters/gimbal_tuning.hpp"

namespace sbgc::emulator {

Device::Device(BoardOptions of, Memory kept, Instant now)
    : options(std::move(of)),
      memory(std::move(kept)),
      eeprom(memory),
      parameters(memory, versions_of(options)),
      files(memory),
      gimbal(options.gimbal, now),
      ports(options),
      restarts(*this, now) {
  ports.on_sent = [this](std::size_t port, const Frame& frame) {
    debug_copies.copy(ports, measured.clock(ports.now), port, frame, true);
  };
}

void Device::apply_parameters(Instant now) {
  if (!restarts.is_listening() || !parameters.take_changes()) return;
  imus.has_frame = options.has_frame_imu && parameters.of<msg::ReadParams3>().frame_imu_pos !=
                                                msg::FrameImuPosition::disabled;
  if (!imus.has_frame) imus.selected = msg::SelectedImu::main;
  tuning = tuning_of(parameters, versions_of(options), has_encoders(options),
                     battery_factor(options, memory));
  for (std::size_t i = 0; i < tuning.axes.size(); ++i) {
    bool& follows = tuning.axes[i].follows;
    follows = (follows || modes.follows) && !modes.follow_off;
  }
  control_link.adjust(tuning);
  if (modes.is_writing_parameters) return;
  gimbal.tune(tuning, now);
  imus.correct(gimbal, memory, parameters, now);
  remote.apply(parameters, gimbal, now);
  slots.apply_parameters(parameters, now);
}

void Device::calibrate_at_start(Instant now) {
  const msg::SkipGyroCalibration skip = parameters.of<msg::ReadParams3>().skip_gyro_calib;
  if (skip == msg::SkipGyroCalibration::skip_always) return;
  const Sample sample = gimbal.sample(now);
  // Assumption: a sensor that turns faster than this, in deg/s, is moving.
  constexpr double still = 1;
  for (const bool of_frame : {false, true}) {
    const Vector& gyro = of_frame ? sample.frame_gyro : sample.gyro;
    const bool moves = std::hypot(gyro.x, gyro.y, gyro.z) > still;
    if (moves && skip == msg::SkipGyroCalibration::skip_if_moving) continue;
    gimbal.gyro_calibrated(of_frame, now);
    Vector& offset = memory.imus[of_frame ? 1 : 0].gyro_offset;
    if (offset != Vector{}) ++memory.revision;
    offset = {};
  }
}

}  // namespace sbgc::emulator
