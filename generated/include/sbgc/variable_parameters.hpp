// Generated from spec/ by generator/: edit those, then run ./dev generate.

/// The settings that the adjustable variables control.
#pragma once

#include <cstdint>

#include <sbgc/enums.hpp>
#include <sbgc/messages/parameters.hpp>
#include <sbgc/messages/parameters_ext3.hpp>
#include <sbgc/types.hpp>
#include <sbgc/variable_scale.hpp>

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wdeprecated-declarations"

namespace sbgc {

/// Returns the value of a variable according to the first setting that it controls; empty if it
/// controls none. The value may exceed the range of the variable, because the setting may.
/// `settings.template of<M>()` returns a reference to the settings of message type M.
template <class Settings>
constexpr Optional<std::int32_t> variable_value([[maybe_unused]] const Settings& settings,
                                                msg::VariableId id) noexcept {
  switch (id) {
    case msg::VariableId::p_roll: return detail::variable_value({1, 0, 1}, settings.template of<msg::ReadParams3>().axes.roll.p);
    case msg::VariableId::p_pitch: return detail::variable_value({1, 0, 1}, settings.template of<msg::ReadParams3>().axes.pitch.p);
    case msg::VariableId::p_yaw: return detail::variable_value({1, 0, 1}, settings.template of<msg::ReadParams3>().axes.yaw.p);
    case msg::VariableId::i_roll: return detail::variable_value({1, 0, 1}, settings.template of<msg::ReadParams3>().axes.roll.i);
    case msg::VariableId::i_pitch: return detail::variable_value({1, 0, 1}, settings.template of<msg::ReadParams3>().axes.pitch.i);
    case msg::VariableId::i_yaw: return detail::variable_value({1, 0, 1}, settings.template of<msg::ReadParams3>().axes.yaw.i);
    case msg::VariableId::d_roll: return detail::variable_value({1, 0, 1}, settings.template of<msg::ReadParams3>().axes.roll.d);
    case msg::VariableId::d_pitch: return detail::variable_value({1, 0, 1}, settings.template of<msg::ReadParams3>().axes.pitch.d);
    case msg::VariableId::d_yaw: return detail::variable_value({1, 0, 1}, settings.template of<msg::ReadParams3>().axes.yaw.d);
    case msg::VariableId::power_roll: return detail::variable_value({1, 0, 1}, settings.template of<msg::ReadParams3>().axes.roll.power);
    case msg::VariableId::power_pitch: return detail::variable_value({1, 0, 1}, settings.template of<msg::ReadParams3>().axes.pitch.power);
    case msg::VariableId::power_yaw: return detail::variable_value({1, 0, 1}, settings.template of<msg::ReadParams3>().axes.yaw.power);
    case msg::VariableId::acc_limiter: return detail::variable_value({1, 0, 5}, settings.template of<msg::ReadParams3>().acc_limiter_all);
    case msg::VariableId::follow_speed_roll: return detail::variable_value({1, 0, 1}, settings.template of<msg::ReadParams3>().follow_speed.roll);
    case msg::VariableId::follow_speed_pitch: return detail::variable_value({1, 0, 1}, settings.template of<msg::ReadParams3>().follow_speed.pitch);
    case msg::VariableId::follow_speed_yaw: return detail::variable_value({1, 0, 1}, settings.template of<msg::ReadParams3>().follow_speed.yaw);
    case msg::VariableId::follow_lpf_roll: return detail::variable_value({1, 0, 1}, settings.template of<msg::ReadParams3>().follow_lpf.roll);
    case msg::VariableId::follow_lpf_pitch: return detail::variable_value({1, 0, 1}, settings.template of<msg::ReadParams3>().follow_lpf.pitch);
    case msg::VariableId::follow_lpf_yaw: return detail::variable_value({1, 0, 1}, settings.template of<msg::ReadParams3>().follow_lpf.yaw);
    case msg::VariableId::rc_speed_roll: return detail::variable_value({1, 0, 1}, settings.template of<msg::ReadParams3>().rc.roll.rc_speed);
    case msg::VariableId::rc_speed_pitch: return detail::variable_value({1, 0, 1}, settings.template of<msg::ReadParams3>().rc.pitch.rc_speed);
    case msg::VariableId::rc_speed_yaw: return detail::variable_value({1, 0, 1}, settings.template of<msg::ReadParams3>().rc.yaw.rc_speed);
    case msg::VariableId::rc_lpf_roll: return detail::variable_value({1, 0, 1}, settings.template of<msg::ReadParams3>().rc.roll.rc_lpf);
    case msg::VariableId::rc_lpf_pitch: return detail::variable_value({1, 0, 1}, settings.template of<msg::ReadParams3>().rc.pitch.rc_lpf);
    case msg::VariableId::rc_lpf_yaw: return detail::variable_value({1, 0, 1}, settings.template of<msg::ReadParams3>().rc.yaw.rc_lpf);
    case msg::VariableId::rc_trim_roll: return detail::variable_value({1, 0, 1}, settings.template of<msg::ReadParams3>().rc_trim.roll);
    case msg::VariableId::rc_trim_pitch: return detail::variable_value({1, 0, 1}, settings.template of<msg::ReadParams3>().rc_trim.pitch);
    case msg::VariableId::rc_trim_yaw: return detail::variable_value({1, 0, 1}, settings.template of<msg::ReadParams3>().rc_trim.yaw);
    case msg::VariableId::rc_deadband: return detail::variable_value({1, 0, 1}, settings.template of<msg::ReadParams3>().rc_deadband);
    case msg::VariableId::rc_expo_rate: return detail::variable_value({1, 0, 1}, settings.template of<msg::ReadParams3>().rc_expo_rate);
    case msg::VariableId::follow_mode: return detail::variable_value({1, 0, 1}, settings.template of<msg::ReadParams3>().follow_mode);
    case msg::VariableId::rc_follow_yaw: return detail::switch_value(settings.template of<msg::ReadParams3>().rc.yaw.rc_follow);
    case msg::VariableId::follow_deadband: return detail::variable_value({1, 0, 1}, settings.template of<msg::ReadParams3>().follow_deadband);
    case msg::VariableId::follow_expo_rate: return detail::variable_value({1, 0, 1}, settings.template of<msg::ReadParams3>().follow_expo_rate);
    case msg::VariableId::follow_roll_mix_start: return detail::variable_value({1, 0, 1}, settings.template of<msg::ReadParams3>().follow_roll_mix_start);
    case msg::VariableId::follow_roll_mix_range: return detail::variable_value({1, 0, 1}, settings.template of<msg::ReadParams3>().follow_roll_mix_range);
    case msg::VariableId::gyro_trust: return detail::variable_value({1, 0, 1}, settings.template of<msg::ReadParams3>().gyro_trust);
    case msg::VariableId::acc_limiter_roll: return detail::variable_value({1, 0, 5}, settings.template of<msg::ReadParamsExt2>().acc_limiter3.roll);
    case msg::VariableId::acc_limiter_pitch: return detail::variable_value({1, 0, 5}, settings.template of<msg::ReadParamsExt2>().acc_limiter3.pitch);
    case msg::VariableId::acc_limiter_yaw: return detail::variable_value({1, 0, 5}, settings.template of<msg::ReadParamsExt2>().acc_limiter3.yaw);
    case msg::VariableId::pid_gain_roll: return detail::variable_value({1, 0, 1}, settings.template of<msg::ReadParamsExt2>().pid_gain.roll);
    case msg::VariableId::pid_gain_pitch: return detail::variable_value({1, 0, 1}, settings.template of<msg::ReadParamsExt2>().pid_gain.pitch);
    case msg::VariableId::pid_gain_yaw: return detail::variable_value({1, 0, 1}, settings.template of<msg::ReadParamsExt2>().pid_gain.yaw);
    case msg::VariableId::lpf_freq_roll: return detail::variable_value({1, 0, 1}, settings.template of<msg::ReadParamsExt>().lpf_freq.roll);
    case msg::VariableId::lpf_freq_pitch: return detail::variable_value({1, 0, 1}, settings.template of<msg::ReadParamsExt>().lpf_freq.pitch);
    case msg::VariableId::lpf_freq_yaw: return detail::variable_value({1, 0, 1}, settings.template of<msg::ReadParamsExt>().lpf_freq.yaw);
    case msg::VariableId::timelapse_time: return detail::variable_value({1, 0, 1}, settings.template of<msg::ReadParamsExt2>().timelapse_time);
    case msg::VariableId::mav_ctrl_mode: return detail::variable_value({1, 0, 1}, settings.template of<msg::ReadParamsExt2>().mav_ctrl_mode);
    case msg::VariableId::sw_lim_min_roll: return detail::variable_value({1, 0, 1}, settings.template of<msg::ReadParamsExt2>().frame_cam_angle_min.roll);
    case msg::VariableId::sw_lim_max_roll: return detail::variable_value({1, 0, 1}, settings.template of<msg::ReadParamsExt2>().frame_cam_angle_max.roll);
    case msg::VariableId::sw_lim_min_pitch: return detail::variable_value({1, 0, 1}, settings.template of<msg::ReadParamsExt2>().frame_cam_angle_min.pitch);
    case msg::VariableId::sw_lim_max_pitch: return detail::variable_value({1, 0, 1}, settings.template of<msg::ReadParamsExt2>().frame_cam_angle_max.pitch);
    case msg::VariableId::sw_lim_min_yaw: return detail::variable_value({1, 0, 1}, settings.template of<msg::ReadParamsExt2>().frame_cam_angle_min.yaw);
    case msg::VariableId::sw_lim_max_yaw: return detail::variable_value({1, 0, 1}, settings.template of<msg::ReadParamsExt2>().frame_cam_angle_max.yaw);
    case msg::VariableId::follow_range_roll: return detail::variable_value({1, 0, 1}, settings.template of<msg::ReadParamsExt2>().follow_range.roll);
    case msg::VariableId::follow_range_pitch: return detail::variable_value({1, 0, 1}, settings.template of<msg::ReadParamsExt2>().follow_range.pitch);
    case msg::VariableId::follow_range_yaw: return detail::variable_value({1, 0, 1}, settings.template of<msg::ReadParamsExt2>().follow_range.yaw);
    case msg::VariableId::follow_in_dband: return detail::variable_value({1, 0, 1}, settings.template of<msg::ReadParamsExt>().follow_inside_deadband);
    case msg::VariableId::rc_limit_min_roll: return detail::variable_value({1, 0, 1}, settings.template of<msg::ReadParams3>().rc.roll.rc_min_angle);
    case msg::VariableId::rc_limit_max_roll: return detail::variable_value({1, 0, 1}, settings.template of<msg::ReadParams3>().rc.roll.rc_max_angle);
    case msg::VariableId::rc_limit_min_pitch: return detail::variable_value({1, 0, 1}, settings.template of<msg::ReadParams3>().rc.pitch.rc_min_angle);
    case msg::VariableId::rc_limit_max_pitch: return detail::variable_value({1, 0, 1}, settings.template of<msg::ReadParams3>().rc.pitch.rc_max_angle);
    case msg::VariableId::rc_limit_min_yaw: return detail::variable_value({1, 0, 1}, settings.template of<msg::ReadParams3>().rc.yaw.rc_min_angle);
    case msg::VariableId::rc_limit_max_yaw: return detail::variable_value({1, 0, 1}, settings.template of<msg::ReadParams3>().rc.yaw.rc_max_angle);
    case msg::VariableId::rc_deadband_pitch: return detail::variable_value({1, 0, 1}, settings.template of<msg::ReadParamsExt3>().rc_deadband_pitch);
    case msg::VariableId::rc_deadband_yaw: return detail::variable_value({1, 0, 1}, settings.template of<msg::ReadParamsExt3>().rc_deadband_yaw);
    case msg::VariableId::rc_expo_rate_pitch: return detail::variable_value({1, 0, 1}, settings.template of<msg::ReadParamsExt3>().rc_expo_rate_pitch);
    case msg::VariableId::rc_expo_rate_yaw: return detail::variable_value({1, 0, 1}, settings.template of<msg::ReadParamsExt3>().rc_expo_rate_yaw);
    case msg::VariableId::shake_amp_roll: return detail::variable_value({1, 0, 1}, settings.template of<msg::ReadParamsExt3>().shake_generator.amplitude.roll);
    case msg::VariableId::shake_amp_tilt: return detail::variable_value({1, 0, 1}, settings.template of<msg::ReadParamsExt3>().shake_generator.amplitude.pitch);
    case msg::VariableId::shake_amp_pan: return detail::variable_value({1, 0, 1}, settings.template of<msg::ReadParamsExt3>().shake_generator.amplitude.yaw);
    case msg::VariableId::shake_freq: return detail::variable_value({1, 0, 1}, settings.template of<msg::ReadParamsExt3>().shake_generator.base_freq);
    case msg::VariableId::shake_freq_range: return detail::variable_value({1, 0, 1}, settings.template of<msg::ReadParamsExt3>().shake_generator.freq_range);
    case msg::VariableId::shake_pause_period: return detail::variable_value({1, -500, 20}, settings.template of<msg::ReadParamsExt3>().shake_generator.pause_period);
    case msg::VariableId::shake_pause_balance: return detail::variable_value({1, 0, 1}, settings.template of<msg::ReadParamsExt3>().shake_generator.pause_balance);
    case msg::VariableId::shake_pause_randomness: return detail::variable_value({1, 0, 1}, settings.template of<msg::ReadParamsExt3>().shake_generator.pause_randomness);
    case msg::VariableId::shake_resonance_gain_roll: return detail::variable_value({1, 0, 1}, settings.template of<msg::ReadParamsExt3>().shake_generator.resonance_gain.roll);
    case msg::VariableId::shake_resonance_gain_tilt: return detail::variable_value({1, 0, 1}, settings.template of<msg::ReadParamsExt3>().shake_generator.resonance_gain.pitch);
    case msg::VariableId::shake_resonance_gain_pan: return detail::variable_value({1, 0, 1}, settings.template of<msg::ReadParamsExt3>().shake_generator.resonance_gain.yaw);
    case msg::VariableId::shake_freq_shift_roll: return detail::variable_value({1, 0, 1}, settings.template of<msg::ReadParamsExt3>().shake_generator.freq_shift.roll);
    case msg::VariableId::shake_freq_shift_tilt: return detail::variable_value({1, 0, 1}, settings.template of<msg::ReadParamsExt3>().shake_generator.freq_shift.pitch);
    case msg::VariableId::shake_freq_shift_pan: return detail::variable_value({1, 0, 1}, settings.template of<msg::ReadParamsExt3>().shake_generator.freq_shift.yaw);
    case msg::VariableId::outer_p_roll: return detail::variable_value({1, 0, 1}, settings.template of<msg::ReadParamsExt>().outer_p.roll);
    case msg::VariableId::outer_p_pitch: return detail::variable_value({1, 0, 1}, settings.template of<msg::ReadParamsExt>().outer_p.pitch);
    case msg::VariableId::outer_p_yaw: return detail::variable_value({1, 0, 1}, settings.template of<msg::ReadParamsExt>().outer_p.yaw);
    case msg::VariableId::d_lpf_freq_roll: return detail::variable_value({1, 0, 1}, settings.template of<msg::ReadParamsExt>().d_term_lpf_freq.roll);
    case msg::VariableId::d_lpf_freq_pitch: return detail::variable_value({1, 0, 1}, settings.template of<msg::ReadParamsExt>().d_term_lpf_freq.pitch);
    case msg::VariableId::d_lpf_freq_yaw: return detail::variable_value({1, 0, 1}, settings.template of<msg::ReadParamsExt>().d_term_lpf_freq.yaw);
    case msg::VariableId::imu_angle_corr_roll: return detail::variable_value({1, 0, 1}, settings.template of<msg::ReadParamsExt3>().imu_angle_corr_r);
    case msg::VariableId::imu_angle_corr_pitch: return detail::variable_value({1, 0, 1}, settings.template of<msg::ReadParamsExt3>().imu_angle_corr_p);
    case msg::VariableId::sw_lim_width_roll: return detail::variable_value({1, 0, 1}, settings.template of<msg::ReadParamsExt3>().soft_limit_width.roll);
    case msg::VariableId::sw_lim_width_pitch: return detail::variable_value({1, 0, 1}, settings.template of<msg::ReadParamsExt3>().soft_limit_width.pitch);
    case msg::VariableId::sw_lim_width_yaw: return detail::variable_value({1, 0, 1}, settings.template of<msg::ReadParamsExt3>().soft_limit_width.yaw);
    default: return {};
  }
}

/// Sets every setting that the variable controls to the nearest raw value; a sentinel only if `value`
/// converts to it exactly. Returns false and changes nothing if the variable controls no setting or
/// `value` is out of its range.
template <class Settings>
constexpr bool set_variable([[maybe_unused]] Settings& settings, msg::VariableId id,
                            [[maybe_unused]] std::int32_t value) noexcept {
  switch (id) {
    case msg::VariableId::p_roll:
      if (value < 0 || value > 255) return false;
      detail::set_variable({1, 0, 1}, settings.template of<msg::ReadParams3>().axes.roll.p, value);
      return true;
    case msg::VariableId::p_pitch:
      if (value < 0 || value > 255) return false;
      detail::set_variable({1, 0, 1}, settings.template of<msg::ReadParams3>().axes.pitch.p, value);
      return true;
    case msg::VariableId::p_yaw:
      if (value < 0 || value > 255) return false;
      detail::set_variable({1, 0, 1}, settings.template of<msg::ReadParams3>().axes.yaw.p, value);
      return true;
    case msg::VariableId::i_roll:
      if (value < 0 || value > 255) return false;
      detail::set_variable({1, 0, 1}, settings.template of<msg::ReadParams3>().axes.roll.i, value);
      return true;
    case msg::VariableId::i_pitch:
      if (value < 0 || value > 255) return false;
      detail::set_variable({1, 0, 1}, settings.template of<msg::ReadParams3>().axes.pitch.i, value);
      return true;
    case msg::VariableId::i_yaw:
      if (value < 0 || value > 255) return false;
      detail::set_variable({1, 0, 1}, settings.template of<msg::ReadParams3>().axes.yaw.i, value);
      return true;
    case msg::VariableId::d_roll:
      if (value < 0 || value > 255) return false;
      detail::set_variable({1, 0, 1}, settings.template of<msg::ReadParams3>().axes.roll.d, value);
      return true;
    case msg::VariableId::d_pitch:
      if (value < 0 || value > 255) return false;
      detail::set_variable({1, 0, 1}, settings.template of<msg::ReadParams3>().axes.pitch.d, value);
      return true;
    case msg::VariableId::d_yaw:
      if (value < 0 || value > 255) return false;
      detail::set_variable({1, 0, 1}, settings.template of<msg::ReadParams3>().axes.yaw.d, value);
      return true;
    case msg::VariableId::power_roll:
      if (value < 0 || value > 255) return false;
      detail::set_variable({1, 0, 1}, settings.template of<msg::ReadParams3>().axes.roll.power, value);
      return true;
    case msg::VariableId::power_pitch:
      if (value < 0 || value > 255) return false;
      detail::set_variable({1, 0, 1}, settings.template of<msg::ReadParams3>().axes.pitch.power, value);
      return true;
    case msg::VariableId::power_yaw:
      if (value < 0 || value > 255) return false;
      detail::set_variable({1, 0, 1}, settings.template of<msg::ReadParams3>().axes.yaw.power, value);
      return true;
    case msg::VariableId::acc_limiter:
      if (value < 0 || value > 1275) return false;
      detail::set_variable({1, 0, 5}, settings.template of<msg::ReadParams3>().acc_limiter_all, value, {0});
      detail::set_variable({1, 0, 5}, settings.template of<msg::ReadParamsExt2>().acc_limiter3.roll, value, {0});
      detail::set_variable({1, 0, 5}, settings.template of<msg::ReadParamsExt2>().acc_limiter3.pitch, value, {0});
      detail::set_variable({1, 0, 5}, settings.template of<msg::ReadParamsExt2>().acc_limiter3.yaw, value, {0});
      return true;
    case msg::VariableId::follow_speed_roll:
      if (value < 0 || value > 255) return false;
      detail::set_variable({1, 0, 1}, settings.template of<msg::ReadParams3>().follow_speed.roll, value);
      return true;
    case msg::VariableId::follow_speed_pitch:
      if (value < 0 || value > 255) return false;
      detail::set_variable({1, 0, 1}, settings.template of<msg::ReadParams3>().follow_speed.pitch, value);
      return true;
    case msg::VariableId::follow_speed_yaw:
      if (value < 0 || value > 255) return false;
      detail::set_variable({1, 0, 1}, settings.template of<msg::ReadParams3>().follow_speed.yaw, value);
      return true;
    case msg::VariableId::follow_lpf_roll:
      if (value < 0 || value > 16) return false;
      detail::set_variable({1, 0, 1}, settings.template of<msg::ReadParams3>().follow_lpf.roll, value);
      return true;
    case msg::VariableId::follow_lpf_pitch:
      if (value < 0 || value > 16) return false;
      detail::set_variable({1, 0, 1}, settings.template of<msg::ReadParams3>().follow_lpf.pitch, value);
      return true;
    case msg::VariableId::follow_lpf_yaw:
      if (value < 0 || value > 16) return false;
      detail::set_variable({1, 0, 1}, settings.template of<msg::ReadParams3>().follow_lpf.yaw, value);
      return true;
    case msg::VariableId::rc_speed_roll:
      if (value < 0 || value > 255) return false;
      detail::set_variable({1, 0, 1}, settings.template of<msg::ReadParams3>().rc.roll.rc_speed, value);
      return true;
    case msg::VariableId::rc_speed_pitch:
      if (value < 0 || value > 255) return false;
      detail::set_variable({1, 0, 1}, settings.template of<msg::ReadParams3>().rc.pitch.rc_speed, value);
      return true;
    case msg::VariableId::rc_speed_yaw:
      if (value < 0 || value > 255) return false;
      detail::set_variable({1, 0, 1}, settings.template of<msg::ReadParams3>().rc.yaw.rc_speed, value);
      return true;
    case msg::VariableId::rc_lpf_roll:
      if (value < 0 || value > 255) return false;
      detail::set_variable({1, 0, 1}, settings.template of<msg::ReadParams3>().rc.roll.rc_lpf, value);
      return true;
    case msg::VariableId::rc_lpf_pitch:
      if (value < 0 || value > 255) return false;
      detail::set_variable({1, 0, 1}, settings.template of<msg::ReadParams3>().rc.pitch.rc_lpf, value);
      return true;
    case msg::VariableId::rc_lpf_yaw:
      if (value < 0 || value > 255) return false;
      detail::set_variable({1, 0, 1}, settings.template of<msg::ReadParams3>().rc.yaw.rc_lpf, value);
      return true;
    case msg::VariableId::rc_trim_roll:
      if (value < -127 || value > 127) return false;
      detail::set_variable({1, 0, 1}, settings.template of<msg::ReadParams3>().rc_trim.roll, value);
      return true;
    case msg::VariableId::rc_trim_pitch:
      if (value < -127 || value > 127) return false;
      detail::set_variable({1, 0, 1}, settings.template of<msg::ReadParams3>().rc_trim.pitch, value);
      return true;
    case msg::VariableId::rc_trim_yaw:
      if (value < -127 || value > 127) return false;
      detail::set_variable({1, 0, 1}, settings.template of<msg::ReadParams3>().rc_trim.yaw, value);
      return true;
    case msg::VariableId::rc_deadband:
      if (value < 0 || value > 255) return false;
      detail::set_variable({1, 0, 1}, settings.template of<msg::ReadParams3>().rc_deadband, value);
      return true;
    case msg::VariableId::rc_expo_rate:
      if (value < 0 || value > 100) return false;
      detail::set_variable({1, 0, 1}, settings.template of<msg::ReadParams3>().rc_expo_rate, value);
      return true;
    case msg::VariableId::follow_mode:
      if (value < 0 || value > 2) return false;
      detail::set_variable({1, 0, 1}, settings.template of<msg::ReadParams3>().follow_mode, value);
      return true;
    case msg::VariableId::rc_follow_yaw:
      if (value < 0 || value > 1) return false;
      detail::set_switch(settings.template of<msg::ReadParams3>().rc.yaw.rc_follow, value);
      return true;
    case msg::VariableId::follow_deadband:
      if (value < 0 || value > 255) return false;
      detail::set_variable({1, 0, 1}, settings.template of<msg::ReadParams3>().follow_deadband, value);
      return true;
    case msg::VariableId::follow_expo_rate:
      if (value < 0 || value > 100) return false;
      detail::set_variable({1, 0, 1}, settings.template of<msg::ReadParams3>().follow_expo_rate, value);
      return true;
    case msg::VariableId::follow_roll_mix_start:
      if (value < 0 || value > 90) return false;
      detail::set_variable({1, 0, 1}, settings.template of<msg::ReadParams3>().follow_roll_mix_start, value);
      return true;
    case msg::VariableId::follow_roll_mix_range:
      if (value < 0 || value > 90) return false;
      detail::set_variable({1, 0, 1}, settings.template of<msg::ReadParams3>().follow_roll_mix_range, value);
      return true;
    case msg::VariableId::gyro_trust:
      if (value < 0 || value > 255) return false;
      detail::set_variable({1, 0, 1}, settings.template of<msg::ReadParams3>().gyro_trust, value);
      return true;
    case msg::VariableId::acc_limiter_roll:
      if (value < 0 || value > 1275) return false;
      detail::set_variable({1, 0, 5}, settings.template of<msg::ReadParamsExt2>().acc_limiter3.roll, value, {0});
      return true;
    case msg::VariableId::acc_limiter_pitch:
      if (value < 0 || value > 1275) return false;
      detail::set_variable({1, 0, 5}, settings.template of<msg::ReadParamsExt2>().acc_limiter3.pitch, value, {0});
      return true;
    case msg::VariableId::acc_limiter_yaw:
      if (value < 0 || value > 1275) return false;
      detail::set_variable({1, 0, 5}, settings.template of<msg::ReadParamsExt2>().acc_limiter3.yaw, value, {0});
      return true;
    case msg::VariableId::pid_gain_roll:
      if (value < 0 || value > 255) return false;
      detail::set_variable({1, 0, 1}, settings.template of<msg::ReadParamsExt2>().pid_gain.roll, value);
      return true;
    case msg::VariableId::pid_gain_pitch:
      if (value < 0 || value > 255) return false;
      detail::set_variable({1, 0, 1}, settings.template of<msg::ReadParamsExt2>().pid_gain.pitch, value);
      return true;
    case msg::VariableId::pid_gain_yaw:
      if (value < 0 || value > 255) return false;
      detail::set_variable({1, 0, 1}, settings.template of<msg::ReadParamsExt2>().pid_gain.yaw, value);
      return true;
    case msg::VariableId::lpf_freq_roll:
      if (value < 10 || value > 400) return false;
      detail::set_variable({1, 0, 1}, settings.template of<msg::ReadParamsExt>().lpf_freq.roll, value);
      return true;
    case msg::VariableId::lpf_freq_pitch:
      if (value < 10 || value > 400) return false;
      detail::set_variable({1, 0, 1}, settings.template of<msg::ReadParamsExt>().lpf_freq.pitch, value);
      return true;
    case msg::VariableId::lpf_freq_yaw:
      if (value < 10 || value > 400) return false;
      detail::set_variable({1, 0, 1}, settings.template of<msg::ReadParamsExt>().lpf_freq.yaw, value);
      return true;
    case msg::VariableId::timelapse_time:
      if (value < 1 || value > 3600) return false;
      detail::set_variable({1, 0, 1}, settings.template of<msg::ReadParamsExt2>().timelapse_time, value);
      return true;
    case msg::VariableId::mav_ctrl_mode:
      if (value < 0 || value > 2) return false;
      detail::set_variable({1, 0, 1}, settings.template of<msg::ReadParamsExt2>().mav_ctrl_mode, value);
      return true;
    case msg::VariableId::sw_lim_min_roll:
      if (value < -3600 || value > 3600) return false;
      detail::set_variable({1, 0, 1}, settings.template of<msg::ReadParamsExt2>().frame_cam_angle_min.roll, value);
      return true;
    case msg::VariableId::sw_lim_max_roll:
      if (value < -3600 || value > 3600) return false;
      detail::set_variable({1, 0, 1}, settings.template of<msg::ReadParamsExt2>().frame_cam_angle_max.roll, value);
      return true;
    case msg::VariableId::sw_lim_min_pitch:
      if (value < -3600 || value > 3600) return false;
      detail::set_variable({1, 0, 1}, settings.template of<msg::ReadParamsExt2>().frame_cam_angle_min.pitch, value);
      return true;
    case msg::VariableId::sw_lim_max_pitch:
      if (value < -3600 || value > 3600) return false;
      detail::set_variable({1, 0, 1}, settings.template of<msg::ReadParamsExt2>().frame_cam_angle_max.pitch, value);
      return true;
    case msg::VariableId::sw_lim_min_yaw:
      if (value < -3600 || value > 3600) return false;
      detail::set_variable({1, 0, 1}, settings.template of<msg::ReadParamsExt2>().frame_cam_angle_min.yaw, value);
      return true;
    case msg::VariableId::sw_lim_max_yaw:
      if (value < -3600 || value > 3600) return false;
      detail::set_variable({1, 0, 1}, settings.template of<msg::ReadParamsExt2>().frame_cam_angle_max.yaw, value);
      return true;
    case msg::VariableId::follow_range_roll:
      if (value < 0 || value > 255) return false;
      detail::set_variable({1, 0, 1}, settings.template of<msg::ReadParamsExt2>().follow_range.roll, value);
      return true;
    case msg::VariableId::follow_range_pitch:
      if (value < 0 || value > 255) return false;
      detail::set_variable({1, 0, 1}, settings.template of<msg::ReadParamsExt2>().follow_range.pitch, value);
      return true;
    case msg::VariableId::follow_range_yaw:
      if (value < 0 || value > 255) return false;
      detail::set_variable({1, 0, 1}, settings.template of<msg::ReadParamsExt2>().follow_range.yaw, value);
      return true;
    case msg::VariableId::follow_in_dband:
      if (value < 0 || value > 255) return false;
      detail::set_variable({1, 0, 1}, settings.template of<msg::ReadParamsExt>().follow_inside_deadband, value);
      return true;
    case msg::VariableId::rc_limit_min_roll:
      if (value < -3600 || value > 3600) return false;
      detail::set_variable({1, 0, 1}, settings.template of<msg::ReadParams3>().rc.roll.rc_min_angle, value);
      return true;
    case msg::VariableId::rc_limit_max_roll:
      if (value < -3600 || value > 3600) return false;
      detail::set_variable({1, 0, 1}, settings.template of<msg::ReadParams3>().rc.roll.rc_max_angle, value);
      return true;
    case msg::VariableId::rc_limit_min_pitch:
      if (value < -3600 || value > 3600) return false;
      detail::set_variable({1, 0, 1}, settings.template of<msg::ReadParams3>().rc.pitch.rc_min_angle, value);
      return true;
    case msg::VariableId::rc_limit_max_pitch:
      if (value < -3600 || value > 3600) return false;
      detail::set_variable({1, 0, 1}, settings.template of<msg::ReadParams3>().rc.pitch.rc_max_angle, value);
      return true;
    case msg::VariableId::rc_limit_min_yaw:
      if (value < -3600 || value > 3600) return false;
      detail::set_variable({1, 0, 1}, settings.template of<msg::ReadParams3>().rc.yaw.rc_min_angle, value);
      return true;
    case msg::VariableId::rc_limit_max_yaw:
      if (value < -3600 || value > 3600) return false;
      detail::set_variable({1, 0, 1}, settings.template of<msg::ReadParams3>().rc.yaw.rc_max_angle, value);
      return true;
    case msg::VariableId::rc_deadband_pitch:
      if (value < 0 || value > 255) return false;
      detail::set_variable({1, 0, 1}, settings.template of<msg::ReadParamsExt3>().rc_deadband_pitch, value);
      return true;
    case msg::VariableId::rc_deadband_yaw:
      if (value < 0 || value > 255) return false;
      detail::set_variable({1, 0, 1}, settings.template of<msg::ReadParamsExt3>().rc_deadband_yaw, value);
      return true;
    case msg::VariableId::rc_expo_rate_pitch:
      if (value < 0 || value > 255) return false;
      detail::set_variable({1, 0, 1}, settings.template of<msg::ReadParamsExt3>().rc_expo_rate_pitch, value);
      return true;
    case msg::VariableId::rc_expo_rate_yaw:
      if (value < 0 || value > 255) return false;
      detail::set_variable({1, 0, 1}, settings.template of<msg::ReadParamsExt3>().rc_expo_rate_yaw, value);
      return true;
    case msg::VariableId::shake_amp_roll:
      if (value < 0 || value > 255) return false;
      detail::set_variable({1, 0, 1}, settings.template of<msg::ReadParamsExt3>().shake_generator.amplitude.roll, value);
      return true;
    case msg::VariableId::shake_amp_tilt:
      if (value < 0 || value > 255) return false;
      detail::set_variable({1, 0, 1}, settings.template of<msg::ReadParamsExt3>().shake_generator.amplitude.pitch, value);
      return true;
    case msg::VariableId::shake_amp_pan:
      if (value < 0 || value > 255) return false;
      detail::set_variable({1, 0, 1}, settings.template of<msg::ReadParamsExt3>().shake_generator.amplitude.yaw, value);
      return true;
    case msg::VariableId::shake_freq:
      if (value < 0 || value > 255) return false;
      detail::set_variable({1, 0, 1}, settings.template of<msg::ReadParamsExt3>().shake_generator.base_freq, value);
      return true;
    case msg::VariableId::shake_freq_range:
      if (value < 0 || value > 100) return false;
      detail::set_variable({1, 0, 1}, settings.template of<msg::ReadParamsExt3>().shake_generator.freq_range, value);
      return true;
    case msg::VariableId::shake_pause_period:
      if (value < 500 || value > 5600) return false;
      detail::set_variable({1, -500, 20}, settings.template of<msg::ReadParamsExt3>().shake_generator.pause_period, value);
      return true;
    case msg::VariableId::shake_pause_balance:
      if (value < 0 || value > 255) return false;
      detail::set_variable({1, 0, 1}, settings.template of<msg::ReadParamsExt3>().shake_generator.pause_balance, value);
      return true;
    case msg::VariableId::shake_pause_randomness:
      if (value < 0 || value > 100) return false;
      detail::set_variable({1, 0, 1}, settings.template of<msg::ReadParamsExt3>().shake_generator.pause_randomness, value);
      return true;
    case msg::VariableId::shake_resonance_gain_roll:
      if (value < 0 || value > 255) return false;
      detail::set_variable({1, 0, 1}, settings.template of<msg::ReadParamsExt3>().shake_generator.resonance_gain.roll, value);
      return true;
    case msg::VariableId::shake_resonance_gain_tilt:
      if (value < 0 || value > 255) return false;
      detail::set_variable({1, 0, 1}, settings.template of<msg::ReadParamsExt3>().shake_generator.resonance_gain.pitch, value);
      return true;
    case msg::VariableId::shake_resonance_gain_pan:
      if (value < 0 || value > 255) return false;
      detail::set_variable({1, 0, 1}, settings.template of<msg::ReadParamsExt3>().shake_generator.resonance_gain.yaw, value);
      return true;
    case msg::VariableId::shake_freq_shift_roll:
      if (value < -127 || value > 127) return false;
      detail::set_variable({1, 0, 1}, settings.template of<msg::ReadParamsExt3>().shake_generator.freq_shift.roll, value);
      return true;
    case msg::VariableId::shake_freq_shift_tilt:
      if (value < -127 || value > 127) return false;
      detail::set_variable({1, 0, 1}, settings.template of<msg::ReadParamsExt3>().shake_generator.freq_shift.pitch, value);
      return true;
    case msg::VariableId::shake_freq_shift_pan:
      if (value < -127 || value > 127) return false;
      detail::set_variable({1, 0, 1}, settings.template of<msg::ReadParamsExt3>().shake_generator.freq_shift.yaw, value);
      return true;
    case msg::VariableId::outer_p_roll:
      if (value < 0 || value > 255) return false;
      detail::set_variable({1, 0, 1}, settings.template of<msg::ReadParamsExt>().outer_p.roll, value);
      return true;
    case msg::VariableId::outer_p_pitch:
      if (value < 0 || value > 255) return false;
      detail::set_variable({1, 0, 1}, settings.template of<msg::ReadParamsExt>().outer_p.pitch, value);
      return true;
    case msg::VariableId::outer_p_yaw:
      if (value < 0 || value > 255) return false;
      detail::set_variable({1, 0, 1}, settings.template of<msg::ReadParamsExt>().outer_p.yaw, value);
      return true;
    case msg::VariableId::d_lpf_freq_roll:
      if (value < 0 || value > 255) return false;
      detail::set_variable({1, 0, 1}, settings.template of<msg::ReadParamsExt>().d_term_lpf_freq.roll, value);
      return true;
    case msg::VariableId::d_lpf_freq_pitch:
      if (value < 0 || value > 255) return false;
      detail::set_variable({1, 0, 1}, settings.template of<msg::ReadParamsExt>().d_term_lpf_freq.pitch, value);
      return true;
    case msg::VariableId::d_lpf_freq_yaw:
      if (value < 0 || value > 255) return false;
      detail::set_variable({1, 0, 1}, settings.template of<msg::ReadParamsExt>().d_term_lpf_freq.yaw, value);
      return true;
    case msg::VariableId::imu_angle_corr_roll:
      if (value < -1000 || value > 1000) return false;
      detail::set_variable({1, 0, 1}, settings.template of<msg::ReadParamsExt3>().imu_angle_corr_r, value);
      return true;
    case msg::VariableId::imu_angle_corr_pitch:
      if (value < -1000 || value > 1000) return false;
      detail::set_variable({1, 0, 1}, settings.template of<msg::ReadParamsExt3>().imu_angle_corr_p, value);
      return true;
    case msg::VariableId::sw_lim_width_roll:
      if (value < 0 || value > 255) return false;
      detail::set_variable({1, 0, 1}, settings.template of<msg::ReadParamsExt3>().soft_limit_width.roll, value);
      return true;
    case msg::VariableId::sw_lim_width_pitch:
      if (value < 0 || value > 255) return false;
      detail::set_variable({1, 0, 1}, settings.template of<msg::ReadParamsExt3>().soft_limit_width.pitch, value);
      return true;
    case msg::VariableId::sw_lim_width_yaw:
      if (value < 0 || value > 255) return false;
      detail::set_variable({1, 0, 1}, settings.template of<msg::ReadParamsExt3>().soft_limit_width.yaw, value);
      return true;
    default: return false;
  }
}

}  // namespace sbgc

#pragma GCC diagnostic pop
