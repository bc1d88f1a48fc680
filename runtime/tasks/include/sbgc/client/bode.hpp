/// Recording of a frequency response: the input and the output of an axis.
///
/// A recording moves the camera, and the protocol cannot stop it: it ends after its last sample, or
/// when the motors turn off. See docs/2-safety.md. <sbgc/analysis/frequency_response.hpp> computes
/// gain and phase from it.
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

/// The number of samples per second.
inline constexpr double bode_sample_rate = 1250;

/// The number of samples in a time span, rounded to the nearest.
constexpr std::uint32_t bode_samples(double seconds) noexcept {
  const double doubled = 2 * seconds * bode_sample_rate;  // lround() is not constexpr
  return (static_cast<std::uint32_t>(doubled) + 1) / 2;
}

/// A recording. A sample that was lost is NaN in both signals.
struct BodeRecording {
  msg::BodeTestStartStopRequest request{};  ///< what was recorded
  std::vector<double> input{};              ///< in a unit that the board does not report
  std::vector<double> output{};             ///< as many as in the input
  std::size_t lost{};                       ///< samples
  /// The final message was lost: the board may have reported an error in it.
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
  /// The interval between calls of `progress`.
  std::chrono::milliseconds interval{200};
  /// Returning false ends the wait with ErrorCode::cancelled, but the board goes on.
  std::function<bool(const BodeProgress&)> progress{};
};

namespace tasks {

/// Records a frequency response. The line is ready for the samples before the board can send the
/// first one. Lost messages leave a gap; if more is missing than the sample counter can show, the
/// recording fails. The error says whether the motion had started.
///
/// Messages do not identify their recording. So the start is sent only after 250 ms without
/// messages of an earlier one; if they do not end within a second, the task fails with
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
