#include "care/calibration_state.hpp"

#include <array>
#include <cstdio>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include <sbgc/availability.hpp>
#include <sbgc/messages/realtime.hpp>
#include <sbgc/meta/enums.hpp>

#include "board/connection.hpp"
#include "care/sensor_motion.hpp"
#include "command/help_text.hpp"

namespace sbgc::tools {

namespace {

constexpr std::array directions{
    std::pair{msg::CalibratedLimit::plus_x, "+X"}, std::pair{msg::CalibratedLimit::minus_x, "-X"},
    std::pair{msg::CalibratedLimit::plus_y, "+Y"}, std::pair{msg::CalibratedLimit::minus_y, "-Y"},
    std::pair{msg::CalibratedLimit::plus_z, "+Z"}, std::pair{msg::CalibratedLimit::minus_z, "-Z"}};

std::string positions(const msg::CalibInfo& state, bool are_done) {
  std::string names;
  for (const auto& [limit, name] : directions) {
    if (state.acc_limits_info.has(limit) != are_done) continue;
    names += (names.empty() ? "" : ", ") + std::string(name);
  }
  return names;
}

void print_line(const char* name, const std::string& text) {
  constexpr std::size_t column = 15;
  fmt::print("{:{}}{}\n", name, column, wrapped(text, line_width(), column, column));
}

std::string temperature_text(bool is_on, msg::Temperature from, msg::Temperature to) {
  if (!is_on) return "not over temperature";
  return fmt::format("over temperature from {:.0f} to {:.0f} degC", from.real(), to.real());
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

std::string calibrated_positions(const msg::CalibInfo& state) {
  const std::string done = positions(state, true);
  return done.empty() ? "none" : done;
}

std::string missing_positions(const msg::CalibInfo& state) { return positions(state, false); }

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
  print_line("motion", motion_text(motion_of(client, false)));
  if (!is_supported<msg::CalibInfoRequest>(client.identity().versions())) return;
  print_imu(client, msg::SelectedImu::main, "main IMU");
  print_imu(client, msg::SelectedImu::frame, "frame IMU");
}

}  // namespace sbgc::tools
