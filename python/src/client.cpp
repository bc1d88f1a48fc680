// The client: what it is asked for becomes operations.

#include <optional>

#include <pybind11/stl.h>

#include <sbgc/client/speed_control.hpp>
#include <sbgc/io/ports.hpp>
#include <sbgc/meta/system.hpp>

#include "arguments.hpp"
#include "emulator.hpp"
#include "link.hpp"

namespace sbgc::python {

namespace {

using LinkPointer = std::shared_ptr<Link>;
using OperationPointer = std::shared_ptr<Operation>;

OperationPointer call(const LinkPointer& link, const AnyMessage& request,
                      std::optional<Seconds> timeout, std::optional<unsigned> retries,
                      bool validates, bool expects_confirmation) {
  auto operation = link->begin();
  const CallOptions options{.timeout = timeout_of(timeout),
                            .retries = retries,
                            .expect_confirmation = expects_confirmation,
                            .validate = validates};
  using Answer = Result<std::optional<AnyMessage>>;
  link->start<Answer>(
      operation,
      [&](AsyncClient& client, auto token) { client.async_call(request, options, token); },
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
  HeldSpeed(const LinkPointer& link, Seconds silence)
      : operation_(link->begin()), held_(std::make_shared<Held>(link, silence)) {
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

  void set(double roll, double pitch, double yaw) {
    const Axes<msg::ControlSpeed> speeds{quantity_of<msg::ControlSpeed>(roll, "roll"),
                                         quantity_of<msg::ControlSpeed>(pitch, "pitch"),
                                         quantity_of<msg::ControlSpeed>(yaw, "yaw")};
    done(held_->control->set(speeds));
  }
  void refresh() { done(held_->control->refresh()); }
  void stop() { done(held_->control->stop()); }
  /// Stops the camera; the operation ends when it stands still.
  OperationPointer close() {
    operation_->cancel();
    return operation_;
  }

 private:
  static void done(const Result<void>& changed) {
    if (!changed) raise_client(changed.error());
  }

  /// It stops the camera, and so needs its client, unless this is a forked child.
  struct Held {
    Held(LinkPointer of, Seconds silence)
        : link(std::move(of)),
          control(std::make_unique<SpeedControl>(
              link->client(),
              SpeedControlOptions{.silence = milliseconds_of(silence, "silence")})) {}
    Held(const Held&) = delete;
    Held& operator=(const Held&) = delete;
    ~Held() {
      if (link->is_forked()) static_cast<void>(control.release());
    }

    LinkPointer link;
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

ConnectOptions connect_options(Seconds timeout, const std::optional<std::string>& capture) {
  ConnectOptions options;
  options.timeout = milliseconds_of(timeout, "timeout");
  options.capture = capture;
  return options;
}

OperationPointer connect(Link& link, const std::string& address, Seconds timeout,
                         const std::optional<std::string>& capture, bool reconnects) {
  return link.connect(address, {}, connect_options(timeout, capture), reconnects);
}

OperationPointer connect_to_board(Link& link, const std::shared_ptr<Emulation>& board,
                                  Seconds timeout, const std::optional<std::string>& capture,
                                  bool reconnects) {
  if (board->time() && reconnects) {
    throw py::value_error("reconnect: a line is searched for in real time only");
  }
  link.use(board->time());
  return link.connect("", board->line(), connect_options(timeout, capture), reconnects);
}

/// Its board, firmware and serial number as texts, and the messages that say more.
py::tuple identity_of(const Link& link) {
  const BoardIdentity board = link.client().identity();
  std::optional<AnyMessage> details;
  if (board.details) details = any_of(*board.details);
  return py::make_tuple(board.board_version(), board.firmware_version(), board.serial_number(),
                        any_of(board.info), details, board.firmware_problem());
}

}  // namespace

void bind_client(py::module_& module) {
  py::class_<Operation, OperationPointer>(module, "Operation")
      .def("wait", &Operation::wait)
      .def("now", [](Operation& one) { return static_cast<double>(one.now().us) / 1e6; })
      .def("cancel", &Operation::cancel)
      .def("result", &Operation::result)
      .def("progress", &Operation::progress);
  py::class_<Link, LinkPointer> link(module, "Link");
  link.def(py::init<>())
      .def("connect", &connect)
      .def("connect", &connect_to_board, py::arg("board").none(false), py::arg(), py::arg(),
           py::arg())
      .def("close",
           [](Link& one) {
             return released([&] {
               one.close();
               return true;
             });
           })
      .def_property_readonly("descriptor", [](Link& one) { return one.bell()->descriptor(); })
      .def("drain", [](Link& one) { one.bell()->drain(); })
      .def("now", [](Link& one) { return static_cast<double>(one.now().us) / 1e6; })
      .def("description", [](const Link& one) { return one.client().description(); })
      .def("is_connected", [](const Link& one) { return one.client().is_connected(); })
      .def("identity", &identity_of)
      .def("call", &call);
  py::class_<HeldSpeed>(module, "HeldSpeed")
      .def(py::init<const LinkPointer&, Seconds>())
      .def("set", &HeldSpeed::set)
      .def("refresh", &HeldSpeed::refresh)
      .def("stop", &HeldSpeed::stop)
      .def("close", &HeldSpeed::close);
  bind_streams(module, link);
  bind_tasks(module, link);
  module.def("list_ports", &list_ports);
}

}  // namespace sbgc::python
