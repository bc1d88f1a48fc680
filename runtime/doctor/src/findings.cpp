#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include <fmt/format.h>

#include <sbgc/doctor/findings.hpp>
#include <sbgc/doctor/frequency_text.hpp>
#include <sbgc/internal/words.hpp>
#include <sbgc/meta/enums.hpp>
#include <sbgc/roles.hpp>
#include <sbgc/text.hpp>

namespace sbgc::doctor {

namespace {

using sbgc::detail::axis_names;

constexpr std::array table{
    Threshold{Limit::power, "motor-power", 90, "%", "mean power of a motor"},
    Threshold{Limit::balance, "balance-error", 10, "%", "mean motor power that imbalance takes"},
    Threshold{Limit::vibration, "vibration", 0.5, "deg/s",
              "root mean square of the gyroscope from 1 Hz to 45 % of the sample rate"},
    Threshold{Limit::resonance, "resonance", 0.035, "deg/s", "root mean square of one frequency"},
    Threshold{Limit::contrast, "resonance-contrast", analysis::least_contrast, "",
              "power of that frequency relative to the median of all"},
    Threshold{Limit::cycle, "cycle-time", 1200, "us", "mean duration of a control cycle"},
    Threshold{Limit::i2c_errors, "i2c-errors", 0.5, "1/s", "errors of the I2C bus"},
    Threshold{Limit::serial_errors, "serial-errors", 0.5, "1/s",
              "errors of the serial line that the board counts"},
    Threshold{Limit::damaged, "damaged-frames", 0.1, "%", "damaged frames from the board"},
    Threshold{Limit::gravity_error, "gravity-error", 2.5, "deg",
              "mean angle between estimated and measured gravity"},
};

/// A remedy for an error that the board reports.
struct Advice {
  msg::SystemError error{};
  const char* text{};
  const char* command = "";
};
constexpr std::array advice_table{
    Advice{msg::SystemError::no_sensor,
           "Check the cable and the plug of the IMU, and its address if there are two."},
    Advice{msg::SystemError::protection,
           "Look for a short circuit of a motor, then turn the power off and on."},
    Advice{msg::SystemError::set_power, "Set the power of each motor; 0 gives no torque.",
           "sbgc params show power"},
    Advice{msg::SystemError::calib_poles, "Calibrate poles and directions of the motors.",
           "sbgc calibrate poles"},
    Advice{msg::SystemError::calib_acc, "Calibrate the accelerometer in all six positions.",
           "sbgc calibrate acc"},
    Advice{msg::SystemError::miss_steps,
           "The motor was too weak or was held: balance the camera, look for what blocks it, raise "
           "its power.",
           "sbgc params show power"},
    Advice{msg::SystemError::serial,
           "Check cable, baud rate and parity of every device on the serial ports.", "sbgc info"},
    Advice{msg::SystemError::gui_version,
           "Use a program that fits the firmware, or update the firmware.", "sbgc info"},
    Advice{msg::SystemError::system,
           "Restart the board; if the error returns, update the firmware.", "sbgc reset"},
    Advice{msg::SystemError::emergency_stop, "Remove its reason, then turn the motors on.",
           "sbgc motors on"},
};

constexpr Advice advice_for(msg::SystemError error) {
  for (const Advice& one : advice_table) {
    if (one.error == error) return one;
  }
  return {error, "Restart the board.", "sbgc reset"};
}

/// Collects findings.
class Judge {
 public:
  explicit Judge(const Measurements& measured) : measured_(measured) {}

  std::vector<Finding> judge() {
    judge_firmware();
    judge_line();  // first: damage can look like other faults
    judge_errors();
    judge_calibration();
    judge_battery();
    judge_controller();
    for (std::size_t axis = 0; axis < axis_names.size(); ++axis) judge_motor(axis);
    judge_vibration();
    return std::move(findings_);
  }

 private:
  double per_second(std::uint64_t count) const {
    return measured_.seconds > 0 ? static_cast<double>(count) / measured_.seconds : 0;
  }

  void judge_firmware() {
    if (measured_.firmware_problem.empty()) return;
    findings_.push_back({.id = "firmware",
                         .sentence = fmt::format("The board reports firmware {}: {}.",
                                                 measured_.firmware, measured_.firmware_problem),
                         .advice = "Check the cables of all IMUs, then turn the power off and on.",
                         .command = "sbgc info"});
  }

  void judge_calibration() {
    const int positions = measured_.calibration ? positions_of(*measured_.calibration) : 6;
    if (positions == 6 || measured_.errors.has(msg::SystemError::calib_acc)) return;
    findings_.push_back({.id = "calibration",
                         .sentence = fmt::format("The accelerometer is calibrated in {} of 6 "
                                                 "positions: the horizon can lean.",
                                                 positions),
                         .advice = "Calibrate it in all six positions.",
                         .command = "sbgc calibrate acc"});
  }

  void judge_errors() {
    for (const ValueInfo& error : EnumMeta<msg::SystemError>::info.values) {
      const auto flag = static_cast<msg::SystemError>(error.value);
      const bool is_of_battery =
          flag == msg::SystemError::low_bat1 || flag == msg::SystemError::low_bat2;
      if (!measured_.errors.has(flag) || is_of_battery) continue;
      std::string sentence = fmt::format("The board reports {}: {}", error.name, error.summary);
      if (flag == msg::SystemError::emergency_stop &&
          measured_.sub_error != msg::SystemSubError{}) {
        sentence += fmt::format(" The reason is {}.", to_string(measured_.sub_error));
      }
      const Advice advice = advice_for(flag);
      findings_.push_back({.id = error.name,
                           .sentence = sentence,
                           .advice = advice.text,
                           .command = advice.command});
    }
  }

  void judge_battery() {
    const double volts = measured_.lowest_battery.value_or(0);
    if (measured_.has_battery_meter && measured_.lowest_battery && volts <= 0) {
      findings_.push_back(
          {.id = "battery",
           .sentence = "The board measures no battery voltage.",
           .advice = "Connect the battery: USB alone turns no motor. If it is connected, calibrate "
                     "the sensor.",
           .command = "sbgc calibrate battery --voltage VOLTS"});
      return;
    }
    // The most severe one that applies. A negative threshold is unused.
    std::string limit;
    if (measured_.parameters && volts > 0) {
      const auto is_below = [&](msg::VoltageThreshold one) {
        return one.raw() >= 0 && volts < one.volts();
      };
      const auto& parameters = *measured_.parameters;
      if (is_below(parameters.bat_threshold_motors)) {
        limit = fmt::format(", below the threshold of {:.2f} V at which the motors stop",
                            parameters.bat_threshold_motors.volts());
      } else if (is_below(parameters.bat_threshold_alarm)) {
        limit = fmt::format(", below the alarm threshold of {:.2f} V",
                            parameters.bat_threshold_alarm.volts());
      }
    }
    const bool stops = measured_.errors.has(msg::SystemError::low_bat2);
    if (limit.empty() && !stops && !measured_.errors.has(msg::SystemError::low_bat1)) return;
    findings_.push_back(
        {.id = "battery",
         .sentence = fmt::format("The battery has {:.2f} V{}{}.", volts, limit,
                                 stops ? "; the board stops the motors" : ""),
         .advice = "Charge or replace it. If a meter shows another voltage, calibrate the sensor.",
         .command = "sbgc calibrate battery --voltage VOLTS"});
  }

  void judge_line() {
    const double serial = per_second(measured_.serial.risen());
    const double damaged = 100 * measured_.damaged_share;
    const bool has_damage = damaged > threshold(Limit::damaged);
    if (serial <= threshold(Limit::serial_errors) && !has_damage) return;
    findings_.push_back(
        {.id = "line",
         .sentence = fmt::format(
             "The line is noisy: the board counts {:.1f} errors per second, and {:.2g} % of its "
             "frames arrive damaged.",
             serial, damaged),
         .advice =
             "Use a shorter cable away from motors, connect the grounds, lower the baud rate. "
             "Do this first: damage can look like other faults.",
         .command = "sbgc info",
         .limit = has_damage ? Limit::damaged : Limit::serial_errors});
  }

  void judge_controller() {
    const double i2c = per_second(measured_.i2c.risen());
    if (i2c > threshold(Limit::i2c_errors)) {
      findings_.push_back(
          {.id = "i2c",
           .sentence = fmt::format("The I2C bus has {:.1f} errors per second.", i2c),
           .advice =
               "Keep the cable of the IMU short and away from motors; use a shielded one with "
               "filters at high power.",
           .limit = Limit::i2c_errors});
    }
    const double cycle = measured_.cycle.value().value_or(0);
    if (cycle > threshold(Limit::cycle)) {
      findings_.push_back(
          {.id = "cycle-time",
           .sentence = fmt::format("A control cycle takes {:.0f} us instead of {} us.", cycle,
                                   roles::stream_cycle_us),
           .advice = "Use fewer streams, scripts and devices on the board.",
           .limit = Limit::cycle});
    }
    const double gravity = measured_.gravity_error.value().value_or(0);
    if (gravity > threshold(Limit::gravity_error)) {
      findings_.push_back(
          {.id = "attitude",
           .sentence = fmt::format(
               "The board's attitude differs from gravity by {:.1f} deg: the horizon drifts.",
               gravity),
           .advice = "Calibrate the gyroscope while the camera is still, then the accelerometer.",
           .command = "sbgc calibrate gyro",
           .limit = Limit::gravity_error});
    }
  }

  void judge_motor(std::size_t axis) {
    const double power = measured_.power[axis].value().value_or(0);
    if (power > threshold(Limit::power)) {
      findings_.push_back(
          {.id = "motor-power",
           .axis = axis,
           .sentence =
               fmt::format("The {} motor runs at {:.0f} % of its power.", axis_names[axis], power),
           .advice =
               "Something holds the camera, such as a cable, or the power is set too high: the "
               "motor gets hot.",
           .command = "sbgc params show power",
           .limit = Limit::power});
    }
    const double balance = measured_.balance[axis].value().value_or(0);
    if (balance > threshold(Limit::balance)) {
      findings_.push_back(
          {.id = "balance",
           .axis = axis,
           .sentence = fmt::format("The {} axis is out of balance: {:.0f} % of the motor's power "
                                   "holds it.",
                                   axis_names[axis], balance),
           .advice = "Turn the motors off and shift the camera until it stays at every angle.",
           .command = "sbgc motors off",
           .limit = Limit::balance});
    }
  }

  void judge_vibration() {
    const auto vibration = measured_.vibration();
    if (!vibration) return;
    for (std::size_t axis = 0; axis < axis_names.size(); ++axis) {
      const AxisVibration& one = (*vibration)[axis];
      std::string frequencies;
      for (const analysis::Frequency& found : strongest(one.frequencies)) {
        const bool is_resonance = rms_of(found.peak) >= threshold(Limit::resonance) &&
                                  found.peak.contrast >= threshold(Limit::contrast);
        if (!is_resonance) continue;
        frequencies += fmt::format("{}{} with {:.2f} deg/s", frequencies.empty() ? "" : ", ",
                                   frequency_text(found), rms_of(found.peak));
      }
      const bool is_strong = one.rms > threshold(Limit::vibration);
      if (frequencies.empty() && !is_strong) continue;
      std::string sentence = fmt::format("The {} axis shakes", axis_names[axis]);
      sentence += frequencies.empty() ? " without one frequency" : " at " + frequencies;
      findings_.push_back(
          {.id = "vibration",
           .axis = axis,
           .sentence = fmt::format("{}; {:.2f} deg/s in all (RMS).", sentence, one.rms),
           .advice =
               "Fasten what is loose. If it ends when you turn the motors off, tune the axis, or "
               "lower its gains.",
           .command = fmt::format("sbgc tune {}", axis_names[axis]),
           .limit = is_strong ? Limit::vibration : Limit::resonance});
    }
  }

  const Measurements& measured_;
  std::vector<Finding> findings_{};
};

}  // namespace

std::span<const Threshold> thresholds() { return table; }

double threshold(Limit limit) {
  const auto is_of_limit = [&](const Threshold& one) { return one.limit == limit; };
  return std::find_if(table.begin(), table.end(), is_of_limit)->value;
}

std::vector<Finding> findings_of(const Measurements& measured) { return Judge(measured).judge(); }

std::string others_text(const analysis::Frequency& frequency) {
  constexpr std::size_t most = 4;
  const std::vector<double>& others = frequency.others;
  const std::size_t shown = std::min(others.size(), most);
  std::string text;
  for (std::size_t i = 0; i < shown; ++i) {
    const bool is_last = i + 1 == others.size();
    text += fmt::format("{}{:.1f}", i == 0 ? "" : is_last ? " or " : ", ", others[i]);
  }
  return text + (shown < others.size() ? " ... Hz" : " Hz");
}

std::string frequency_text(const analysis::Frequency& frequency) {
  std::string seen = fmt::format("{:.1f} Hz", frequency.peak.frequency);
  if (frequency.others.empty()) return seen;
  const std::string others = others_text(frequency);
  if (frequency.is_real) return fmt::format("{} (or an alias of {})", seen, others);
  return fmt::format("{} (an alias at {})", others, seen);
}

}  // namespace sbgc::doctor
