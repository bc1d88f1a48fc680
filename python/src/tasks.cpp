// The tasks of the client, as methods that begin them.

#include <array>
#include <filesystem>
#include <optional>
#include <type_traits>

#include <pybind11/stl.h>

#include <sbgc/client/tasks.hpp>
#include <sbgc/meta/calibration.hpp>

#include "arguments.hpp"
#include "link.hpp"

namespace sbgc::python {

namespace {

using OperationPointer = std::shared_ptr<Operation>;
using Memory = std::vector<std::uint8_t>;

// Results

py::tuple angles_of(const Axes<msg::Angle14>& axes) {
  return py::make_tuple(axes.roll.degrees(), axes.pitch.degrees(), axes.yaw.degrees());
}
py::object move_progress(const MoveProgress& progress) {
  return py::make_tuple(
      angles_of(progress.angles),
      py::make_tuple(progress.remaining.roll, progress.remaining.pitch, progress.remaining.yaw),
      progress.is_close, std::chrono::duration<double>(progress.elapsed).count());
}

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

template <class T>
py::object value_of(const T& value) {
  return py::cast(value);
}
py::object value_of(const MoveProgress& progress) { return move_progress(progress); }
py::object value_of(const Memory& bytes) { return to_bytes(bytes); }
py::object value_of(const ParameterSet& set) { return blocks_of(set); }
py::object value_of(const Backup& backup) { return py::cast(to_json_text(backup)); }
py::list value_of(const ProfileNames& names) {
  py::list result;
  for (const std::string& one : names) result.append(to_text(one));
  return result;
}
py::object value_of(const BodeRecording& recording) {
  return py::make_tuple(any_of(recording.request), recording.input, recording.output,
                        recording.lost, recording.is_end_lost);
}
py::object value_of(CalibrationEnd end) {
  switch (end) {
    case CalibrationEnd::finished: return py::str("finished");
    case CalibrationEnd::accepted: break;
  }
  return py::str("accepted");
}

template <class T>
py::object result_of(const Result<T>& result) {
  if (!result) raise_client(result.error());
  if constexpr (std::is_void_v<T>) {
    return py::none();
  } else {
    return value_of(*result);
  }
}
py::object result_of(const WriteReport& report) { return report_of(report); }

// Progress. An operation that nobody waits for any more has none.

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

// Arguments

Memory memory_of(const py::buffer& data) {
  return with_bytes(data, [](Bytes all) { return Memory(all.begin(), all.end()); });
}

TransferOptions transfer(const OperationPointer& operation, Seconds timeout) {
  return {.timeout = milliseconds_of(timeout, "timeout"), .progress = progress_to(operation)};
}

ReadOptions reading(const OperationPointer& operation, Seconds timeout) {
  ReadOptions options;
  options.timeout = milliseconds_of(timeout, "timeout");
  options.progress = progress_to(operation);
  return options;
}

MoveTarget target_of(std::optional<double> roll, std::optional<double> pitch,
                     std::optional<double> yaw) {
  MoveTarget target;
  if (roll) target.roll = quantity_of<msg::Angle14>(*roll, "roll");
  if (pitch) target.pitch = quantity_of<msg::Angle14>(*pitch, "pitch");
  if (yaw) target.yaw = quantity_of<msg::Angle14>(*yaw, "yaw");
  return target;
}

Task<Result<MoveProgress>> move_to(const OperationPointer& operation, std::optional<double> roll,
                                   std::optional<double> pitch, std::optional<double> yaw,
                                   double speed, Seconds timeout, double tolerance, bool waits) {
  const MoveTarget target = target_of(roll, pitch, yaw);
  MoveOptions options;
  options.speed = quantity_of<msg::ControlSpeed>(speed, "speed");
  options.timeout = milliseconds_of(timeout, "timeout");
  options.tolerance = tolerance;
  options.progress = [weak = std::weak_ptr(operation)](const MoveProgress& progress) {
    if (const auto one = weak.lock()) one->report([progress] { return move_progress(progress); });
    return true;
  };
  return waits ? tasks::move_to(target, options) : tasks::begin_move(target, options);
}

Task<Result<CalibrationEnd>> calibrate(const OperationPointer& operation, const AnyMessage& request,
                                       std::optional<Seconds> timeout) {
  CalibrationOptions options;
  options.timeout = timeout_of(timeout);
  request.with_leaf(
      "imu_idx", [&](const Leaf& leaf) { options.imu = static_cast<msg::CalibImu>(leaf.integer); });
  options.progress = [weak = std::weak_ptr(operation)](const CalibrationProgress& progress) {
    const auto one = weak.lock();
    if (!one) return true;
    std::optional<AnyMessage> state;
    if (progress.state) state = any_of(*progress.state);
    one->report([started = progress.has_started, elapsed = progress.elapsed, state] {
      return py::make_tuple(started, std::chrono::duration<double>(elapsed).count(), state);
    });
    return true;
  };
  return tasks::run_calibration(request, options);
}

Task<Result<BodeRecording>> record_bode(const OperationPointer& operation,
                                        const AnyMessage& request) {
  const auto* const of = request.get_if<msg::BodeTestStartStopRequest>();
  if (of == nullptr) throw py::type_error("not a BodeTestStartStopRequest");
  BodeOptions options;
  options.progress = [weak = std::weak_ptr(operation)](const BodeProgress& progress) {
    if (const auto one = weak.lock()) {
      one->report([progress] {
        return py::make_tuple(progress.samples, progress.total, "recording a frequency response");
      });
    }
    return true;
  };
  return tasks::record_bode(*of, options);
}

Task<Result<ParameterSet>> read_parameters(const OperationPointer& operation,
                                           std::optional<std::uint8_t> copy, Seconds timeout) {
  ReadOptions options = reading(operation, timeout);
  if (copy) {
    options.wanted = [copy](const ParametersId& id) { return id.copy == *copy || id.copy == 0; };
  }
  return tasks::read_parameters(options);
}

Task<WriteReport> write_parameters(const OperationPointer& operation, const py::list& blocks,
                                   Seconds timeout) {
  WriteOptions options;
  options.timeout = milliseconds_of(timeout, "timeout");
  options.progress = progress_to(operation);
  return tasks::write_parameters(set_of(blocks), options);
}

Backup backup_of(const std::string& text) {
  auto backup = parse_backup(text);
  if (!backup) raise_client(backup.error());
  return *std::move(backup);
}

Task<WriteReport> restore(const OperationPointer& operation, const std::string& text,
                          const std::optional<std::string>& save_current, bool dry_run,
                          bool allow_other_model, bool allow_other_firmware, bool allow_partial,
                          Seconds timeout) {
  RestoreOptions options;
  if (save_current) options.save_current = save_to(*save_current);
  options.dry_run = dry_run;
  options.allow_other_model = allow_other_model;
  options.allow_other_firmware = allow_other_firmware;
  options.allow_partial = allow_partial;
  options.timeout = milliseconds_of(timeout, "timeout");
  options.progress = progress_to(operation);
  return tasks::restore(backup_of(text), options);
}

Task<Result<std::optional<AnyMessage>>> confirmed(AnyMessage request) {
  co_return co_await tasks::call(request, confirming());
}

Task<Result<void>> set_variables(const std::vector<std::pair<std::string, double>>& values) {
  std::vector<VariableValue> wanted;
  for (const auto& [name, value] : values) wanted.push_back({name, value});
  return tasks::set_variables(std::move(wanted));
}

Task<Result<void>> rename_profiles(const std::array<std::string, profile_count>& names) {
  return tasks::rename_profiles({names});
}

std::string diff_of(const std::string& before, const std::string& after) {
  const Backup old = backup_of(before);
  const Backup now = backup_of(after);
  return to_text(diff(old.parameters, now.parameters, old.board.versions(), now.board.versions()));
}

std::uint16_t file_of(std::int64_t number) { return integer_of<std::uint16_t>(number, "file"); }

// Methods

class Methods {
 public:
  explicit Methods(LinkClass& link) : link_(link) {}

  /// Adds a method that runs the task which `make` returns.
  template <class R, class... Arguments>
  const Methods& def(const char* name, Task<R> (*make)(Arguments...)) const {
    link_.def(name, [make](Link& link, Arguments... arguments) {
      OperationPointer operation = link.begin();
      link.run(operation, make(std::forward<Arguments>(arguments)...),
               [](const R& result) { return result_of(result); });
      return operation;
    });
    return *this;
  }
  /// The same if the task reports its progress to its operation.
  template <class R, class... Arguments>
  const Methods& def(const char* name,
                     Task<R> (*make)(const OperationPointer&, Arguments...)) const {
    link_.def(name, [make](Link& link, Arguments... arguments) {
      OperationPointer operation = link.begin();
      link.run(operation, make(operation, std::forward<Arguments>(arguments)...),
               [](const R& result) { return result_of(result); });
      return operation;
    });
    return *this;
  }

 private:
  LinkClass& link_;
};

}  // namespace

void bind_tasks(py::module_& module, LinkClass& link) {
  using Text = const std::string&;
  Methods(link)
      .def("move_to", &move_to)
      .def(
          "stop", +[] { return tasks::stop(); })
      .def("release", &tasks::release)
      .def(
          "confirm", +[](const AnyMessage& request) { return confirmed(request); })
      .def(
          "set_control_timeout",
          +[](Seconds timeout) {
            return tasks::set_control_timeout(milliseconds_of(timeout, "timeout"));
          })
      .def("calibrate", &calibrate)
      .def("record_bode", &record_bode)
      .def("read_parameters", &read_parameters)
      .def("write_parameters", &write_parameters)
      .def(
          "make_backup",
          +[](const OperationPointer& operation, Seconds timeout) {
            return tasks::make_backup(utc_now(), reading(operation, timeout));
          })
      .def("restore", &restore)
      .def("active_profile", &tasks::active_profile)
      .def("profile_names", &tasks::profile_names)
      .def(
          "rename_profile",
          +[](std::size_t profile, Text name) { return tasks::rename_profile(profile, name); })
      .def("rename_profiles", &rename_profiles)
      .def(
          "get_variables",
          +[](const std::vector<std::string>& names) { return tasks::get_variables(names); })
      .def("set_variables", &set_variables)
      .def("save_variables", &tasks::save_variables)
      .def(
          "download_eeprom",
          +[](const OperationPointer& operation, std::int64_t address, std::int64_t size,
              Seconds timeout) {
            return tasks::download_eeprom(integer_of<std::uint32_t>(address, "address"),
                                          integer_of<std::uint32_t>(size, "size"),
                                          transfer(operation, timeout));
          })
      .def(
          "upload_eeprom",
          +[](const OperationPointer& operation, std::int64_t address, const py::buffer& data,
              Seconds timeout) {
            return tasks::upload_eeprom(integer_of<std::uint32_t>(address, "address"),
                                        memory_of(data), transfer(operation, timeout));
          })
      .def(
          "file_size", +[](std::int64_t file) { return tasks::file_size(file_of(file)); })
      .def(
          "download_file",
          +[](const OperationPointer& operation, std::int64_t file, Seconds timeout) {
            return tasks::download_file(file_of(file), transfer(operation, timeout));
          })
      .def(
          "upload_file",
          +[](const OperationPointer& operation, std::int64_t file, const py::buffer& data,
              Seconds timeout) {
            return tasks::upload_file(file_of(file), memory_of(data), transfer(operation, timeout));
          })
      .def(
          "delete_file", +[](std::int64_t file) { return tasks::delete_file(file_of(file)); })
      .def("delete_all_files", &tasks::delete_all_files)
      .def("download_user_data", &tasks::download_user_data)
      .def(
          "upload_user_data", +[](std::int64_t offset, const py::buffer& data) {
            return tasks::upload_user_data(integer_of<std::uint32_t>(offset, "offset"),
                                           memory_of(data));
          });
  module.def("diff", &diff_of);
}

}  // namespace sbgc::python
