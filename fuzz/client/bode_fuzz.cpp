// Fuzzes the reader of recorded frequency responses. Every text is a recording or an error that
// names a line, in time in proportion to its size; a recording survives being written and read
// again.

#include <cmath>

#include <sbgc/client/bode.hpp>

#include "hostile_text.hpp"
#include "input.hpp"

namespace {

using sbgc::fuzz::require;

void check_recording(const std::string& text) {
  const sbgc::Result<sbgc::BodeRecording> recording = sbgc::parse_bode_csv(text);
  if (!recording) return require(recording.error().message.starts_with("line "));
  require(recording->input.size() == recording->output.size());
  require(recording->input.size() == recording->request.samples_num);
  const std::string written = to_csv(*recording);
  const sbgc::Result<sbgc::BodeRecording> again = sbgc::parse_bode_csv(written);
  require(static_cast<bool>(again));
  require(again->request == recording->request);
  require(again->lost == recording->lost);
  require(to_csv(*again) == written);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text = sbgc::fuzz::text_with_bombs({data, size});
  sbgc::fuzz::require_linear_time(text.size(), std::chrono::microseconds(20),
                                  [&] { check_recording(text); });
  return 0;
}
