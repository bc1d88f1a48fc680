// sbgc calibrate: calibrates sensors, encoders and motors.

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <string>
#include <vector>

#include <fmt/format.h>

#include <sbgc/availability.hpp>
#include <sbgc/client/calibration.hpp>
#include <sbgc/client/calibrations.hpp>
#include <sbgc/client/client.hpp>
#include <sbgc/client/sensor_motion.hpp>
#include <sbgc/internal/suggestions.hpp>
#include <sbgc/internal/words.hpp>
#include <sbgc/messages/realtime.hpp>
#include <sbgc/meta/enums.hpp>

#include "board/connection.hpp"
#include "board/progress_bar.hpp"
#include "care/readiness.hpp"
#include "command/common_options.hpp"
#include "command/interruption.hpp"
#include "command/remark.hpp"
#include "command/subcommand.hpp"
#include "command/system.hpp"
#include "command/terminal_text.hpp"
#include "command/wording.hpp"
#include "values/assignments.hpp"
#include "values/complete_message.hpp"
#include "values/effect_text.hpp"
#include "values/message_names.hpp"

namespace sbgc::tools {

namespace {

void print_line(const char* name, const std::string& text) {
  constexpr std::size_t column = 15;
  fmt::print("{:{}}{}\n", name, column, wrapped(text, line_width(), column, column));
}

std::string temperature_text(bool is_on, msg::Temperature from, msg::Temperature to) {
  if (!is_on) return "not over temperature";
  return fmt::format("over temperature from {:.0f} to {:.0f} degC", from.real(), to.real());
}

/// Returns, for example, "shakes by 0.05 deg/s, turns by 0.01 deg/s".
std::string motion_text(const SensorMotion& motion) {
  return fmt::format("shakes by {:.2f} deg/s, turns by {:.2f} deg/s", motion.shaking,
                     motion.turning);
}

/// Prints a paragraph about one IMU. A board without a second IMU refuses to report its state.
void print_imu(Client& client, msg::SelectedImu imu, const char* name) {
  msg::CalibInfoRequest request;
  request.imu_type = imu;
  const Result<msg::CalibInfo> state = client.call(request);
  if (!state) return print_line(name, "no answer: " + state.error().message);
  const std::string missing = missing_positions(*state);
  print_line(name, fmt::format("accelerometer: {}{}; {}", calibrated_positions(*state),
                               missing.empty() ? "" : ", not " + missing,
                               temperature_text(state->temp_calib_acc_enabled != 0,
                                                state->temp_calib_acc_t_min_cels,
                                                state->temp_calib_acc_t_max_cels)));
  print_line("", "gyroscope: " + temperature_text(state->temp_calib_gyro_enabled != 0,
                                                  state->temp_calib_gyro_t_min_cels,
                                                  state->temp_calib_gyro_t_max_cels));
  print_line("", fmt::format("now {:.0f} degC", state->imu_temp_cels.real()));
}

/// Prints the state of calibration, for people. Throws CommandError.
void print_calibration_state(Client& client) {
  const msg::RealtimeData3 data =
      value_of(Result<msg::RealtimeData3>(client.call(msg::RealtimeData3Request{})));
  print_line("motors", data.other_flags.has(msg::OtherFlag::motors_on) ? "on" : "off");
  std::string problems;
  for (const auto error : {msg::SystemError::calib_acc, msg::SystemError::calib_poles}) {
    if (!data.system_error.has(error)) continue;
    for (const ValueInfo& one : EnumMeta<msg::SystemError>::info.values) {
      if (one.value == static_cast<std::int64_t>(error)) {
        problems += fmt::format("{}{}: {}", problems.empty() ? "" : " ", one.name, one.summary);
      }
    }
  }
  print_line("errors", problems.empty() ? "none of a calibration" : problems);
  print_line("motion", motion_text(value_of(client.run(tasks::watch_sensor(false)))));
  if (!is_supported<msg::CalibInfoRequest>(client.identity().versions())) return;
  print_imu(client, msg::SelectedImu::main, "main IMU");
  print_imu(client, msg::SelectedImu::frame, "frame IMU");
}

struct CalibrateOptions {
  std::string name{};
  std::vector<std::string> values{};
  std::string imu{};
  std::string voltage{};
  bool temperature = false;
  bool list = false;
  bool status = false;
  bool motors_off = false;
  bool no_check = false;
  Arming arming{};
};

const Calibration& calibration_named(const std::string& name) {
  std::vector<std::string> names;
  for (const Calibration& one : calibrations()) {
    if (detail::is_same_word(name, one.name)) return one;
    names.emplace_back(one.name);
  }
  const auto near = detail::nearest(detail::lower_case(name), names);
  throw CommandError(fmt::format("unknown calibration '{}'{}", clipped(name),
                                 detail::did_you_mean(near, "`sbgc calibrate --list` lists them")),
                     wrong_usage);
}

void list_calibrations() {
  constexpr std::size_t column = 20;
  for (const Calibration& one : calibrations()) {
    const std::string text = fmt::format("{} ({})", one.info().summary, one.info().command);
    fmt::print("{:{}}{}\n", one.name, column, wrapped(text, line_width(), column, column));
  }
}

/// A request with its values.
struct Chosen {
  const CalibrationForm* form{};
  AnyMessage request;
  Effects effects{};
  CalibrationOptions options{};
  CalibrationConditions conditions{};
};

/// Returns the assignments of the command line; those from options come last.
std::vector<Assignment> assignments_of(const CalibrateOptions& options) {
  std::vector<Assignment> result = parse_assignments(options.values);
  if (!options.imu.empty()) result.push_back({"imu_idx", options.imu});
  if (options.temperature) result.push_back({"action", "TEMPERATURE"});
  if (!options.voltage.empty()) result.push_back({"actual_voltage", options.voltage});
  return result;
}

/// True unless the request only manages stored calibrations.
bool measures(const AnyMessage& request, bool is_of_sensor) {
  bool does = true;
  request.with_leaf("action", [&](const Leaf& leaf) {
    const auto of_sensor = static_cast<msg::CalibAction>(leaf.integer);
    does =
        is_of_sensor
            ? of_sensor == msg::CalibAction::regular || of_sensor == msg::CalibAction::temperature
            : static_cast<msg::CoggingAction>(leaf.integer) == msg::CoggingAction::calibrate;
  });
  return does;
}

Chosen choose(const Calibration& calibration, const CalibrateOptions& options) {
  try {
    std::vector<Assignment> assignments = assignments_of(options);
    if (assignments.empty() && calibration.needs_values) {
      throw ValueError("say the values as FIELD=VALUE");
    }
    std::vector<const MessageType*> types;
    std::vector<std::string> names;
    for (const CalibrationForm& form : calibration.forms) {
      types.push_back(find_message(form.info->name));
    }
    names.reserve(assignments.size());
    for (const Assignment& one : assignments) names.emplace_back(one.name);
    const MessageType& type = form_with(types, names);
    Chosen result{.request = new_message(type)};
    result.form = &*std::ranges::find(calibration.forms, type.info, &CalibrationForm::info);
    const bool says_action = std::ranges::find(names, "action") != names.end();
    if (result.form->has_action && !says_action) assignments.push_back({"action", "REGULAR"});
    // Actions other than calibrating have different effects, which those of the whole form include.
    result.effects = says_action && !options.temperature ? result.form->info->effects
                                                         : calibration.info().effects;
    assign(result.request, assignments);
    if (measures(result.request, result.form->has_action)) {
      result.conditions = calibration.conditions;
    }
    const std::string problems = violations_of(result.request, newest);
    if (!problems.empty()) throw ValueError(problems);
    result.request.with_leaf("imu_idx", [&](const Leaf& leaf) {
      result.options.imu = static_cast<msg::CalibImu>(leaf.integer);
    });
    return result;
  } catch (const std::runtime_error& error) {
    std::string problem = clipped(error.what());
    if (problem.find("`sbgc describe ") == std::string::npos) {
      problem += fmt::format("; `sbgc describe {}` shows the fields", calibration.info().command);
    }
    throw CommandError(problem, wrong_usage);
  }
}

/// Returns the information for the user before the calibration begins.
std::string sentences(const Chosen& chosen) {
  const MessageInfo& info = *chosen.form->info;
  std::string text = fmt::format("{} {}", info.summary, effect_text(chosen.effects));
  if (*info.preparation != '\0') text += fmt::format("\nBefore: {}", info.preparation);
  return text;
}

std::string progress_text(const CalibrationProgress& progress) {
  const double seconds = std::chrono::duration<double>(progress.elapsed).count();
  if (!progress.state) return fmt::format("calibrating for {:.0f} s", seconds);
  return fmt::format("calibrating for {:.0f} s: {:.0f} %", seconds,
                     progress.state->progress.percent());
}

/// Returns the conditions for the calibration.
ReadinessAtTerminal::Options readiness_of(const CalibrateOptions& command, const Chosen& chosen) {
  ReadinessAtTerminal::Options options{
      .conditions = chosen.conditions,
      .of_frame = chosen.options.imu == msg::CalibImu::frame,
      .can_ask = !command.arming.yes && is_terminal(stdin) && is_terminal(stderr),
      .motors_off = command.motors_off,
      .checks = !command.no_check};
  chosen.request.with_leaf("actual_voltage", [&](const Leaf& leaf) {
    options.voltage = msg::Voltage(static_cast<msg::Voltage::raw_type>(leaf.integer)).volts();
  });
  return options;
}

/// Reports the calibrated positions of the accelerometer. Returns true if the user wants to
/// calibrate another one.
bool wants_next_position(Client& client, const Chosen& chosen, const CalibrateOptions& command) {
  const bool is_of_acc =
      chosen.form->info->id == static_cast<std::uint8_t>(msg::CalibAcc::command) ||
      chosen.form->info->id == static_cast<std::uint8_t>(msg::CalibAccExt::command);
  if (!is_of_acc || !is_supported<msg::CalibInfoRequest>(client.identity().versions()))
    return false;
  msg::CalibInfoRequest request;
  request.imu_type =
      chosen.options.imu == msg::CalibImu::frame ? msg::SelectedImu::frame : msg::SelectedImu::main;
  const Result<msg::CalibInfo> state = client.call(request);
  if (!state) return false;  // the calibration is done, whatever it says
  const std::string missing = missing_positions(*state);
  remark("Calibrated positions: {}{}.\n", calibrated_positions(*state),
         missing.empty() ? "" : "; not " + missing);
  if (missing.empty() || command.arming.yes || !is_terminal(stdin) || !is_terminal(stderr)) {
    return false;
  }
  return agrees("Turn another of these sides upwards. Calibrate it as well? [y/N] ");
}

void run_once(Client& client, Chosen& chosen) {
  const Interruption interruption;
  ProgressBar bar;
  chosen.options.progress = [&](const CalibrationProgress& progress) {
    bar.show(progress_text(progress));
    return !was_interrupted();
  };
  const auto ended = client.run_calibration(chosen.request, chosen.options);
  bar.clear();
  if (was_interrupted() && !ended) {
    throw CommandError(
        "interrupted; no command stops a calibration: the board goes on, so leave the camera as it "
        "is until it is done",
        interrupted);
  }
  switch (value_of(ended)) {
    case CalibrationEnd::finished: remark("The calibration is done.\n"); break;
    case CalibrationEnd::accepted:
      remark("The board has accepted the calibration; it does not report the end.\n");
      break;
  }
}

int calibrate(const CalibrateOptions& command, const CommandContext& context) {
  if (command.list) {
    list_calibrations();
    return success;
  }
  if (command.status) {
    Client client = connect(context.gimbal);
    print_calibration_state(client);
    return success;
  }
  if (command.name.empty()) {
    throw CommandError("say what to calibrate; `sbgc calibrate --list` lists it", wrong_usage);
  }
  Chosen chosen = choose(calibration_named(command.name), command);
  Client client = connect(context.gimbal);
  require_possible(client, chosen.request);
  arm(command.arming, sentences(chosen));
  ReadinessAtTerminal readiness(client, readiness_of(command, chosen));
  do {
    readiness.require();
    run_once(client, chosen);
  } while (wants_next_position(client, chosen, command));
  return success;
}

}  // namespace

void add_calibrate(CLI::App& app, CommandContext& context) {
  const Subcommand<CalibrateOptions> command(app, context, "calibrate",
                                             "Calibrate sensors, encoders and motors");
  auto& options = command.options();
  command->add_option("what", options.name, "What to calibrate, such as gyro")
      ->type_name("CALIBRATION");
  command->add_option("values", options.values, "Fields of the request, as in `sbgc send`")
      ->type_name("FIELD=VALUE");
  command->add_flag("--list", options.list, "List what can be calibrated");
  command->add_flag("--status", options.status, "Show what is calibrated; change nothing");
  command->add_flag("--motors-off", options.motors_off,
                    "Turn the motors off first if necessary; the camera drops to its heavy side");
  command->add_flag("--no-check", options.no_check, "Skip the checks of the gimbal");
  command->add_option("--imu", options.imu, "For gyro, acc and mag: the sensor to calibrate")
      ->type_name("active|main|frame");
  command->add_flag("--temperature", options.temperature,
                    "For gyro and acc: over temperature, which takes up to an hour");
  command
      ->add_option("--voltage", options.voltage, "For battery: its measured voltage, such as 12.6V")
      ->type_name("VOLTAGE");
  command->footer(
      "It first says how to hold the camera, and checks what the board can tell: motors off, "
      "camera still, one side of the accelerometer up, a balanced camera, motors with power, a "
      "voltage near the measured one. It offers to turn the motors off. After `acc`, it says "
      "which of the six positions are done, and continues with another one. A calibration "
      "replaces the stored one. No command stops it: after Ctrl-C, or if the line is lost, the "
      "board continues.\n"
      "\n"
      "Examples:\n"
      "  sbgc calibrate --status\n"
      "  sbgc calibrate gyro --motors-off\n"
      "  sbgc calibrate acc --imu frame\n"
      "  sbgc calibrate battery --voltage 12.6V\n"
      "\n"
      "The exit status is 0 if the calibration is done, or accepted by a board that does not "
      "report the end; 1 if not; 2 for wrong usage; 3 if it was sent but not confirmed; 130 "
      "after Ctrl-C.");
  command.runs(calibrate);
}

}  // namespace sbgc::tools
