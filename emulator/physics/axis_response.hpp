/// The response of an axis to a stimulus: the system of which CMD_BODE_TEST_START_STOP records the
/// response.
#pragma once

#include <sbgc/enums.hpp>

namespace sbgc::emulator {

/// A camera on a motor that is not stiff, as a filter of samples of 0.8 ms: two poles at
/// `resonance`, and one sample of delay. A controller multiplies by a constant. Assumption: all of
/// this; a real board has a system of its own.
class AxisResponse {
 public:
  static constexpr double sample_time = 0.0008;  ///< seconds
  static constexpr double gain = 0.003;          ///< at 0 Hz
  static constexpr double resonance = 40;        ///< Hz, without damping
  static constexpr double damping = 0.3;
  static constexpr double controller = 100;

  explicit AxisResponse(msg::BodeSystem system);

  /// Returns the next output.
  double operator()(double input);

 private:
  msg::BodeSystem system_;
  double first_, second_;  ///< the coefficients of the last two outputs
  double scale_;           ///< of the last input
  double input_ = 0;       ///< of the plant, in the previous sample
  double output_ = 0, earlier_output_ = 0;
};

}  // namespace sbgc::emulator
