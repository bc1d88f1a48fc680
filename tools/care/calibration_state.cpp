#include "care/calibration_state.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <string_view>
#include <thread>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <sbgc/availability.hpp>
#include <sbgc/messages/realtime.hpp>
#include <sbgc/meta/enums.hpp>

#include "board/connection.hpp"
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

msg::RealtimeData3 live_data(Client& client) {
  return value_of(Result<msg::RealtimeData3>(client.call(msg::RealtimeData3Request{})));
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
  const msg::RealtimeData3 data = live_data(client);
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
  print_line("motion", fmt::format("{:.2f} deg/s", motion_of(client)));
  if (!is_supported<msg::CalibInfoRequest>(client.identity().versions())) return;
  print_imu(client, msg::SelectedImu::main, "main IMU");
  print_imu(client, msg::SelectedImu::frame, "frame IMU");
}

double motion_of(Client& client) {
  constexpr int samples = 20;
  constexpr std::chrono::milliseconds pause{50};
  std::vector<Axes<double>> rates;
  Axes<double> mean{};
  for (int i = 0; i < samples; ++i) {
    if (i != 0) std::this_thread::sleep_for(pause);
    const msg::RealtimeData3 data = live_data(client);
    auto& rate = rates.emplace_back();
    for (std::size_t axis = 0; axis < rate.size(); ++axis) {
      rate[axis] = data.axes[axis].gyro_data.degrees_per_second();
      mean[axis] += rate[axis] / samples;
    }
  }
  double most = 0;
  for (const Axes<double>& rate : rates) {
    for (std::size_t axis = 0; axis < rate.size(); ++axis) {
      most = std::max(most, std::abs(rate[axis] - mean[axis]));
    }
  }
  return most;
}

}  // namespace sbgc::tools
