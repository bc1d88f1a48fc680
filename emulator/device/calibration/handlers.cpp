// spec/calibration.yaml: calibration and tuning.

#include "device/handlers.hpp"

#include <algorithm>
#include <array>
#include <optional>

#include <sbgc/meta/calibration.hpp>
#include <sbgc/meta/enums.hpp>
#include <sbgc/parameters.hpp>
#include <sbgc/validate.hpp>

#include "device/calibration/auto_tuning.hpp"
#include "device/calibration/calibrations.hpp"
#include "device/calibration/frequency_response.hpp"
#include "device/features.hpp"
#include "device/imu/imus.hpp"
#include "device/parameters/parameters.hpp"
#include "device/system/restarts.hpp"

namespace sbgc::emulator {
namespace {

using Kind = Calibrations::Kind;

/// Returns the index of an IMU in Memory::imus; nothing if the board does not have it.
std::optional<std::size_t> index_of(const Imus& imus, msg::CalibImu imu) {
  switch (imu) {
    case msg::CalibImu::active: return imus.selected_index();
    case msg::CalibImu::main: return 0;
    case msg::CalibImu::frame: break;
    default: return {};
  }
  return imus.has_frame ? std::optional<std::size_t>(1) : std::nullopt;
}

/// Starts a calibration that is confirmed on reception and, if `confirms_end`, again at its end.
Reaction begin(RequestContext& context, CalibrationParts& parts, Kind kind, std::size_t imu,
               bool confirms_end, Duration length = {}) {
  std::optional<Calibrations::Requester> requester;
  if (confirms_end) requester = Calibrations::Requester{context.port, context.command};
  if (!parts.calibrations.start(parts, kind, imu, requester, context.now, length)) {
    return context.refuse(msg::BoardErrorCode::wrong_state);
  }
  return context.confirm();
}

/// Starts a calibration that is confirmed only at its end.
Reaction begin_silently(RequestContext& context, CalibrationParts& parts, Kind kind) {
  const Calibrations::Requester requester{context.port, context.command};
  const bool starts = parts.calibrations.start(parts, kind, 0, requester, context.now);
  return starts ? Reaction::executed : context.refuse(msg::BoardErrorCode::wrong_state);
}

Reaction restart(RequestContext& context, CalibrationParts& parts) {
  ++parts.memory.revision;
  const Reaction reaction = context.confirm();
  parts.restarts.announce(parts.ports, context.now);
  return reaction;
}

/// The actions of CMD_CALIB_ACC and CMD_CALIB_GYRO on one sensor of an IMU.
struct Sensor {
  Kind regular, temperature, from_sensor, to_sensor;
  void (*forget)(ImuCalibration& imu);
  /// Enables or disables the temperature calibration, if there is one.
  void (*use_temperature)(ImuCalibration& imu, bool used);
};

/// The options of CMD_AUTO_PID that correspond to a later configuration; nothing if it enables no
/// axis. Assumption: later firmware tunes in the same way.
std::optional<msg::AutoPidFlags> tuning_flags(const msg::AutoPid2Config& config) {
  constexpr std::array axis_flags{msg::AutoPidFlag::roll, msg::AutoPidFlag::pitch,
                                  msg::AutoPidFlag::yaw};
  msg::AutoPidFlags flags;
  bool has_axis = false;
  for (std::size_t axis = 0; axis < axis_flags.size(); ++axis) {
    const msg::AxisTuningOptions options = config.axes[axis].axis_flags;
    if (!options.enabled()) continue;
    has_axis = true;
    flags.set(axis_flags[axis]);
    if (options.tune_lpf()) flags.set(msg::AutoPidFlag::tune_lpf_freq);
  }
  if (!has_axis) return {};
  if (config.general_flags.has(msg::AutoPid2Flag::start_from_current)) {
    flags.set(msg::AutoPidFlag::keep_current);
  }
  if (config.general_flags.has(msg::AutoPid2Flag::all_profiles)) {
    flags.set(msg::AutoPidFlag::all_profiles);
  }
  return flags;
}

constexpr Sensor gyro{Kind::gyro,
                      Kind::gyro_temperature,
                      Kind::gyro_from_sensor,
                      Kind::gyro_to_sensor,
                      [](ImuCalibration& imu) {
                        imu.gyro_is_calibrated = imu.gyro_temperature_enabled = false;
                        imu.gyro_temperature_min = imu.gyro_temperature_max = 0;
                        imu.gyro_offset = {};
                      },
                      [](ImuCalibration& imu, bool used) {
                        // Assumption: a range of 0 to 0 degrees means that there is none.
                        const bool exists =
                            imu.gyro_temperature_min != 0 || imu.gyro_temperature_max != 0;
                        imu.gyro_temperature_enabled = used && exists;
                      }};

constexpr Sensor acc{Kind::acc,
                     Kind::acc_temperature,
                     Kind::acc_from_sensor,
                     Kind::acc_to_sensor,
                     [](ImuCalibration& imu) {
                       imu.acc_limits = 0;
                       imu.acc_temperature_enabled = false;
                       imu.acc_temperature_min = imu.acc_temperature_max = 0;
                       imu.acc_slots = {};
                     },
                     [](ImuCalibration& imu, bool used) {
                       const bool exists =
                           std::any_of(imu.acc_slots.begin(), imu.acc_slots.end(),
                                       [](std::uint8_t slots) { return slots != 0; });
                       imu.acc_temperature_enabled = used && exists;
                     }};

Reaction carry_out(RequestContext& context, CalibrationParts& parts, const Sensor& sensor,
                   msg::CalibImu which, msg::CalibAction action, Duration length = {}) {
  const auto imu = index_of(parts.imus, which);
  if (!imu) return RequestContext::ignore();
  ImuCalibration& memory = parts.memory.imus[*imu];
  const bool changes_at_once = action == msg::CalibAction::reset ||
                               action == msg::CalibAction::enable_temperature ||
                               action == msg::CalibAction::disable_temperature;
  if (changes_at_once && parts.calibrations.under_way()) {
    return context.refuse(msg::BoardErrorCode::wrong_state);
  }
  switch (action) {
    case msg::CalibAction::regular:
      return begin(context, parts, sensor.regular, *imu, true, length);
    case msg::CalibAction::temperature:
      return begin(context, parts, sensor.temperature, *imu, true);
    case msg::CalibAction::restore_factory:
      return begin(context, parts, sensor.from_sensor, *imu, true);
    case msg::CalibAction::store_in_sensor:
      return begin(context, parts, sensor.to_sensor, *imu, true);
    case msg::CalibAction::reset: sensor.forget(memory); return restart(context, parts);
    case msg::CalibAction::enable_temperature:
      sensor.use_temperature(memory, true);
      return restart(context, parts);
    case msg::CalibAction::disable_temperature:
      sensor.use_temperature(memory, false);
      return restart(context, parts);
    default: return RequestContext::ignore();
  }
}

}  // namespace

Reaction handle(RequestContext& context, const msg::CalibAccExt& request, CalibrationParts& parts) {
  return carry_out(context, parts, acc, request.imu_idx, request.action);
}
Reaction handle(RequestContext& context, const msg::CalibGyroExt& request,
                CalibrationParts& parts) {
  return carry_out(context, parts, gyro, request.imu_idx, request.action,
                   milliseconds(request.time_ms.raw()));
}

/// Assumption: a magnetometer has no temperature calibration and no own memory.
Reaction handle(RequestContext& context, const msg::CalibMagExt& request, CalibrationParts& parts) {
  const auto imu = index_of(parts.imus, request.imu_idx);
  if (!imu) return RequestContext::ignore();
  switch (request.action) {
    case msg::CalibAction::regular: return begin(context, parts, Kind::mag, *imu, false);
    case msg::CalibAction::reset:
    case msg::CalibAction::enable_temperature:
    case msg::CalibAction::disable_temperature:
      if (parts.calibrations.under_way()) {
        return context.refuse(msg::BoardErrorCode::wrong_state);
      }
      return restart(context, parts);
    case msg::CalibAction::temperature:
    case msg::CalibAction::restore_factory:
    case msg::CalibAction::store_in_sensor:
      return context.refuse(msg::BoardErrorCode::not_supported);
    default: return RequestContext::ignore();
  }
}
Reaction handle(RequestContext& context, const msg::CalibExtGain&, CalibrationParts& parts) {
  return begin_silently(context, parts, Kind::ext_gain);
}
Reaction handle(RequestContext& context, const msg::CalibPoles&, CalibrationParts& parts) {
  return begin_silently(context, parts, Kind::poles);
}

Reaction handle(RequestContext& context, const msg::CalibOrientCorr&, CalibrationParts& parts) {
  return begin_silently(context, parts, Kind::orientation);
}
Reaction handle(RequestContext& context, const msg::CalibCogging& request,
                CalibrationParts& parts) {
  if (!is_valid(request)) return context.refuse(msg::BoardErrorCode::wrong_params);
  switch (request.action) {
    case msg::CoggingAction::calibrate: return begin_silently(context, parts, Kind::cogging);
    case msg::CoggingAction::erase: return context.confirm();
    default: return context.refuse(msg::BoardErrorCode::wrong_params);
  }
}
Reaction handle(RequestContext& context, const msg::CalibAccExtRef&, CalibrationParts& parts) {
  return begin_silently(context, parts, Kind::acc_reference);
}

Reaction handle(RequestContext& context, const msg::CalibOffset&, Gimbal& gimbal,
                Parameters& parameters) {
  if (!Calibrations::store_follow_offsets(gimbal, parameters, context.now)) {
    return context.refuse(msg::BoardErrorCode::wrong_state);
  }
  return context.confirm();
}

Reaction handle(RequestContext& context, const msg::CalibBat& request, const BoardOptions& options,
                Memory& memory, Gimbal& gimbal, Parameters& parameters) {
  if (!has_battery_meter(options)) return context.refuse(msg::BoardErrorCode::not_supported);
  const double measured = gimbal.sample(context.now).battery;
  // Assumption: no voltage divider is off by more than this, so such a request is a mistake.
  constexpr double lowest = 0.5;
  constexpr double highest = 2;
  const double factor = measured > 0 ? request.actual_voltage.volts() / measured : 0;
  if (!(factor >= lowest && factor <= highest))
    return context.refuse(msg::BoardErrorCode::wrong_params);
  memory.battery_factor = factor;
  ++memory.revision;
  parameters.apply_later();
  return context.confirm();
}

Reaction handle(RequestContext& context, const msg::EncodersCalibOffset4& request,
                CalibrationParts& parts) {
  if (!has_encoders(parts.options)) return context.refuse(msg::BoardErrorCode::not_supported);
  if (request.for_motor && !knows(context.versions(), *request.for_motor)) {
    return context.refuse(msg::BoardErrorCode::wrong_params);
  }
  return begin(context, parts, Kind::encoder_offset, 0, false);
}
Reaction handle(RequestContext& context, const msg::EncodersCalibFldOffset4&,
                CalibrationParts& parts) {
  if (!has_encoders(parts.options)) return context.refuse(msg::BoardErrorCode::not_supported);
  return begin(context, parts, Kind::encoder_field, 0, false);
}

Reaction handle(RequestContext& context, const msg::CalibInfoRequest& request,
                const Calibrations& calibrations, const Imus& imus, const Memory& memory,
                Gimbal& gimbal) {
  const bool is_frame = request.imu_type == msg::SelectedImu::frame;
  if (!is_frame && request.imu_type != msg::SelectedImu::main) {
    return context.refuse(msg::BoardErrorCode::wrong_params);
  }
  if (is_frame && !imus.has_frame) return context.refuse(msg::BoardErrorCode::not_supported);
  return context.answer(calibrations.info(memory, gimbal, is_frame ? 1 : 0, context.now));
}

Reaction handle(RequestContext& context, const msg::AutoPidRequest& request,
                CalibrationParts& parts) {
  if (request.cfg_flags.raw() == msg::AutoPidRequest::stop_tuning) {
    parts.auto_tuning.stop();
    return context.confirm();
  }
  const msg::AutoPidFlags flags = request.cfg_flags;
  const bool names_axis = flags.has(msg::AutoPidFlag::roll) || flags.has(msg::AutoPidFlag::pitch) ||
                          flags.has(msg::AutoPidFlag::yaw);
  if (request.profile_id >= ParametersOf<msg::ReadParams3>::copies || !names_axis) {
    return context.refuse(msg::BoardErrorCode::wrong_params);
  }
  if (!parts.auto_tuning.start(parts, request.profile_id, flags, request.gain_vs_stability,
                               context.port, context.now)) {
    return context.refuse(msg::BoardErrorCode::wrong_state);
  }
  return context.confirm();
}

Reaction handle(RequestContext& context, const msg::AutoPid2& request, CalibrationParts& parts) {
  switch (request.action) {
    case msg::AutoPid2Action::stop: parts.auto_tuning.stop(); return context.confirm();
    case msg::AutoPid2Action::read:
    case msg::AutoPid2Action::save: return context.confirm();
    case msg::AutoPid2Action::start:
    case msg::AutoPid2Action::start_save: break;
    default: return context.refuse(msg::BoardErrorCode::wrong_params);
  }
  if (!request.config) return context.refuse(msg::BoardErrorCode::cmd_size);
  const auto flags = tuning_flags(*request.config);
  if (!flags) return context.refuse(msg::BoardErrorCode::wrong_params);
  if (!parts.auto_tuning.start(parts, parts.parameters.profile(), *flags,
                               request.config->axes.roll.gain, context.port, context.now)) {
    return context.refuse(msg::BoardErrorCode::wrong_state);
  }
  return context.confirm();
}

Reaction handle(RequestContext& context, const msg::BodeTestStartStopRequest& request,
                CalibrationParts& parts) {
  if (!is_valid(request) || request.samples_num == 0) {
    return context.refuse(msg::BoardErrorCode::wrong_params);
  }
  if (!parts.frequency_response.start(parts, request, context.port, context.now)) {
    return context.refuse(msg::BoardErrorCode::wrong_state);
  }
  return parts.options.response.is_confirmed ? context.confirm() : Reaction::executed;
}

Reaction calibrate_gyro(RequestContext& context, CalibrationParts& parts, msg::CalibImu which,
                        msg::CalibAction action, Duration length) {
  return carry_out(context, parts, gyro, which, action, length);
}

}  // namespace sbgc::emulator
