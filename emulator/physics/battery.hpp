/// The battery of the board and its motors.
#pragma once

#include <optional>

namespace sbgc::emulator {

/// The voltage falls with the charge that has been taken and with the current.
class Battery {
 public:
  /// Volts when full; ampere hours, 0: it never gets empty.
  Battery(double full, double capacity);

  /// Draws a current for some time.
  void draw(double current, double seconds);
  /// The voltage while that current flows.
  double voltage(double current) const;
  /// Fixes the voltage, whatever is drawn.
  void set(double volts);

 private:
  double full_;
  double capacity_;
  double drawn_ = 0;  ///< ampere hours
  std::optional<double> set_{};
};

}  // namespace sbgc::emulator
