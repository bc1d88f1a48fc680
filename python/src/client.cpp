// The client: turns requests of Python into operations.

#include <optional>
#include <string>
#include <variant>

#include <pybind11/stl.h>

#include <sbgc/client/speed_control.hpp>
#include <sbgc/internal/words.hpp>
#include <sbgc/io/internal/real_path.hpp>
#include <sbgc/io/open.hpp>
#include <sbgc/io/ports.hpp>
#include <sbgc/meta/system.hpp>

#include "arguments.hpp"
#include "emulator.hpp"
#include "link.hpp"

namespace sbgc::python {

namespace {

using LinkPointer = std::shared_ptr<Link>;
using OperationPointer = std::shared_ptr<Operation>;

OperationPointer call(Link& link, const AnyMessage& request, OptionalSeconds<"timeout"> timeout,
                      OptionalInteger<unsigned, "retries"> retries, Flag<"validates"> validates,
                      Flag<"expects_confirmation"> expects_confirmation) {
  auto operation = link.make_operation();
  const CallOptions options{.timeout = timeout,
                            .retries = retries,
                            .expect_confirmation = expects_confirmation,
                            .validate = validates};
  using Answer = Result<std::optional<AnyMessage>>;
  link.prepare<Answer>(
      *operation,
      [request, options](AsyncClient& client, auto token) {
        client.async_call(request, options, token);
      },
      [](Answer answer) -> Operation::Result {
        return [answer = std::make_shared<Answer>(std::move(answer))] {
          if (!*answer) raise_client(answer->error());
          return py::cast(**answer);
        };
      });
  return operation;
}

/// A held speed.
class HeldSpeed {
 public:
  HeldSpeed(const LinkPointer& link, Seconds<"silence"> silence)
      : operation_(link->make_operation()), held_(std::make_shared<Held>(link, silence)) {
    // The client's thread must not be the one that releases the client.
    operation_->set_cancel([held = std::weak_ptr(held_), weak = std::weak_ptr(operation_)] {
      const auto one = held.lock();
      if (!one) return;
      one->control->close([weak](const Result<void>& result) {
        const auto operation = weak.lock();
        if (operation) operation->end([result] { return to_python(result); });
      });
    });
    link->add(operation_);
  }

  void set(Float<"roll"> roll, Float<"pitch"> pitch, Float<"yaw"> yaw) {
    const Axes<msg::ControlSpeed> speeds{quantity_of<msg::ControlSpeed>(roll, "roll"),
                                         quantity_of<msg::ControlSpeed>(pitch, "pitch"),
                                         quantity_of<msg::ControlSpeed>(yaw, "yaw")};
    done([&](SpeedControl& control) { return control.set(speeds); });
  }
  void refresh() {
    done([](SpeedControl& control) { return control.refresh(); });
  }
  void stop() {
    done([](SpeedControl& control) { return control.stop(); });
  }
  /// Warns if it has stopped the camera because its owner was silent. `level` selects the caller
  /// that the warning names.
  void warn_of_silence(int level) const {
    held_->link->require_this_process();
    if (held_->control->state() != SpeedControlState::silenced) return;
    const auto ms = std::to_string(held_->silence.count());
    const std::string text =
        "the camera has been stopped, because neither set() nor refresh() was "
        "called for " +
        ms + " ms; turn() turns for a longer time";
    if (PyErr_WarnEx(PyExc_RuntimeWarning, text.c_str(), level) != 0) {
      throw py::error_already_set();
    }
  }
  /// Stops the camera; the operation ends when the camera stands still.
  OperationPointer close() {
    operation_->cancel_by_python();
    return operation_;
  }
  /// The end of a block, in one call that no signal interrupts: KeyboardInterrupt is raised when
  /// the camera stands still, or after a second.
  void exit(const py::args& error) {
    if (held_->link->is_forked()) return;
    const bool is_silenced = held_->control->state() == SpeedControlState::silenced;
    close();
    Instant until = Instant::never;
    std::optional<py::error_already_set> signal;
    while (!operation_->wait(0.05) && operation_->now() < until) {
      if (PyErr_CheckSignals() == 0) continue;
      signal.emplace();
      until = operation_->now() + seconds(1);
    }
    if (signal) throw py::error_already_set(*signal);
    operation_->result();
    if (is_silenced && error.size() > 0 && error[0].is_none()) warn_of_silence(1);
  }

 private:
  template <class Change>
  void done(const Change& change) {
    held_->link->require_this_process();
    const Result<void> changed = released([&] { return change(*held_->control); });
    if (changed) return;
    static_cast<void>(held_->link->client());  // raises if close() has ended it
    raise_client(changed.error());
  }

  /// It stops the camera, and so needs its client, except in a forked child.
  struct Held {
    Held(LinkPointer of, std::chrono::milliseconds longest)
        : link(std::move(of)),
          silence(longest),
          control(std::make_unique<SpeedControl>(link->client(),
                                                 SpeedControlOptions{.silence = longest})) {}
    Held(const Held&) = delete;
    Held& operator=(const Held&) = delete;
    ~Held() {
      if (link->is_forked()) static_cast<void>(control.release());
    }

    LinkPointer link;
    std::chrono::milliseconds silence;
    std::unique_ptr<SpeedControl> control;
  };

  OperationPointer operation_;
  std::shared_ptr<Held> held_;
};

py::list list_ports() {
  const io::PortList list = io::list_ports();
  if (list.error) raise_client({ErrorCode::io, list.error.message});
  py::list result;
  for (const io::PortInfo& port : list.ports) {
    py::object usb = py::none();
    if (port.usb) {
      usb =
          py::make_tuple(port.usb->vendor_id, port.usb->product_id, to_text(port.usb->manufacturer),
                         to_text(port.usb->product), to_text(port.usb->serial_number));
    }
    result.append(py::make_tuple(to_text(port.name), to_text(port.description), usb));
  }
  return result;
}

using Timeout = Seconds<"timeout">;
using CapturePath = OptionalPath<"capture">;
using Reconnects = Flag<"reconnect">;

ConnectOptions connect_options(Timeout timeout, const CapturePath& capture) {
  ConnectOptions options;
  options.timeout = timeout;
  options.capture = capture;
  return options;
}

OperationPointer connect(Link& link, const std::string& address, Timeout timeout,
                         const CapturePath& capture, Reconnects reconnects) {
  return link.connect(address, {}, connect_options(timeout, capture), reconnects);
}

OperationPointer connect_to_board(Link& link, const std::shared_ptr<Emulation>& board,
                                  Timeout timeout, const CapturePath& capture,
                                  Reconnects reconnects) {
  board->require_this_process();
  if (board->time() && reconnects) {
    throw py::value_error("reconnect: a line is searched for in real time only");
  }
  link.use(board->time());
  return link.connect("", board->line(), connect_options(timeout, capture), reconnects);
}

/// Returns board, firmware and serial number as texts, and the messages with the details.
py::tuple identity_of(const Link& link) {
  const BoardIdentity board = link.client().identity();
  std::optional<AnyMessage> details;
  if (board.details) details = any_of(*board.details);
  return py::make_tuple(board.board_version(), board.firmware_version(), board.serial_number(),
                        any_of(board.info), details, board.firmware_problem());
}

/// Returns what two addresses of one board have in common. Raises ValueError for a malformed one.
std::string board_at(const std::string& text) {
  const io::AddressResult address = io::parse_address(text);
  if (!address) throw py::value_error(detail::without_period(address.error.message));
  const auto* const serial = std::get_if<io::SerialAddress>(&address.address);
  return serial != nullptr ? io::detail::real_path(serial->path) : text;
}

}  // namespace

void bind_client(py::module_& module) {
  py::class_<Operation, OperationPointer>(module, "Operation")
      .def("begin", &Operation::begin)
      .def("wait", &Operation::wait)
      .def("now", [](Operation& one) { return static_cast<double>(one.now().us) / 1e6; })
      .def("cancel", &Operation::cancel_by_python)
      .def("is_running", &Operation::is_running)
      .def("result", &Operation::result)
      .def("progress", &Operation::progress);
  py::class_<Link, LinkPointer> link(module, "Link");
  link.def(py::init<>())
      .def("connect", &connect)
      .def("connect", &connect_to_board, py::arg("board").none(false), py::arg(), py::arg(),
           py::arg())
      .def("begin_close", &Link::begin_close)
      .def("is_still", &Link::is_still)
      .def("close",
           [](Link& one, double seconds) {
             return released([&] {
               one.close(one.now() + duration_of(seconds));
               return true;
             });
           })
      .def_property_readonly("descriptor", [](Link& one) { return one.bell()->descriptor(); })
      .def("pause",
           [](Link& one, double seconds) {
             one.require_this_process();
             released([&] { return one.pause(duration_of(seconds)), true; });
           })
      .def("drain", [](Link& one) { one.bell()->drain(); })
      .def("now", [](Link& one) { return static_cast<double>(one.now().us) / 1e6; })
      .def("description", [](const Link& one) { return one.client().description(); })
      .def("require", [](const Link& one) { one.client(); })
      .def("is_connected", &Link::is_connected)
      .def("is_forked", &Link::is_forked)
      .def("take_events", &Link::take_events)
      .def("identity", &identity_of)
      .def("call", &call);
  py::class_<HeldSpeed>(module, "HeldSpeed")
      .def(py::init<const LinkPointer&, Seconds<"silence">>())
      .def("set", &HeldSpeed::set)
      .def("refresh", &HeldSpeed::refresh)
      .def("stop", &HeldSpeed::stop)
      .def("warn_of_silence", &HeldSpeed::warn_of_silence)
      .def("close", &HeldSpeed::close)
      .def("exit", &HeldSpeed::exit);
  module.def("require_speeds", [](Float<"roll"> roll, Float<"pitch"> pitch, Float<"yaw"> yaw) {
    static_cast<void>(speed_of(roll, "roll"));
    static_cast<void>(speed_of(pitch, "pitch"));
    static_cast<void>(speed_of(yaw, "yaw"));
  });
  bind_streams(module, link);
  bind_tasks(module, link);
  module.def("list_ports", &list_ports);
  module.def("board_at", &board_at);
}

}  // namespace sbgc::python
