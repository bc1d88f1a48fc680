// The tasks of the client, as methods that begin them.

#include <algorithm>
#include <cmath>
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
using Octets = std::vector<std::uint8_t>;

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
py::object value_of(const Octets& bytes) { return to_bytes(bytes); }
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

// Progress. An operation that is no longer awaited has none.

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

using Time = std::chrono::milliseconds;

TransferOptions transfer(const OperationPointer& operation, Time timeout) {
  return {.timeout = timeout, .progress = progress_to(operation)};
}

ReadOptions reading(const OperationPointer& operation, Time timeout) {
  ReadOptions options;
  options.timeout = timeout;
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

Task<Result<MoveProgress>> move_to(const OperationPointer& operation, OptionalFloat<"roll"> roll,
                                   OptionalFloat<"pitch"> pitch, OptionalFloat<"yaw"> yaw,
                                   Float<"speed"> speed, Seconds<"timeout"> timeout,
                                   Float<"tolerance"> tolerance, bool waits) {
  const MoveTarget target = target_of(roll, pitch, yaw);
  MoveOptions options;
  options.speed = speed_of(speed, "speed");
  options.timeout = timeout;
  options.tolerance = number_in(tolerance, "tolerance", 0, 360);
  options.progress = [weak = std::weak_ptr(operation)](const MoveProgress& progress) {
    if (const auto one = weak.lock()) one->report([progress] { return move_progress(progress); });
    return true;
  };
  return waits ? tasks::move_to(target, options) : tasks::begin_move(target, options);
}

Task<Result<CalibrationEnd>> calibrate(const OperationPointer& operation, const AnyMessage& request,
                                       OptionalSeconds<"timeout"> timeout) {
  CalibrationOptions options;
  options.timeout = timeout;
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
                                           std::optional<std::uint8_t> copy,
                                           Seconds<"timeout"> timeout) {
  ReadOptions options = reading(operation, timeout);
  if (copy) {
    options.wanted = [copy](const ParametersId& id) { return id.copy == *copy || id.copy == 0; };
  }
  return tasks::read_parameters(options);
}

Task<WriteReport> write_parameters(const OperationPointer& operation, const py::list& blocks,
                                   Seconds<"timeout"> timeout) {
  WriteOptions options;
  options.timeout = timeout;
  options.progress = progress_to(operation);
  return tasks::write_parameters(set_of(blocks), options);
}

Backup backup_of(const std::string& text) {
  auto backup = parse_backup(text);
  if (!backup) raise_client(backup.error());
  return *std::move(backup);
}

Task<WriteReport> restore(const OperationPointer& operation, const Text<"backup">& text,
                          const OptionalPath<"save_current">& save_current, Flag<"dry_run"> dry_run,
                          Flag<"allow_other_model"> allow_other_model,
                          Flag<"allow_other_firmware"> allow_other_firmware,
                          Flag<"allow_partial"> allow_partial, Seconds<"timeout"> timeout) {
  RestoreOptions options;
  if (*save_current) options.save_current = save_to(**save_current);
  options.dry_run = dry_run;
  options.allow_other_model = allow_other_model;
  options.allow_other_firmware = allow_other_firmware;
  options.allow_partial = allow_partial;
  options.timeout = timeout;
  options.progress = progress_to(operation);
  return tasks::restore(backup_of(text), options);
}

Task<Result<std::optional<AnyMessage>>> confirmed(AnyMessage request) {
  co_return co_await tasks::call(request, confirming());
}

/// Raises for a value between two whole steps, which the library would round.
void require_step(const std::string& name, double value, const Availability& versions) {
  const Result<const VariableInfo*> variable = find_variable(name);
  if (!variable) return;
  const UnitInfo unit = (*variable)->unit_in(versions);
  const double step = unit.numerator / unit.denominator;
  const double exact = unit.raw(value);
  if (step < 1 || !(std::abs(exact - std::round(exact)) > 1e-6)) return;
  std::string problem = name + ": " + detail::unit_text(value, unit);
  problem += unit.is_plain()
                 ? " is not an integer"
                 : " is between two values, which are " + detail::unit_text(step, unit) + " apart";
  raise("FieldError", problem, name);
}

OperationPointer set_variables(Link& link, const py::dict& values) {
  const Availability versions = link.client().identity().versions();
  std::vector<VariableValue> wanted;
  for (const auto& [name, value] : values) {
    std::string text = string_of(name, "values");
    const double number = number_of(value, text.c_str());
    require_step(text, number, versions);
    wanted.push_back({std::move(text), number});
  }
  OperationPointer operation = link.make_operation();
  link.prepare_task(*operation, tasks::set_variables(std::move(wanted)),
                    [](const Result<void>& result) { return result_of(result); });
  return operation;
}

Task<Result<void>> rename_profiles(const Texts<"names">& names) {
  ProfileNames all;
  if (names.value.size() != all.size()) {
    throw py::value_error("names: " + std::to_string(all.size()) + " are needed, not " +
                          std::to_string(names.value.size()));
  }
  std::ranges::copy(names.value, all.begin());
  return tasks::rename_profiles(all);
}

std::string diff_of(const Text<"before">& before, const Text<"after">& after) {
  const Backup old = backup_of(before);
  const Backup now = backup_of(after);
  return to_text(diff(old.parameters, now.parameters, old.board.versions(), now.board.versions()));
}

using File = Integer<std::uint16_t, "file">;
using Address = Integer<std::uint32_t, "address">;
using Timeout = Seconds<"timeout">;
using Data = Memory<"data">;

// Methods

class Methods {
 public:
  explicit Methods(LinkClass& link) : link_(link) {}

  /// Adds a method that runs the task returned by `make`.
  template <class R, class... Arguments>
  const Methods& def(const char* name, Task<R> (*make)(Arguments...)) const {
    link_.def(name, [make](Link& link, Arguments... arguments) {
      OperationPointer operation = link.make_operation();
      link.prepare_task(*operation, make(std::forward<Arguments>(arguments)...),
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
      OperationPointer operation = link.make_operation();
      link.prepare_task(*operation, make(operation, std::forward<Arguments>(arguments)...),
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
  link.def("set_variables", &set_variables);
  Methods(link)
      .def("move_to", &move_to)
      .def(
          "stop", +[] { return tasks::stop(); })
      .def("release", &tasks::release)
      .def(
          "confirm", +[](const AnyMessage& request) { return confirmed(request); })
      .def(
          "set_control_timeout",
          +[](Seconds<"seconds"> timeout) { return tasks::set_control_timeout(timeout); })
      .def("calibrate", &calibrate)
      .def("record_bode", &record_bode)
      .def("read_parameters", &read_parameters)
      .def("write_parameters", &write_parameters)
      .def(
          "make_backup",
          +[](const OperationPointer& operation, Timeout timeout) {
            return tasks::make_backup(utc_now(), reading(operation, timeout));
          })
      .def("restore", &restore)
      .def("active_profile", &tasks::active_profile)
      .def("profile_names", &tasks::profile_names)
      .def(
          "rename_profile", +[](std::size_t profile,
                                Text<"name"> name) { return tasks::rename_profile(profile, name); })
      .def("rename_profiles", &rename_profiles)
      .def(
          "get_variables", +[](Texts<"names"> names) { return tasks::get_variables(names); })
      .def("save_variables", &tasks::save_variables)
      .def(
          "download_eeprom",
          +[](const OperationPointer& operation, Address address,
              Integer<std::uint32_t, "size"> size, Timeout timeout) {
            return tasks::download_eeprom(address, size, transfer(operation, timeout));
          })
      .def(
          "upload_eeprom",
          +[](const OperationPointer& operation, Address address, Data data, Timeout timeout) {
            return tasks::upload_eeprom(address, data, transfer(operation, timeout));
          })
      .def(
          "file_size", +[](File file) { return tasks::file_size(file); })
      .def(
          "download_file",
          +[](const OperationPointer& operation, File file, Timeout timeout) {
            return tasks::download_file(file, transfer(operation, timeout));
          })
      .def(
          "upload_file",
          +[](const OperationPointer& operation, File file, Data data, Timeout timeout) {
            return tasks::upload_file(file, data, transfer(operation, timeout));
          })
      .def(
          "delete_file", +[](File file) { return tasks::delete_file(file); })
      .def("delete_all_files", &tasks::delete_all_files)
      .def("download_user_data", &tasks::download_user_data)
      .def(
          "upload_user_data", +[](Integer<std::uint32_t, "offset"> offset, Data data) {
            return tasks::upload_user_data(offset, data);
          });
  module.def("diff", &diff_of);
}

}  // namespace sbgc::python
