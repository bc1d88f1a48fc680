// spec/external_motors.yaml: motors that are not axes of the camera.

#include "device/handlers.hpp"

#include "device/external_motors/external_motors.hpp"

namespace sbgc::emulator {
namespace {

bool names(std::uint8_t motors, std::size_t motor) { return ((motors >> motor) & 1U) != 0; }

/// Returns the setpoint of the `index`-th selected motor, from the list in the request.
ExternalMotors::Setpoint setpoint_of(const msg::ExtMotorsControl& request, std::size_t index) {
  if (request.setpoint16) return {.value = (*request.setpoint16)[index], .wraps = true};
  if (request.setpoint32) return {.value = (*request.setpoint32)[index]};
  if (request.setpoint16_param16) {
    const auto& one = (*request.setpoint16_param16)[index];
    return {one.setpoint, true, one.param1, true};
  }
  if (request.setpoint16_param32) {
    const auto& one = (*request.setpoint16_param32)[index];
    return {one.setpoint, true, one.param1, true};
  }
  if (request.setpoint32_param16) {
    const auto& one = (*request.setpoint32_param16)[index];
    return {one.setpoint, false, one.param1, true};
  }
  if (!request.setpoint32_param32) return {};
  const auto& one = (*request.setpoint32_param32)[index];
  return {one.setpoint, false, one.param1, true};
}

}  // namespace

Reaction handle(RequestContext& context, const msg::ExtMotorsAction& request,
                ExternalMotors& external_motors) {
  for (std::size_t motor = 0; motor < ExternalMotors::count; ++motor) {
    if (!names(request.for_motors.raw(), motor)) continue;
    if (!external_motors.act(motor, request.action, context.now)) {
      return context.refuse(msg::BoardErrorCode::wrong_params,
                            static_cast<std::uint32_t>(request.action));
    }
  }
  return context.confirm();
}

Reaction handle(RequestContext& context, const msg::ExtMotorsControl& request,
                ExternalMotors& external_motors) {
  std::size_t index = 0;
  for (std::size_t motor = 0; motor < ExternalMotors::count; ++motor) {
    if (!names(request.for_motors.raw(), motor)) continue;
    external_motors.control(motor, setpoint_of(request, index++), context.now);
  }
  return context.confirm();
}

Reaction handle(RequestContext& context, const msg::ExtMotorsControlConfig& request,
                ExternalMotors& external_motors) {
  for (std::size_t motor = 0; motor < ExternalMotors::count; ++motor) {
    if (!names(request.for_motors.raw(), motor)) continue;
    if (!external_motors.configure(motor, request, context.now)) {
      return context.refuse(msg::BoardErrorCode::wrong_params);
    }
  }
  return context.confirm();
}

/// Answers once for each motor.
Reaction handle(RequestContext& context, const msg::ExtMotorsStateRequest& request,
                ExternalMotors& external_motors, Gimbal& gimbal) {
  for (std::size_t motor = 0; motor < ExternalMotors::count; ++motor) {
    if (!names(request.for_motors.raw(), motor)) continue;
    static_cast<void>(
        context.answer(external_motors.state(gimbal, motor, request.data_set, context.now)));
  }
  return Reaction::executed;
}

}  // namespace sbgc::emulator
