/// Collects the samples of a recording, in order.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include <sbgc/client/bode.hpp>

namespace sbgc::detail {

/// Assembles the messages, and detects lost ones by their counter.
class BodeCollector {
 public:
  explicit BodeCollector(const msg::BodeTestStartStopRequest& request) {
    recording_.request = request;
  }

  /// Adds the next message. A duplicate of the previous one is ignored.
  void add(const msg::BodeTestData& data);
  std::size_t samples() const noexcept { return recording_.input.size(); }
  std::size_t lost() const noexcept { return recording_.lost; }
  /// True if the board has sent more than was requested.
  bool has_too_many() const noexcept;
  /// Checks the samples against the board's report at the end.
  Result<BodeRecording> finish(const msg::BodeTestStartStop& end) &&;
  /// Without that report: fails with `reason` if samples are missing, unless the time of the
  /// recording is over, so that the last ones are missing.
  Result<BodeRecording> finish_without_end(ClientError reason, bool is_over) &&;

 private:
  void add_gap(std::size_t samples);

  BodeRecording recording_{};
  std::optional<msg::BodeTestData> last_{};
};

}  // namespace sbgc::detail
