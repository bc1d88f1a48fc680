#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include <sbgc/availability.hpp>
#include <sbgc/client/sensor_motion.hpp>
#include <sbgc/messages/realtime.hpp>

namespace sbgc {

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
Task<Result<void>> for_a_second(std::function<Task<Result<void>>()> take) {
  constexpr Duration pause = milliseconds(50);
  const TaskMachine& task = co_await tasks::this_task();
  for (int i = 0; i < samples_of_motion; ++i) {
    if (i != 0) {
      const Result<void> waited = co_await tasks::wait_until(task.now() + pause);
      if (!waited) co_return waited;
    }
    if (auto taken = co_await take(); !taken) co_return taken;
  }
  co_return Result<void>();
}

/// The mean of the acceleration, and the variation of the rates.
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

Task<Result<SensorMotion>> motion_of_camera() {
  MotionSum sum;
  const std::function<Task<Result<void>>()> take = [&]() -> Task<Result<void>> {
    const auto data = co_await tasks::call(msg::RealtimeData3Request{});
    if (!data) co_return data.error();
    Axes<double> rate{};
    Axes<double> up{};
    for (std::size_t axis = 0; axis < rate.size(); ++axis) {
      rate[axis] = data->axes[axis].gyro_data.degrees_per_second();
      up[axis] = data->axes[axis].acc_data.real();
    }
    sum.add(rate);
    sum.add_up(up);
    co_return Result<void>();
  };
  if (const auto taken = co_await for_a_second(take); !taken) co_return taken.error();
  co_return sum.motion();
}

/// For firmware that sends the sensors of the frame.
Task<Result<SensorMotion>> motion_of_frame() {
  using Flag = msg::RealtimeDataCustom2Flag;
  MotionSum sum;
  bool is_known = false;
  const std::function<Task<Result<void>>()> take = [&]() -> Task<Result<void>> {
    msg::RealtimeDataCustom2Request request;
    request.flags = Flag::frame_gyro | Flag::frame_acc;
    const auto data = co_await tasks::call(request);
    if (!data) co_return data.error();
    if (!data->frame_gyro || !data->frame_acc) co_return Result<void>();
    const auto& acc = *data->frame_acc;
    const Axes<double> up{acc.roll.real(), acc.pitch.real(), acc.yaw.real()};
    is_known = is_known || length_of(up) > 0;
    sum.add(in_degrees_per_second(*data->frame_gyro));
    sum.add_up(up);
    co_return Result<void>();
  };
  if (const auto taken = co_await for_a_second(take); !taken) co_return taken.error();
  if (!is_known) co_return SensorMotion{.is_known = false};
  co_return sum.motion();
}

/// For older firmware, which sends only the angles of the frame: their changes are rates.
Task<Result<SensorMotion>> motion_of_frame_angles() {
  // A rate between neighbors would mostly be the rounding of the angles.
  constexpr std::size_t apart = 5;
  const TaskMachine& task = co_await tasks::this_task();
  std::vector<Axes<double>> angles;
  std::vector<Instant> times;
  bool is_known = false;
  const std::function<Task<Result<void>>()> take = [&]() -> Task<Result<void>> {
    const auto data = co_await tasks::call(msg::RealtimeData3Request{});
    if (!data) co_return data.error();
    times.push_back(task.now());
    const auto& frame = data->frame_imu_angle;
    angles.push_back({frame.roll.degrees(), frame.pitch.degrees(), frame.yaw.degrees()});
    is_known = is_known || length_of(angles.back()) > 0;
    co_return Result<void>();
  };
  if (const auto taken = co_await for_a_second(take); !taken) co_return taken.error();
  if (!is_known) co_return SensorMotion{.is_known = false};
  MotionSum sum;
  for (std::size_t i = apart; i < angles.size(); ++i) {
    const double seconds = 1e-6 * static_cast<double>((times[i] - times[i - apart]).us);
    Axes<double> rate{};
    for (std::size_t axis = 0; axis < rate.size(); ++axis) {
      rate[axis] = std::remainder(angles[i][axis] - angles[i - apart][axis], 360) / seconds;
    }
    sum.add(rate);
  }
  co_return sum.motion();
}

}  // namespace

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

namespace tasks {

Task<Result<SensorMotion>> watch_sensor(bool of_frame) {
  const Availability versions = (co_await this_task()).identity().versions();
  if (!of_frame) co_return co_await motion_of_camera();
  const bool has_sensors = is_supported<msg::RealtimeDataCustom2Request>(versions);
  if (has_sensors) co_return co_await motion_of_frame();
  co_return co_await motion_of_frame_angles();
}

}  // namespace tasks
}  // namespace sbgc
