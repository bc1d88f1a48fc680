#include "device/control/control_link.hpp"

#include <algorithm>

#include "device/control/quaternion_control.hpp"
#include "device/control/reported_state.hpp"
#include "device/parameters/gimbal_tuning.hpp"

namespace sbgc::emulator {

void ControlLink::configure(Modes& modes, const msg::ControlConfig& config, std::size_t port,
                            Instant now) {
  using enum msg::ControlConfigFlag;
  timeout_ = milliseconds(config.timeout_ms.raw());
  // A timeout also ends control that began without one.
  if (is_active_) commanded(now);
  for (std::size_t i = 0; i < config.ch_priority.size(); ++i) {
    if (config.ch_priority[i] != msg::ControlConfig::keep_priority) {
      priority_[i] = config.ch_priority[i];
    }
  }
  if (config.this_ch_priority != msg::ControlConfig::keep_priority) {
    priority_[port] = config.this_ch_priority;
  }
  for (std::size_t axis = 0; axis < acceleration_.size(); ++axis) {
    const std::uint16_t limit = config.axes[axis].acc_limit.raw();
    if (limit != msg::ControlConfigAxis::keep_acc_limit) acceleration_[axis] = limit;
  }
  confirms_ = !config.flags.has(no_confirm);
  if (config.flags.has(servo_mode_enable)) modes.servo = true;
  if (config.flags.has(servo_mode_disable)) modes.servo = false;
  // The value is that of EULER_ORDER plus one; 0 keeps the order.
  const auto order = static_cast<unsigned>(config.euler_order.order());
  if (order != 0) order_ = static_cast<msg::EulerOrder>(order - 1);
}

bool ControlLink::admits(std::size_t port) const {
  return priority_[port] == *std::max_element(priority_.begin(), priority_.end());
}

void ControlLink::commanded(Instant now) {
  is_active_ = true;
  end_ = timeout_ == Duration{} ? Instant::never : now + timeout_;
}

void ControlLink::adjust(Tuning& tuning) const {
  for (std::size_t axis = 0; axis < acceleration_.size(); ++axis) {
    if (acceleration_[axis] != 0) tuning.axes[axis].acceleration = acceleration_[axis];
  }
  if (order_) tuning.rotation_order = rotation_order_of(*order_);
}

void ControlLink::advance(Instant now, QuaternionControl& quaternions, Gimbal& gimbal) {
  end_ = Instant::never;
  is_active_ = false;
  quaternions.end();
  for (std::size_t axis = 0; axis < 3; ++axis) gimbal.command(axis, {}, now);
}

}  // namespace sbgc::emulator
