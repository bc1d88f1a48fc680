// CMD_AHRS_HELPER: attitudes as vectors.

#include <cmath>
#include <optional>

#include "handlers.hpp"
#include "live_data.hpp"
#include "machine.hpp"

namespace sbgc::board {
namespace {

double dot(const Vector& a, const Vector& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

Vector cross(const Vector& a, const Vector& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// Nothing if it points nowhere.
std::optional<Vector> unit(const Xyz<float>& from) {
  const Vector vector{static_cast<double>(from.x), static_cast<double>(from.y),
                      static_cast<double>(from.z)};
  const double length = std::sqrt(dot(vector, vector));
  // Ours: a unit vector may be off by rounding and by the noise of a sensor.
  constexpr double tolerance = 0.1;
  if (!(std::abs(length - 1) <= tolerance)) return {};
  return Vector{vector.x / length, vector.y / length, vector.z / length};
}

/// Where a direction of the frame lies in coordinates of the camera, by the joints.
Vector to_camera(const Vector& of_frame, const Sample& sample) {
  const Vector frame_east = cross(sample.frame_north, sample.frame_up);
  const Vector east = cross(sample.north, sample.up);
  const double to_east = dot(of_frame, frame_east);
  const double to_north = dot(of_frame, sample.frame_north);
  const double to_up = dot(of_frame, sample.frame_up);
  Vector result;
  for (std::size_t i = 0; i < Vector::size(); ++i) {
    result[i] = to_east * east[i] + to_north * sample.north[i] + to_up * sample.up[i];
  }
  return result;
}

Outcome tell(Turn& turn, AhrsHelperMode mode) {
  const bool of_frame = mode.has(AhrsHelperModeBit::frame_imu);
  if (of_frame && !knows_frame(turn.machine)) return turn.refuse(Refusal::no_device);
  AhrsHelper answer;
  measure(turn.machine, of_frame, turn.now, answer);
  return turn.answer(answer);
}

}  // namespace

Outcome handle(Turn& turn, const AhrsHelperRequest& request) {
  // Without vectors there is nothing to set.
  if (request.mode.has(AhrsHelperModeBit::set)) {
    return turn.refuse(Refusal::bad_parameter, request.mode.raw());
  }
  return tell(turn, request.mode);
}

Outcome handle(Turn& turn, const AhrsHelperRequestExt& request) {
  using Bit = AhrsHelperModeBit;
  const AhrsHelperMode mode = request.mode;
  if (!mode.has(Bit::set)) return tell(turn, mode);
  if (mode.has(Bit::z1_only) && mode.has(Bit::h1_only)) {
    return turn.refuse(Refusal::bad_parameter, mode.raw());
  }
  Gimbal::Attitude attitude;
  attitude.of_frame = mode.has(Bit::frame_imu);
  attitude.reference_only = mode.has(Bit::reference_only);
  if (!mode.has(Bit::h1_only)) {
    attitude.up = unit(request.z1_vector);
    if (!attitude.up) return turn.refuse(Refusal::bad_parameter, mode.raw());
  }
  if (!mode.has(Bit::z1_only)) {
    attitude.north = unit(request.h1_vector);
    if (!attitude.north) return turn.refuse(Refusal::bad_parameter, mode.raw());
  }
  Machine& machine = turn.machine;
  // Before the estimates change: where the frame's vectors lie for the camera.
  const Sample sample = machine.gimbal.sample(turn.now);
  machine.gimbal.correct(attitude, turn.now);
  if (attitude.of_frame && mode.has(Bit::translate)) {
    Gimbal::Attitude camera{.reference_only = true};
    if (attitude.up) camera.up = to_camera(*attitude.up, sample);
    if (attitude.north) camera.north = to_camera(*attitude.north, sample);
    machine.gimbal.correct(camera, turn.now);
  }
  return turn.confirm();
}

}  // namespace sbgc::board
