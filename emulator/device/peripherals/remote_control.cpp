#include "device/peripherals/remote_control.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include <sbgc/internal/meta_limits.hpp>
#include <sbgc/meta/parameters.hpp>

#include "device/control/menu.hpp"
#include "device/parameters/parameters.hpp"
#include "physics/quantities.hpp"

namespace sbgc::emulator {
namespace {

/// Parameters that shape a signal have its resolution: 500 counts from the center to the end.
/// Assumption: the specification gives no units.
double share_of_signal(int counts) {
  return msg::CentredRcSignal(static_cast<std::int16_t>(counts)).fraction();
}

/// Scales a signal of a flight controller by EXT_FC_GAIN. Assumption: 127 means the full signal.
double amplified(double signal, int gain) {
  return signal * gain / std::numeric_limits<std::int8_t>::max();
}

/// Adds the flight controller's share if it is mixed into this axis. Assumption: an axis without
/// its own signal uses the share alone, as if its own signal were centered.
void mix_in(std::optional<double>& signal, msg::RcMix mix, std::size_t axis,
            std::optional<double> controller, int gain) {
  constexpr std::array targets{msg::MixTarget::roll, msg::MixTarget::pitch, msg::MixTarget::yaw};
  if (mix.target() != targets[axis] || mix.rate() == 0 || !controller) return;
  constexpr double all = msg::RcMix(std::numeric_limits<msg::RcMix::raw_type>::max()).rate();
  const double share = mix.rate() / all;
  signal = signal.value_or(0) * (1 - share) + amplified(*controller, gain) * share;
}

}  // namespace

msg::FineRcSignal fine_signal(std::optional<double> signal) {
  return signal ? saturated<msg::FineRcSignal>(*signal)
                : msg::FineRcSignal(msg::RealtimeDataCustom::undefined);
}

double RemoteControl::shaped(const msg::ReadParams3& parameters, std::size_t axis, double signal) {
  if (parameters.rc[axis].rc_mode.inverted()) signal = -signal;
  signal += share_of_signal(parameters.rc_trim[axis]);
  const double deadband = share_of_signal(parameters.rc_deadband);
  const double beyond = std::abs(signal) - deadband;
  if (beyond <= 0) return 0;
  constexpr double whole =
      sbgc::detail::field_info<msg::ReadParams3>("rc_expo_rate").range->highest;
  const double curve = parameters.rc_expo_rate / whole;
  // Assumption: the remaining range is stretched, so that the ends can be reached.
  const double size = std::min(beyond / (1 - deadband), 1.0);
  return std::copysign((1 - curve) * size + curve * size * size * size, signal);
}

std::optional<double> RemoteControl::signal(msg::RcMap source) const {
  if (source.source() != msg::RcSource::api || source.channel() == 0) return {};
  return signals_[source.channel() - 1U];
}

std::optional<double> RemoteControl::own(const Parameters& parameters, std::size_t axis) const {
  return signal(parameters.of<msg::ReadParams3>().rc_map[source_of_axis_[axis]]);
}

std::optional<double> RemoteControl::axis(const Parameters& in_use, std::size_t axis) const {
  const auto& parameters = in_use.of<msg::ReadParams3>();
  std::optional<double> result = own(in_use, axis);
  if (result) result = shaped(parameters, axis, *result);
  mix_in(result, parameters.rc_mix_fc_roll, axis, signal(parameters.rc_map_fc_roll),
         parameters.ext_fc_gain_roll);
  mix_in(result, parameters.rc_mix_fc_pitch, axis, signal(parameters.rc_map_fc_pitch),
         parameters.ext_fc_gain_pitch);
  if (result) result = std::clamp(*result, -1.0, 1.0);
  return result;
}

std::optional<double> RemoteControl::followed(const Parameters& in_use, std::size_t axis) const {
  constexpr std::size_t roll = 0, pitch = 1;
  const auto& parameters = in_use.of<msg::ReadParams3>();
  if (parameters.follow_mode != msg::FollowMode::fc || (axis != roll && axis != pitch)) return {};
  const msg::RcMap source = axis == roll ? parameters.rc_map_fc_roll : parameters.rc_map_fc_pitch;
  const int gain = axis == roll ? parameters.ext_fc_gain_roll : parameters.ext_fc_gain_pitch;
  // Assumption: the full signal means a frame tilt of 90 degrees, RC_FOLLOW is in percent, and a
  // missing signal means level.
  return 90 * amplified(signal(source).value_or(0), gain) * parameters.rc[axis].rc_follow / 100;
}

void RemoteControl::swap(std::size_t one, std::size_t other) {
  std::swap(source_of_axis_[one], source_of_axis_[other]);
}

void RemoteControl::apply(const Parameters& parameters, Gimbal& gimbal, Instant now) const {
  for (std::size_t index = 0; index < source_of_axis_.size(); ++index) {
    gimbal.set_remote(index, axis(parameters, index), now);
    gimbal.set_followed(index, followed(parameters, index), now);
  }
}

template <class Signals>
void RemoteControl::set_channels(MenuParts& parts, const Signals& signals, Instant now) {
  for (std::size_t i = 0; i < signals.val_ch.size(); ++i) {
    const auto signal = signals.val_ch[i];
    if (signal.raw() == Signals::undefined) {
      signals_[i].reset();
    } else {
      // "Value may go outside these limits and will be clipped."
      signals_[i] = std::clamp(signal.fraction(), -1.0, 1.0);
    }
  }
  apply(parts.parameters, parts.gimbal, now);
  follow_command_channel(parts, now);
}

template void RemoteControl::set_channels(MenuParts&, const msg::ApiVirtChControl&, Instant);
template void RemoteControl::set_channels(MenuParts&, const msg::ApiVirtChHighRes&, Instant);

/// The command channel is a switch with three positions; each change of position starts an action.
/// Only new signals count, because an action that changes the source of the channel could otherwise
/// trigger itself endlessly.
void RemoteControl::follow_command_channel(MenuParts& parts, Instant now) {
  const auto& parameters = parts.parameters.of<msg::ReadParams3>();
  const auto level = signal(parameters.rc_map_cmd);
  // Assumption: thirds of the range.
  constexpr double third = 1.0 / 3;
  const Position position = !level            ? Position::none
                            : *level < -third ? Position::low
                            : *level > third  ? Position::high
                                              : Position::middle;
  if (std::exchange(command_, position) == position || position == Position::none) return;
  const msg::MenuCommand action = position == Position::low    ? parameters.rc_cmd_low
                                  : position == Position::high ? parameters.rc_cmd_high
                                                               : parameters.rc_cmd_mid;
  static_cast<void>(execute_menu(parts, action, now));
}

}  // namespace sbgc::emulator
