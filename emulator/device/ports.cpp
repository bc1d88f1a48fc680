#include "device/ports.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include <sbgc/availability.hpp>

namespace sbgc::emulator {
namespace {

std::size_t limit(std::size_t size) {
  return size == 0 ? std::numeric_limits<std::size_t>::max() : size;
}

}  // namespace

Ports::Ports(const BoardOptions& options)
    : input_limit_(std::min(limit(options.input_buffer), max_input)),
      output_limit_(limit(options.output_buffer)),
      newest_framing_(newest_framing({options.firmware.raw(), options.board.raw()})),
      holds_(options.waits_for_saving),
      has_password_(!options.password.empty()) {}

std::optional<std::size_t> Ports::open(bool is_usb) {
  for (std::size_t port = 0; port < ports_.size(); ++port) {
    if (ports_[port].is_open) continue;
    ports_[port] = {};
    ports_[port].is_open = true;
    ports_[port].is_usb = is_usb;
    if (newest_framing_ == basic_framing) ports_[port].parser.formats().accept_only(basic_framing);
    return port;
  }
  return {};
}

void Ports::close(std::size_t port) { ports_[port] = {}; }

bool Ports::is_open(std::size_t port) const { return port < ports_.size() && ports_[port].is_open; }

bool Ports::is_usb(std::size_t port) const { return is_open(port) && ports_[port].is_usb; }

void Ports::end_input(std::size_t port) { ports_[port].has_ended = true; }

std::uint64_t Ports::parser_errors(const ParserCounters& counters) {
  return counters.header_errors + counters.body_errors + counters.incomplete;
}

std::uint64_t Ports::errors(std::size_t port) const {
  return is_open(port) ? parser_errors(ports_[port].parser.counters()) : 0;
}

void Ports::report(std::size_t port, const Frame& frame, std::optional<Reaction> reaction) const {
  if (on_traffic != nullptr && *on_traffic) (*on_traffic)({now, port, frame, reaction});
}

void Ports::send_frame(std::size_t port, std::span<const std::uint8_t> frame) {
  if (!is_open(port) || is_silent_ || is_locked(port)) return;
  Port& to = ports_[port];
  if (to.output_size() > output_limit_ && to.output_size() - output_limit_ > max_overflow) {
    ++counters.skipped;
    return;
  }
  if (to.output_begin > to.output.size() / 2) to.forget_sent();
  const std::size_t begin = to.output.size();
  const Frame message = frame_at(frame.data());
  to.output.resize(begin + frame_size(to.framing, message.body.size()));
  static_cast<void>(
      write_frame(to.framing, message.id, message.body, std::span(to.output).subspan(begin)));
  if (holds_) to.held.push_back({begin, to.output.size() - begin, {}});
  ++counters.sent;
  const Frame sent = frame_at(to.output.data() + begin);
  report(port, sent, {});
  if (on_sent) on_sent(port, sent);
}

void Ports::Port::forget_sent() {
  output.erase(output.begin(), output.begin() + static_cast<std::ptrdiff_t>(output_begin));
  for (Held& frame : held) frame.begin -= output_begin;
  output_begin = 0;
}

void Ports::end_step(std::optional<std::uint32_t> changed) {
  for (Port& port : ports_) {
    for (auto frame = port.held.rbegin(); frame != port.held.rend() && !frame->revision; ++frame) {
      frame->revision = changed;
    }
    while (!port.held.empty() && !port.held.back().revision) port.held.pop_back();
  }
}

void Ports::release(std::uint32_t revision) {
  for (Port& port : ports_) {
    while (!port.held.empty() && *port.held.front().revision <= revision) port.held.pop_front();
  }
}

void Ports::fail(std::uint32_t revision, const Refusal& refusal) {
  for (std::size_t number = 0; number < ports_.size(); ++number) {
    Port& port = ports_[number];
    while (!port.held.empty() && *port.held.front().revision <= revision) {
      const Held frame = port.held.front();
      port.held.pop_front();
      const auto begin = port.output.begin() + static_cast<std::ptrdiff_t>(frame.begin);
      const auto end = begin + static_cast<std::ptrdiff_t>(frame.size);
      const std::vector<std::uint8_t> instead = refusal({begin, end});
      const bool is_other = !std::equal(begin, end, instead.begin(), instead.end());
      const auto place = port.output.erase(begin, end);
      port.output.insert(place, instead.begin(), instead.end());
      for (Held& later : port.held) later.begin += instead.size() - frame.size;
      if (!is_other || instead.empty()) continue;
      report(number, frame_at(instead.data()), {});
    }
  }
}

std::size_t Ports::room(std::size_t port) const {
  if (!is_open(port) || is_silent_ || ports_[port].has_ended) return 0;
  const std::size_t size = ports_[port].output_size();
  return size < output_limit_ ? output_limit_ - size : 0;
}

void Ports::receive(std::size_t port, std::span<const std::uint8_t> bytes, bool is_listening) {
  if (is_silent_) return;
  ports_[port].parser.feed(bytes, [&](const Frame& frame) { keep(port, frame, is_listening); });
}

bool Ports::is_in_frame(std::size_t port) const {
  return is_open(port) && ports_[port].parser.waiting_bytes() != 0;
}

void Ports::drop_frame(std::size_t port, bool is_listening) {
  ports_[port].parser.flush([&](const Frame& frame) { keep(port, frame, is_listening); });
}

void Ports::keep(std::size_t port, const Frame& frame, bool is_listening) {
  ++counters.requests;
  if (!is_listening) return report(port, frame, Reaction::not_listening);
  Port& from = ports_[port];
  const std::size_t size = frame_size(frame.framing, frame.body.size());
  if (size > input_limit_ || from.requests_size > input_limit_ - size) {
    ++counters.lost;
    return report(port, frame, Reaction::lost);
  }
  from.requests.push_back({frame.id, {frame.body.begin(), frame.body.end()}, frame.framing});
  from.requests_size += size;
}

bool Ports::can_take(std::size_t port) const {
  if (!is_open(port)) return false;
  return !ports_[port].requests.empty() && ports_[port].output_size() <= output_limit_;
}

QueuedRequest Ports::take(std::size_t port) {
  Port& from = ports_[port];
  QueuedRequest first = std::move(from.requests.front());
  from.requests.pop_front();
  from.requests_size -= frame_size(first.framing, first.body.size());
  from.framing = first.framing;
  return first;
}

void Ports::restart(bool output_too) {
  if (output_too) ++counters.outputs_lost;
  for (Port& port : ports_) {
    forget_input(port);
    if (output_too) {
      port.output.clear();
      port.output_begin = 0;
      port.held.clear();
    }
  }
}

void Ports::forget_input(Port& port) {
  port.requests.clear();
  port.requests_size = 0;
  port.parser.reset();
  port.framing = basic_framing;
  port.is_unlocked = false;
}

std::span<const std::uint8_t> Ports::output(std::size_t port) const {
  const Port& from = ports_[port];
  const auto all = std::span(from.output).subspan(from.output_begin);
  if (is_silent_) return all.first(0);
  const std::size_t free =
      from.held.empty() ? all.size() : from.held.front().begin - from.output_begin;
  return all.first(std::min(free, output_limit_));
}

bool Ports::has_output(std::size_t port) const {
  return !is_silent_ && ports_[port].output_size() != 0;
}

void Ports::sent(std::size_t port, std::size_t size) {
  Port& from = ports_[port];
  from.output_begin += size;
  if (from.output_begin == from.output.size()) {
    from.output.clear();
    from.output_begin = 0;
  }
}

}  // namespace sbgc::emulator
