#include <algorithm>
#include <array>
#include <span>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>

#include <sbgc/availability.hpp>
#include <sbgc/dispatch.hpp>
#include <sbgc/emulator/board.hpp>
#include <sbgc/message_infos.hpp>
#include <sbgc/parameters.hpp>
#include <sbgc/request_sizes.hpp>
#include <sbgc/responses/all.hpp>

#include "device/default_response.hpp"
#include "device/device.hpp"
#include "device/handlers.hpp"
#include "device/parameters/access.hpp"
#include "device/realtime/streams.hpp"

namespace sbgc::emulator {
namespace {

template <class Part>
inline constexpr bool is_part = []<class... Parts>(std::type_identity<std::tuple<Parts&...>>) {
  return std::is_lvalue_reference_v<Part> &&
         (std::is_same_v<std::remove_cvref_t<Part>, Parts> || ...);
}(std::type_identity<decltype(std::declval<Device&>().parts())>{});

template <class Part>
bool has(const BoardOptions& options) {
  if constexpr (requires { Part::are_supported(options); }) return Part::are_supported(options);
  return true;
}

/// Calls a handler with the parts of the device that it takes, if the board has them.
template <Message M, class... Parts>
Reaction call(Reaction (*handler)(RequestContext&, const M&, Parts...), RequestContext& context,
              const M& request, Device& device) {
  static_assert((is_part<Parts> && ...), "a handler takes parts of the device by reference");
  if (!(has<std::remove_cvref_t<Parts>>(device.options) && ...)) {
    return context.refuse(msg::BoardErrorCode::not_supported);
  }
  return handler(context, request, device.part<std::remove_cvref_t<Parts>>()...);
}

template <Message M>
Reaction carry_out(RequestContext& context, const M& request, Device& device) {
  if constexpr (requires { equivalent(request); }) {
    return carry_out(context, equivalent(request), device);
  } else if constexpr (requires { call<M>(handle, context, request, device); }) {
    return call<M>(handle, context, request, device);
  } else if constexpr (accesses_parameters<M>) {
    return access_parameters(context, request, device.parameters, device.imus);
  } else {
    return default_response(context, request);
  }
}

}  // namespace

/// The device and the order of its events.
class Board::Core {
 public:
  Core(const BoardOptions& options, Memory memory, Instant now)
      : device(options, std::move(memory), now), clock_(now) {
    request_times_.fill(Instant::never);
    free_times_.fill(now);
    idle_times_.fill(Instant::never);
  }

  /// Executes everything that is due until this time, in order.
  void run_until(Instant until) {
    until = later(until, clock_);
    for (;;) {
      const Instant at = later(next(), clock_);
      if (at > until || at == Instant::never) break;
      clock_ = device.ports.now = at;
      run_due(at);
    }
    clock_ = device.ports.now = until;
    device.streams.count_skipped(device.ports, until);
  }

  Instant next() {
    Instant next = device.restarts.next();
    for_each_part(device, [&](auto& part) {
      if constexpr (requires { part.next(); }) next = earlier(next, part.next());
    });
    for (const Instant time : request_times_) next = earlier(next, time);
    for (const Instant time : idle_times_) next = earlier(next, time);
    return next;
  }

  void receive(std::size_t port, std::span<const std::uint8_t> bytes, Instant now) {
    run_until(now);
    if (bytes.empty()) return;
    device.ports.receive(port, bytes, device.restarts.is_listening());
    idle_times_[port] = device.ports.is_in_frame(port) ? clock_ + idle_time : Instant::never;
    plan_request(port);
  }

  void sent(std::size_t port, std::size_t size, Instant now) {
    run_until(now);
    device.ports.sent(port, size);
    device.streams.has_room(device.ports, port, clock_);
    plan_request(port);
  }

  void close(std::size_t port) {
    device.streams.forget(device.ports, port, clock_);
    for_each_part(device, [&](auto& part) {
      if constexpr (requires { part.drop_port(port); }) part.drop_port(port);
    });
    device.ports.close(port);
    request_times_[port] = idle_times_[port] = Instant::never;
  }

  void end_input(std::size_t port) {
    device.streams.forget(device.ports, port, clock_);
    device.ports.end_input(port);
  }

  void restart(Instant now) {
    run_until(now);
    step([&] { device.restarts.restart_now(device, clock_, false, true); });
  }

  void memory_saved(std::uint32_t revision, Instant now) {
    run_until(now);
    if (revision == device.memory.revision) device.memory.is_unsaved = false;
    device.ports.release(revision);
  }

  void memory_not_saved(std::uint32_t revision, Instant now) {
    run_until(now);
    device.ports.fail(revision, [&](std::span<const std::uint8_t> frame) {
      return refusal_instead(versions_of(device.options), frame);
    });
    for (std::size_t port = 0; port < request_times_.size(); ++port) plan_request(port);
  }

  void set_silent(bool is_silent) {
    device.ports.set_silent(is_silent);
    for (std::size_t port = 0; port < request_times_.size(); ++port) {
      device.streams.has_room(device.ports, port, clock_);
    }
  }

  Device device;

 private:
  /// The pause after which a partial frame is dropped. Assumption.
  static constexpr Duration idle_time = milliseconds(100);
  /// The delay between the end of a request and its execution. Assumption.
  static constexpr Duration reaction_time = microseconds(100);

  /// Runs one step of the board. Any frame sent in this step may report a change of the memory in
  /// this step.
  template <class Do>
  void step(Do&& something) {
    const std::uint32_t before = device.memory.revision;
    something();
    device.apply_parameters(clock_);
    device.events.watch(device.menu, clock_);
    if (!device.options.waits_for_saving) return;
    const std::uint32_t after = device.memory.revision;
    if (after != before) device.memory.is_unsaved = true;
    device.ports.end_step(after != before ? std::optional(after) : std::nullopt);
  }

  void run_due(Instant now) {
    step([&] { device.restarts.advance(device, now); });
    for_each_part(device, [&]<class Part>(Part& part) {
      if constexpr (requires { part.next(); }) {
        if (part.next() <= now) step([&] { device.run(&Part::advance, now); });
      }
    });
    for (std::size_t port = 0; port < idle_times_.size(); ++port) {
      if (idle_times_[port] > now) continue;
      idle_times_[port] = Instant::never;
      device.ports.drop_frame(port, device.restarts.is_listening());
      plan_request(port);
    }
    for (std::size_t port = 0; port < request_times_.size(); ++port) {
      if (request_times_[port] > now) continue;
      request_times_[port] = Instant::never;
      free_times_[port] = now + cycle;
      if (device.ports.can_take(port)) step([&] { carry_out_next(port, now); });
      plan_request(port);
    }
  }

  /// Schedules the next request: the controller executes at most one per port in the time of a
  /// cycle.
  void plan_request(std::size_t port) {
    if (request_times_[port] != Instant::never || !device.ports.can_take(port)) return;
    request_times_[port] = later(clock_ + reaction_time, free_times_[port]);
  }

  void carry_out_next(std::size_t port, Instant now) {
    const QueuedRequest request = device.ports.take(port);
    if (device.ports.is_locked(port) && !unlocks(port, request)) {
      return device.ports.report(port, {request.id, request.body}, Reaction::locked);
    }
    device.debug_copies.copy(device.ports, device.measured.clock(now), port,
                             {request.id, request.body, 0}, false);
    const Reaction reaction = carry_out_frame(port, request, now);
    BoardCounters& counters = device.ports.counters;
    if (reaction == Reaction::refused) ++counters.refused;
    if (reaction == Reaction::unknown || reaction == Reaction::malformed) ++counters.unknown;
    device.ports.report(port, {request.id, request.body}, reaction);
  }

  /// Unlocks the port if the request has the password.
  bool unlocks(std::size_t port, const QueuedRequest& request) {
    msg::BoardInfoRequestExt opening;
    if (request.id != static_cast<std::uint8_t>(opening.command) ||
        !decode(std::span(request.body), opening) || !opening.password) {
      return false;
    }
    const std::string_view given(opening.password->data(), opening.password->size());
    if (given != device.options.password) return false;
    device.ports.unlock(port);
    return true;
  }

  /// True if this board supports any request with this id.
  bool knows(std::uint8_t id) const {
    const Availability versions = versions_of(device.options);
    return std::any_of(message_infos.begin(), message_infos.end(), [&](const MessageInfo* info) {
      return info->id == id && info->travels(Direction::to_board) && is_supported(*info, versions);
    });
  }

  /// Answers an unknown request with CMD_ERROR if the board supports it. Does not answer errors,
  /// because two boards on one line would answer each other endlessly.
  Reaction carry_out_frame(std::size_t port, const QueuedRequest& request, Instant now) {
    const Reaction reaction = try_frame(port, request, now);
    const bool is_strange = reaction == Reaction::unknown || reaction == Reaction::malformed;
    if (is_strange && !roles::is_error({request.id, request.body})) {
      refuse(
          port, request.id,
          knows(request.id) ? msg::BoardErrorCode::cmd_size : msg::BoardErrorCode::unknown_command,
          now);
    }
    return reaction;
  }

  Reaction refuse(std::size_t port, std::uint8_t id, msg::BoardErrorCode reason, Instant now) {
    RequestContext context(device.ports, device.options, port, id, Confirmed::never, now);
    return context.refuse(reason);
  }

  /// True if a request with this decoding status is executed.
  bool is_accepted(const Status& status, bool has_surplus) const {
    if (has_surplus && device.options.is_strict) return false;
    // Flags may indicate that even the largest form ends earlier.
    return status || (has_surplus && status.code == Code::too_long);
  }

  /// Ignores bytes that the firmware does not know, as real boards do.
  Reaction try_frame(std::size_t port, const QueuedRequest& request, Instant now) {
    Reaction reaction = Reaction::unknown;
    const Availability versions = versions_of(device.options);
    const std::size_t largest = largest_request(request.id, versions);
    const bool has_surplus = request.body.size() > largest;
    const auto body =
        std::span<const std::uint8_t>(request.body).first(std::min(request.body.size(), largest));
    const Code code = select(Direction::to_board, request.id, body.size(), [&]<class M>(Type<M>) {
      if constexpr (M::direction != Direction::from_board) {
        if (!is_supported<M>(versions)) return;
        M message{};
        if (!is_accepted(decode(body, message), has_surplus)) {
          reaction = Reaction::malformed;
          return;
        }
        if constexpr (!accesses_parameters<M>) {
          const bool has_unknown_values = limit_to(versions, message);
          if (has_unknown_values && !checks_values<M>) {
            reaction = refuse(port, request.id, msg::BoardErrorCode::wrong_params, now);
            return;
          }
        }
        const Confirmed confirmed = response_policy(message).responses.confirmed;
        RequestContext context(device.ports, device.options, port, request.id, confirmed, now);
        reaction = carry_out(context, message, device);
      }
    });
    return code == Code::unknown_form ? Reaction::malformed : reaction;
  }

  Instant clock_;
  // For each port
  std::array<Instant, max_ports> request_times_{};  ///< when the next request is executed
  std::array<Instant, max_ports> free_times_{};     ///< when the next one may be executed
  std::array<Instant, max_ports> idle_times_{};     ///< when a partial frame is dropped
};

Board::Board(const BoardOptions& options, Memory memory, Instant now)
    : core_(std::make_unique<Core>(options, std::move(memory), now)) {}
Board::Board(Board&& other) noexcept = default;
Board& Board::operator=(Board&& other) noexcept = default;
Board::~Board() = default;

Board::Core& Board::entered() {
  core_->device.ports.on_traffic = &on_traffic;
  return *core_;
}

std::optional<std::size_t> Board::open_port(bool is_usb) {
  return core_->device.ports.open(is_usb);
}

void Board::close_port(std::size_t port) { core_->close(port); }

void Board::end_input(std::size_t port) { core_->end_input(port); }

void Board::receive(std::size_t port, std::span<const std::uint8_t> bytes, Instant now) {
  entered().receive(port, bytes, now);
}

void Board::advance(Instant now) { entered().run_until(now); }

Instant Board::next() const { return core_->next(); }

std::span<const std::uint8_t> Board::output(std::size_t port) const {
  return core_->device.ports.output(port);
}

void Board::sent(std::size_t port, std::size_t size, Instant now) {
  entered().sent(port, size, now);
}

void Board::restart(Instant now) { entered().restart(now); }

void Board::change(const BoardFaults& faults, const Gimbal::Options& gimbal, Instant now) {
  advance(now);
  Device& device = core_->device;
  device.measured.count_faults(now);
  device.options.faults = faults;
  device.options.gimbal = gimbal;
  device.gimbal.change(gimbal, now);
}

void Board::memory_saved(std::uint32_t revision, Instant now) {
  entered().memory_saved(revision, now);
}

void Board::memory_not_saved(std::uint32_t revision, Instant now) {
  entered().memory_not_saved(revision, now);
}

void Board::set_silent(bool is_silent) { core_->set_silent(is_silent); }

const Memory& Board::memory() const { return core_->device.memory; }

std::size_t Board::queued_bytes(std::size_t port) const {
  return core_->device.ports.queued_bytes(port);
}

bool Board::is_quiet(std::size_t port) const {
  const Ports& ports = core_->device.ports;
  return !ports.is_in_frame(port) && ports.queued_bytes(port) == 0 && !ports.has_output(port);
}

const std::map<msg::ModuleId, std::vector<std::uint8_t>>& Board::module_firmware() const {
  return core_->device.module_flash.firmware();
}

Gimbal& Board::gimbal() { return core_->device.gimbal; }

const BoardCounters& Board::counters() const { return core_->device.ports.counters; }

const BoardOptions& Board::options() const { return core_->device.options; }

std::uint32_t Board::baud_rate() const { return core_->device.baud_rate; }

}  // namespace sbgc::emulator
