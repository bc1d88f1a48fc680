/// The samples of a recording, in their order.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include <sbgc/client/bode.hpp>

namespace sbgc::detail {

/// Puts messages together, and finds the lost ones by their counter.
class BodeCollector {
 public:
  explicit BodeCollector(const msg::BodeTestStartStopRequest& request) {
    recording_.request = request;
  }

  /// Takes the next message. A copy of the previous one counts for nothing.
  void add(const msg::BodeTestData& data);
  std::size_t samples() const noexcept { return recording_.input.size(); }
  std::size_t lost() const noexcept { return recording_.lost; }
  /// True if the board has sent more than was requested.
  bool has_too_many() const noexcept;
  /// Checks the samples against what the board reports at the end.
  Result<BodeRecording> finish(const msg::BodeTestStartStop& end) &&;
  /// Without that report: fails with `reason` if samples are missing, unless the time of the
  /// recording is over, so that they are the last ones.
  Result<BodeRecording> finish_without_end(ClientError reason, bool is_over) &&;

 private:
  void add_gap(std::size_t samples);

  BodeRecording recording_{};
  std::optional<msg::BodeTestData> last_{};
};

}  // namespace sbgc::detail
