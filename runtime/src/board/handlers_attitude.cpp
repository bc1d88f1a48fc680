// CMD_AHRS_HELPER: attitudes as vectors.

#include <cmath>
#include <optional>

#include "attitude.hpp"
#include "handlers.hpp"
#include "live_data.hpp"
#include "machine.hpp"

namespace sbgc::board {
namespace {

/// Nothing if its length is not near 1.
std::optional<Vector> direction(const Xyz<float>& from) {
  const Vector vector{static_cast<double>(from.x), static_cast<double>(from.y),
                      static_cast<double>(from.z)};
  // Ours: a unit vector may be off by rounding and by the noise of a sensor.
  constexpr double tolerance = 0.1;
  if (!(std::abs(std::sqrt(dot(vector, vector)) - 1) <= tolerance)) return {};
  return unit(vector);
}

Outcome tell(Turn& turn, AhrsHelperMode mode) {
  const bool of_frame = mode.has(AhrsHelperModeBit::frame_imu);
  if (of_frame && !knows_frame(turn.machine, turn.now)) return turn.refuse(Refusal::no_device);
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
  attitude.translates = mode.has(Bit::translate) && knows_joints(turn.machine);
  if (!mode.has(Bit::h1_only)) {
    attitude.up = direction(request.z1_vector);
    if (!attitude.up) return turn.refuse(Refusal::bad_parameter, mode.raw());
  }
  if (!mode.has(Bit::z1_only)) {
    attitude.north = direction(request.h1_vector);
    if (!attitude.north) return turn.refuse(Refusal::bad_parameter, mode.raw());
  }
  turn.machine.gimbal.correct(attitude, turn.now);
  return turn.confirm();
}

}  // namespace sbgc::board
