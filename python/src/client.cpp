// The client: what it is asked for becomes operations.

#include <cmath>
#include <deque>
#include <filesystem>
#include <optional>

#include <pybind11/stl.h>

#include <sbgc/client/speed_control.hpp>
#include <sbgc/client/tasks.hpp>
#include <sbgc/io/clock.hpp>
#include <sbgc/messages.hpp>
#include <sbgc/meta/all.hpp>

#include "emulator.hpp"
#include "link.hpp"
#include "tasks/hold_speed.hpp"

namespace sbgc::python {

namespace {

using Seconds = double;
using LinkPointer = std::shared_ptr<Link>;
using OperationPointer = std::shared_ptr<Operation>;

std::chrono::milliseconds milliseconds_of(Seconds seconds, const char* what) {
  if (!(seconds >= 0 && seconds <= 1e6)) {
    throw py::value_error(std::string(what) + ": 0 to 1000000 seconds are possible");
  }
  return std::chrono::milliseconds(std::llround(seconds * 1000));
}

std::optional<std::chrono::milliseconds> timeout_of(std::optional<Seconds> seconds) {
  if (!seconds) return std::nullopt;
  return milliseconds_of(*seconds, "timeout");
}

/// Raises if the quantity cannot hold the value.
template <class Q>
Q quantity_of(double value, const char* field) {
  const Conversion<Q> result = Q::from_real(value);
  if (!result) {
    const Q lowest(std::numeric_limits<typename Q::raw_type>::lowest());
    const Q highest(std::numeric_limits<typename Q::raw_type>::max());
    const std::string problem = std::string(field) + ": " + std::to_string(value) +
                                " does not fit: " + std::to_string(lowest.real()) + " to " +
                                std::to_string(highest.real()) + ' ' + Q::unit;
    raise("FieldError", problem, field);
  }
  return *result;
}

py::tuple angles_of(const Axes<msg::Angle14>& axes) {
  return py::make_tuple(axes.roll.degrees(), axes.pitch.degrees(), axes.yaw.degrees());
}
py::object move_progress(const MoveProgress& progress) {
  return py::make_tuple(
      angles_of(progress.angles),
      py::make_tuple(progress.remaining.roll, progress.remaining.pitch, progress.remaining.yaw),
      progress.is_close, std::chrono::duration<double>(progress.elapsed).count());
}

ProgressHandler progress_to(const OperationPointer& operation) {
  return [weak = std::weak_ptr(operation)](const Progress& progress) {
    if (const auto one = weak.lock()) {
      one->report(
          [done = progress.done, total = progress.total, what = std::string(progress.what)] {
            return py::make_tuple(done, total, what);
          });
    }
    return true;
  };
}

template <class T>
py::object cast_of(const Result<T>& result) {
  if (!result) raise_client(result.error());
  return py::cast(*result);
}
py::object bytes_of(const Result<std::vector<std::uint8_t>>& result) {
  if (!result) raise_client(result.error());
  return to_bytes(*result);
}

// Calls

OperationPointer call(const LinkPointer& link, const AnyMessage& request,
                      std::optional<Seconds> timeout, std::optional<unsigned> retries,
                      bool validates) {
  auto operation = link->begin();
  const CallOptions options{
      .timeout = timeout_of(timeout), .retries = retries, .validate = validates};
  const detail::Conversation conversation = link->conversation();
  const CallId id = conversation.start(
      conversation.prepare(request, options), options, [operation](const Result<Reply>& reply) {
        const auto result = std::make_shared<Result<std::optional<AnyMessage>>>(
            detail::read_response<AnyMessage>(reply));
        operation->end([result] { return cast_of(*result); });
      });
  operation->set_cancel([conversation, id] { conversation.cancel(id); });
  return operation;
}

OperationPointer move_to(const LinkPointer& link, std::optional<double> roll,
                         std::optional<double> pitch, std::optional<double> yaw, double speed,
                         Seconds timeout, double tolerance, bool waits) {
  MoveTarget target;
  if (roll) target.roll = quantity_of<msg::Angle14>(*roll, "roll");
  if (pitch) target.pitch = quantity_of<msg::Angle14>(*pitch, "pitch");
  if (yaw) target.yaw = quantity_of<msg::Angle14>(*yaw, "yaw");
  const auto operation = link->begin();
  MoveOptions options;
  options.speed = quantity_of<msg::ControlSpeed>(speed, "speed");
  options.timeout = milliseconds_of(timeout, "timeout");
  options.tolerance = tolerance;
  options.progress = [weak = std::weak_ptr(operation)](const MoveProgress& progress) {
    if (const auto one = weak.lock()) one->report([progress] { return move_progress(progress); });
    return true;
  };
  const auto convert = [](const Result<MoveProgress>& result) {
    if (!result) raise_client(result.error());
    return move_progress(*result);
  };
  if (waits) return link->run(operation, tasks::move_to(target, options), convert);
  return link->run(operation, tasks::begin_move(target, options), convert);
}

OperationPointer calibrate(const LinkPointer& link, bool gyroscope,
                           std::optional<Seconds> timeout) {
  const auto operation = link->begin();
  CalibrationOptions options;
  options.timeout = timeout_of(timeout);
  options.progress = [weak = std::weak_ptr(operation)](const CalibrationProgress& progress) {
    if (const auto one = weak.lock()) {
      one->report([started = progress.has_started, elapsed = progress.elapsed] {
        return py::make_tuple(started, std::chrono::duration<double>(elapsed).count());
      });
    }
    return true;
  };
  const auto sensor = gyroscope ? Sensor::gyroscope : Sensor::accelerometer;
  return link->run(operation, tasks::calibrate(sensor, options), to_python);
}

// Parameters

py::list blocks_of(const ParameterSet& set) {
  py::list result;
  for (const Parameters& block : set.all()) {
    AnyMessage message = find_message(block.id.message)->make();
    static_cast<void>(message.decode(block.body));  // put() has checked this
    result.append(py::make_tuple(block.id.message, block.id.copy, message));
  }
  return result;
}

ParameterSet set_of(const py::list& blocks) {
  ParameterSet set;
  for (const py::handle item : blocks) {
    const auto block = py::reinterpret_borrow<py::tuple>(item);
    std::vector<std::uint8_t> body(max_body_size);
    const auto message = block[2].cast<AnyMessage>();
    const WriteResult written = message.encode(body);
    if (!written) raise_status("EncodeError", message.type().info->name, written.status);
    body.resize(written.size);
    const auto put =
        set.put({{block[0].cast<std::string>(), block[1].cast<std::uint8_t>()}, std::move(body)});
    if (!put) raise_client(put.error());
  }
  return set;
}

py::object report_of(const WriteReport& report) {
  if (!report) {
    ClientError error = report.outcome.error();
    error.message = to_text(report);
    raise_client(error);
  }
  return py::cast(to_text(report));
}

OperationPointer read_parameters(const LinkPointer& link, std::optional<std::uint8_t> copy,
                                 Seconds timeout) {
  const auto operation = link->begin();
  ReadOptions options;
  options.timeout = milliseconds_of(timeout, "timeout");
  options.progress = progress_to(operation);
  if (copy) {
    options.wanted = [copy](const ParametersId& id) { return id.copy == *copy || id.copy == 0; };
  }
  return link->run(operation, tasks::read_parameters(options),
                   [](const Result<ParameterSet>& result) -> py::object {
                     if (!result) raise_client(result.error());
                     return blocks_of(*result);
                   });
}

OperationPointer write_parameters(const LinkPointer& link, const py::list& blocks,
                                  Seconds timeout) {
  const auto operation = link->begin();
  WriteOptions options;
  options.timeout = milliseconds_of(timeout, "timeout");
  options.progress = progress_to(operation);
  return link->run(operation, tasks::write_parameters(set_of(blocks), options), report_of);
}

OperationPointer make_backup(const LinkPointer& link, Seconds timeout) {
  const auto operation = link->begin();
  ReadOptions options;
  options.timeout = milliseconds_of(timeout, "timeout");
  options.progress = progress_to(operation);
  return link->run(operation, tasks::make_backup(utc_now(), options),
                   [](const Result<Backup>& result) -> py::object {
                     if (!result) raise_client(result.error());
                     return py::cast(to_json_text(*result));
                   });
}

Backup backup_of(const std::string& text) {
  auto backup = parse_backup(text);
  if (!backup) raise_client(backup.error());
  return *std::move(backup);
}

OperationPointer restore(const LinkPointer& link, const std::string& text,
                         const std::string& save_current, bool allow_other_model,
                         bool allow_other_firmware, Seconds timeout) {
  const auto operation = link->begin();
  RestoreOptions options;
  options.save_current = save_to(save_current);
  options.allow_other_model = allow_other_model;
  options.allow_other_firmware = allow_other_firmware;
  options.timeout = milliseconds_of(timeout, "timeout");
  options.progress = progress_to(operation);
  return link->run(operation, tasks::restore(backup_of(text), options), report_of);
}

std::string diff_of(const std::string& before, const std::string& after) {
  return to_text(diff(backup_of(before).parameters, backup_of(after).parameters));
}

// Streams

/// Samples that wait for Python. Beyond a limit, the oldest are dropped.
class SampleQueue {
 public:
  SampleQueue(std::shared_ptr<Bell> bell, VirtualTimePointer time)
      : bell_(std::move(bell)), time_(std::move(time)) {}

  void put(AnyMessage message) {
    {
      const std::scoped_lock lock(mutex_);
      if (samples_.size() == limit) {
        samples_.pop_front();
        ++missed_;
      }
      samples_.push_back(std::move(message));
    }
    changed_.notify_all();
    bell_->ring();
  }
  /// Returns the next sample; nothing if there is none within this time.
  std::optional<AnyMessage> take(Seconds seconds) {
    return released([&]() -> std::optional<AnyMessage> {
      if (time_) time_->run([this] { return has_sample(); }, time_->now() + duration_of(seconds));
      std::unique_lock lock(mutex_);
      const auto time = std::chrono::duration<double>(time_ ? 0 : seconds);
      if (!changed_.wait_for(lock, time, [this] { return !samples_.empty(); })) return {};
      std::optional<AnyMessage> sample(std::move(samples_.front()));
      samples_.pop_front();
      return sample;
    });
  }
  std::uint64_t missed() const {
    const std::scoped_lock lock(mutex_);
    return missed_;
  }
  void own(Subscription subscription) { subscription_ = std::move(subscription); }
  void cancel() { subscription_.cancel(); }

 private:
  static constexpr std::size_t limit = 4096;

  bool has_sample() const {
    const std::scoped_lock lock(mutex_);
    return !samples_.empty();
  }

  std::shared_ptr<Bell> bell_;
  VirtualTimePointer time_;
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<AnyMessage> samples_{};
  std::uint64_t missed_ = 0;
  Subscription subscription_{};
};

/// Starts the stream of the message with this name; its result is a SampleQueue.
OperationPointer stream(const LinkPointer& link, const std::string& name, Seconds interval,
                        const AnyMessage* request, std::optional<Seconds> timeout) {
  auto operation = link->begin();
  const detail::Conversation conversation = link->conversation();
  const CallOptions options{.timeout = timeout_of(timeout)};
  auto wanted = detail::stream_request<roles::StreamRequest>(milliseconds_of(interval, "interval"));
  if (!wanted) raise_client(wanted.error());
  if (request != nullptr) {
    const auto* const given = request->get_if<roles::StreamRequest>();
    if (given == nullptr) throw py::type_error("request: the request of a stream is needed");
    const auto chosen = roles::stream_interval(*wanted);
    *wanted = without_surplus(*given);
    roles::stream_interval(*wanted) = chosen;
  }
  bool is_known = false;
  roles::StreamMessages::for_each([&]<class M>(Type<M>) {
    if (name != Meta<M>::info.name) return;
    is_known = true;
    const auto queue = std::make_shared<SampleQueue>(link->bell(), link->time());
    const CallId id = conversation.start_stream(
        detail::stream_requests<M>(conversation, *wanted, options), detail::key_of<M>,
        detail::typed_handler<M>([queue](const M& sample) {
          AnyMessage message = find_message(Meta<M>::info.name)->make();
          static_cast<M&>(*message.get_if<M>()) = sample;
          queue->put(std::move(message));
        }),
        options, [operation, queue](Result<Subscription> started) {
          const Result<void> result = started ? Result<void>() : started.error();
          if (started) queue->own(*std::move(started));
          operation->end([queue, result] {
            if (!result) raise_client(result.error());
            return py::cast(queue);
          });
        });
    operation->set_cancel([conversation, id] { conversation.cancel(id); });
  });
  if (!is_known) throw py::value_error("the board has no stream of " + name);
  return operation;
}

// Speeds

/// A held speed: SpeedControl without a thread of its own.
class HeldSpeed {
 public:
  HeldSpeed(const LinkPointer& link, Seconds silence)
      : speed_(std::make_shared<detail::HeldSpeed>(
            detail::DeadMansSwitch(milliseconds(milliseconds_of(silence, "silence").count()),
                                   milliseconds(SpeedControlOptions{}.repeat.count())))),
        operation_(link->begin()) {
    const SpeedControlOptions usual;
    const auto task = std::make_shared<Task<Result<void>>>(
        detail::hold_speed(speed_, detail::BoundedTurn(usual.bound, usual.lookahead)));
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
    change([&](detail::DeadMansSwitch& rules) -> Result<void> {
      rules.set(speeds, operation_->now());
      return {};
    });
  }
  void refresh() {
    change([this](detail::DeadMansSwitch& rules) -> Result<void> {
      if (rules.state() != detail::DeadMansSwitch::State::turning) {
        return ClientError{ErrorCode::cancelled, "the camera has been stopped"};
      }
      rules.refresh(operation_->now());
      return {};
    });
  }
  void stop() {
    change([](detail::DeadMansSwitch& rules) -> Result<void> {
      rules.stop();
      return {};
    });
  }
  /// Stops the camera; the operation ends when it stands still.
  OperationPointer close() {
    operation_->cancel();
    return operation_;
  }

 private:
  template <class Change>
  void change(const Change& change) {
    const Result<void> changed = speed_->with(change);
    if (!changed) raise_client(changed.error());
    wake_();
  }

  std::shared_ptr<detail::HeldSpeed> speed_;
  OperationPointer operation_;
  std::function<void()> wake_{};
};

ConnectOptions connect_options(Seconds timeout, const std::optional<std::string>& capture) {
  ConnectOptions options;
  options.timeout = milliseconds_of(timeout, "timeout");
  options.capture = capture;
  return options;
}

}  // namespace

void bind_client(py::module_& module) {
  py::class_<Operation, OperationPointer>(module, "Operation")
      .def("wait", &Operation::wait)
      .def("cancel", &Operation::cancel)
      .def("result", &Operation::result)
      .def("progress", &Operation::progress);
  py::class_<SampleQueue, std::shared_ptr<SampleQueue>>(module, "SampleQueue")
      .def("take", &SampleQueue::take)
      .def("cancel", &SampleQueue::cancel)
      .def_property_readonly("missed", &SampleQueue::missed);
  py::class_<HeldSpeed>(module, "HeldSpeed")
      .def(py::init<const LinkPointer&, Seconds>())
      .def("set", &HeldSpeed::set)
      .def("refresh", &HeldSpeed::refresh)
      .def("stop", &HeldSpeed::stop)
      .def("close", &HeldSpeed::close);
  py::class_<Link, LinkPointer>(module, "Link")
      .def(py::init<>())
      .def("connect",
           [](Link& link, const std::string& address, Seconds timeout,
              const std::optional<std::string>& capture) {
             const ConnectOptions options = connect_options(timeout, capture);
             return link.connect(detail::opener_of(address, options), options);
           })
      .def("connect",
           [](Link& link, const std::shared_ptr<Emulation>& board, Seconds timeout,
              const std::optional<std::string>& capture) {
             const ConnectOptions options = connect_options(timeout, capture);
             link.use(board->time());
             return link.connect(detail::opener_of(board->line(), options), options);
           })
      .def("close",
           [](Link& link) {
             return released([&] {
               link.close();
               return true;
             });
           })
      .def_property_readonly("descriptor", [](Link& link) { return link.bell()->descriptor(); })
      .def("now", [](Link& link) { return static_cast<double>(link.now().us) / 1e6; })
      .def("silence", [](Link& link) { link.bell()->silence(); })
      .def("description", [](Link& link) { return link.conversation().description(); })
      .def("identity",
           [](Link& link) {
             const BoardIdentity& board = link.conversation().identity();
             AnyMessage info = find_message("BoardInfo")->make();
             static_cast<msg::BoardInfo&>(*info.get_if<msg::BoardInfo>()) = board.info;
             return py::make_tuple(board.board_version(), board.firmware_version(),
                                   board.serial_number(), info);
           })
      .def("call", &call)
      .def("move_to", &move_to)
      .def("stop", [](Link& link) { return link.run(tasks::stop(), to_python); })
      .def("release", [](Link& link) { return link.run(tasks::release(), to_python); })
      .def("calibrate", &calibrate)
      .def("read_parameters", &read_parameters)
      .def("write_parameters", &write_parameters)
      .def("make_backup", &make_backup)
      .def("restore", &restore)
      .def("active_profile",
           [](Link& link) { return link.run(tasks::active_profile(), cast_of<std::size_t>); })
      .def("get_variables",
           [](Link& link, std::vector<std::string> names) {
             return link.run(tasks::get_variables(std::move(names)), cast_of<std::vector<double>>);
           })
      .def("set_variables",
           [](Link& link, const std::vector<std::pair<std::string, double>>& values) {
             std::vector<VariableValue> wanted;
             for (const auto& [name, value] : values) wanted.push_back({name, value});
             return link.run(tasks::set_variables(std::move(wanted)), to_python);
           })
      .def("save_variables",
           [](Link& link) { return link.run(tasks::save_variables(), to_python); })
      .def("download_eeprom",
           [](Link& link, std::uint32_t address, std::size_t size) {
             return link.run(tasks::download_eeprom(address, size), bytes_of);
           })
      .def("download_file",
           [](Link& link, std::uint16_t file) {
             return link.run(tasks::download_file(file), bytes_of);
           })
      .def("upload_file",
           [](Link& link, std::uint16_t file, const py::buffer& data) {
             auto bytes = with_bytes(
                 data, [](Bytes all) { return std::vector<std::uint8_t>(all.begin(), all.end()); });
             return link.run(tasks::upload_file(file, std::move(bytes)), to_python);
           })
      .def("delete_file",
           [](Link& link, std::uint16_t file) {
             return link.run(tasks::delete_file(file), to_python);
           })
      .def("stream", &stream);
  module.def("diff", &diff_of);
}

}  // namespace sbgc::python
