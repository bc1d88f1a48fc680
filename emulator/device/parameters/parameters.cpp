
#include "device/parameters/parameters.hpp"

#include <algorithm>
#include <string>

#include <sbgc/meta/variables.hpp>
#include <sbgc/variable_parameters.hpp>

namespace sbgc::emulator {

Parameters::Parameters(Memory& memory, const Availability& versions)
    : memory_(memory), versions_(versions), eeprom_(memory) {
  reload();
}

void Parameters::reload() {
  variables_.clear();
  ParameterMessages::for_each([this]<class M>(Type<M>) { use(stored<M>(copy_in_use<M>())); });
}

std::uint8_t Parameters::profile() const {
  constexpr std::uint8_t profiles = ParametersOf<msg::ReadParams3>::copies;
  return memory_.profile < profiles ? memory_.profile : std::uint8_t{0};
}

void Parameters::select_profile(std::uint8_t profile) {
  if (memory_.is_unsaved || memory_.profile != profile) ++memory_.revision;
  memory_.profile = profile;
  apply_later();
  ParameterMessages::for_each([&]<class M>(Type<M>) {
    if constexpr (is_of_profile<M>) use(stored<M>(profile));
  });
}

std::optional<std::int32_t> Parameters::variable(msg::VariableId id) const {
  if (find_variable(id) == nullptr || !knows(versions_, id)) return std::nullopt;
  const Optional<std::int32_t> now = variable_value(in_use_, id);
  // Another variable may have changed the same parameter meanwhile.
  const auto set = variables_.find(id);
  if (set != variables_.end() && set->second.made == now) return set->second.given;
  return now ? *now : 0;
}

std::uint8_t Parameters::variable_count() const {
  return static_cast<std::uint8_t>(std::count_if(
      std::begin(EnumMeta<msg::VariableId>::values), std::end(EnumMeta<msg::VariableId>::values),
      [this](const ValueInfo& value) { return is_available(value.since, versions_); }));
}

bool Parameters::set_variable(msg::VariableId id, std::int32_t value) {
  const VariableInfo* const known = find_variable(id);
  if (known == nullptr || !knows(versions_, id) || value < known->range.lowest ||
      value > known->range.highest) {
    return false;
  }
  if (variable_value(in_use_, id) && !sbgc::set_variable(in_use_, id, value)) return false;
  variables_[id] = {value, variable_value(in_use_, id)};
  apply_later();
  return true;
}

std::optional<msg::VariableId> Parameters::set_variables(std::span<const msg::AdjVarValue> values) {
  const auto in_use = in_use_;
  const auto variables = variables_;
  const bool is_changed = is_changed_;
  for (const msg::AdjVarValue& one : values) {
    if (set_variable(one.param_id, one.param_value)) continue;
    // Do not set the old values again: they may be out of the variable's range.
    in_use_ = in_use;
    variables_ = variables;
    is_changed_ = is_changed;
    return one.param_id;
  }
  return {};
}

void Parameters::forget_variables() {
  std::erase_if(variables_, [](const auto& entry) { return entry.second.made.has_value(); });
}

void Parameters::save() {
  ParameterMessages::for_each([this]<class M>(Type<M>) {
    // Active parameters were stored or loaded before, so they are not too long.
    if constexpr (is_of_profile<M>) static_cast<void>(store(profile(), of<M>()));
  });
  forget_variables();
}

void Parameters::save(std::span<const msg::VariableId> variables) {
  // The stored parameters, with only these variables changed.
  OneOfEach<ParameterMessages> kept;
  ParameterMessages::for_each([&]<class M>(Type<M>) {
    if constexpr (is_of_profile<M>) kept.template of<M>() = stored<M>(profile());
  });
  for (const msg::VariableId id : variables) {
    const Optional<std::int32_t> value = variable_value(in_use_, id);
    if (value) static_cast<void>(sbgc::set_variable(kept, id, *value));
  }
  ParameterMessages::for_each([&]<class M>(Type<M>) {
    if constexpr (is_of_profile<M>) static_cast<void>(store(profile(), kept.template of<M>()));
  });
}

void Parameters::use_defaults(std::uint8_t profile) {
  ParameterMessages::for_each([&]<class M>(Type<M>) {
    if constexpr (is_of_profile<M>) {
      M defaults = factory<M>(profile);
      share(record<M>(0), defaults);
      static_cast<void>(write(profile, defaults));
    }
  });
}

void Parameters::save_profile_set(std::size_t slot) {
  std::vector<std::uint8_t>& all = memory_.profile_sets[slot];
  all.clear();
  for_each_record([&](std::size_t address) {
    const auto bytes = eeprom_.bytes(address, record_size());
    all.insert(all.end(), bytes.begin(), bytes.end());
  });
  ++memory_.revision;
}

void Parameters::clear_profile_set(std::size_t slot) {
  memory_.profile_sets[slot].clear();
  ++memory_.revision;
}

bool Parameters::load_profile_set(std::size_t slot) {
  std::span<const std::uint8_t> profiles = memory_.profile_sets[slot];
  std::size_t size = 0;
  for_each_record([&](std::size_t) { size += record_size(); });
  if (profiles.size() != size) return false;
  for_each_record([&](std::size_t address) {
    eeprom_.write(address, profiles.first(record_size()));
    profiles = profiles.subspan(record_size());
  });
  memory_.profile_set = static_cast<std::uint8_t>(slot + 1);
  ++memory_.revision;
  reload();
  apply_later();
  return true;
}

void Parameters::erase() {
  eeprom_.erase();
  if (memory_.profile != 0) ++memory_.revision;
  memory_.profile = 0;
  reload();
  apply_later();
}

namespace {

constexpr std::size_t axes = Axes<int>::size();

void set_motors(msg::ReadParams3& out) {
  constexpr std::uint8_t poles = 14;
  out.axes.roll = {
      .p = 12, .i = msg::Hundredths(10), .d = 12, .power = 80, .invert = 0, .poles = poles};
  out.axes.pitch = {
      .p = 14, .i = msg::Hundredths(12), .d = 14, .power = 90, .invert = 0, .poles = poles};
  out.axes.yaw = {
      .p = 18, .i = msg::Hundredths(14), .d = 18, .power = 110, .invert = 0, .poles = poles};
  out.output = {msg::MotorOutput::roll, msg::MotorOutput::pitch, msg::MotorOutput::yaw};
  out.pwm_freq = msg::PwmFrequency::high;
  out.booster_power = {40, 40, 40};
}

void set_remote_control(msg::ReadParams3& out) {
  for (std::size_t axis = 0; axis < axes; ++axis) {
    out.rc[axis].rc_lpf = 2;
    out.rc[axis].rc_speed = 50;
    out.follow_speed[axis] = 40;
    out.follow_lpf[axis] = 4;
  }
  out.rc.roll.rc_min_angle = -30_deg;
  out.rc.roll.rc_max_angle = 30_deg;
  out.rc.pitch.rc_min_angle = -45_deg;
  out.rc.pitch.rc_max_angle = 90_deg;
  out.rc.yaw.rc_min_angle = -180_deg;
  out.rc.yaw.rc_max_angle = 180_deg;
  out.rc_map = {msg::RcInput::rc_input_roll, msg::RcInput::rc_input_pitch,
                msg::RcInput::rc_input_yaw};
  out.rc_deadband = 10;
  out.follow_deadband = 2;
  out.follow_roll_mix_start = 0_deg;
  out.follow_roll_mix_range = 90_deg;
  out.menu_cmd = {msg::MenuCommand::profile1, msg::MenuCommand::profile2,
                  msg::MenuCommand::profile3, msg::MenuCommand::calib_acc,
                  msg::MenuCommand::calib_gyro};
  out.menu_cmd_long = msg::MenuCommand::motor_toggle;
}

void set_sensors(msg::ReadParams3& out) {
  out.gyro_trust = 120;
  out.axis_top = msg::SensorAxis::z;
  out.axis_right = msg::SensorAxis::x;
  out.frame_axis_top = msg::SensorAxis::z;
  out.frame_axis_right = msg::SensorAxis::x;
  out.frame_imu_pos = msg::FrameImuPosition::below_yaw;
  out.i2c_internal_pullups = 1;
  out.skip_gyro_calib = msg::SkipGyroCalibration::skip_always;
}

}  // namespace

void set_factory_values(msg::ReadParams3& out) {
  set_motors(out);
  set_remote_control(out);
  set_sensors(out);
  out.serial_speed = msg::SerialSpeed::baud_115200;
  out.bat_threshold_alarm = 14_V;
  out.bat_threshold_motors = 13.2_V;
  out.bat_comp_ref = 16_V;
  out.beeper_modes = msg::BeeperMode::calibrate | msg::BeeperMode::confirm |
                     msg::BeeperMode::error | msg::BeeperMode::alarm;
  out.servo_rate = 50_Hz;
  out.adaptive_pid_threshold = 10;
  out.adaptive_pid_rate = 10;
  out.adaptive_pid_recovery_factor = 5;
  out.cur_imu = msg::SelectedImu::main;
  out.cur_profile_id = out.profile_id;
}

void set_factory_values(msg::ReadParamsExt& out) {
  for (std::size_t axis = 0; axis < axes; ++axis) {
    out.lpf_freq[axis] = 120_Hz;
    out.filters_en[axis] = msg::FilterSwitch::lpf;
    out.motor_mag_link[axis] = 100;
    out.motor_gearing[axis] = 1_value;
    out.encoder_gear_ratio[axis] = 1_value;
    out.outer_p[axis] = 100;
    out.outer_i[axis] = 10;
    out.d_term_lpf_freq[axis] = 200_Hz;
  }
  out.beeper_volume = 100;
  out.mag_axis_top = msg::SensorAxis::z;
  out.mag_axis_right = msg::SensorAxis::x;
  out.mag_trust = 50;
  out.acc_lpf_freq = 5_Hz;
}

void set_factory_values(msg::ReadParamsExt2& out) {
  for (std::size_t axis = 0; axis < axes; ++axis) {
    out.motor_mag_link_fine[axis] = 100_value;
    out.pid_gain[axis] = 1_value;
  }
  out.frame_imu_lpf_freq = 60_Hz;
  out.auto_pid_cfg = msg::AutoPidFlag::roll | msg::AutoPidFlag::pitch | msg::AutoPidFlag::yaw |
                     msg::AutoPidFlag::send_gui;
  out.auto_pid_gain = 127;
  out.general_flags2 = msg::GeneralFlags2Bit::save_system_stat;
  out.auto_speed = 50;
  out.auto_acc_limiter = msg::AngularAcceleration(100);
  out.timelapse_time = msg::Seconds(60);
}

void set_factory_values(msg::ReadParamsExt3& out) {
  for (std::size_t axis = 0; axis < axes; ++axis) {
    out.stab_threshold_angle[axis] = msg::SmallDegrees(30);
    out.enc_limit_return_speed[axis] = 50;
  }
  for (std::size_t motor = 0; motor < out.ext_motor_drv_ids.size(); ++motor) {
    out.ext_motor_drv_ids[motor] = static_cast<std::uint8_t>(motor + 1);
  }
  out.rc_deadband_pitch = out.rc_deadband_yaw = 10;
}

void set_factory_values(msg::ReadProfileNames& out) {
  std::size_t number = 1;
  for (auto& name : out.profile_name) {
    static_cast<void>(name.assign("Profile " + std::to_string(number++)));  // short enough
  }
}

void set_factory_values(msg::ReadExternalData& out) {
  out.data.fill(0xFF);  // like erased memory
}

}  // namespace sbgc::emulator
