/// @file
/// The frequency response of a system from its recorded input and output.
#pragma once

#include <complex>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace sbgc::analysis {

/// The response at one frequency.
struct ResponsePoint {
  double frequency = 0;           ///< Hz
  std::complex<double> response;  ///< output over input
  double gain = 0;                ///< dB; minus infinity for no output
  double phase = 0;  ///< degrees: -180 to 180 at the first frequency, then without jumps
  /// The share of the output that follows the input, 0 to 1; 1 without noise and other inputs. Only
  /// set for 4 segments or more, because it is meaningless with fewer.
  std::optional<double> coherence;
  /// The uncertainty of the response, as a share of it, from the coherence: 95 % of the responses
  /// deviate by less than twice this, in the real and in the imaginary part each.
  std::optional<double> deviation;
};

/// The response in a range of frequencies.
struct FrequencyResponse {
  double resolution = 0;     ///< Hz between two points
  std::size_t segments = 0;  ///< in the average; 0: there is no response
  std::vector<ResponsePoint> points{};
};

/// The minimum number of samples in a segment.
inline constexpr std::size_t shortest_segment = 64;
/// The minimum number of segments for a coherence.
inline constexpr std::size_t least_segments = 4;

/// The response from `from` to `to`, in Hz, of samples that were taken `rate` times per second. A
/// segment has 1024 samples, or fewer if there are fewer samples. Segments that contain NaN and
/// frequencies without any input are left out. With fewer samples than the shortest segment, there
/// is no response.
[[nodiscard]] FrequencyResponse frequency_response(std::span<const double> input,
                                                   std::span<const double> output, double rate,
                                                   double from, double to);

}  // namespace sbgc::analysis
