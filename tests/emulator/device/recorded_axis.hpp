/// A recording request, and the known frequency response of the emulated plant.
#pragma once

#include <cmath>
#include <complex>
#include <cstdint>
#include <numbers>

#include <sbgc/messages/calibration.hpp>

namespace sbgc::test {

inline msg::BodeTestStartStopRequest recording(std::uint32_t samples = 5000) {
  msg::BodeTestStartStopRequest request;
  request.axis = msg::BodeAxis::roll;
  request.stimulus_type = msg::BodeStimulus::white_noise;
  request.stimulus_gain = 3000;
  request.start_freq = msg::Frequency(6);
  request.end_freq = msg::Frequency(200);
  request.system = msg::BodeSystem::open_loop_plant;
  request.samples_num = samples;
  return request;
}

/// The response of the emulated plant: two poles at 40 Hz, damping 0.3, one sample of delay, 0.003
/// at rest.
inline std::complex<double> plant(double frequency) {
  const double turn = 2 * std::numbers::pi * 40 * 0.0008;
  const auto pole = std::exp(turn * std::complex<double>(-0.3, std::sqrt(1 - 0.09)));
  const auto z = std::polar(1.0, 2 * std::numbers::pi * frequency * 0.0008);
  return 0.003 * std::norm(1.0 - pole) * z / ((z - pole) * (z - std::conj(pole)));
}

}  // namespace sbgc::test
