// spec/imu.yaml: selection and correction of IMUs; attitudes as vectors.

#include "device/handlers.hpp"

#include <cmath>
#include <optional>

#include <sbgc/meta/enums.hpp>

#include "device/calibration/calibrations.hpp"
#include "device/features.hpp"
#include "device/imu/imus.hpp"
#include "device/parameters/parameters.hpp"
#include "device/realtime/custom_data.hpp"
#include "device/realtime/live_data.hpp"
#include "physics/attitude.hpp"

namespace sbgc::emulator {
namespace {

bool has_external_imu(const BoardOptions& options) {
  return features_ext_of(options).has(msg::BoardFeaturesExtBit::ext_imu);
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
Reaction report_attitude(RequestContext& context, Gimbal& gimbal, const Imus& imus, Mode mode) {
  const bool of_frame = mode.has(Mode::flag_type::frame_imu);
  if (of_frame && !knows_frame(imus, gimbal, context.now))
    return context.refuse(msg::BoardErrorCode::not_supported);
  return context.answer(directions(gimbal, of_frame, context.now));
}

/// For the forms without vectors, which cannot set the attitude.
template <class Request>
Reaction report_attitude_only(RequestContext& context, Gimbal& gimbal, const Imus& imus,
                              const Request& request) {
  using Bit = typename decltype(request.mode)::flag_type;
  if (request.mode.has(Bit::set)) {
    return context.refuse(msg::BoardErrorCode::wrong_params, request.mode.raw());
  }
  return report_attitude(context, gimbal, imus, request.mode);
}

/// Options of the form with a wide mode.
struct WideOptions {
  bool translates = false;  ///< one of the vectors
  bool disables = false;    ///< the correction
};

WideOptions wide_options(msg::AhrsHelperMode) { return {}; }
/// Assumption: translating one vector is like translating both, and the position of the sensor does
/// not matter.
WideOptions wide_options(msg::AhrsHelperWideMode mode) {
  using enum msg::AhrsHelperWideModeBit;
  return {mode.has(translate_z1_only) || mode.has(translate_h1_only), mode.has(disable_correction)};
}

template <class Request>
Reaction report_or_set_attitude(RequestContext& context, Gimbal& gimbal, const Imus& imus,
                                const BoardOptions& options, const Request& request) {
  const auto mode = request.mode;
  using Bit = typename decltype(request.mode)::flag_type;
  if (!mode.has(Bit::set)) return report_attitude(context, gimbal, imus, mode);
  const WideOptions wide = wide_options(mode);
  if (wide.disables) return context.confirm();
  if (mode.has(Bit::z1_only) && mode.has(Bit::h1_only)) {
    return context.refuse(msg::BoardErrorCode::wrong_params, mode.raw());
  }
  Gimbal::Attitude attitude;
  attitude.of_frame = mode.has(Bit::frame_imu);
  attitude.reference_only = mode.has(Bit::reference_only);
  attitude.translates =
      (mode.has(Bit::translate) || wide.translates) && knows_joints(options, imus);
  if (!mode.has(Bit::h1_only)) {
    attitude.up = direction(request.z1_vector);
    if (!attitude.up) return context.refuse(msg::BoardErrorCode::wrong_params, mode.raw());
  }
  if (!mode.has(Bit::z1_only)) {
    attitude.north = direction(request.h1_vector);
    if (!attitude.north) return context.refuse(msg::BoardErrorCode::wrong_params, mode.raw());
  }
  gimbal.correct(attitude, context.now);
  return context.confirm();
}

}  // namespace

Reaction handle(RequestContext& context, const msg::SelectImu3& request, Imus& imus) {
  const bool exists = request.imu_type == msg::SelectedImu::main ||
                      (request.imu_type == msg::SelectedImu::frame && imus.has_frame);
  if (!exists) return RequestContext::ignore();
  imus.selected = request.imu_type;
  return context.confirm();
}
/// Assumption: the gyroscope is calibrated, as its duration is a parameter.
Reaction handle(RequestContext& context, const msg::SelectImu3Calibrate& request, Imus& imus,
                CalibrationParts& parts) {
  if (request.imu_type == msg::CalibImu::frame && !imus.has_frame) {
    return RequestContext::ignore();
  }
  if (request.imu_type == msg::CalibImu::main) imus.selected = msg::SelectedImu::main;
  if (request.imu_type == msg::CalibImu::frame) imus.selected = msg::SelectedImu::frame;
  return calibrate_gyro(context, parts, request.imu_type, request.action,
                        milliseconds(request.time_ms.raw()));
}

Reaction handle(RequestContext& context, const msg::AhrsHelperRequest& request, Gimbal& gimbal,
                const Imus& imus) {
  return report_attitude_only(context, gimbal, imus, request);
}
Reaction handle(RequestContext& context, const msg::AhrsHelperRequestWide& request, Gimbal& gimbal,
                const Imus& imus) {
  return report_attitude_only(context, gimbal, imus, request);
}
Reaction handle(RequestContext& context, const msg::AhrsHelperRequestExt& request, Gimbal& gimbal,
                const Imus& imus, const BoardOptions& options) {
  return report_or_set_attitude(context, gimbal, imus, options, request);
}
Reaction handle(RequestContext& context, const msg::AhrsHelperRequestExtWide& request,
                Gimbal& gimbal, const Imus& imus, const BoardOptions& options) {
  return report_or_set_attitude(context, gimbal, imus, options, request);
}

Reaction handle(RequestContext& context, const msg::GyroCorrection& request, Imus& imus,
                Memory& memory, Gimbal& gimbal, const Parameters& parameters) {
  const bool of_frame = request.imu_type == msg::ImuIndex::frame;
  if (!of_frame && request.imu_type != msg::ImuIndex::main)
    return context.refuse(msg::BoardErrorCode::wrong_params);
  if (of_frame && !imus.has_frame) return context.refuse(msg::BoardErrorCode::not_supported);
  Vector offset;
  for (std::size_t i = 0; i < 3; ++i) {
    offset[i] = degrees_per_second(request.gyro_zero_corr[i]);
  }
  const std::size_t imu = of_frame ? 1 : 0;
  imus.headings[imu] = degrees_per_second(request.gyro_zero_heading_corr);
  memory.imus[imu].gyro_offset = offset;
  ++memory.revision;
  imus.correct(gimbal, memory, parameters, context.now);
  return context.confirm();
}

Reaction handle(RequestContext& context, const msg::ExtImuDebugInfoRequest&,
                const BoardOptions& options, Gimbal& gimbal, const Imus& imus,
                const Parameters& parameters, const Tuning& tuning) {
  if (!has_external_imu(options)) return context.refuse(msg::BoardErrorCode::not_supported);
  const Sample sample = gimbal.sample(context.now);
  const Rotation attitude = Pose(sample.angles, tuning.rotation_order).rotation();
  msg::ExtImuDebugInfo info;
  info.ahrs_debug_info = attitude_debug(sample, imus, parameters);
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t column = 0; column < 3; ++column) {
      info.dcm[3 * row + column] = static_cast<float>(attitude.rows[row][column]);
    }
    info.acc_body[row] = static_cast<float>(sample.acceleration[row]);
  }
  return context.answer(info);
}

/// The emulated external IMU has no protocol: it repeats the command without data.
Reaction handle(RequestContext& context, const msg::ExtImuCmd& request,
                const BoardOptions& options) {
  if (!has_external_imu(options)) return context.refuse(msg::BoardErrorCode::not_supported);
  msg::ExtImuCmd answer;
  answer.cmd_id = request.cmd_id;
  static_cast<void>(context.confirm());
  return context.answer(answer);
}

/// The emulated sensor answers queries without data and confirms all other commands.
Reaction handle(RequestContext& context, const msg::ExtSensCmdRequest& request,
                const BoardOptions& options) {
  using enum msg::ExtSensCommand;
  if (!has_external_imu(options)) return context.refuse(msg::BoardErrorCode::not_supported);
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
