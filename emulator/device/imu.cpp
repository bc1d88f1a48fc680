// CMD_AHRS_HELPER: attitudes as vectors.

#include <cmath>
#include <optional>

#include <sbgc/meta/enums.hpp>

#include "device/device.hpp"
#include "device/handlers.hpp"
#include "device/parts/live_data.hpp"
#include "physics/attitude.hpp"

namespace sbgc::emulator {
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
Outcome tell(RequestContext& context, Mode mode) {
  const bool of_frame = mode.has(Mode::flag_type::frame_imu);
  if (of_frame && !knows_frame(context.device, context.now))
    return context.refuse(msg::BoardErrorCode::not_supported);
  msg::AhrsHelper answer;
  measure(context.device, of_frame, context.now, answer);
  return context.answer(answer);
}

/// Without vectors there is nothing to set.
template <class Request>
Outcome tell_only(RequestContext& context, const Request& request) {
  using Bit = typename decltype(request.mode)::flag_type;
  if (request.mode.has(Bit::set)) {
    return context.refuse(msg::BoardErrorCode::wrong_params, request.mode.raw());
  }
  return tell(context, request.mode);
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
Outcome tell_or_set(RequestContext& context, const Request& request) {
  const auto mode = request.mode;
  using Bit = typename decltype(request.mode)::flag_type;
  if (!mode.has(Bit::set)) return tell(context, mode);
  if ((mode.raw() & ~known_bits) != 0) {
    return context.refuse(msg::BoardErrorCode::not_supported, mode.raw());
  }
  if (mode.has(Bit::z1_only) && mode.has(Bit::h1_only)) {
    return context.refuse(msg::BoardErrorCode::wrong_params, mode.raw());
  }
  Gimbal::Attitude attitude;
  attitude.of_frame = mode.has(Bit::frame_imu);
  attitude.reference_only = mode.has(Bit::reference_only);
  attitude.translates = mode.has(Bit::translate) && knows_joints(context.device);
  if (!mode.has(Bit::h1_only)) {
    attitude.up = direction(request.z1_vector);
    if (!attitude.up) return context.refuse(msg::BoardErrorCode::wrong_params, mode.raw());
  }
  if (!mode.has(Bit::z1_only)) {
    attitude.north = direction(request.h1_vector);
    if (!attitude.north) return context.refuse(msg::BoardErrorCode::wrong_params, mode.raw());
  }
  context.device.gimbal.correct(attitude, context.now);
  return context.confirm();
}

}  // namespace

Outcome handle(RequestContext& context, const msg::AhrsHelperRequest& request) {
  return tell_only(context, request);
}
Outcome handle(RequestContext& context, const msg::AhrsHelperRequestWide& request) {
  return tell_only(context, request);
}
Outcome handle(RequestContext& context, const msg::AhrsHelperRequestExt& request) {
  return tell_or_set(context, request);
}
Outcome handle(RequestContext& context, const msg::AhrsHelperRequestExtWide& request) {
  return tell_or_set(context, request);
}

}  // namespace sbgc::emulator
