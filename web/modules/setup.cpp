// Exports of the module `setup`: the board, its parameters and their files, and long tasks that
// need a person. Profiles count from 1. Progress is reported as {"progress": ID, "of": {"share":
// 0.5, "text": "…"}}, without a share if it is not known; a result as {"done": ID, "result": …}.

#include "modules/setup.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>

#include <sbgc/analysis/frequency_response.hpp>
#include <sbgc/any.hpp>
#include <sbgc/availability.hpp>
#include <sbgc/client/bode.hpp>
#include <sbgc/client/calibration.hpp>
#include <sbgc/client/calibrations.hpp>
#include <sbgc/client/motion.hpp>
#include <sbgc/client/readiness.hpp>
#include <sbgc/client/tuning.hpp>
#include <sbgc/internal/parse_number.hpp>

#include "modules/exchange.hpp"
#include "values/complete_message.hpp"
#include "values/effect_text.hpp"

namespace sbgc::web {

namespace {

Parameters& parameters() {
  static Parameters made;
  return made;
}

std::uint8_t index_of(double profile) { return static_cast<std::uint8_t>(profile - 1); }

void put(const Json& result) { tools::exchange().output = detail::json_text(result); }

template <class E>
void add_missing(Flags<E> flags, Json& names) {
  for (const ValueInfo& value : EnumMeta<E>::info.values) {
    if (!flags.has(static_cast<E>(value.value))) names.push_back(value.name);
  }
}

}  // namespace

/// Starts with a new client, whose moves end when commands cease.
SBGC_EXPORT(setup_begin) void setup_begin() {
  client()->bound_moves();
  parameters() = {};
}

/// The output has the versions and the serial number of the board, and the features that it lacks.
SBGC_EXPORT(setup_board) void setup_board() {
  const BoardIdentity& board = client()->passive().identity();
  Json lacks = Json::array();
  add_missing(board.info.board_features, lacks);
  if (!board.firmware_problem().empty()) lacks.push_back("firmware: " + board.firmware_problem());
  put({{"board", board.info.board_ver.raw()},
       {"firmware", board.info.firmware_ver.raw()},
       {"serialNumber", board.serial_number()},
       {"lacks", std::move(lacks)}});
}

/// Reads all parameters; the input is the time, for backups.
SBGC_EXPORT(setup_read) void setup_read(double id) {
  parameters().read(id, std::string(input_text()));
}

/// Outputs a topic with its parameters in a profile; null after the last topic.
SBGC_EXPORT(setup_topic) void setup_topic(double number, double profile) {
  put(parameters().topic(static_cast<std::size_t>(number), index_of(profile)));
}

/// Plans the values in the input, a line MESSAGE.PATH=TEXT each. The output is the plan.
SBGC_EXPORT(setup_plan) void setup_plan(double profile) {
  put(parameters().plan_values(input_text(), index_of(profile)));
}

/// Plans the file in the input.
SBGC_EXPORT(setup_plan_file) void setup_plan_file(double profile) {
  put(parameters().plan_file(input_text(), index_of(profile)));
}

/// Plans to restore the parameters from before the last write.
SBGC_EXPORT(setup_plan_undo) void setup_plan_undo() { put(parameters().plan_undo()); }

/// Makes the next undo go back to the parameters that were read last.
SBGC_EXPORT(setup_remember) void setup_remember() { parameters().remember(); }

/// Writes the plan; the input is the time.
SBGC_EXPORT(setup_write) void setup_write(double id) {
  parameters().write(id, std::string(input_text()));
}

/// The output is a backup of the board, or with `of_plan` of the board with the plan.
SBGC_EXPORT(setup_backup) void setup_backup(double of_plan) {
  tools::exchange().output = parameters().backup(of_plan != 0);
}

namespace {

/// The page no longer wants the task that runs.
bool& is_cancelled() {
  static bool value = false;
  return value;
}

const Calibration* calibration_named(std::string_view name) {
  const auto& all = calibrations();
  const auto found = std::find_if(all.begin(), all.end(),
                                  [&](const Calibration& one) { return one.name == name; });
  return found == all.end() ? nullptr : &*found;
}

/// Returns the fields of a calibration that somebody must choose.
Json values_of(const Calibration& one) {
  Json values = Json::array();
  if (!one.needs_values) return values;
  for (const FieldType& field : find_message(one.info().name)->fields()) {
    if (field.info == nullptr || field.info->reserved || field.is_tail()) continue;
    Json names = Json::array();
    if (field.names != nullptr) {
      for (const ValueInfo& value : field.names->values) names.push_back(value.name);
    }
    values.push_back({{"path", field.name},
                      {"unit", field.unit != nullptr ? field.unit->name : ""},
                      {"summary", field.info->summary},
                      {"names", std::move(names)}});
  }
  return values;
}

/// Makes the request from the settings in `lines`. Returns what is wrong.
std::string fill(AnyMessage& request, std::string_view lines) {
  std::string problem;
  for_each_setting(lines, [&](std::string_view path, std::string_view value) {
    if (problem.empty()) problem = request.assign(path, value);
  });
  return problem;
}

/// A board that continues after an error would shake the camera.
Task<Result<void>> tune(msg::AutoPidRequest request, TuningOptions options) {
  const Result<void> tuned = co_await tasks::run_tuning(request, options);
  if (tuned) co_return tuned;
  ClientError error = tuned.error();
  if (const Result<void> ended = co_await tasks::end_tuning(); !ended) {
    error.message += "; ending it failed: " + ended.error().message;
  }
  static_cast<void>(co_await tasks::stop());
  co_return error;
}

Json to_json(const analysis::FrequencyResponse& response) {
  Json frequency = Json::array();
  Json gain = Json::array();
  Json phase = Json::array();
  for (const analysis::ResponsePoint& point : response.points) {
    if (!std::isfinite(point.gain)) continue;
    frequency.push_back(point.frequency);
    gain.push_back(point.gain);
    phase.push_back(point.phase);
  }
  return {{"frequency", frequency}, {"gain", gain}, {"phase", phase}};
}

}  // namespace

/// The output lists the calibrations.
SBGC_EXPORT(setup_calibrations) void setup_calibrations() {
  Json result = Json::array();
  for (const Calibration& one : calibrations()) {
    const MessageInfo& info = one.info();
    result.push_back({{"name", one.name},
                      {"summary", info.summary},
                      {"preparation", info.preparation},
                      {"effects", tools::effect_text(info.effects)},
                      {"moves", info.effects.has(Effect::moves)},
                      {"values", values_of(one)}});
  }
  tools::exchange().output = detail::json_text(result);
}

/// Checks whether the gimbal is ready for the calibration in the input.
SBGC_EXPORT(setup_check) void setup_check(double id) {
  const Calibration* const one = calibration_named(input_text());
  if (one == nullptr) return client()->report_end(id, "there is no such calibration");
  client()->passive().start(tasks::check_readiness({.conditions = one->conditions}),
                            [id](const Result<Readiness>& found) {
                              if (!found) return client()->report_end(id, found.error().message);
                              report_result(id, {{"problem", found->problem}});
                            });
}

/// Calibrates. The input is the name of the calibration, and a line PATH=TEXT for each value.
SBGC_EXPORT(setup_calibrate) void setup_calibrate(double id) {
  std::string_view lines = input_text();
  const Calibration* const one = calibration_named(take_until('\n', lines));
  if (one == nullptr) return client()->report_end(id, "there is no such calibration");
  AnyMessage request = tools::new_message(*find_message(one->info().name));
  if (one->forms.front().has_action) static_cast<void>(request.assign("action", "REGULAR"));
  if (std::string problem = fill(request, lines); !problem.empty()) {
    return client()->report_end(id, problem);
  }
  is_cancelled() = false;
  CalibrationOptions options;
  options.progress = [id](const CalibrationProgress& now) {
    const double seconds = std::chrono::duration<double>(now.elapsed).count();
    const double share = now.state ? static_cast<double>(now.state->progress.raw()) / 100 : -1;
    report_progress(id, share, fmt::format("calibrating for {:.0f} s", seconds));
    return !is_cancelled();
  };
  client()->start(id, tasks::run_calibration(std::move(request), options));
}

/// Tunes the axes whose bits are set: 1 roll, 2 pitch, 4 yaw.
SBGC_EXPORT(setup_tune)
void setup_tune(double id, double axes, double gain, double profile) {
  const auto bits = static_cast<unsigned>(axes);
  TuningChoice choice{.gain = gain, .profile = static_cast<std::uint8_t>(profile - 1)};
  choice.axes = {(bits & 1U) != 0, (bits & 2U) != 0, (bits & 4U) != 0};
  is_cancelled() = false;
  TuningOptions options;
  options.progress = [id](const std::optional<msg::AutoPid>&) {
    report_progress(id, -1, "tuning");
    return !is_cancelled();
  };
  client()->start(id, tune(tuning_request(choice), options));
}

/// Records the response of an axis, from 0, to white noise in a range of frequencies, in hertz.
SBGC_EXPORT(setup_bode)
void setup_bode(double id, double axis, double gain, double from, double to) {
  constexpr double seconds_of_recording = 4;
  msg::BodeTestStartStopRequest request;
  request.axis = static_cast<msg::BodeAxis>(axis);
  request.stimulus_type = msg::BodeStimulus::white_noise;
  request.stimulus_gain = static_cast<std::uint16_t>(gain);
  request.start_freq = msg::Frequency(static_cast<std::uint16_t>(from));
  request.end_freq = msg::Frequency(static_cast<std::uint16_t>(to));
  request.system = msg::BodeSystem::open_loop_plant;
  request.samples_num = bode_samples(seconds_of_recording);
  is_cancelled() = false;
  BodeOptions options;
  options.progress = [id](const BodeProgress& now) {
    report_progress(id, static_cast<double>(now.samples) / static_cast<double>(now.total),
                    fmt::format("{} of {} samples", now.samples, now.total));
    return !is_cancelled();
  };
  client()->passive().start(
      tasks::record_bode(request, options), [id, from, to](const Result<BodeRecording>& made) {
        if (!made) return client()->report_end(id, made.error().message);
        Json result = to_json(
            analysis::frequency_response(made->input, made->output, bode_sample_rate, from, to));
        result["csv"] = to_csv(*made);
        report_result(id, result);
      });
}

/// Ends the waiting of a calibration, a tuning or a recording.
SBGC_EXPORT(setup_cancel) void setup_cancel() { is_cancelled() = true; }

}  // namespace sbgc::web
