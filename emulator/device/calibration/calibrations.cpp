#include "device/calibration/calibrations.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include <sbgc/internal/find_by.hpp>
#include <sbgc/internal/meta_limits.hpp>
#include <sbgc/meta/calibration.hpp>
#include <sbgc/meta/parameters.hpp>

#include "device/calibration/auto_tuning.hpp"
#include "device/calibration/frequency_response.hpp"
#include "device/imu/imus.hpp"
#include "device/parameters/parameters.hpp"
#include "device/peripherals/outputs.hpp"
#include "device/realtime/streams.hpp"
#include "device/request_context.hpp"
#include "physics/noise.hpp"
#include "physics/quantities.hpp"

namespace sbgc::emulator {
namespace {

using Kind = Calibrations::Kind;

constexpr unsigned steps = 40;  ///< sensor readings per calibration
/// Assumption: a sensor that turns faster than this, in deg/s, is not at rest.
constexpr double rest_speed = 5;
/// Assumption: a calibration fails if the gimbal does not rest for its full duration within this
/// multiple of it.
constexpr unsigned patience = 3;

/// The actions of the board during a calibration.
struct KindFacts {
  Kind kind{};
  msg::CalibMode mode{};
  Duration length{};  ///< on a real board; assumption: the specification gives none
  bool needs_rest = false;
};
constexpr KindFacts kinds[] = {
    {Kind::gyro, msg::CalibMode::gyro, seconds(4), true},
    {Kind::acc, msg::CalibMode::acc, seconds(3), true},
    {Kind::gyro_temperature, msg::CalibMode::gyro_temp, seconds(240), true},
    {Kind::acc_temperature, msg::CalibMode::acc_temp, seconds(240), true},
    {Kind::gyro_from_sensor, msg::CalibMode::gyro, milliseconds(200)},
    {Kind::acc_from_sensor, msg::CalibMode::acc, milliseconds(200)},
    {Kind::gyro_to_sensor, msg::CalibMode::gyro, milliseconds(200)},
    {Kind::acc_to_sensor, msg::CalibMode::acc, milliseconds(200)},
    {Kind::mag, msg::CalibMode::mag, seconds(20)},
    {Kind::ext_gain, msg::CalibMode::ext_gain, seconds(5)},
    {Kind::poles, msg::CalibMode::poles, seconds(10)},
    {Kind::encoder_offset, msg::CalibMode::encoder_offset, seconds(1)},
    {Kind::encoder_field, msg::CalibMode::encoder_fld_offset, seconds(10)},
    {Kind::orientation, msg::CalibMode::imu_orientation_corr, seconds(10)},
    {Kind::cogging, msg::CalibMode::cogging, seconds(20)},
    {Kind::acc_reference, msg::CalibMode::acc_ext_ref, seconds(2), true},
    {Kind::momentum, msg::CalibMode::momentum, seconds(10)},
};

const KindFacts& facts_of(Kind kind) {
  return *sbgc::detail::find_by(kinds, kind, &KindFacts::kind);
}

const Vector& gyro_of(const Sample& sample, std::size_t imu) {
  return imu == 0 ? sample.gyro : sample.frame_gyro;
}
const Vector& acceleration_of(const Sample& sample, std::size_t imu) {
  return imu == 0 ? sample.acceleration : sample.frame_acceleration;
}
double temperature_of(const Sample& sample, std::size_t imu) {
  return imu == 0 ? sample.temperature : sample.frame_temperature;
}
double heading_error_of(const Sample& sample, std::size_t imu) {
  return imu == 0 ? sample.heading_error : sample.frame_heading_error;
}
double length(const Vector& v) { return std::hypot(v.x, v.y, v.z); }

/// Returns whole degrees Celsius in the range of the sensor.
int whole_celsius(double value) {
  constexpr double lowest = sbgc::detail::field_info<msg::CalibInfo>("imu_temp_cels").range->lowest;
  return saturated_raw<std::int8_t>(std::max(value, lowest));
}

/// The direction of the accelerometer that points up.
struct Direction {
  std::size_t axis{};
  bool negative{};

  msg::CalibratedLimit limit() const {
    using enum msg::CalibratedLimit;
    constexpr msg::CalibratedLimit limits[3][2]{
        {plus_x, minus_x}, {plus_y, minus_y}, {plus_z, minus_z}};
    return limits[axis][negative ? 1 : 0];
  }
  /// The index into TEMP_CALIB_ACC_SLOT_NUM: +X, +Y, +Z, -X, -Y, -Z.
  std::size_t slot() const { return axis + (negative ? 3 : 0); }
};

Direction up(const Vector& acceleration) {
  std::size_t axis = 0;
  for (std::size_t i = 1; i < 3; ++i) {
    if (std::abs(acceleration[i]) > std::abs(acceleration[axis])) axis = i;
  }
  return {axis, acceleration[axis] < 0};
}

/// All directions of the accelerometer.
std::uint8_t calibrated_limits() {
  msg::CalibratedLimits limits;
  for (const std::size_t axis : {0U, 1U, 2U}) {
    limits.set(Direction{axis, false}.limit());
    limits.set(Direction{axis, true}.limit());
  }
  return limits.raw();
}

constexpr std::size_t max_temperature_slots =
    sbgc::detail::highest<msg::CalibInfo>("temp_calib_acc_slot_num");

void copy_gyro(const ImuCalibration& from, ImuCalibration& to) {
  to.gyro_is_calibrated = from.gyro_is_calibrated;
  to.gyro_temperature_enabled = from.gyro_temperature_enabled;
  to.gyro_temperature_min = from.gyro_temperature_min;
  to.gyro_temperature_max = from.gyro_temperature_max;
  to.gyro_offset = from.gyro_offset;
}
void copy_acc(const ImuCalibration& from, ImuCalibration& to) {
  to.acc_limits = from.acc_limits;
  to.acc_temperature_enabled = from.acc_temperature_enabled;
  to.acc_temperature_min = from.acc_temperature_min;
  to.acc_temperature_max = from.acc_temperature_max;
  to.acc_slots = from.acc_slots;
}

/// Ends a gyroscope calibration, which replaces the manual correction.
void gyro_calibrated(CalibrationParts& parts, std::size_t imu, Instant now) {
  parts.gimbal.gyro_calibrated(imu == 1, now);
  parts.memory.imus[imu].gyro_offset = {};
  parts.imus.headings[imu] = 0;
  parts.imus.correct(parts.gimbal, parts.memory, parts.parameters, now);
}

}  // namespace

Duration Calibrations::scaled(const BoardOptions& options, Duration length) {
  const std::int64_t us = length.us / 100 * options.calibration_time;
  return std::max(cycle, microseconds(us));
}

bool Calibrations::start(CalibrationParts& parts, Kind kind, std::size_t imu,
                         std::optional<Requester> requester, Instant now, Duration length) {
  if (run_ || parts.auto_tuning.is_running() || parts.frequency_response.is_running()) return false;
  Run run{.kind = kind, .imu = imu, .profile = parts.parameters.profile(), .requester = requester};
  if (length == Duration{}) length = facts_of(kind).length;
  length = scaled(parts.options, length);
  run.steps_needed = length <= cycle ? 1 : steps;
  run.steps_left = patience * run.steps_needed;
  run.step = std::max(cycle, microseconds(length.us / run.steps_needed));
  run.due = now + run.step;
  run.temperature_min = run.temperature_max =
      whole_celsius(temperature_of(parts.gimbal.sample(now), imu));
  run_ = run;
  parts.outputs.signal(parts.parameters, msg::BeeperMode::calibrate, now);
  return true;
}

msg::CalibMode Calibrations::mode() const {
  return run_ ? facts_of(run_->kind).mode : msg::CalibMode::none;
}

Instant Calibrations::next() const { return run_ ? run_->due : Instant::never; }

void Calibrations::advance(Instant now, CalibrationParts& parts) {
  while (run_ && run_->due <= now) {
    const Instant at = run_->due;
    const Sample sample = parts.gimbal.sample(now);
    const int temperature = whole_celsius(temperature_of(sample, run_->imu));
    run_->temperature_min = std::min(run_->temperature_min, temperature);
    run_->temperature_max = std::max(run_->temperature_max, temperature);
    const bool rests =
        !facts_of(run_->kind).needs_rest || length(gyro_of(sample, run_->imu)) <= rest_speed;
    run_->steps_at_rest = rests ? run_->steps_at_rest + 1 : 0;
    run_->due = at + run_->step;
    --run_->steps_left;
    if (run_->steps_at_rest == run_->steps_needed) {
      const Run run = *run_;
      finish(parts, store(parts, run, now), now);
    } else if (run_->steps_left == 0) {
      finish(parts, false, now);
    }
  }
}

void Calibrations::drop_port(std::size_t port) {
  if (run_ && run_->requester && run_->requester->port == port) run_->requester.reset();
}

/// Stores the result. Returns false if that is not possible.
bool Calibrations::store(CalibrationParts& parts, const Run& run, Instant now) {
  const Sample sample = parts.gimbal.sample(now);
  ImuCalibration& imu = parts.memory.imus[run.imu];
  ImuCalibration& sensor = parts.memory.sensors[run.imu];
  const auto minimum = static_cast<std::int8_t>(run.temperature_min);
  const auto maximum = static_cast<std::int8_t>(run.temperature_max);
  const auto random = [&](std::uint64_t counter) {
    return random_share(parts.options.gimbal.seed + 0xCA11B, counter);
  };
  switch (run.kind) {
    case Kind::gyro:
      imu.gyro_is_calibrated = true;
      gyro_calibrated(parts, run.imu, now);
      break;
    case Kind::acc: {
      const Direction direction = up(acceleration_of(sample, run.imu));
      imu.acc_limits = msg::CalibratedLimits(imu.acc_limits).set(direction.limit()).raw();
      break;
    }
    case Kind::gyro_temperature:
      imu.gyro_is_calibrated = true;
      imu.gyro_temperature_enabled = true;
      imu.gyro_temperature_min = minimum;
      imu.gyro_temperature_max = maximum;
      gyro_calibrated(parts, run.imu, now);
      break;
    case Kind::acc_temperature: {
      const Direction direction = up(acceleration_of(sample, run.imu));
      const bool is_first =
          std::all_of(imu.acc_slots.begin(), imu.acc_slots.end(), [](auto n) { return n == 0; });
      imu.acc_temperature_min = is_first ? minimum : std::min(imu.acc_temperature_min, minimum);
      imu.acc_temperature_max = is_first ? maximum : std::max(imu.acc_temperature_max, maximum);
      imu.acc_limits = msg::CalibratedLimits(imu.acc_limits).set(direction.limit()).raw();
      // Assumption: if all slots are in use, the new temperature replaces one.
      std::uint8_t& slots = imu.acc_slots[direction.slot()];
      if (slots < max_temperature_slots) ++slots;
      imu.acc_temperature_enabled = true;
      break;
    }
    case Kind::gyro_from_sensor:
      copy_gyro(sensor, imu);
      parts.imus.correct(parts.gimbal, parts.memory, parts.parameters, now);
      break;
    case Kind::acc_from_sensor: copy_acc(sensor, imu); break;
    case Kind::gyro_to_sensor: copy_gyro(imu, sensor); break;
    case Kind::acc_to_sensor: copy_acc(imu, sensor); break;
    // The emulated magnetometer and motors need no correction.
    case Kind::mag:
    case Kind::cogging: break;
    case Kind::acc_reference:
      // The reference replaces the measurements of all directions.
      imu.acc_limits = calibrated_limits();
      break;
    case Kind::orientation:
      // Assumption: an IMU that is mounted with a small error.
      return parts.parameters.change<msg::ReadParamsExt2>(run.profile, [&](auto& parameters) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
          const auto hundredths = std::lround(200 * random(5 + axis) - 100);
          parameters.imu_orientation_corr[axis] =
              msg::HundredthDegrees(static_cast<std::int16_t>(hundredths));
        }
      });
    case Kind::momentum:
      return parts.parameters.change<msg::ReadParamsExt2>(run.profile, [&](auto& parameters) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
          parameters.momentum[axis] = static_cast<std::uint16_t>(100 + 100 * random(8 + axis));
        }
      });
    case Kind::ext_gain:
      // Assumption: gains of a flight controller that differs slightly from board to board.
      return parts.parameters.change<msg::ReadParams3>(run.profile, [&](auto& parameters) {
        parameters.ext_fc_gain_roll = static_cast<std::int8_t>(40 + std::lround(20 * random(0)));
        parameters.ext_fc_gain_pitch = static_cast<std::int8_t>(40 + std::lround(20 * random(1)));
      });
    case Kind::poles:
      // Assumption: motors with 14 poles, common in gimbals, and the correct direction.
      return parts.parameters.change<msg::ReadParams3>(run.profile, [](auto& parameters) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
          parameters.axes[axis].poles = 14;
          parameters.axes[axis].invert = 0;
        }
      });
    case Kind::encoder_offset:
      return parts.parameters.change<msg::ReadParamsExt>(run.profile, [&](auto& parameters) {
        // The current position becomes zero.
        for (std::size_t axis = 0; axis < 3; ++axis) {
          parameters.encoder_offset[axis] = wire_angle(std::remainder(sample.joints[axis], 360.0));
        }
      });
    case Kind::encoder_field:
      return parts.parameters.change<msg::ReadParamsExt>(run.profile, [&](auto& parameters) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
          parameters.encoder_fld_offset[axis] = wire_angle(360 * random(2 + axis) - 180);
        }
      });
  }
  ++parts.memory.revision;
  return true;
}

void Calibrations::finish(CalibrationParts& parts, bool is_success, Instant now) {
  const Run run = *run_;
  run_.reset();
  last_progress_ = is_success ? 100 : 0;
  if (run.kind == Kind::acc || run.kind == Kind::acc_temperature) {
    errors_.set(msg::SystemError::calib_acc, !is_success);
  }
  if (run.kind == Kind::poles) errors_.set(msg::SystemError::calib_poles, !is_success);
  parts.outputs.signal(parts.parameters,
                       is_success ? msg::BeeperMode::confirm : msg::BeeperMode::error, now);
  if (!run.requester) return;
  RequestContext context(parts.ports, parts.options, run.requester->port, run.requester->command,
                         Confirmed::always, now);
  if (is_success) {
    context.confirm();
  } else {
    // Assumption: the specification defines no other response to a failed calibration.
    context.refuse(msg::BoardErrorCode::operation_failed);
  }
}

msg::CalibInfo Calibrations::info(const Memory& memory, Gimbal& gimbal, std::size_t imu,
                                  Instant now) const {
  const Sample sample = gimbal.sample(now);
  const ImuCalibration& calibration = memory.imus[imu];
  const Vector& acceleration = acceleration_of(sample, imu);
  msg::CalibInfo info;
  // Assumption: reports the last calibration until the next one starts.
  info.progress = msg::Percent(last_progress_);
  if (run_) {
    info.progress =
        msg::Percent(static_cast<std::uint8_t>(100 * run_->steps_at_rest / run_->steps_needed));
  }
  info.imu_type = imu == 0 ? msg::SelectedImu::main : msg::SelectedImu::frame;
  info.acc_data = saturated<msg::Acceleration>(acceleration);
  // Assumption: in the unit of the gyroscope, like GYRO_DATA of CMD_REALTIME_DATA_3.
  info.gyro_abs_val = saturated_raw<std::uint16_t>(length(gyro_of(sample, imu)) /
                                                   msg::GyroRate(1).degrees_per_second());
  info.acc_cur_axis = static_cast<std::uint8_t>(up(acceleration).axis);
  info.acc_limits_info = msg::CalibratedLimits(calibration.acc_limits);
  info.imu_temp_cels = saturated<msg::Temperature>(whole_celsius(temperature_of(sample, imu)));
  info.temp_calib_gyro_enabled = calibration.gyro_temperature_enabled ? 1 : 0;
  info.temp_calib_gyro_t_min_cels = msg::Temperature(calibration.gyro_temperature_min);
  info.temp_calib_gyro_t_max_cels = msg::Temperature(calibration.gyro_temperature_max);
  info.temp_calib_acc_enabled = calibration.acc_temperature_enabled ? 1 : 0;
  info.temp_calib_acc_slot_num = calibration.acc_slots;
  info.temp_calib_acc_t_min_cels = msg::Temperature(calibration.acc_temperature_min);
  info.temp_calib_acc_t_max_cels = msg::Temperature(calibration.acc_temperature_max);
  // The distance of two unit vectors with this angle between them.
  constexpr double half_degree = 3.14159265358979323846 / 360;
  info.h1_err_length = saturated<msg::Hundredths>(
      2 * std::abs(std::sin(heading_error_of(sample, imu) * half_degree)));
  return info;
}

bool Calibrations::store_follow_offsets(Gimbal& gimbal, Parameters& parameters, Instant now) {
  const Sample sample = gimbal.sample(now);
  Axes<std::int8_t> offsets;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    // Assumption: FOLLOW_OFFSET is in degrees; its unit is undocumented.
    const auto degrees =
        msg::SignedDegrees::from_degrees(std::remainder(sample.joints[axis], 360.0));
    constexpr Range range = *sbgc::detail::field_info<msg::ReadParams3>("follow_offset").range;
    if (!degrees || (*degrees).raw() < range.lowest || (*degrees).raw() > range.highest) {
      return false;
    }
    offsets[axis] = (*degrees).raw();
  }
  return parameters.change<msg::ReadParams3>(
      parameters.profile(), [&](msg::ReadParams3& changed) { changed.follow_offset = offsets; });
}

}  // namespace sbgc::emulator
