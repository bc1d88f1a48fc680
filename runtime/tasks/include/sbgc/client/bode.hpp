/// Recording of a frequency response: what goes into an axis and what comes out.
///
/// A recording moves the camera, and the protocol cannot stop it: it ends after its last sample, or
/// when the motors turn off. See docs/2-safety.md. <sbgc/analysis/frequency_response.hpp> makes
/// gain and phase of it.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include <sbgc/client/task.hpp>
#include <sbgc/messages/calibration.hpp>
#include <sbgc/responses/calibration.hpp>

namespace sbgc {

/// Samples of a recording per second.
inline constexpr double bode_sample_rate = 1250;

/// The number of samples in a time, rounded to the nearest.
constexpr std::uint32_t bode_samples(double seconds) noexcept {
  const double doubled = 2 * seconds * bode_sample_rate;  // no lround() in a constant
  return (static_cast<std::uint32_t>(doubled) + 1) / 2;
}

/// A recording. A sample that was lost is NaN in both signals.
struct BodeRecording {
  msg::BodeTestStartStopRequest request{};  ///< what was recorded
  std::vector<double> input{};              ///< in a unit that the board does not tell
  std::vector<double> output{};             ///< as many as of the input
  std::size_t lost{};                       ///< samples
  /// The message of the end was lost: the board may have reported an error there.
  bool is_end_lost{};
};

/// The progress of a recording.
struct BodeProgress {
  bool is_sent{};         ///< from now on, the camera may move
  bool has_started{};     ///< the board has confirmed the start, or sent samples
  std::size_t samples{};  ///< received
  std::size_t total{};    ///< expected
  std::size_t lost{};     ///< missing between those that were received
};

/// Options of record_bode().
struct BodeOptions {
  /// How often `progress` is called.
  std::chrono::milliseconds interval{200};
  /// Returning false ends the wait with ErrorCode::cancelled, but the board goes on.
  std::function<bool(const BodeProgress&)> progress{};
};

namespace tasks {

/// Records a frequency response. The line is ready for the samples before the board can send the
/// first one. Lost messages leave a gap; if more is missing than the counter of the samples can
/// show, the recording fails. The error says whether the motion had started.
///
/// Messages do not say to which recording they belong. So the start is sent only after 250 ms
/// without those of an earlier one; if they do not end within a second, the task fails with
/// ErrorCode::board_error. Errors: those of Client::call(); `invalid` without samples,
/// `bad_response` if too many are lost.
Task<Result<BodeRecording>> record_bode(msg::BodeTestStartStopRequest request,
                                        BodeOptions options = {});

}  // namespace tasks

/// The recording in the CSV format of the vendor's program. Lost samples are "nan".
std::string to_csv(const BodeRecording& recording);

/// The longest file that parse_bode_csv() reads, in bytes.
inline constexpr std::size_t max_bode_csv = 64U << 20U;

/// Reads the CSV format of the vendor's program. Errors: `bad_file`, which names the line.
Result<BodeRecording> parse_bode_csv(std::string_view text);

}  // namespace sbgc
