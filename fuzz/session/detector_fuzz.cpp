// Fuzzes the search for a board's line settings. For each request the input has a step: the number
// of bytes received before the next request, and these bytes. 0xFE is a valid response instead;
// 0xFF also makes the port refuse the next settings.

#include <sbgc/detector.hpp>

#include "input.hpp"

namespace {

using sbgc::fuzz::require;

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::span<const std::uint8_t> input(data, size);
  sbgc::Detector detector;
  sbgc::Instant now{};
  for (int steps = 0; steps < 10'000; ++steps) {
    const sbgc::DetectorStep step = detector.next(now);
    switch (step.kind) {
      case sbgc::DetectorStep::Kind::set_line:
        if (!input.empty() && input.front() == 0xFF) detector.refuse();
        break;
      case sbgc::DetectorStep::Kind::write: {
        require(!step.bytes.empty());
        if (input.empty()) break;
        const std::uint8_t code = input.front();
        input = input.subspan(1);
        if (code == 0xFE) {  // a valid response
          std::array<std::uint8_t, sbgc::max_frame_size> frame{};
          const std::array<std::uint8_t, sbgc::roles::introduction_size> body{};
          const auto written = sbgc::write_frame(sbgc::roles::introduction_request_id, body, frame);
          detector.feed(std::span(frame).first(written.size));
          break;
        }
        const std::size_t count = code < input.size() ? code : input.size();
        detector.feed(input.first(count));
        input = input.subspan(count);
        break;
      }
      case sbgc::DetectorStep::Kind::wait:
        require(step.until > now && step.until != sbgc::Instant::never);
        now = step.until;
        break;
      case sbgc::DetectorStep::Kind::found:
        require(sbgc::roles::is_introduction(detector.introduction()));
        return 0;
      case sbgc::DetectorStep::Kind::failed: require(detector.introduction().id == 0); return 0;
    }
  }
  std::abort();  // the search must terminate
}
