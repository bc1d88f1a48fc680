#include "physics/battery.hpp"

#include <algorithm>

#include "physics/limits.hpp"

namespace sbgc::emulator {

namespace {

constexpr double resistance = 0.05;  // ohms, including the wires

}  // namespace

Battery::Battery(double full, double capacity)
    : full_(within(full, 0, 1000)), capacity_(within(capacity, 0, 1e6)) {}

void Battery::draw(double current, double seconds) {
  if (capacity_ > 0) drawn_ = std::min(capacity_, drawn_ + current * seconds / 3600);
}

double Battery::voltage(double current) const {
  if (set_) return *set_;
  const double charge = capacity_ > 0 ? 1 - drawn_ / capacity_ : 1;
  // Like lithium cells: a slow decrease, and a steep one at the end.
  double open = full_ * (0.84 + 0.16 * charge);
  if (charge < 0.1) open -= full_ * 0.14 * (1 - charge / 0.1);
  return std::max(0.0, open - resistance * current);
}

void Battery::set(double volts) { set_ = within(volts, 0, 1000); }

}  // namespace sbgc::emulator
