#include "care/calibration_state.hpp"

#include <cstdio>

#include <fmt/format.h>

#include <sbgc/availability.hpp>
#include <sbgc/client/calibration.hpp>
#include <sbgc/client/sensor_motion.hpp>
#include <sbgc/messages/realtime.hpp>
#include <sbgc/meta/enums.hpp>

#include "board/connection.hpp"
#include "command/help_text.hpp"

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

/// For example "shakes by 0.05 deg/s, turns by 0.01 deg/s".
std::string motion_text(const SensorMotion& motion) {
  return fmt::format("shakes by {:.2f} deg/s, turns by {:.2f} deg/s", motion.shaking,
                     motion.turning);
}

/// Prints a paragraph about one IMU. A board without a second one refuses its state.
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

}  // namespace

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

}  // namespace sbgc::tools
