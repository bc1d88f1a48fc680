/// @file
/// Spectra of sampled signals by Welch's method: the average over segments that overlap by half,
/// have their mean removed, and are multiplied by a Hann window.
#pragma once

#include <complex>
#include <cstddef>
#include <span>
#include <vector>

namespace sbgc::analysis {

/// The largest power of two that exceeds neither `samples` nor `longest`; 0 for no samples.
[[nodiscard]] std::size_t segment_length(std::size_t samples, std::size_t longest = 1024);

/// A one-sided power spectrum. Bin k is at the frequency k * resolution.
struct PowerSpectrum {
  double resolution = 0;     ///< Hz between two bins.
  std::size_t segments = 0;  ///< Segments in the average; 0: there is no spectrum.
  std::vector<double>
      density{};  ///< Square of the signal's unit per Hz, from 0 Hz to half the sample rate.

  /// The mean square of the part of the signal in these bins: the sum of density * resolution.
  [[nodiscard]] double power(std::size_t first_bin, std::size_t last_bin) const;
};

/// The spectra of two signals that were sampled together.
struct CrossSpectrum {
  PowerSpectrum input;
  PowerSpectrum output;
  std::vector<std::complex<double>> cross{};  ///< Average of conj(input) * output, as a density.
};

/// The power spectrum of samples taken `rate` times per second, in segments of `length`, an even
/// number. NaN marks a missing sample: segments that contain one are left out. Without a complete
/// segment, or with an odd length, the number of segments is 0.
[[nodiscard]] PowerSpectrum power_spectrum(std::span<const double> samples, double rate,
                                           std::size_t length);

/// The same for two signals. A segment counts if it is complete in both signals.
[[nodiscard]] CrossSpectrum cross_spectrum(std::span<const double> input,
                                           std::span<const double> output, double rate,
                                           std::size_t length);

}  // namespace sbgc::analysis
