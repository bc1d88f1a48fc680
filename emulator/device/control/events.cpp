#include "device/control/events.hpp"

#include <sbgc/meta/enums.hpp>

#include "device/control/menu.hpp"
#include "device/control/modes.hpp"
#include "device/features.hpp"
#include "device/realtime/streams.hpp"
#include "device/scripting/scripts.hpp"

namespace sbgc::emulator {
namespace {

/// Assumption: how often the board looks for changes that no request causes.
constexpr Duration watch_period = milliseconds(20);

}  // namespace

void Events::emit(MenuParts& parts, msg::EventId id, msg::EventType type) {
  if (!knows(versions_of(parts.options), id)) return;
  msg::Event event;
  event.event_id = id;
  event.event_type = type;
  parts.streams.emit(parts.ports, event);
}

Events::State Events::state_of(const MenuParts& parts) {
  return {parts.gimbal.motors_on(), parts.gimbal.stopped_by_battery(), parts.modes.retracted,
          parts.scripts.running()};
}

void Events::watch(MenuParts& parts, Instant now) {
  next_ = parts.streams.wants_events() ? now + watch_period : Instant::never;
  const State before = state_;
  state_ = state_of(parts);
  if (next_ == Instant::never) return;
  const auto report = [&](msg::EventId id, bool was, bool is) {
    if (was != is) emit(parts, id, is ? msg::EventType::on : msg::EventType::off);
  };
  report(msg::EventId::motor_state, before.motors_on, state_.motors_on);
  report(msg::EventId::emergency_stop, before.stopped, state_.stopped);
  report(msg::EventId::retracted_position, before.retracted, state_.retracted);
  if (before.script == state_.script) return;
  if (before.script) emit(parts, msg::EventId::script, msg::EventType::off);
  if (state_.script) emit(parts, msg::EventId::script, msg::EventType::on);
}

void Events::advance(Instant now, MenuParts& parts) {
  // Notices that the battery is empty.
  static_cast<void>(parts.gimbal.sample(now));
  watch(parts, now);
}

}  // namespace sbgc::emulator
