#include "device/parts/restarts.hpp"

#include <sbgc/roles.hpp>

#include "device/device.hpp"

namespace sbgc::board {

Restarts::Restarts(Machine& machine, Instant now) { begin_start(machine, now); }

void Restarts::schedule(Instant at, bool to_bootloader) {
  if (scheduled_ && scheduled_->at <= at) return;
  scheduled_ = {at, to_bootloader};
}

void Restarts::announce(Machine& machine, Instant now) {
  for (std::size_t port = 0; port < Board::max_ports; ++port) {
    machine.ports.send(port, roles::Reset{});
  }
  schedule(now + milliseconds(roles::reset_delay_ms), false);
}

void Restarts::restart_now(Machine& machine, Instant now, bool to_bootloader, bool power_off) {
  ++machine.ports.counters.restarts;
  scheduled_.reset();
  machine.ports.restart(power_off);
  for_each_part(machine, [&](auto& part) { part.restart(machine, now); });
  if (power_off) machine.i2c.power_off();
  machine.gyro_headings = {};
  machine.cur_imu = msg::SelectedImu::main;
  machine.gimbal.set_motors(false, now);
  machine.gimbal.restart(now);
  if (to_bootloader) {
    state_ = State::in_bootloader;
    changes_ = now + machine.options.bootloader_time;
  } else {
    begin_start(machine, now);
  }
}

void Restarts::begin_start(Machine& machine, Instant now) {
  state_ = State::starting;
  changes_ = now + machine.options.start_time;
  started_ = now;
  machine.settings.reload();
  const msg::GeneralFlags flags = machine.settings.of<msg::ReadParams3>().general_flags1;
  if (!flags.has(msg::GeneralFlag::remember_last_used_profile) && machine.settings.profile() != 0) {
    machine.settings.select_profile(0);
  }
  const std::uint32_t rate = number_of(machine.settings.of<msg::ReadParams3>().serial_speed);
  machine.baud_rate = rate != 0 ? rate : number_of(msg::SerialSpeed{});
}

void Restarts::begin_running(Machine& machine, Instant now) {
  state_ = State::running;
  changes_ = Instant::never;
  machine.ports.restart(false);
  machine.apply_settings(now);
  machine.calibrate_at_start(now);
  machine.set_motors(true, now);
}

Instant Restarts::next() const { return scheduled_ ? earlier(scheduled_->at, changes_) : changes_; }

void Restarts::advance(Machine& machine, Instant now) {
  if (scheduled_ && scheduled_->at <= now) {
    restart_now(machine, now, scheduled_->to_bootloader, false);
  } else if (changes_ <= now) {
    if (state_ == State::in_bootloader) {
      begin_start(machine, now);
    } else {
      begin_running(machine, now);
    }
  }
}

}  // namespace sbgc::board
