/// Measurements of a gimbal, before they are judged.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include <sbgc/analysis/frequencies.hpp>
#include <sbgc/analysis/uniform_samples.hpp>
#include <sbgc/analysis/vibration.hpp>
#include <sbgc/client/statistics.hpp>
#include <sbgc/messages/calibration.hpp>
#include <sbgc/messages/parameters.hpp>
#include <sbgc/messages/realtime.hpp>
#include <sbgc/types.hpp>

namespace sbgc::doctor {

/// The mean of the samples that were added.
class Mean {
 public:
  void add(double value) {
    sum_ += value;
    ++count_;
  }
  /// Returns the mean, or nothing without samples.
  std::optional<double> value() const {
    if (count_ == 0) return {};
    return sum_ / static_cast<double>(count_);
  }

 private:
  double sum_ = 0;
  std::size_t count_ = 0;
};

/// Counts the increments of a 16-bit counter while it is watched.
class CountedErrors {
 public:
  void add(std::uint16_t count) {
    if (last_) risen_ += static_cast<std::uint16_t>(count - *last_);
    last_ = count;
  }
  std::uint64_t risen() const { return risen_; }

 private:
  std::optional<std::uint16_t> last_{};
  std::uint64_t risen_ = 0;
};

/// The source of the gyroscope's samples.
enum class Sampling : std::uint8_t { stream, polls };

/// The vibration of an axis.
struct AxisVibration {
  double rms{};                                    ///< in deg/s
  std::vector<analysis::Frequency> frequencies{};  ///< the strongest first
};

/// The root mean square of one frequency, for comparison with that of all frequencies.
inline double rms_of(const analysis::Peak& peak) { return peak.amplitude / std::numbers::sqrt2; }

/// The number of calibrated positions of the accelerometer, up to six.
inline int positions_of(const msg::CalibInfo& calibration) {
  return std::popcount(static_cast<unsigned>(calibration.acc_limits_info.raw()) & 0x3FU);
}

struct Measurements {
  double seconds = 0;  ///< from the first to the last message of live data

  // From live data
  std::size_t messages = 0;
  msg::SystemErrors errors{};  ///< all errors reported so far
  msg::SystemSubError sub_error{};
  CountedErrors i2c{}, serial{};
  Axes<Mean> power{};    ///< of the motors, in percent
  Axes<Mean> balance{};  ///< size of the balance error, in percent; later live data only
  Mean cycle{};          ///< in microseconds
  Mean gravity_error{};  ///< in degrees; later live data only
  std::optional<double> lowest_battery{};  ///< in volts
  bool has_motors_on = false;              ///< in each message
  unsigned profile = 0;                    ///< from 1
  msg::CalibMode task{};

  // From other messages
  std::string firmware{}, firmware_problem{};  ///< of the identity
  bool has_battery_meter = false;
  // Nothing if the board did not answer
  std::optional<msg::ReadParams3> parameters{};
  std::optional<msg::CalibInfo> calibration{};

  // The line
  double damaged_share = 0;      ///< of frames from the board
  std::uint64_t unanswered = 0;  ///< requests

  // The gyroscope, in deg/s
  Sampling sampling{};
  std::optional<analysis::UniformSamples> gyro{};
  std::optional<analysis::UniformSamples> again{};  ///< at another rate, which identifies aliases

  /// Adds a message of live data.
  void add(const msg::RealtimeData3& data) { add_common(data); }
  void add(const msg::RealtimeData4& data);
  /// Adds the counters of the line.
  void add(const SessionStatistics& session);

  /// Empty if too many samples are lost, or too few were taken.
  std::optional<Axes<AxisVibration>> vibration() const;

 private:
  template <class M>
  void add_common(const M& data);
};

/// The rates of the gyroscope in live data, in deg/s.
template <class M>
Axes<double> gyro_of(const M& data) {
  return {data.axes.roll.gyro_data.degrees_per_second(),
          data.axes.pitch.gyro_data.degrees_per_second(),
          data.axes.yaw.gyro_data.degrees_per_second()};
}

}  // namespace sbgc::doctor
