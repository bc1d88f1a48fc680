#include <algorithm>
#include <cassert>
#include <utility>

#include <sbgc/emulator/emulator.hpp>

#include "physics/noise.hpp"

namespace sbgc::emulator {

Emulator::Emulator(const EmulatorOptions& options, Memory memory, Instant now, Instant beginning)
    : options_(options), beginning_(beginning), board_(options.board, std::move(memory), now) {
  if (options.restart_at) restart_at_ = beginning + *options.restart_at;
  follow_rate();
}

Emulator::Port& Emulator::at(std::size_t port) {
  assert(port < ports_.size() && ports_[port]);
  return *ports_[port];
}

const Emulator::Port& Emulator::at(std::size_t port) const {
  assert(port < ports_.size() && ports_[port]);
  return *ports_[port];
}

std::optional<std::size_t> Emulator::connect(bool is_usb, Instant now) {
  advance(now);
  const std::optional<std::size_t> number = board_.open_port(is_usb);
  if (!number) return std::nullopt;
  LineOptions line = options_.line;
  if (is_usb) line.board = {};
  line.seed = static_cast<std::uint32_t>(random_bits(options_.line.seed, connections_++));
  ports_[*number].emplace(Port{.is_usb = is_usb,
                               .to_board = Line(line, Line::Way::to_board, beginning_, now),
                               .to_host = Line(line, Line::Way::to_host, beginning_, now)});
  step(now);
  return number;
}

void Emulator::disconnect(std::size_t port, Instant now) {
  assert(ports_[port]);
  advance(now);
  board_.close_port(port);
  ports_[port].reset();
}

void Emulator::set_host_line(std::size_t port, const std::optional<LineSettings>& settings,
                             Instant now) {
  advance(now);
  at(port).to_board.set_host(settings);
  at(port).to_host.set_host(settings);
}

void Emulator::end_input(std::size_t port, Instant now) {
  advance(now);
  board_.end_input(port);
  at(port).to_host.end_text();
}

std::size_t Emulator::queued_bytes(std::size_t port) const {
  return at(port).to_board.under_way() + board_.queued_bytes(port);
}

std::size_t Emulator::room(std::size_t port) const {
  const std::size_t limit = input_limit + options_.board.input_buffer;
  const std::size_t used = queued_bytes(port);
  return used < limit ? limit - used : 0;
}

bool Emulator::is_quiet(std::size_t port) const {
  const Port& one = at(port);
  return one.to_board.under_way() == 0 && board_.is_quiet(port) && one.to_host.under_way() == 0 &&
         one.arrived.empty();
}

void Emulator::from_host(std::size_t port, std::span<const std::uint8_t> bytes, Instant now) {
  advance(now);
  at(port).to_board.send(bytes, now);
  step(now);
}

void Emulator::advance(Instant now) {
  for (Instant at = next(); at <= now; at = next()) step(at);
  board_.advance(now);  // updates its counters
}

Instant Emulator::next() const {
  Instant result = board_.next();
  if (restart_at_) result = earlier(result, *restart_at_);
  for (std::size_t number = 0; number < ports_.size(); ++number) {
    const std::optional<Port>& port = ports_[number];
    if (!port) continue;
    result = earlier(result, earlier(port->to_board.next(), port->to_host.next()));
    if (port->has_room() && !board_.output(number).empty()) {
      result = earlier(result, port->to_host.ready());
    }
  }
  return result;
}

void Emulator::step(Instant now) {
  for (std::size_t number = 0; number < ports_.size(); ++number) {
    if (!ports_[number]) continue;
    received_.clear();
    ports_[number]->to_board.receive(now, received_);
    if (!received_.empty()) board_.receive(number, received_, now);
  }
  if (restart_at_ && *restart_at_ <= now) {
    restart_at_.reset();
    board_.restart(now);
  }
  board_.advance(now);
  follow_rate();
  follow_restarts();
  for (std::size_t number = 0; number < ports_.size(); ++number) {
    if (ports_[number]) pump(number, *ports_[number], now);
  }
}

void Emulator::pump(std::size_t number, Port& port, Instant now) {
  if (!port.has_room()) port.to_host.skip_text(now);
  port.to_host.receive(now, port.arrived);
  while (port.has_room()) {
    const std::span<const std::uint8_t> waiting = board_.output(number);
    const std::size_t free = output_limit - port.arrived.size() - port.to_host.under_way();
    const std::size_t size = std::min({waiting.size(), port.to_host.room(now), free});
    if (size == 0) return;
    port.to_host.send(waiting.first(size), now);
    board_.sent(number, size, now);
    port.to_host.receive(now, port.arrived);
  }
}

void Emulator::follow_rate() {
  if (!options_.rate_from_parameters || options_.line.board.baud_rate == board_.baud_rate()) return;
  options_.line.board.baud_rate = board_.baud_rate();
  for (std::optional<Port>& port : ports_) {
    if (!port || port->is_usb) continue;
    port->to_board.set_board(options_.line.board);
    port->to_host.set_board(options_.line.board);
  }
}

void Emulator::follow_restarts() {
  // The board may have dropped the rest of a frame that was being sent.
  const std::uint64_t lost = board_.counters().outputs_lost;
  if (std::exchange(outputs_lost_, lost) == lost) return;
  for (std::optional<Port>& port : ports_) {
    if (port) port->to_host.abort_frame();
  }
}

std::span<const std::uint8_t> Emulator::to_host(std::size_t port) const { return at(port).arrived; }

void Emulator::take(std::size_t port, std::size_t size, Instant now) {
  advance(now);
  std::vector<std::uint8_t>& arrived = at(port).arrived;
  assert(size <= arrived.size());
  arrived.erase(arrived.begin(), arrived.begin() + static_cast<std::ptrdiff_t>(size));
  step(now);
}

void Emulator::restart(Instant now) {
  advance(now);
  board_.restart(now);
  step(now);
}

void Emulator::change(const EmulatorOptions& options, Instant now) {
  advance(now);
  options_.line.faults = options.line.faults;
  for (std::optional<Port>& port : ports_) {
    if (!port) continue;
    port->to_board.set_faults(options.line.faults, now);
    port->to_host.set_faults(options.line.faults, now);
  }
  board_.change(options.board.faults, options.board.gimbal, now);
  step(now);
}

void Emulator::memory_saved(std::uint32_t revision, Instant now) {
  advance(now);
  board_.memory_saved(revision, now);
  step(now);
}

void Emulator::memory_not_saved(std::uint32_t revision, Instant now) {
  advance(now);
  board_.memory_not_saved(revision, now);
  step(now);
}

const LineCounters& Emulator::counters(std::size_t port, Line::Way way) const {
  return way == Line::Way::to_board ? at(port).to_board.counters() : at(port).to_host.counters();
}

}  // namespace sbgc::emulator
