#include "care/sensor_motion.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <numbers>
#include <thread>
#include <vector>

#include <fmt/format.h>

#include <sbgc/availability.hpp>
#include <sbgc/messages/realtime.hpp>

#include "board/connection.hpp"

namespace sbgc::tools {

namespace {

constexpr int samples_of_motion = 20;

template <class T>
Axes<double> in_degrees_per_second(const Axes<T>& rates) {
  return {rates.roll.degrees_per_second(), rates.pitch.degrees_per_second(),
          rates.yaw.degrees_per_second()};
}

double length_of(const Axes<double>& vector) {
  return std::hypot(vector.roll, vector.pitch, vector.yaw);
}

/// Calls `take` several times within a second.
template <class Take>
void for_a_second(const Take& take) {
  constexpr std::chrono::milliseconds pause{50};
  for (int i = 0; i < samples_of_motion; ++i) {
    if (i != 0) std::this_thread::sleep_for(pause);
    take();
  }
}

/// The mean of acceleration, and how the rates vary.
class MotionSum {
 public:
  void add(const Axes<double>& rate) { rates_.push_back(rate); }
  void add_up(const Axes<double>& acceleration) {
    for (std::size_t axis = 0; axis < up_.size(); ++axis) up_[axis] += acceleration[axis];
    ++ups_;
  }
  SensorMotion motion() const {
    SensorMotion result;
    Axes<double> mean{};
    const auto count = static_cast<double>(rates_.size());
    for (const Axes<double>& rate : rates_) {
      for (std::size_t axis = 0; axis < rate.size(); ++axis) mean[axis] += rate[axis] / count;
    }
    for (const Axes<double>& rate : rates_) {
      for (std::size_t axis = 0; axis < rate.size(); ++axis) {
        result.shaking = std::max(result.shaking, std::abs(rate[axis] - mean[axis]));
      }
    }
    result.turning = length_of(mean);
    if (ups_ == 0) return result;
    result.up = up_;
    for (std::size_t axis = 0; axis < up_.size(); ++axis) (*result.up)[axis] /= ups_;
    return result;
  }

 private:
  std::vector<Axes<double>> rates_{};
  Axes<double> up_{};
  int ups_ = 0;
};

SensorMotion motion_of_camera(Client& client) {
  MotionSum sum;
  for_a_second([&] {
    const auto data =
        value_of(Result<msg::RealtimeData3>(client.call(msg::RealtimeData3Request{})));
    Axes<double> rate{};
    Axes<double> up{};
    for (std::size_t axis = 0; axis < rate.size(); ++axis) {
      rate[axis] = data.axes[axis].gyro_data.degrees_per_second();
      up[axis] = data.axes[axis].acc_data.real();
    }
    sum.add(rate);
    sum.add_up(up);
  });
  return sum.motion();
}

/// Of firmware that sends the sensors of the frame.
SensorMotion motion_of_frame(Client& client) {
  using Flag = msg::RealtimeDataCustom2Flag;
  msg::RealtimeDataCustom2Request request;
  request.flags = Flag::frame_gyro | Flag::frame_acc;
  MotionSum sum;
  bool is_known = false;
  for_a_second([&] {
    const auto data = value_of(Result<msg::RealtimeDataCustom2>(client.call(request)));
    if (!data.frame_gyro || !data.frame_acc) return;
    const auto& acc = *data.frame_acc;
    const Axes<double> up{acc.roll.real(), acc.pitch.real(), acc.yaw.real()};
    is_known = is_known || length_of(up) > 0;
    sum.add(in_degrees_per_second(*data.frame_gyro));
    sum.add_up(up);
  });
  if (!is_known) return {.is_known = false};
  return sum.motion();
}

/// Of older firmware, which sends only its angles: their changes are rates.
SensorMotion motion_of_frame_angles(Client& client) {
  using Clock = std::chrono::steady_clock;
  // A rate of two neighbors would be mostly the rounding of the angles.
  constexpr std::size_t apart = 5;
  std::vector<Axes<double>> angles;
  std::vector<Clock::time_point> times;
  bool is_known = false;
  for_a_second([&] {
    const auto data =
        value_of(Result<msg::RealtimeData3>(client.call(msg::RealtimeData3Request{})));
    times.push_back(Clock::now());
    const auto& frame = data.frame_imu_angle;
    angles.push_back({frame.roll.degrees(), frame.pitch.degrees(), frame.yaw.degrees()});
    is_known = is_known || length_of(angles.back()) > 0;
  });
  if (!is_known) return {.is_known = false};
  MotionSum sum;
  for (std::size_t i = apart; i < angles.size(); ++i) {
    const double seconds = std::chrono::duration<double>(times[i] - times[i - apart]).count();
    Axes<double> rate{};
    for (std::size_t axis = 0; axis < rate.size(); ++axis) {
      rate[axis] = std::remainder(angles[i][axis] - angles[i - apart][axis], 360) / seconds;
    }
    sum.add(rate);
  }
  return sum.motion();
}

}  // namespace

SensorMotion motion_of(Client& client, bool of_frame) {
  if (!of_frame) return motion_of_camera(client);
  const bool has_sensors =
      is_supported<msg::RealtimeDataCustom2Request>(client.identity().versions());
  return has_sensors ? motion_of_frame(client) : motion_of_frame_angles(client);
}

std::string motion_text(const SensorMotion& motion) {
  return fmt::format("shakes by {:.2f} deg/s, turns by {:.2f} deg/s", motion.shaking,
                     motion.turning);
}

double angle_to_side(const Axes<double>& up) {
  const double largest =
      std::max({std::abs(up.roll), std::abs(up.pitch), std::abs(up.yaw)}) / length_of(up);
  return std::acos(std::min(largest, 1.0)) * 180 / std::numbers::pi;
}

std::size_t side_of(const Axes<double>& up) {
  std::size_t side = 0;
  for (std::size_t axis = 1; axis < up.size(); ++axis) {
    if (std::abs(up[axis]) > std::abs(up[side])) side = axis;
  }
  return up[side] < 0 ? side + up.size() : side;
}

}  // namespace sbgc::tools
