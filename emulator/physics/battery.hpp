/// The battery of the board and its motors.
#pragma once

#include <optional>

namespace sbgc::emulator {

/// The voltage decreases with the charge drawn and with the current.
class Battery {
 public:
  /// `full` is the full voltage; `capacity` is in ampere hours, 0 means that it never runs empty.
  Battery(double full, double capacity);

  /// Replaces both values; the charge drawn stays drawn.
  void change(double full, double capacity) {
    const double drawn = drawn_;
    *this = Battery(full, capacity);
    drawn_ = drawn;
  }
  /// Draws a current for some time.
  void draw(double current, double seconds);
  /// Returns the voltage at this current.
  double voltage(double current) const;
  /// Fixes the voltage, regardless of load.
  void set(double volts);

 private:
  double full_;
  double capacity_;
  double drawn_ = 0;  ///< ampere hours
  std::optional<double> set_{};
};

}  // namespace sbgc::emulator
