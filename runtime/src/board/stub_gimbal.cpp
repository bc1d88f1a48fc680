// Until the simulation is here.
#include <sbgc/board/gimbal.hpp>

namespace sbgc::board {
struct Gimbal::State {
  bool on{};
  std::array<AxisCommand, 3> commands{};
  Sample sample{};
};
Gimbal::Gimbal(const Options& options, Instant) : state_(std::make_unique<State>()) {
  state_->sample.battery = options.battery;
  state_->sample.up = state_->sample.frame_up = state_->sample.acceleration = {0, 0, 1};
  state_->sample.north = state_->sample.frame_north = {0, 1, 0};
  state_->sample.current = 0.1;
  state_->sample.temperature = state_->sample.frame_temperature = 25;
}
Gimbal::Gimbal(Gimbal&&) noexcept = default;
Gimbal& Gimbal::operator=(Gimbal&&) noexcept = default;
Gimbal::~Gimbal() = default;
void Gimbal::restart(Instant) {}
void Gimbal::tune(const Tuning&, Instant) {}
void Gimbal::set_motors(bool on, Instant) { state_->on = on; }
bool Gimbal::motors_on() const { return state_->on; }
bool Gimbal::stopped_by_battery() const { return false; }
void Gimbal::command(std::size_t axis, const AxisCommand& command, Instant) {
  state_->commands[axis] = command;
  state_->sample.angles[axis] = state_->sample.targets[axis] = command.angle;
}
const AxisCommand& Gimbal::command(std::size_t axis) const { return state_->commands[axis]; }
void Gimbal::set_remote(std::size_t, std::optional<double>, Instant) {}
void Gimbal::help(const Vector&, Instant) {}
void Gimbal::correct(const Attitude&, Instant) {}
void Gimbal::correct_gyro(bool, const Vector&, double, Instant) {}
void Gimbal::gyro_calibrated(bool, Instant) {}
void Gimbal::push(std::size_t, double, Instant) {}
void Gimbal::jam(std::size_t, bool, Instant) {}
void Gimbal::set_battery(double volts, Instant) { state_->sample.battery = volts; }
void Gimbal::place(const Axes<double>& angles, Instant) {
  state_->sample.angles = state_->sample.targets = angles;
}
Sample Gimbal::sample(Instant) { return state_->sample; }
}  // namespace sbgc::board
