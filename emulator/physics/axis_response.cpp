#include "physics/axis_response.hpp"

#include <cmath>
#include <numbers>
#include <utility>

namespace sbgc::emulator {

AxisResponse::AxisResponse(msg::BodeSystem system) : system_(system) {
  // The poles of the damped oscillation, a turn in the complex plane for each sample.
  const double turn = 2 * std::numbers::pi * resonance * sample_time;
  const double radius = std::exp(-damping * turn);
  first_ = 2 * radius * std::cos(turn * std::sqrt(1 - damping * damping));
  second_ = -radius * radius;
  // NOLINTNEXTLINE(cppcoreguidelines-prefer-member-initializer): from the other two
  scale_ = gain * (1 - first_ - second_);
}

double AxisResponse::operator()(double input) {
  // The delay comes first, so a closed loop needs only earlier inputs.
  const double output = first_ * output_ + second_ * earlier_output_ + scale_ * input_;
  earlier_output_ = std::exchange(output_, output);
  switch (system_) {
    case msg::BodeSystem::controller: return controller * input;
    case msg::BodeSystem::open_loop_plant:
    case msg::BodeSystem::open_loop_plant_with_filters: input_ = input; break;
    case msg::BodeSystem::closed_loop_plant:
    case msg::BodeSystem::closed_loop_plant_with_filters:
      input_ = input - controller * output;
      break;
    case msg::BodeSystem::open_loop_controller_and_plant: input_ = controller * input; break;
    case msg::BodeSystem::closed_loop_controller_and_plant:
    case msg::BodeSystem::overall: input_ = controller * (input - output); break;
    default: break;
  }
  return output;
}

}  // namespace sbgc::emulator
