// The client: what it is asked for becomes operations.

#include <optional>

#include <pybind11/stl.h>

#include <sbgc/client/speed_control.hpp>
#include <sbgc/io/clock.hpp>
#include <sbgc/io/ports.hpp>
#include <sbgc/meta/system.hpp>

#include "arguments.hpp"
#include "driving/order_of.hpp"
#include "emulator.hpp"
#include "link.hpp"
#include "shared_speed.hpp"

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
  const detail::Conversation conversation = link->conversation();
  const CallId id = conversation.start(
      conversation.prepare(request, options), options, [operation](const Result<Reply>& reply) {
        const auto result = std::make_shared<Result<std::optional<AnyMessage>>>(
            detail::read_response<AnyMessage>(reply));
        operation->end([result] {
          if (!*result) raise_client(result->error());
          return py::cast(**result);
        });
      });
  operation->set_cancel([conversation, id] { conversation.cancel(id); });
  return operation;
}

/// A held speed: SpeedControl without a thread of its own.
class HeldSpeed {
 public:
  HeldSpeed(const LinkPointer& link, Seconds silence)
      : speed_(std::make_shared<detail::SharedSpeed>(
            detail::DeadMansSwitch(milliseconds(milliseconds_of(silence, "silence").count()),
                                   milliseconds(SpeedControlOptions{}.repeat.count())),
            detail::order_of(link->conversation()))),
        operation_(link->begin()) {
    const SpeedControlOptions usual;
    const auto task = std::make_shared<Task<Result<void>>>(detail::hold_speed(
        speed_, detail::BoundedTurn(usual.bound, usual.lookahead), usual.ends_when_stopped));
    wake_ = link->drive(operation_, task->begin(link->conversation().identity()),
                        [operation = operation_, task] {
                          const Result<void> result = std::move(*task).result();
                          operation->end([result] { return to_python(result); });
                        });
    operation_->set_cancel([speed = speed_, wake = wake_] {
      speed->close();
      wake();
    });
  }

  void set(double roll, double pitch, double yaw) {
    const Axes<msg::ControlSpeed> speeds{quantity_of<msg::ControlSpeed>(roll, "roll"),
                                         quantity_of<msg::ControlSpeed>(pitch, "pitch"),
                                         quantity_of<msg::ControlSpeed>(yaw, "yaw")};
    done(speed_->set(speeds, operation_->now()));
  }
  void refresh() { done(speed_->refresh(operation_->now())); }
  void stop() { done(speed_->stop()); }
  /// Stops the camera; the operation ends when it stands still.
  OperationPointer close() {
    operation_->cancel();
    return operation_;
  }

 private:
  void done(const Result<void>& changed) {
    if (!changed) raise_client(changed.error());
    wake_();
  }

  std::shared_ptr<detail::SharedSpeed> speed_;
  OperationPointer operation_;
  std::function<void()> wake_{};
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
  const BoardIdentity board = link.identity();
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
      .def("description", &Link::description)
      .def("is_connected", &Link::is_connected)
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
