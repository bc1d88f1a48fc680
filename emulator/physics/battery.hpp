/// What feeds the board and its motors.
#pragma once

#include <optional>

namespace sbgc::emulator {

/// The voltage falls with the charge that has been taken and with the current.
class Battery {
 public:
  /// Volts when full; ampere hours, 0: it never gets empty.
  Battery(double full, double capacity);

  /// So many amperes flow for so long.
  void draw(double current, double seconds);
  /// The voltage while so many amperes flow.
  double voltage(double current) const;
  /// Is this from now on, whatever is drawn.
  void set(double volts);

 private:
  double full_;
  double capacity_;
  double drawn_ = 0;  ///< ampere hours
  std::optional<double> set_{};
};

}  // namespace sbgc::emulator
