// Exports of the module `setup`, except those for parameters.

#include "modules/setup.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include <fmt/format.h>

#include <sbgc/analysis/frequency_response.hpp>
#include <sbgc/any.hpp>
#include <sbgc/client/bode.hpp>
#include <sbgc/client/calibration.hpp>
#include <sbgc/client/calibrations.hpp>
#include <sbgc/client/motion.hpp>
#include <sbgc/client/readiness.hpp>
#include <sbgc/client/tuning.hpp>

#include "modules/client.hpp"
#include "modules/exchange.hpp"
#include "values/complete_message.hpp"
#include "values/effect_text.hpp"

namespace sbgc::web {

namespace {

/// The page no longer wants the task that runs.
bool& is_cancelled() {
  static bool value = false;
  return value;
}

}  // namespace

void put(const Json& result) { tools::exchange().output = detail::json_text(result); }

void start(double id, Task<Result<Json>> task) {
  client()->passive().start(std::move(task), [id](const Result<Json>& result) {
    if (!result) return client()->report_end(id, result.error().message);
    client()->report_end(id, "", [&](JsonWriter& out) {
      out.key("result").value().put(detail::json_text(*result));
    });
  });
}

bool report_progress(double id, double share, std::string_view text) {
  client()->report([&](JsonWriter& out) {
    out.member("progress", static_cast<std::int64_t>(id));
    out.key("of").object([&] {
      if (share >= 0) out.member("share", share);
      out.member("text", text);
    });
  });
  return !is_cancelled();
}

/// Starts with a new client, whose moves end when commands cease.
SBGC_EXPORT(setup_begin) void setup_begin() {
  client()->bound_moves();
  forget_parameters();
}

/// The output has the versions and the serial number of the board, and the features that it lacks.
SBGC_EXPORT(setup_board) void setup_board() {
  const BoardIdentity& board = client()->passive().identity();
  Json lacks = Json::array();
  for (const ValueInfo& value : EnumMeta<msg::BoardFeature>::info.values) {
    const auto feature = static_cast<msg::BoardFeature>(value.value);
    if (!board.info.board_features.has(feature)) lacks.push_back(value.name);
  }
  if (!board.firmware_problem().empty()) lacks.push_back("firmware: " + board.firmware_problem());
  put({{"board", board.info.board_ver.raw()},
       {"firmware", board.info.firmware_ver.raw()},
       {"serialNumber", board.serial_number()},
       {"lacks", std::move(lacks)}});
}

namespace {

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

Task<Result<Json>> bode(msg::BodeTestStartStopRequest request, BodeOptions options, double from,
                        double to) {
  const Result<BodeRecording> made = co_await tasks::record_bode(request, std::move(options));
  if (!made) co_return made.error();
  const auto response =
      analysis::frequency_response(made->input, made->output, bode_sample_rate, from, to);
  Json result{{"frequency", Json::array()}, {"gain", Json::array()}, {"phase", Json::array()}};
  for (const analysis::ResponsePoint& point : response.points) {
    if (!std::isfinite(point.gain)) continue;
    result["frequency"].push_back(point.frequency);
    result["gain"].push_back(point.gain);
    result["phase"].push_back(point.phase);
  }
  result["csv"] = to_csv(*made);
  co_return result;
}

Task<Result<Json>> check(const Calibration& one) {
  const Result<Readiness> found = co_await tasks::check_readiness({.conditions = one.conditions});
  if (!found) co_return found.error();
  co_return Json(found->problem);
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
  put(result);
}

/// Checks whether the gimbal is ready for the calibration in the input. The result is the problem.
SBGC_EXPORT(setup_check) void setup_check(double id) {
  const Calibration* const one = calibration_named(input_text());
  if (one == nullptr) return client()->report_end(id, "there is no such calibration");
  start(id, check(*one));
}

/// Calibrates. The input is the name of the calibration, and a line PATH=TEXT for each value.
SBGC_EXPORT(setup_calibrate) void setup_calibrate(double id) {
  std::string_view lines = input_text();
  const Calibration* const one = calibration_named(take_until('\n', lines));
  if (one == nullptr) return client()->report_end(id, "there is no such calibration");
  AnyMessage request = tools::new_message(*find_message(one->info().name));
  if (one->forms.front().has_action) static_cast<void>(request.assign("action", "REGULAR"));
  std::string problem;
  for_each_setting(lines, [&](std::string_view path, std::string_view value) {
    if (problem.empty()) problem = request.assign(path, value);
  });
  if (!problem.empty()) return client()->report_end(id, problem);
  is_cancelled() = false;
  CalibrationOptions options;
  options.progress = [id](const CalibrationProgress& now) {
    const double seconds = std::chrono::duration<double>(now.elapsed).count();
    const double share = now.state ? static_cast<double>(now.state->progress.raw()) / 100 : -1;
    return report_progress(id, share, fmt::format("calibrating for {:.0f} s", seconds));
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
    return report_progress(id, -1, "tuning");
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
    const double share = static_cast<double>(now.samples) / static_cast<double>(now.total);
    return report_progress(id, share, fmt::format("{} of {} samples", now.samples, now.total));
  };
  start(id, bode(request, std::move(options), from, to));
}

/// Ends the waiting of a calibration, a tuning or a recording.
SBGC_EXPORT(setup_cancel) void setup_cancel() { is_cancelled() = true; }

}  // namespace sbgc::web
