// sbgc doctor: measures a gimbal for some seconds and reports problems.

#include <chrono>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>

#include <sbgc/doctor/findings.hpp>
#include <sbgc/doctor/measure.hpp>
#include <sbgc/json_dom.hpp>
#include <sbgc/meta/enums.hpp>
#include <sbgc/text.hpp>

#include "board/connection.hpp"
#include "board/progress_bar.hpp"
#include "command/interruption.hpp"
#include "command/option_values.hpp"
#include "command/remark.hpp"
#include "command/subcommand.hpp"
#include "command/terminal_text.hpp"
#include "command/wording.hpp"
#include "values/axis_values.hpp"

namespace sbgc::tools {

namespace {

using doctor::AxisVibration;
using doctor::Finding;
using doctor::Measurements;
using doctor::Sampling;
using doctor::Threshold;

struct DoctorOptions {
  std::optional<std::chrono::milliseconds> time{};
  std::string format = "text";
  bool thresholds = false;
};

/// The measurements, their findings, and their source.
struct Examination {
  std::string board{}, firmware{}, line{};
  Measurements measured{};
  std::optional<Axes<AxisVibration>> vibration{};
  std::vector<Finding> findings{};
};

const char* to_text(Sampling sampling) { return sampling == Sampling::stream ? "stream" : "polls"; }

/// Returns why there is no spectrum; "" if there is one.
std::string no_vibration_text(const Examination& examination) {
  if (examination.vibration) return "";
  const auto& gyro = examination.measured.gyro;
  if (!gyro || gyro->size() < 2) return "the gyroscope sent no samples";
  if (gyro->is_usable()) return "the samples are too few";
  return fmt::format("{:.1f} % of the samples were lost, more than {:.0f} %",
                     100 * gyro->lost_share(), 100 * analysis::most_lost);
}

Json threshold_json() {
  Json result = Json::object();
  for (const Threshold& one : doctor::thresholds()) {
    result[one.name] = {{"value", one.value}, {"unit", one.unit}, {"meaning", one.meaning}};
  }
  return result;
}

Json finding_json(const Finding& finding) {
  Json result{{"id", finding.id},
              {"sentence", finding.sentence},
              {"advice", finding.advice},
              {"command", finding.command}};
  if (finding.axis) result["axis"] = axis_names[*finding.axis];
  for (const Threshold& one : doctor::thresholds()) {
    if (finding.limit == one.limit) result["threshold"] = one.name;
  }
  return result;
}

Json number_or_null(const std::optional<double>& number) {
  return number ? Json(*number) : Json(nullptr);
}

Json axis_json(const Examination& examination, std::size_t axis) {
  const Measurements& measured = examination.measured;
  Json result{{"motor_power_percent", number_or_null(measured.power[axis].value())},
              {"balance_error_percent", number_or_null(measured.balance[axis].value())}};
  if (!examination.vibration) return result;
  const AxisVibration& vibration = (*examination.vibration)[axis];
  result["vibration_rms"] = vibration.rms;
  result["frequencies"] = Json::array();
  for (const analysis::Frequency& one : doctor::strongest(vibration.frequencies)) {
    result["frequencies"].push_back({{"hz", one.is_real ? Json(one.peak.frequency) : Json(nullptr)},
                                     {"seen_at_hz", one.peak.frequency},
                                     {"or_hz", one.others},
                                     {"deg_per_s", one.peak.amplitude},
                                     {"rms", doctor::rms_of(one.peak)}});
  }
  return result;
}

Json to_json(const Examination& examination) {
  const Measurements& measured = examination.measured;
  Json sampling{{"how", to_text(measured.sampling)}};
  if (measured.gyro) {
    sampling["rate_hz"] = measured.gyro->rate();
    sampling["samples"] = measured.gyro->size();
    sampling["lost_share"] = measured.gyro->lost_share();
    sampling["highest_hz"] = analysis::highest_share * measured.gyro->rate();
  }
  if (measured.again) sampling["second_rate_hz"] = measured.again->rate();
  if (!examination.vibration) sampling["problem"] = no_vibration_text(examination);
  Json state{{"motors_on", measured.has_motors_on},
             {"profile", measured.profile},
             {"battery_v", number_or_null(measured.lowest_battery)},
             {"cycle_us", number_or_null(measured.cycle.value())},
             {"gravity_error_deg", number_or_null(measured.gravity_error.value())},
             {"i2c_errors", measured.i2c.risen()},
             {"serial_errors", measured.serial.risen()},
             {"damaged_share", measured.damaged_share},
             {"unanswered", measured.unanswered},
             {"task", to_string(measured.task)}};
  if (measured.parameters) {
    state["follow_mode"] = to_string(measured.parameters->follow_mode);
    state["battery_alarm_v"] = measured.parameters->bat_threshold_alarm.volts();
    state["battery_stop_v"] = measured.parameters->bat_threshold_motors.volts();
  }
  if (measured.calibration) state["acc_positions"] = doctor::positions_of(*measured.calibration);
  Json axes = Json::object();
  for (std::size_t axis = 0; axis < axis_names.size(); ++axis) {
    axes[axis_names[axis]] = axis_json(examination, axis);
  }
  Json findings = Json::array();
  for (const Finding& finding : examination.findings) findings.push_back(finding_json(finding));
  return {{"format", "sbgc-doctor"},
          {"version", 1},
          {"board", examination.board},
          {"firmware", examination.firmware},
          {"line", examination.line},
          {"seconds", measured.seconds},
          {"sampling", sampling},
          {"state", state},
          {"axes", axes},
          {"findings", findings},
          {"thresholds", threshold_json()}};
}

constexpr std::size_t name_column = 13;

void print_row(const std::string& name, const std::string& text) {
  fmt::print("{:{}}{}\n", name, name_column,
             wrapped(printable(text), line_width(), name_column, name_column));
}

std::string sampling_text(const Examination& examination) {
  const Measurements& measured = examination.measured;
  std::string text = fmt::format("{:.1f} s, {}", measured.seconds,
                                 counted(measured.messages, "message of live data"));
  if (measured.messages != 1) {
    text = fmt::format("{:.1f} s, {} messages of live data", measured.seconds, measured.messages);
  }
  if (!measured.gyro) return text;
  const std::string again =
      measured.again ? fmt::format(" and then {:.0f}", measured.again->rate()) : "";
  text +=
      fmt::format("; the gyroscope {:.0f}{} times per second ({})", measured.gyro->rate(), again,
                  measured.sampling == Sampling::stream ? "a data stream" : "by requests");
  if (!examination.vibration) return text + "; no vibration: " + no_vibration_text(examination);
  return text + fmt::format(", {:.1f} % lost, which shows frequencies up to {:.0f} Hz",
                            100 * measured.gyro->lost_share(),
                            analysis::highest_share * measured.gyro->rate());
}

std::string state_text(const Measurements& measured) {
  std::string text =
      fmt::format("motors {}, profile {}", measured.has_motors_on ? "on" : "off", measured.profile);
  if (measured.parameters) {
    text += ", follow mode " + to_string(measured.parameters->follow_mode);
  }
  if (measured.task != msg::CalibMode{}) text += ", running " + to_string(measured.task);
  text += fmt::format(", cycle {:.0f} us", measured.cycle.value().value_or(0));
  return text;
}

std::string battery_text(const Measurements& measured) {
  std::string text = fmt::format("{:.2f} V", measured.lowest_battery.value_or(0));
  if (!measured.parameters) return text;
  const auto volts = [](auto threshold) {
    return threshold.raw() < 0 ? std::string("never") : fmt::format("{:.2f} V", threshold.volts());
  };
  return text + fmt::format("; alarm {}, motors stop {}",
                            volts(measured.parameters->bat_threshold_alarm),
                            volts(measured.parameters->bat_threshold_motors));
}

std::string cell(const std::optional<double>& value, int decimals) {
  return value ? fmt::format("{:.{}f}", *value, decimals) : "-";
}

void print_axes(const Examination& examination) {
  const Measurements& measured = examination.measured;
  const std::size_t cell_width = line_width() < 60 ? 7 : 9;
  const auto row = [&](const std::string& name, const auto& text_of) {
    fmt::print("{:<19}", name);
    for (std::size_t axis = 0; axis < axis_names.size(); ++axis) {
      fmt::print("{:>{}}", text_of(axis), cell_width);
    }
    fmt::print("\n");
  };
  fmt::print("\n");
  row("", [](std::size_t axis) { return std::string(axis_names[axis]); });
  row("motor power, %", [&](std::size_t axis) { return cell(measured.power[axis].value(), 0); });
  row("balance error, %",
      [&](std::size_t axis) { return cell(measured.balance[axis].value(), 1); });
  const auto of_vibration = [&](auto value) {
    return [&examination, value](std::size_t axis) -> std::string {
      if (!examination.vibration) return "-";
      return value((*examination.vibration)[axis]);
    };
  };
  row("vibration, deg/s",
      of_vibration([](const AxisVibration& one) { return fmt::format("{:.2f}", one.rms); }));
  bool has_alias = false;
  row("  strongest, Hz", of_vibration([&](const AxisVibration& one) {
        if (one.frequencies.empty()) return std::string("-");
        const analysis::Frequency& first = one.frequencies.front();
        has_alias = has_alias || !first.others.empty();
        return fmt::format("{:.1f}{}", first.peak.frequency, first.others.empty() ? "" : "?");
      }));
  row("  with, deg/s", of_vibration([](const AxisVibration& one) {
        return one.frequencies.empty()
                   ? std::string("-")
                   : fmt::format("{:.2f}", doctor::rms_of(one.frequencies.front().peak));
      }));
  if (has_alias) {
    fmt::print("{}\n", wrapped("? A higher frequency can look the same at this sample rate.",
                               line_width(), 0, 2));
  }
}

void print_findings(const std::vector<Finding>& findings) {
  const Colors colors(stdout);
  fmt::print("\n");
  if (findings.empty()) {
    fmt::print("{}\n", colors(Color::green, "Nothing is wrong."));
    return;
  }
  std::size_t number = 0;
  for (const Finding& finding : findings) {
    const std::string mark = fmt::format("{}. ", ++number);
    const std::size_t indent = mark.size();
    fmt::print(
        "{}{}\n", mark,
        colors(Color::bold, wrapped(printable(finding.sentence), line_width(), indent, indent)));
    fmt::print("{:{}}{}\n", "", indent, wrapped(finding.advice, line_width(), indent, indent));
    if (!finding.command.empty()) fmt::print("{:{}}{}\n", "", indent + 2, finding.command);
  }
}

void print_text(const Examination& examination) {
  const Measurements& measured = examination.measured;
  print_row("board", examination.board + ", firmware " + examination.firmware);
  print_row("line",
            fmt::format("{}; {:.2g} % of frames damaged, {} unanswered", examination.line,
                        100 * measured.damaged_share, counted(measured.unanswered, "request")));
  print_row("measured", sampling_text(examination));
  print_row("state", state_text(measured));
  print_row("battery", battery_text(measured));
  if (measured.calibration) {
    print_row("calibrated", fmt::format("accelerometer in {} of 6 positions",
                                        doctor::positions_of(*measured.calibration)));
  }
  print_axes(examination);
  if (!measured.has_motors_on) {
    fmt::print("\n{}\n", wrapped("The motors are off: power, balance and vibration say little.",
                                 line_width()));
  }
  print_findings(examination.findings);
}

void print_thresholds() {
  fmt::print("{}\n", wrapped("All thresholds are assumptions: no document says what is normal.",
                             line_width()));
  const bool is_narrow = line_width() < 60;
  const std::size_t column = is_narrow ? 2 : 34;
  for (const Threshold& one : doctor::thresholds()) {
    const std::string value = fmt::format("{} {}", one.value, one.unit);
    fmt::print("{:20}{:{}}{}{}\n", one.name, value, is_narrow ? 0 : 14, is_narrow ? "\n  " : "",
               wrapped(one.meaning, line_width(), column, column));
  }
}

/// Like tasks::measure(). A board without a real firmware version often answers nothing else, and
/// then the reason for that matters more than the message that got no answer. Throws CommandError.
Measurements measure_board(Client& client, std::chrono::milliseconds time) {
  const ProgressBar bar;
  auto measured =
      client.run(tasks::measure({.time = time, .progress = [&](double seconds) {
                                   bar.show(fmt::format("measuring for {:.0f} s", seconds));
                                   return !was_interrupted();
                                 }}));
  if (!measured) {
    ClientError error = measured.error();
    const BoardIdentity& board = client.identity();
    if (error.code == ErrorCode::cancelled) {
      error.message = "interrupted";
    } else if (!board.firmware_problem().empty()) {
      error.message += fmt::format("; the board reports firmware {}: {}", board.firmware_version(),
                                   board.firmware_problem());
    }
    fail(error);
  }
  measured->add(client.statistics().session);
  return *std::move(measured);
}

int examine(const DoctorOptions& options, const CommandContext& context) {
  if (options.thresholds) {
    print_thresholds();
    return success;
  }
  const std::chrono::milliseconds time = options.time.value_or(std::chrono::seconds(5));
  constexpr std::chrono::seconds shortest{1};
  constexpr std::chrono::minutes longest{10};
  if (time < shortest || time > longest) {
    throw CommandError("--for is from 1 s to 10 minutes", wrong_usage);
  }
  Client client = connect(context.gimbal);
  const Interruption interruption;
  Examination examination{client.identity().board_version(),
                          client.identity().firmware_version(),
                          client.description(),
                          measure_board(client, time),
                          {},
                          {}};
  if (was_interrupted()) throw CommandError("interrupted", interrupted);
  examination.vibration = examination.measured.vibration();
  examination.findings = doctor::findings_of(examination.measured);
  if (options.format == "json") {
    fmt::print("{}\n", detail::json_text(to_json(examination), 2));
  } else {
    print_text(examination);
  }
  return examination.findings.empty() ? success : failure;
}

}  // namespace

void add_doctor(CLI::App& app, CommandContext& context) {
  const Subcommand<DoctorOptions> command(app, context, "doctor",
                                          "Measure for some seconds, and report what is wrong");
  auto& options = command.options();
  add_duration(*command, "--for", options.time, "Measure for this time; 5 s without it");
  command->add_flag("--thresholds", options.thresholds, "List the limits of all measurements");
  add_format(*command, options.format);
  command->footer(
      "It moves and changes nothing. Leave the camera as you use it, with its motors on, and do "
      "not touch it. Vibration is the root mean square of the gyroscope, from 1 Hz to 45 % of "
      "the sample rate. It samples with a data stream, or with requests if the firmware has no "
      "streams or another host uses them. A higher frequency looks like a lower one, its alias, "
      "so it samples at two rates and names the frequencies that remain possible. It "
      "interpolates up to 1 % of lost samples; if more are lost, there is no spectrum.\n"
      "\n"
      "Examples:\n"
      "  sbgc doctor\n"
      "  sbgc doctor --for 20s --format json\n"
      "  sbgc doctor --thresholds\n"
      "\n"
      "The exit status is 0 if nothing is wrong, 1 if something is or the gimbal does not "
      "answer, 2 for wrong usage, 130 after Ctrl-C.");
  command.runs(examine);
}

}  // namespace sbgc::tools
