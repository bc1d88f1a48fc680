#include "device/realtime/live_data.hpp"

#include <limits>

#include <sbgc/internal/meta_limits.hpp>
#include <sbgc/meta/realtime.hpp>
#include <sbgc/responses/realtime.hpp>

#include "device/control/reported_state.hpp"
#include "device/external_motors/external_motors.hpp"
#include "device/features.hpp"
#include "device/imu/imus.hpp"
#include "device/modules/modules.hpp"
#include "device/parameters/parameters.hpp"
#include "device/peripherals/remote_control.hpp"
#include "device/ports.hpp"
#include "device/realtime/custom_data.hpp"
#include "device/realtime/measured_parts.hpp"
#include "physics/attitude.hpp"
#include "physics/quantities.hpp"

namespace sbgc::emulator {
namespace {

/// Assumption: the sensors of an axis measure along the direction about which it turns: forward,
/// right and up, and its gyroscope counts as its angle. The specification names only axes.
constexpr std::size_t sensor_axis(std::size_t axis) { return turning_axes[axis].direction; }

/// Converts an RC signal to a pulse in the specified range.
msg::RcSignal pulse(std::optional<double> signal) {
  // NOLINTNEXTLINE(modernize-return-braced-init-list): the constructor is explicit
  if (!signal) return msg::RcSignal(msg::RealtimeData3::no_signal);
  constexpr Range range = *sbgc::detail::field_info<msg::RealtimeData3>("rc").range;
  constexpr double middle = (range.lowest + range.highest) / 2;
  constexpr double half = (range.highest - range.lowest) / 2;
  return saturated<msg::RcSignal>(middle + half * *signal);
}

/// Returns the signal for a flight controller; 0 if no input is assigned to it.
msg::RcSignal controller_pulse(const RemoteControl& remote, msg::RcMap source) {
  // NOLINTNEXTLINE(modernize-return-braced-init-list): the constructor is explicit
  if (source == msg::RcInput::input_no) return msg::RcSignal(msg::RealtimeData3::ext_fc_unused);
  return pulse(remote.signal(source));
}

Xyz<float> vector(const Vector& from) {
  return {static_cast<float>(from.x), static_cast<float>(from.y), static_cast<float>(from.z)};
}

Axes<msg::Acceleration> accelerations(const Vector& measured) {
  Axes<msg::Acceleration> to;
  for (std::size_t axis = 0; axis < to.size(); ++axis) {
    to[axis] = saturated<msg::Acceleration>(measured[sensor_axis(axis)]);
  }
  return to;
}

/// Assumption: the scale of the raw data depends on the sensor.
Axes<std::int16_t> magnetometer(const Sample& sample) {
  Axes<std::int16_t> to;
  for (std::size_t axis = 0; axis < to.size(); ++axis) {
    to[axis] = saturated_raw<std::int16_t>(1000 * sample.magnetic[sensor_axis(axis)]);
  }
  return to;
}

/// Sets the initial fields that both long messages share.
template <class M>
void measure_common(MeasuredParts& parts, std::size_t port, Instant now, const Sample& sample,
                    M& data) {
  const auto& parameters = parts.parameters.of<msg::ReadParams3>();
  const Axes<msg::Acceleration> acceleration = accelerations(sample.acceleration);
  const Axes<msg::GyroRate> gyro = saturated<msg::GyroRate>(turning(sample.gyro));
  for (std::size_t axis = 0; axis < data.axes.size(); ++axis) {
    data.axes[axis].acc_data = acceleration[axis];
    data.axes[axis].gyro_data = gyro[axis];
    data.rc[axis] = pulse(parts.remote.own(parts.parameters, axis));
    data.motor_power[axis] =
        saturated_raw<std::uint8_t>(sample.power[axis] * std::numeric_limits<std::uint8_t>::max());
  }
  data.serial_error_cnt = parts.serial_errors(port, now);
  data.system_error = parts.errors(now);
  data.system_sub_error = parts.options.faults.sub_error;
  data.error_code = static_cast<std::uint8_t>(data.system_error.raw());
  data.rc_cmd = pulse(parts.remote.signal(parameters.rc_map_cmd));
  data.ext_fc_roll = controller_pulse(parts.remote, parameters.rc_map_fc_roll);
  data.ext_fc_pitch = controller_pulse(parts.remote, parameters.rc_map_fc_pitch);
  data.angle = wire_angles(sample.angles);
  data.rc_angle = wire_angles(sample.targets);
  if (parts.imus.has_frame) data.frame_imu_angle = wire_angles(sample.frame);
  data.cycle_time = saturated<msg::Microseconds>(static_cast<double>(parts.reported_cycle().us));
  data.i2c_error_count = parts.i2c_errors(now);
  data.bat_level = saturated<msg::Voltage>(parts.measured_battery(sample));
  if (parts.gimbal.motors_on()) data.other_flags.set(msg::OtherFlag::motors_on);
  data.cur_imu = parts.imus.selected;
  data.cur_profile = parts.parameters.profile();
}

msg::RealtimeDataCustomFlags blocks_of(const msg::DataStreamInterval& request) {
  return request.config.flags ? *request.config.flags : msg::RealtimeDataCustomFlags{};
}

bool is_of_frame(const msg::DataStreamInterval& request) {
  return request.config.imu_type && *request.config.imu_type == msg::ImuIndex::frame;
}

}  // namespace

bool knows_frame(const Imus& imus, Gimbal& gimbal, Instant now) {
  return imus.has_frame || gimbal.is_frame_reported(now);
}

bool knows_joints(const BoardOptions& options, const Imus& imus) {
  return has_encoders(options) || imus.has_frame;
}

msg::RealtimeData3 realtime_data_3(MeasuredParts& parts, std::size_t port, Instant now) {
  msg::RealtimeData3 data;
  measure_common(parts, port, now, parts.gimbal.sample(now), data);
  return data;
}

msg::RealtimeData4 realtime_data_4(MeasuredParts& parts, std::size_t port, Instant now) {
  msg::RealtimeData4 data;
  const Sample sample = parts.gimbal.sample(now);
  measure_common(parts, port, now, sample, data);
  if (knows_joints(parts.options, parts.imus)) data.rotor_angle = wire_angles(sample.joints);
  data.mag_data = magnetometer(sample);
  data.balance_error = saturated<msg::BalanceError>(sample.imbalance, 100);
  if (parts.options.features.has(msg::BoardFeature::current_sensor)) {
    data.current = saturated<msg::Current>(1000 * sample.current);
  }
  data.imu_temperature = saturated<msg::Temperature>(sample.temperature);
  if (parts.imus.has_frame) {
    data.frame_imu_temperature = saturated<msg::Temperature>(sample.frame_temperature);
  }
  const bool is_frame = parts.imus.selected == msg::SelectedImu::frame;
  data.imu_g_err =
      saturated<msg::AngleError>(is_frame ? sample.frame_gravity_error : sample.gravity_error);
  data.imu_h_err =
      saturated<msg::AngleError>(is_frame ? sample.frame_heading_error : sample.heading_error);
  constexpr double full_output = 10000;
  for (std::size_t axis = 0; axis < data.motor_out.size(); ++axis) {
    data.motor_out[axis] = saturated_raw<std::int16_t>(full_output * sample.power[axis]);
  }
  data.calib_mode = calibration_mode(parts.control, parts.calibration);
  data.actual_angle = wire_angles(sample.angles);
  data.system_state_flags = state_flags(parts.gimbal, parts.modes, parts.tuning, now);
  return data;
}

std::optional<msg::RealtimeDataCustomFlags> known_blocks(Availability versions,
                                                         msg::RealtimeDataCustomFlags blocks) {
  msg::RealtimeDataCustomRequest request{.flags = blocks};
  limit_to(versions, request);
  // Only the size of the message matters, not its values.
  msg::RealtimeDataCustom data;
  std::array<std::uint8_t, max_body_size> body{};
  std::array<std::uint8_t, max_body_size> empty{};
  std::size_t size = 0;
  Code code = Code::too_short;
  while (size <= empty.size() && code == Code::too_short) {
    code = decode(std::span(empty).first(size), data, {request.flags}).code;
    ++size;
  }
  if (request.flags.has(msg::RealtimeDataCustomFlag::include_flags)) data.flags = request.flags;
  if (code != Code::ok || !encode(data, body)) return {};
  return request.flags;
}

msg::RealtimeDataCustom custom_data(MeasuredParts& parts, std::size_t port,
                                    msg::RealtimeDataCustomFlags blocks, Instant now) {
  using Flag = msg::RealtimeDataCustomFlag;
  msg::RealtimeDataCustom data;
  const Sample sample = parts.gimbal.sample(now);
  const auto& parameters = parts.parameters.of<msg::ReadParams3>();
  data.timestamp_ms = parts.clock(now);
  if (blocks.has(Flag::include_flags)) data.flags = blocks;
  if (blocks.has(Flag::imu_angles)) data.imu_angles = wire_angles(sample.angles);
  if (blocks.has(Flag::target_angles)) data.target_angles = wire_angles(sample.targets);
  if (blocks.has(Flag::target_speed))
    data.target_speed = saturated<msg::GyroRate>(sample.target_speeds);
  if (blocks.has(Flag::stator_rotor_angle)) {
    data.stator_rotor_angle =
        knows_joints(parts.options, parts.imus) ? wire_angles(sample.joints) : Axes<msg::Angle14>{};
  }
  if (blocks.has(Flag::gyro_data)) data.gyro_data = saturated<msg::GyroRate>(turning(sample.gyro));
  if (blocks.has(Flag::rc_data)) {
    auto& signals = data.rc_data.emplace();
    for (std::size_t axis = 0; axis < 3; ++axis) {
      signals[axis] = fine_signal(parts.remote.own(parts.parameters, axis));
    }
    signals[3] = fine_signal(parts.remote.signal(parameters.rc_map_cmd));
    signals[4] = fine_signal(parts.remote.signal(parameters.rc_map_fc_roll));
    signals[5] = fine_signal(parts.remote.signal(parameters.rc_map_fc_pitch));
  }
  if (blocks.has(Flag::z1_h1_vectors)) {
    data.z1_vector = vector(sample.up);
    data.h1_vector = vector(sample.north);
  }
  // No receiver is connected.
  if (blocks.has(Flag::rc_channels)) data.rc_channels.emplace().fill(fine_signal({}));
  if (blocks.has(Flag::acc_data)) data.acc_data = accelerations(sample.acceleration);
  measure_later(parts, port, blocks, now, data);
  return data;
}

msg::RealtimeDataCustom2 custom_data_2(MeasuredParts& parts, msg::RealtimeDataCustom2Flags blocks,
                                       Instant now) {
  using Flag = msg::RealtimeDataCustom2Flag;
  msg::RealtimeDataCustom2 data;
  const Sample sample = parts.gimbal.sample(now);
  const bool has_frame = parts.imus.has_frame;
  data.timestamp_ms = parts.clock(now);
  if (blocks.has(Flag::include_flags)) data.flags = blocks;
  if (blocks.has(Flag::frame_imu_angles)) {
    data.frame_imu_angles = has_frame ? wire_angles(sample.frame) : Axes<msg::Angle14>{};
  }
  if (blocks.has(Flag::frame_gyro)) {
    data.frame_gyro =
        has_frame ? saturated<msg::GyroRate>(turning(sample.frame_speed)) : Axes<msg::GyroRate>{};
  }
  if (blocks.has(Flag::frame_acc)) {
    // Only gravity: the frame does not accelerate.
    data.frame_acc = has_frame ? accelerations(sample.frame_up) : Axes<msg::Acceleration>{};
  }
  if (blocks.has(Flag::debug)) data.debug = std::array<std::int16_t, 4>{};
  if (blocks.has(Flag::mag_sens_data)) data.mag_sens_data = magnetometer(sample);
  if (blocks.has(Flag::pin_state)) {
    // Nothing is assigned to the inputs.
    constexpr msg::InputStates unavailable(0xAAAA);
    data.pin_state = msg::PinStates{unavailable, unavailable, {}};
  }
  if (blocks.has(Flag::stab_err_ampl)) {
    auto& errors = data.stab_err_ampl.emplace();
    for (std::size_t axis = 0; axis < errors.size(); ++axis) {
      errors[axis] =
          saturated<msg::Millidegrees>(std::abs(sample.targets[axis] - sample.angles[axis]));
    }
  }
  return data;
}

msg::GetAngles angles(Gimbal& gimbal, Instant now) {
  const Sample sample = gimbal.sample(now);
  msg::GetAngles data;
  for (std::size_t axis = 0; axis < data.axes.size(); ++axis) {
    data.axes[axis].imu_angle = wire_angle(sample.angles[axis]);
    data.axes[axis].rc_target_angle = wire_angle(sample.targets[axis]);
    data.axes[axis].rc_speed = saturated<msg::ControlSpeed>(sample.target_speeds[axis]);
  }
  return data;
}

msg::GetAnglesExt angles(Gimbal& gimbal, bool has_joints, Instant now) {
  const Sample sample = gimbal.sample(now);
  msg::GetAnglesExt data;
  for (std::size_t axis = 0; axis < data.axes.size(); ++axis) {
    data.axes[axis].imu_angle = wire_angle(sample.angles[axis]);
    data.axes[axis].rc_target_angle = wire_angle(sample.targets[axis]);
    if (has_joints) {
      data.axes[axis].stator_rotor_angle = saturated<msg::LongAngle14>(sample.joints[axis]);
    }
  }
  return data;
}

msg::AhrsHelper directions(Gimbal& gimbal, bool of_frame, Instant now) {
  const Sample sample = gimbal.sample(now);
  return {.z1_vector = vector(of_frame ? sample.frame_up : sample.up),
          .h1_vector = vector(of_frame ? sample.frame_north : sample.north)};
}

bool can_stream(const BoardOptions& options, const Imus& imus, Gimbal& gimbal,
                const msg::DataStreamInterval& request, Instant now) {
  const Availability versions = versions_of(options);
  const auto& config = request.config;
  switch (request.cmd_id) {
    case msg::RealtimeData3::command: return is_supported<msg::RealtimeData3>(versions);
    case msg::RealtimeData4::command: return is_supported<msg::RealtimeData4>(versions);
    case msg::RealtimeDataCustom::command:
      return is_supported<msg::RealtimeDataCustom>(versions) &&
             known_blocks(versions, blocks_of(request));
    case msg::RealtimeDataCustom2::command: return is_supported<msg::RealtimeDataCustom2>(versions);
    case msg::Event::command: return is_supported<msg::Event>(versions);
    case msg::CanDrvTelemetry::command:
      return is_supported<msg::CanDrvTelemetry>(versions) && *config.drv_id < can_drivers(options);
    case msg::ExtMotorsState::command:
      return is_supported<msg::ExtMotorsState>(versions) &&
             ExternalMotors::are_supported(options) && *config.motor < ExternalMotors::count;
    case msg::AhrsHelper::command:
      if (!is_supported<msg::AhrsHelper>(versions)) return false;
      if (is_of_frame(request)) return knows_frame(imus, gimbal, now);
      return !config.imu_type || *config.imu_type == msg::ImuIndex::main;
    default: return false;
  }
}

bool offer_sample(MeasuredParts& parts, std::size_t port, const msg::DataStreamInterval& request,
                  Instant now) {
  // Checking the room first saves a measurement.
  const std::size_t size = frame_size(parts.ports.framing(port), stream_change(request).size);
  if (parts.ports.room(port) < size) return false;
  const Availability versions = versions_of(parts.options);
  const auto& config = request.config;
  const auto offer = [&](auto data) {
    limit_to(versions, data);
    return parts.ports.offer(port, data);
  };
  switch (request.cmd_id) {
    case msg::RealtimeData3::command: return offer(realtime_data_3(parts, port, now));
    case msg::RealtimeData4::command: return offer(realtime_data_4(parts, port, now));
    case msg::RealtimeDataCustom::command: {
      const auto blocks = known_blocks(versions, blocks_of(request));
      return blocks && offer(custom_data(parts, port, *blocks, now));
    }
    case msg::RealtimeDataCustom2::command:
      return offer(custom_data_2(parts, *config.custom2_flags, now));
    case msg::CanDrvTelemetry::command:
      return offer(telemetry(parts.options, parts.external_motors, parts.gimbal, *config.drv_id,
                             *config.telemetry_flags, parts.clock(now), now));
    case msg::ExtMotorsState::command:
      return offer(parts.external_motors.state(parts.gimbal, *config.motor, *config.data_set, now));
    case msg::AhrsHelper::command:
      return offer(directions(parts.gimbal, is_of_frame(request), now));
    default: return false;
  }
}

}  // namespace sbgc::emulator
