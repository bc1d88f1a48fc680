/// The state of a gimbal in the monitor, and its history.
#pragma once

#include <array>
#include <chrono>
#include <deque>
#include <mutex>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <sbgc/client/client.hpp>
#include <sbgc/messages/realtime.hpp>
#include <sbgc/meta/enums.hpp>
#include <sbgc/types.hpp>

namespace sbgc::tools {

/// Values over time. Keeps as many as a wide terminal can show.
class History {
 public:
  void add(double value) {
    values_.push_back(value);
    if (values_.size() > most) values_.pop_front();
  }
  std::vector<double> values() const { return {values_.begin(), values_.end()}; }

 private:
  static constexpr std::size_t most = 1000;
  std::deque<double> values_{};
};

/// One value of each axis: roll, pitch, yaw.
using PerAxis = Axes<double>;

/// The values of one message of live data, in their units. NaN is a value that the message lacks.
struct LiveValues {
  PerAxis angle{};        ///< of the camera, in degrees
  PerAxis target{};       ///< in degrees
  PerAxis frame_angle{};  ///< in degrees
  PerAxis joint{};        ///< in degrees
  PerAxis balance{};      ///< motor power lost to imbalance, in percent
  PerAxis power{};        ///< of the motors, 0 to 1
  PerAxis rate{};         ///< of the gyroscope, in deg/s
  PerAxis vibration{};    ///< of the last seconds, as vibration_of() has it, in deg/s
  double slowest_vibration{}, fastest_vibration{};  ///< its frequencies, in hertz
  double battery{};                                 ///< in volts
  double current{};                                 ///< in milliamperes
  double temperature{};                             ///< of the main IMU, in degrees Celsius
  double cycle_us{};
  unsigned profile{};  ///< from 1
  unsigned i2c_errors{};
  unsigned serial_errors{};
  bool motors_on{};
  std::vector<const ValueInfo*> errors{};
  std::string sub_error{};  ///< the reason of an emergency stop, or ""
  std::string task{};       ///< a calibration that is running, or ""
};

/// The message that the values come from.
using LiveMessage = std::variant<msg::RealtimeData3, msg::RealtimeData4>;

struct LogEntry {
  std::chrono::system_clock::time_point time{};
  std::string text{};
};

/// A copy of everything to show.
struct GimbalSnapshot {
  std::optional<LiveMessage> message{};
  LiveValues values{};
  double rate{};  ///< messages per second
  std::array<History, 3> angles{};
  std::array<History, 3> powers{};
  History battery{};
  History current{};
  std::deque<LogEntry> log{};
  bool is_connected = true;
};

/// Collects what the gimbal sends. Thread-safe.
class GimbalState {
 public:
  void add(const LiveMessage& message);
  void add(const Notice& notice);
  void add(const LinkChange& change);
  void add(const ClientError& error);

  GimbalSnapshot snapshot() const;

 private:
  void log(std::string text);

  mutable std::mutex mutex_;
  GimbalSnapshot state_{};
  std::deque<std::chrono::steady_clock::time_point> arrivals_{};  // within the last seconds
  std::deque<PerAxis> rates_{};                                   // of the gyroscope, likewise
};

}  // namespace sbgc::tools
