/// Requests that calibrate and tune.
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include <sbgc/meta/calibration.hpp>
#include <sbgc/settings.hpp>

#include "device/handlers.hpp"
#include "device/device.hpp"

namespace sbgc::board {
namespace {

using Kind = Calibrations::Kind;

/// Index of an IMU in Memory::imus; nothing if the board has none such.
std::optional<std::size_t> index_of(const Machine& machine, msg::CalibImu imu) {
  switch (imu) {
    case msg::CalibImu::active: return machine.cur_imu == msg::SelectedImu::frame ? 1 : 0;
    case msg::CalibImu::main: return 0;
    case msg::CalibImu::frame: break;
    default: return {};
  }
  return machine.has_frame_imu() ? std::optional<std::size_t>(1) : std::nullopt;
}

/// A calibration that is confirmed on reception, and once more at its end if `confirms_end`.
Outcome begin(Turn& turn, Kind kind, std::size_t imu, bool confirms_end) {
  std::optional<Calibrations::Asker> asker;
  if (confirms_end) asker = Calibrations::Asker{turn.port, turn.command};
  if (!turn.machine.calibrations.start(turn.machine, kind, imu, asker, turn.now)) {
    return turn.refuse(msg::BoardErrorCode::wrong_state);
  }
  return turn.confirm();
}

/// A calibration that is confirmed once, at its end.
Outcome begin_silently(Turn& turn, Kind kind) {
  const Calibrations::Asker asker{turn.port, turn.command};
  if (!turn.machine.calibrations.start(turn.machine, kind, 0, asker, turn.now)) {
    return turn.refuse(msg::BoardErrorCode::wrong_state);
  }
  return Outcome::carried_out;
}

Outcome restart(Turn& turn) {
  ++turn.machine.memory.revision;
  const Outcome outcome = turn.confirm();
  turn.machine.restarts.announce(turn.machine, turn.now);
  return outcome;
}

/// What CMD_CALIB_ACC and CMD_CALIB_GYRO do with an IMU.
struct Sensor {
  Kind regular, temperature, from_sensor, to_sensor;
  void (*forget)(ImuCalibration& imu);
  /// Uses the calibration over temperature, if there is one, or no longer.
  void (*use_temperature)(ImuCalibration& imu, bool used);
};

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
                        // Ours: a range of 0 to 0 degrees means that there is none.
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

Outcome carry_out(Turn& turn, const Sensor& sensor, msg::CalibImu which, msg::CalibAction action) {
  Machine& machine = turn.machine;
  const auto imu = index_of(machine, which);
  if (!imu) return Turn::ignore();
  ImuCalibration& memory = machine.memory.imus[*imu];
  const bool changes_at_once = action == msg::CalibAction::reset ||
                               action == msg::CalibAction::enable_temperature ||
                               action == msg::CalibAction::disable_temperature;
  if (changes_at_once && machine.calibrations.under_way()) {
    return turn.refuse(msg::BoardErrorCode::wrong_state);
  }
  switch (action) {
    case msg::CalibAction::regular: return begin(turn, sensor.regular, *imu, true);
    case msg::CalibAction::temperature: return begin(turn, sensor.temperature, *imu, true);
    case msg::CalibAction::restore_factory: return begin(turn, sensor.from_sensor, *imu, true);
    case msg::CalibAction::store_in_sensor: return begin(turn, sensor.to_sensor, *imu, true);
    case msg::CalibAction::reset: sensor.forget(memory); return restart(turn);
    case msg::CalibAction::enable_temperature:
      sensor.use_temperature(memory, true);
      return restart(turn);
    case msg::CalibAction::disable_temperature:
      sensor.use_temperature(memory, false);
      return restart(turn);
  }
  return Turn::ignore();
}

}  // namespace

Outcome handle(Turn& turn, const msg::CalibAcc&) {
  return carry_out(turn, acc, msg::CalibImu::active, msg::CalibAction::regular);
}
Outcome handle(Turn& turn, const msg::CalibAccExt& request) {
  return carry_out(turn, acc, request.imu_idx, request.action);
}
Outcome handle(Turn& turn, const msg::CalibGyro&) {
  return carry_out(turn, gyro, msg::CalibImu::active, msg::CalibAction::regular);
}
Outcome handle(Turn& turn, const msg::CalibGyroExt& request) {
  return carry_out(turn, gyro, request.imu_idx, request.action);
}

Outcome handle(Turn& turn, const msg::CalibMag&) { return begin(turn, Kind::mag, 0, false); }
Outcome handle(Turn& turn, const msg::CalibExtGain&) {
  return begin_silently(turn, Kind::ext_gain);
}
Outcome handle(Turn& turn, const msg::CalibPoles&) { return begin_silently(turn, Kind::poles); }

Outcome handle(Turn& turn, const msg::CalibOffset&) {
  if (!Calibrations::store_follow_offsets(turn.machine, turn.now)) {
    return turn.refuse(msg::BoardErrorCode::wrong_state);
  }
  return turn.confirm();
}

Outcome handle(Turn& turn, const msg::CalibBat& request) {
  if (!turn.machine.has_battery_meter()) return turn.refuse(msg::BoardErrorCode::not_supported);
  const double measured = turn.machine.gimbal.sample(turn.now).battery;
  // Ours: a divider is never off by more than this, so it must be a mistake.
  constexpr double lowest = 0.5;
  constexpr double highest = 2;
  const double factor = measured > 0 ? request.actual_voltage.volts() / measured : 0;
  if (!(factor >= lowest && factor <= highest))
    return turn.refuse(msg::BoardErrorCode::wrong_params);
  turn.machine.memory.battery_factor = factor;
  ++turn.machine.memory.revision;
  turn.machine.apply_settings(turn.now);
  return turn.confirm();
}

Outcome handle(Turn& turn, const msg::EncodersCalibOffset4&) {
  if (!turn.machine.has_encoders()) return turn.refuse(msg::BoardErrorCode::not_supported);
  return begin(turn, Kind::encoder_offset, 0, false);
}
Outcome handle(Turn& turn, const msg::EncodersCalibFldOffset4&) {
  if (!turn.machine.has_encoders()) return turn.refuse(msg::BoardErrorCode::not_supported);
  return begin(turn, Kind::encoder_field, 0, false);
}

Outcome handle(Turn& turn, const msg::CalibInfoRequest& request) {
  Machine& machine = turn.machine;
  const bool is_frame = request.imu_type == msg::SelectedImu::frame;
  if (!is_frame && request.imu_type != msg::SelectedImu::main) {
    return turn.refuse(msg::BoardErrorCode::wrong_params);
  }
  if (is_frame && !machine.has_frame_imu()) return turn.refuse(msg::BoardErrorCode::not_supported);
  return turn.answer(machine.calibrations.info(machine, is_frame ? 1 : 0, turn.now));
}

Outcome handle(Turn& turn, const msg::AutoPidRequest& request) {
  Machine& machine = turn.machine;
  if (request.cfg_flags.raw() == msg::AutoPidRequest::stop_tuning) {
    machine.auto_tuning.stop();
    return turn.confirm();
  }
  const msg::AutoPidFlags flags = request.cfg_flags;
  const bool names_axis = flags.has(msg::AutoPidFlag::roll) || flags.has(msg::AutoPidFlag::pitch) ||
                          flags.has(msg::AutoPidFlag::yaw);
  if (request.profile_id >= SettingsOf<msg::ReadParams3>::copies || !names_axis) {
    return turn.refuse(msg::BoardErrorCode::wrong_params);
  }
  if (!machine.auto_tuning.start(machine, request.profile_id, flags, request.gain_vs_stability,
                                 turn.port, turn.now)) {
    return turn.refuse(msg::BoardErrorCode::wrong_state);
  }
  return turn.confirm();
}

}  // namespace sbgc::board
