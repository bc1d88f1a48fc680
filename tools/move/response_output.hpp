/// Frequency responses as text and as a picture.
#pragma once

#include <string>
#include <vector>

#include <sbgc/analysis/frequency_response.hpp>
#include <sbgc/client/bode.hpp>

namespace sbgc::tools {

/// The response of a recording.
struct NamedResponse {
  std::string name{};
  analysis::FrequencyResponse response{};
};

/// Returns the distance of the frequencies in the response of this recording, in Hz.
double resolution_of(const msg::BodeTestStartStopRequest& request);
/// True if the response has a frequency in the range of the recording.
bool has_frequencies(const msg::BodeTestStartStopRequest& request);

/// The response between the frequencies of the recording, at most 500 Hz.
analysis::FrequencyResponse response_of(const BodeRecording& recording);

/// Returns a line for each frequency: frequency, gain, phase, and coherence or "-".
std::string response_table(const analysis::FrequencyResponse& response);

/// Draws gain, phase and coherence over the frequency, a color for each response.
std::string response_svg(const std::vector<NamedResponse>& responses);

}  // namespace sbgc::tools
