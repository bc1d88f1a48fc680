/// Requests that choose and correct IMUs.
#include "device/device.hpp"
#include "device/handlers.hpp"

namespace sbgc::emulator {
namespace {

Outcome select(RequestContext& context, msg::SelectedImu imu) {
  const bool exists = imu == msg::SelectedImu::main ||
                      (imu == msg::SelectedImu::frame && context.device.has_frame_imu());
  if (!exists) return RequestContext::ignore();
  context.device.cur_imu = imu;
  return context.confirm();
}

double degrees_per_second(msg::GyroOffset offset) {
  return offset.gyro_units() * Device::gyro_unit();
}

}  // namespace

Outcome handle(RequestContext& context, const msg::SelectImu3& request) {
  return select(context, request.imu_type);
}
/// Its further parameters are not documented.
Outcome handle(RequestContext& context, const msg::SelectImu3Ext& request) {
  return select(context, request.imu_type);
}

Outcome handle(RequestContext& context, const msg::GyroCorrection& request) {
  Device& device = context.device;
  const bool of_frame = request.imu_type == msg::ImuIndex::frame;
  if (!of_frame && request.imu_type != msg::ImuIndex::main)
    return context.refuse(msg::BoardErrorCode::wrong_params);
  if (of_frame && !device.has_frame_imu())
    return context.refuse(msg::BoardErrorCode::not_supported);
  Vector offset;
  for (std::size_t i = 0; i < 3; ++i) {
    offset[i] = degrees_per_second(request.gyro_zero_corr[i]);
  }
  const std::size_t imu = of_frame ? 1 : 0;
  device.gyro_headings[imu] = degrees_per_second(request.gyro_zero_heading_corr);
  device.memory.imus[imu].gyro_offset = offset;
  ++device.memory.revision;
  device.correct_gyros(context.now);
  return context.confirm();
}

}  // namespace sbgc::emulator
