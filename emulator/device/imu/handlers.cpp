// spec/imu.yaml: selection and correction of IMUs; attitudes as vectors.

#include "device/handlers.hpp"

#include <cmath>
#include <optional>

#include <sbgc/meta/enums.hpp>

#include "device/calibration/actions.hpp"
#include "device/realtime/custom_data.hpp"
#include "device/realtime/live_data.hpp"
#include "physics/attitude.hpp"

namespace sbgc::emulator {
namespace {

Reaction select_imu(RequestContext& context, Device& device, msg::SelectedImu imu) {
  const bool exists =
      imu == msg::SelectedImu::main || (imu == msg::SelectedImu::frame && device.has_frame_imu());
  if (!exists) return RequestContext::ignore();
  device.cur_imu = imu;
  return context.confirm();
}

bool has_external_imu(const Device& device) {
  return device.features_ext().has(msg::BoardFeaturesExtBit::ext_imu);
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
Reaction report_attitude(RequestContext& context, Device& device, Mode mode) {
  const bool of_frame = mode.has(Mode::flag_type::frame_imu);
  if (of_frame && !knows_frame(device, context.now))
    return context.refuse(msg::BoardErrorCode::not_supported);
  msg::AhrsHelper answer;
  measure(device, of_frame, context.now, answer);
  return context.answer(answer);
}

/// For the forms without vectors, which cannot set the attitude.
template <class Request>
Reaction report_attitude_only(RequestContext& context, Device& device, const Request& request) {
  using Bit = typename decltype(request.mode)::flag_type;
  if (request.mode.has(Bit::set)) {
    return context.refuse(msg::BoardErrorCode::wrong_params, request.mode.raw());
  }
  return report_attitude(context, device, request.mode);
}

/// Options of the form with a wide mode.
struct WideOptions {
  bool translates = false;  ///< one of the vectors
  bool disables = false;    ///< the correction
};

WideOptions wide_options(msg::AhrsHelperMode) { return {}; }
/// Assumption: translating one vector is like translating both, and the place of the sensor does
/// not matter.
WideOptions wide_options(msg::AhrsHelperWideMode mode) {
  using enum msg::AhrsHelperWideModeBit;
  return {mode.has(translate_z1_only) || mode.has(translate_h1_only), mode.has(disable_correction)};
}

template <class Request>
Reaction report_or_set_attitude(RequestContext& context, Device& device, const Request& request) {
  const auto mode = request.mode;
  using Bit = typename decltype(request.mode)::flag_type;
  if (!mode.has(Bit::set)) return report_attitude(context, device, mode);
  const WideOptions options = wide_options(mode);
  if (options.disables) return context.confirm();
  if (mode.has(Bit::z1_only) && mode.has(Bit::h1_only)) {
    return context.refuse(msg::BoardErrorCode::wrong_params, mode.raw());
  }
  Gimbal::Attitude attitude;
  attitude.of_frame = mode.has(Bit::frame_imu);
  attitude.reference_only = mode.has(Bit::reference_only);
  attitude.translates = (mode.has(Bit::translate) || options.translates) && knows_joints(device);
  if (!mode.has(Bit::h1_only)) {
    attitude.up = direction(request.z1_vector);
    if (!attitude.up) return context.refuse(msg::BoardErrorCode::wrong_params, mode.raw());
  }
  if (!mode.has(Bit::z1_only)) {
    attitude.north = direction(request.h1_vector);
    if (!attitude.north) return context.refuse(msg::BoardErrorCode::wrong_params, mode.raw());
  }
  device.gimbal.correct(attitude, context.now);
  return context.confirm();
}

}  // namespace

Reaction handle(RequestContext& context, const msg::SelectImu3& request, Device& device) {
  return select_imu(context, device, request.imu_type);
}
/// Ignores the other parameters, which are undocumented.
Reaction handle(RequestContext& context, const msg::SelectImu3Ext& request, Device& device) {
  return select_imu(context, device, request.imu_type);
}

/// Assumption: the gyroscope is calibrated, as its duration is a parameter.
Reaction handle(RequestContext& context, const msg::SelectImu3Calibrate& request, Device& device) {
  if (request.imu_type == msg::CalibImu::frame && !device.has_frame_imu()) {
    return RequestContext::ignore();
  }
  if (request.imu_type == msg::CalibImu::main) device.cur_imu = msg::SelectedImu::main;
  if (request.imu_type == msg::CalibImu::frame) device.cur_imu = msg::SelectedImu::frame;
  return calibrate_gyro(context, device, request.imu_type, request.action,
                        milliseconds(request.time_ms.raw()));
}

Reaction handle(RequestContext& context, const msg::SelectImu3CalibrateShort& request,
                Device& device) {
  return handle(
      context,
      msg::SelectImu3Calibrate{
          .imu_type = request.imu_type, .action = request.action, .time_ms = request.time_ms},
      device);
}

Reaction handle(RequestContext& context, const msg::AhrsHelperRequest& request, Device& device) {
  return report_attitude_only(context, device, request);
}
Reaction handle(RequestContext& context, const msg::AhrsHelperRequestWide& request,
                Device& device) {
  return report_attitude_only(context, device, request);
}
Reaction handle(RequestContext& context, const msg::AhrsHelperRequestExt& request, Device& device) {
  return report_or_set_attitude(context, device, request);
}
Reaction handle(RequestContext& context, const msg::AhrsHelperRequestExtWide& request,
                Device& device) {
  return report_or_set_attitude(context, device, request);
}

Reaction handle(RequestContext& context, const msg::GyroCorrection& request, Device& device) {
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

Reaction handle(RequestContext& context, const msg::ExtImuDebugInfoRequest&, Device& device) {
  if (!has_external_imu(device)) return context.refuse(msg::BoardErrorCode::not_supported);
  const Sample sample = device.gimbal.sample(context.now);
  const Rotation attitude = Pose(sample.angles, device.tuning().rotation_order).rotation();
  msg::ExtImuDebugInfo info;
  info.ahrs_debug_info = attitude_debug(device, context.now);
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t column = 0; column < 3; ++column) {
      info.dcm[3 * row + column] = static_cast<float>(attitude.rows[row][column]);
    }
    info.acc_body[row] = static_cast<float>(sample.acceleration[row]);
  }
  return context.answer(info);
}

/// The emulated external IMU has no protocol of its own: it repeats the command without data.
Reaction handle(RequestContext& context, const msg::ExtImuCmd& request, Device& device) {
  if (!has_external_imu(device)) {
    return context.refuse(msg::BoardErrorCode::not_supported);
  }
  msg::ExtImuCmd answer;
  answer.cmd_id = request.cmd_id;
  static_cast<void>(context.confirm());
  return context.answer(answer);
}

/// The emulated sensor answers queries without data and confirms all other commands.
Reaction handle(RequestContext& context, const msg::ExtSensCmdRequest& request, Device& device) {
  using enum msg::ExtSensCommand;
  if (!has_external_imu(device)) {
    return context.refuse(msg::BoardErrorCode::not_supported);
  }
  static_cast<void>(context.confirm());
  msg::ExtSensCmd answer;
  switch (request.cmd_id) {
    case get_device_info: answer.cmd_id = device_info; break;
    case get_data: answer.cmd_id = data; break;
    case get_user_conf_log: answer.cmd_id = user_conf_log; break;
    case reset: answer.cmd_id = reset_notify; break;
    default: answer.cmd_id = msg::ExtSensCommand::confirm; break;
  }
  return context.answer(answer);
}

}  // namespace sbgc::emulator
