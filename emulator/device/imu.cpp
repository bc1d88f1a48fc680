// CMD_AHRS_HELPER: attitudes as vectors.

#include <cmath>
#include <optional>

#include <sbgc/meta/enums.hpp>

#include "device/handlers.hpp"
#include "device/parts/live_data.hpp"
#include "device/device.hpp"
#include "physics/attitude.hpp"

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

template <class Mode>
Outcome tell(Turn& turn, Mode mode) {
  const bool of_frame = mode.has(Mode::flag_type::frame_imu);
  if (of_frame && !knows_frame(turn.machine, turn.now))
    return turn.refuse(msg::BoardErrorCode::not_supported);
  msg::AhrsHelper answer;
  measure(turn.machine, of_frame, turn.now, answer);
  return turn.answer(answer);
}

/// Without vectors there is nothing to set.
template <class Request>
Outcome tell_only(Turn& turn, const Request& request) {
  using Bit = typename decltype(request.mode)::flag_type;
  if (request.mode.has(Bit::set)) {
    return turn.refuse(msg::BoardErrorCode::wrong_params, request.mode.raw());
  }
  return tell(turn, request.mode);
}

/// The bits of a mode that the simulation understands: those of the earlier form.
constexpr unsigned known_bits = [] {
  unsigned bits = 0;
  for (const ValueInfo& value : EnumMeta<msg::AhrsHelperModeBit>::info.values) {
    bits |= static_cast<unsigned>(value.value);
  }
  return bits;
}();

template <class Request>
Outcome tell_or_set(Turn& turn, const Request& request) {
  const auto mode = request.mode;
  using Bit = typename decltype(request.mode)::flag_type;
  if (!mode.has(Bit::set)) return tell(turn, mode);
  if ((mode.raw() & ~known_bits) != 0) {
    return turn.refuse(msg::BoardErrorCode::not_supported, mode.raw());
  }
  if (mode.has(Bit::z1_only) && mode.has(Bit::h1_only)) {
    return turn.refuse(msg::BoardErrorCode::wrong_params, mode.raw());
  }
  Gimbal::Attitude attitude;
  attitude.of_frame = mode.has(Bit::frame_imu);
  attitude.reference_only = mode.has(Bit::reference_only);
  attitude.translates = mode.has(Bit::translate) && knows_joints(turn.machine);
  if (!mode.has(Bit::h1_only)) {
    attitude.up = direction(request.z1_vector);
    if (!attitude.up) return turn.refuse(msg::BoardErrorCode::wrong_params, mode.raw());
  }
  if (!mode.has(Bit::z1_only)) {
    attitude.north = direction(request.h1_vector);
    if (!attitude.north) return turn.refuse(msg::BoardErrorCode::wrong_params, mode.raw());
  }
  turn.machine.gimbal.correct(attitude, turn.now);
  return turn.confirm();
}

}  // namespace

Outcome handle(Turn& turn, const msg::AhrsHelperRequest& request) {
  return tell_only(turn, request);
}
Outcome handle(Turn& turn, const msg::AhrsHelperRequestWide& request) {
  return tell_only(turn, request);
}
Outcome handle(Turn& turn, const msg::AhrsHelperRequestExt& request) {
  return tell_or_set(turn, request);
}
Outcome handle(Turn& turn, const msg::AhrsHelperRequestExtWide& request) {
  return tell_or_set(turn, request);
}

}  // namespace sbgc::board
