// A program of a user: the power of a signal.
#include <vector>

#include <sbgc/analysis/spectrum.hpp>

int main() {
  std::vector<double> samples(64);
  for (std::size_t i = 0; i < samples.size(); ++i) samples[i] = i % 2 == 0 ? 1.0 : -1.0;
  const auto spectrum = sbgc::analysis::power_spectrum(samples, 64, 64);
  return spectrum.segments == 1 && spectrum.density.back() > 0.1 ? 0 : 1;
}
