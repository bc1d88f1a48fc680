#include "device/parts/remote_control.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include <sbgc/detail/meta_limits.hpp>
#include <sbgc/meta/parameters.hpp>

#include "device/device.hpp"

namespace sbgc::board {
namespace {

/// Settings that bend a signal have its resolution: 500 counts from the middle to the end. Ours:
/// the specification gives no units.
double share_of_signal(int counts) {
  return msg::CentredRcSignal(static_cast<std::int16_t>(counts)).fraction();
}

/// A flight controller's signal with EXT_FC_GAIN; 127 is the whole signal: ours.
double amplified(double signal, int gain) {
  return signal * gain / std::numeric_limits<std::int8_t>::max();
}

/// Adds the flight controller's share, if it is mixed into this axis. Ours: an axis without a
/// signal of its own has that share alone, as if its own signal were in the middle.
void mix_in(std::optional<double>& signal, msg::RcMix mix, std::size_t axis,
            std::optional<double> controller, int gain) {
  constexpr std::array targets{msg::MixTarget::roll, msg::MixTarget::pitch, msg::MixTarget::yaw};
  if (mix.target() != targets[axis] || mix.rate() == 0 || !controller) return;
  constexpr double all = msg::RcMix(std::numeric_limits<msg::RcMix::raw_type>::max()).rate();
  const double share = mix.rate() / all;
  signal = signal.value_or(0) * (1 - share) + amplified(*controller, gain) * share;
}

}  // namespace

double Remote::bent(const msg::ReadParams3& settings, std::size_t axis, double signal) {
  if (settings.rc[axis].rc_mode.inverted()) signal = -signal;
  signal += share_of_signal(settings.rc_trim[axis]);
  const double deadband = share_of_signal(settings.rc_deadband);
  const double beyond = std::abs(signal) - deadband;
  if (beyond <= 0) return 0;
  constexpr double whole =
      sbgc::detail::field_info<msg::ReadParams3>("rc_expo_rate").range->highest;
  const double curve = settings.rc_expo_rate / whole;
  // Ours: the rest of the way covers the whole range, so that the ends can be reached.
  const double size = std::min(beyond / (1 - deadband), 1.0);
  return std::copysign((1 - curve) * size + curve * size * size * size, signal);
}

std::optional<double> Remote::signal(msg::RcMap source) const {
  if (source.source() != msg::RcSource::api || source.channel() == 0) return {};
  return signals_[source.channel() - 1U];
}

std::optional<double> Remote::own(const Machine& machine, std::size_t axis) const {
  return signal(machine.settings.of<msg::ReadParams3>().rc_map[source_of_axis_[axis]]);
}

std::optional<double> Remote::axis(const Machine& machine, std::size_t axis) const {
  const auto& settings = machine.settings.of<msg::ReadParams3>();
  std::optional<double> result = own(machine, axis);
  if (result) result = bent(settings, axis, *result);
  mix_in(result, settings.rc_mix_fc_roll, axis, signal(settings.rc_map_fc_roll),
         settings.ext_fc_gain_roll);
  mix_in(result, settings.rc_mix_fc_pitch, axis, signal(settings.rc_map_fc_pitch),
         settings.ext_fc_gain_pitch);
  if (result) result = std::clamp(*result, -1.0, 1.0);
  return result;
}

std::optional<double> Remote::followed(const Machine& machine, std::size_t axis) const {
  constexpr std::size_t roll = 0, pitch = 1;
  const auto& settings = machine.settings.of<msg::ReadParams3>();
  if (settings.follow_mode != msg::FollowMode::fc || (axis != roll && axis != pitch)) return {};
  const msg::RcMap source = axis == roll ? settings.rc_map_fc_roll : settings.rc_map_fc_pitch;
  const int gain = axis == roll ? settings.ext_fc_gain_roll : settings.ext_fc_gain_pitch;
  // Ours: the whole signal says that the frame leans by 90 degrees, RC_FOLLOW counts percents, and
  // who is no longer heard is level.
  return 90 * amplified(signal(source).value_or(0), gain) * settings.rc[axis].rc_follow / 100;
}

void Remote::swap(std::size_t one, std::size_t other) {
  std::swap(source_of_axis_[one], source_of_axis_[other]);
}

void Remote::apply(Machine& machine, Instant now) const {
  for (std::size_t index = 0; index < source_of_axis_.size(); ++index) {
    machine.gimbal.set_remote(index, axis(machine, index), now);
    machine.gimbal.set_followed(index, followed(machine, index), now);
  }
}

void Remote::set_channels(Machine& machine, const msg::ApiVirtChControl& signals, Instant now) {
  for (std::size_t i = 0; i < signals.val_ch.size(); ++i) {
    const msg::CentredRcSignal signal = signals.val_ch[i];
    if (signal.raw() == msg::ApiVirtChControl::undefined) {
      signals_[i].reset();
    } else {
      // "Value may go outside these limits and will be clipped."
      signals_[i] = std::clamp(signal.fraction(), -1.0, 1.0);
    }
  }
  apply(machine, now);
  follow_command_channel(machine, now);
}

/// The command channel is a switch of three positions; each change of it starts an action. Only new
/// signals do: were it looked at after each change of settings, an action that changes the
/// channel's source could start itself for ever.
void Remote::follow_command_channel(Machine& machine, Instant now) {
  const auto& settings = machine.settings.of<msg::ReadParams3>();
  const auto level = signal(settings.rc_map_cmd);
  // Thirds of the range: ours.
  constexpr double third = 1.0 / 3;
  const Position position = !level            ? Position::none
                            : *level < -third ? Position::low
                            : *level > third  ? Position::high
                                              : Position::middle;
  if (std::exchange(command_, position) == position || position == Position::none) return;
  const msg::MenuCommand action = position == Position::low    ? settings.rc_cmd_low
                                  : position == Position::high ? settings.rc_cmd_high
                                                               : settings.rc_cmd_mid;
  static_cast<void>(machine.execute(action, now));
}

void Remote::restart(Machine& /*machine*/, Instant /*now*/) { *this = {}; }

}  // namespace sbgc::board
