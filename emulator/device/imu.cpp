// spec/imu.yaml: selection and correction of IMUs; attitudes as vectors.

#include <cmath>
#include <optional>

#include <sbgc/meta/enums.hpp>

#include "device/device.hpp"
#include "device/handlers.hpp"
#include "device/parts/live_data.hpp"
#include "physics/attitude.hpp"

namespace sbgc::emulator {
namespace {

Outcome select_imu(RequestContext& context, msg::SelectedImu imu) {
  const bool exists = imu == msg::SelectedImu::main ||
                      (imu == msg::SelectedImu::frame && context.device.has_frame_imu());
  if (!exists) return RequestContext::ignore();
  context.device.cur_imu = imu;
  return context.confirm();
}

double degrees_per_second(msg::GyroOffset offset) {
  return offset.gyro_units() * Device::gyro_unit();
}

/// Returns nothing if the length is not close to 1.
std::optional<Vector> direction(const Xyz<float>& from) {
  const Vector vector{static_cast<double>(from.x), static_cast<double>(from.y),
                      static_cast<double>(from.z)};
  // Assumption: a unit vector may be off by rounding and sensor noise.
  constexpr double tolerance = 0.1;
  if (!(std::abs(std::sqrt(dot(vector, vector)) - 1) <= tolerance)) return {};
  return unit(vector);
}

template <class Mode>
Outcome report_attitude(RequestContext& context, Mode mode) {
  const bool of_frame = mode.has(Mode::flag_type::frame_imu);
  if (of_frame && !knows_frame(context.device, context.now))
    return context.refuse(msg::BoardErrorCode::not_supported);
  msg::AhrsHelper answer;
  measure(context.device, of_frame, context.now, answer);
  return context.answer(answer);
}

/// For the forms without vectors, which cannot set the attitude.
template <class Request>
Outcome report_attitude_only(RequestContext& context, const Request& request) {
  using Bit = typename decltype(request.mode)::flag_type;
  if (request.mode.has(Bit::set)) {
    return context.refuse(msg::BoardErrorCode::wrong_params, request.mode.raw());
  }
  return report_attitude(context, request.mode);
}

/// The mode bits that the simulation supports: those of the earlier form.
constexpr unsigned known_bits = [] {
  unsigned bits = 0;
  for (const ValueInfo& value : EnumMeta<msg::AhrsHelperModeBit>::info.values) {
    bits |= static_cast<unsigned>(value.value);
  }
  return bits;
}();

template <class Request>
Outcome report_or_set_attitude(RequestContext& context, const Request& request) {
  const auto mode = request.mode;
  using Bit = typename decltype(request.mode)::flag_type;
  if (!mode.has(Bit::set)) return report_attitude(context, mode);
  if ((mode.raw() & ~known_bits) != 0) {
    return context.refuse(msg::BoardErrorCode::not_supported, mode.raw());
  }
  if (mode.has(Bit::z1_only) && mode.has(Bit::h1_only)) {
    return context.refuse(msg::BoardErrorCode::wrong_params, mode.raw());
  }
  Gimbal::Attitude attitude;
  attitude.of_frame = mode.has(Bit::frame_imu);
  attitude.reference_only = mode.has(Bit::reference_only);
  attitude.translates = mode.has(Bit::translate) && knows_joints(context.device);
  if (!mode.has(Bit::h1_only)) {
    attitude.up = direction(request.z1_vector);
    if (!attitude.up) return context.refuse(msg::BoardErrorCode::wrong_params, mode.raw());
  }
  if (!mode.has(Bit::z1_only)) {
    attitude.north = direction(request.h1_vector);
    if (!attitude.north) return context.refuse(msg::BoardErrorCode::wrong_params, mode.raw());
  }
  context.device.gimbal.correct(attitude, context.now);
  return context.confirm();
}

}  // namespace

Outcome handle(RequestContext& context, const msg::SelectImu3& request) {
  return select_imu(context, request.imu_type);
}
/// Ignores the other parameters, which are undocumented.
Outcome handle(RequestContext& context, const msg::SelectImu3Ext& request) {
  return select_imu(context, request.imu_type);
}

Outcome handle(RequestContext& context, const msg::AhrsHelperRequest& request) {
  return report_attitude_only(context, request);
}
Outcome handle(RequestContext& context, const msg::AhrsHelperRequestWide& request) {
  return report_attitude_only(context, request);
}
Outcome handle(RequestContext& context, const msg::AhrsHelperRequestExt& request) {
  return report_or_set_attitude(context, request);
}
Outcome handle(RequestContext& context, const msg::AhrsHelperRequestExtWide& request) {
  return report_or_set_attitude(context, request);
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
