#include "device/control/events.hpp"

#include "device/device.hpp"

namespace sbgc::emulator {
namespace {

/// Assumption: how often the board looks for changes that no request causes.
constexpr Duration watch_period = milliseconds(20);

}  // namespace

void Events::emit(Device& device, msg::EventId id, msg::EventType type) {
  if (!knows(versions_of(device.options), id)) return;
  msg::Event event;
  event.event_id = id;
  event.event_type = type;
  device.streams.emit(device.ports, event);
}

Events::State Events::state_of(const Device& device) {
  return {device.gimbal.motors_on(), device.gimbal.stopped_by_battery(), device.modes.retracted,
          device.scripts.running()};
}

void Events::watch(Device& device, Instant now) {
  next_ = device.streams.wants_events() ? now + watch_period : Instant::never;
  const State before = state_;
  state_ = state_of(device);
  if (next_ == Instant::never) return;
  const auto report = [&](msg::EventId id, bool was, bool is) {
    if (was != is) emit(device, id, is ? msg::EventType::on : msg::EventType::off);
  };
  report(msg::EventId::motor_state, before.motors_on, state_.motors_on);
  report(msg::EventId::emergency_stop, before.stopped, state_.stopped);
  report(msg::EventId::retracted_position, before.retracted, state_.retracted);
  if (before.script == state_.script) return;
  if (before.script) emit(device, msg::EventId::script, msg::EventType::off);
  if (state_.script) emit(device, msg::EventId::script, msg::EventType::on);
}

void Events::advance(Instant now, Device& device) {
  // Notices that the battery is empty.
  static_cast<void>(device.gimbal.sample(now));
  watch(device, now);
}

}  // namespace sbgc::emulator
