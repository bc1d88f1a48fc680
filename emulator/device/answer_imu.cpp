/// Requests that choose and correct IMUs.
#include "device/handlers.hpp"
#include "device/device.hpp"

namespace sbgc::board {
namespace {

Outcome select(Turn& turn, msg::SelectedImu imu) {
  const bool exists = imu == msg::SelectedImu::main ||
                      (imu == msg::SelectedImu::frame && turn.machine.has_frame_imu());
  if (!exists) return Turn::ignore();
  turn.machine.cur_imu = imu;
  return turn.confirm();
}

double degrees_per_second(msg::GyroOffset offset) {
  return offset.gyro_units() * Machine::gyro_unit();
}

}  // namespace

Outcome handle(Turn& turn, const msg::SelectImu3& request) {
  return select(turn, request.imu_type);
}
/// Its further parameters are not documented.
Outcome handle(Turn& turn, const msg::SelectImu3Ext& request) {
  return select(turn, request.imu_type);
}

Outcome handle(Turn& turn, const msg::GyroCorrection& request) {
  Machine& machine = turn.machine;
  const bool of_frame = request.imu_type == msg::ImuIndex::frame;
  if (!of_frame && request.imu_type != msg::ImuIndex::main)
    return turn.refuse(msg::BoardErrorCode::wrong_params);
  if (of_frame && !machine.has_frame_imu()) return turn.refuse(msg::BoardErrorCode::not_supported);
  Vector offset;
  for (std::size_t i = 0; i < 3; ++i) {
    offset[i] = degrees_per_second(request.gyro_zero_corr[i]);
  }
  const std::size_t imu = of_frame ? 1 : 0;
  machine.gyro_headings[imu] = degrees_per_second(request.gyro_zero_heading_corr);
  machine.memory.imus[imu].gyro_offset = offset;
  ++machine.memory.revision;
  machine.correct_gyros(turn.now);
  return turn.confirm();
}

}  // namespace sbgc::board
