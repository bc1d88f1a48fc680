#include "device/system/restarts.hpp"

#include <sbgc/roles.hpp>

#include "device/device.hpp"

namespace sbgc::emulator {

Restarts::Restarts(Device& device, Instant now) { begin_start(device, now); }

void Restarts::schedule(Instant at, bool to_bootloader) {
  if (scheduled_ && scheduled_->at <= at) return;
  scheduled_ = {at, to_bootloader};
}

void Restarts::announce(Ports& ports, Instant now) {
  for (std::size_t port = 0; port < Board::max_ports; ++port) {
    ports.send(port, roles::Reset{});
  }
  schedule(now + milliseconds(roles::reset_delay_ms), false);
}

void Restarts::restart_now(Device& device, Instant now, bool to_bootloader, bool power_off) {
  ++device.ports.counters.restarts;
  scheduled_.reset();
  device.ports.restart(power_off);
  for_each_part(device, [&]<class Part>(Part& part) {
    if constexpr (requires { &Part::restart; }) {
      device.run(&Part::restart, now);
    } else {
      part = Part{};
    }
  });
  if (power_off) device.i2c.power_off();
  device.gimbal.set_motors(false, now);
  device.gimbal.restart(now);
  if (to_bootloader) {
    state_ = State::in_bootloader;
    changes_ = now + device.options.bootloader_time;
  } else {
    begin_start(device, now);
  }
}

void Restarts::begin_start(Device& device, Instant now) {
  state_ = State::starting;
  changes_ = now + device.options.start_time;
  started_ = now;
  device.parameters.reload();
  const msg::GeneralFlags flags = device.parameters.of<msg::ReadParams3>().general_flags1;
  if (!flags.has(msg::GeneralFlag::remember_last_used_profile) &&
      device.parameters.profile() != 0) {
    device.parameters.select_profile(0);
  }
  const std::uint32_t rate = number_of(device.parameters.of<msg::ReadParams3>().serial_speed);
  device.baud_rate = rate != 0 ? rate : number_of(msg::SerialSpeed{});
}

void Restarts::begin_running(Device& device, Instant now) {
  state_ = State::running;
  changes_ = Instant::never;
  device.ports.restart(false);
  device.parameters.apply_later();
  device.apply_parameters(now);
  device.calibrate_at_start(now);
  device.state_variables.start(device.options, device.memory, device.parameters, now);
  const auto flags = device.parameters.of<msg::ReadParamsExt2>().general_flags2;
  const bool stays_off =
      knows(versions_of(device.options), msg::GeneralFlags2Bit::motors_off_at_startup) &&
      flags.has(msg::GeneralFlags2Bit::motors_off_at_startup);
  if (!stays_off) device.tasks.set_motors(device.gimbal, true, now);
}

Instant Restarts::next() const { return scheduled_ ? earlier(scheduled_->at, changes_) : changes_; }

void Restarts::advance(Device& device, Instant now) {
  if (scheduled_ && scheduled_->at <= now) {
    restart_now(device, now, scheduled_->to_bootloader, false);
  } else if (changes_ <= now) {
    if (state_ == State::in_bootloader) {
      begin_start(device, now);
    } else {
      begin_running(device, now);
    }
  }
}

}  // namespace sbgc::emulator
