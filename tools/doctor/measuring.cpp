#include "doctor/measuring.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <mutex>
#include <optional>
#include <thread>
#include <type_traits>
#include <vector>

#include <fmt/format.h>

#include <sbgc/roles.hpp>

#include "board/connection.hpp"
#include "command/interruption.hpp"

namespace sbgc::tools {

namespace {

using MeasuringClock = std::chrono::steady_clock;

double seconds_since(MeasuringClock::time_point start) {
  return std::chrono::duration<double>(MeasuringClock::now() - start).count();
}

/// A data stream of the gyroscope alone, whose samples are short.
class GyroStream {
 public:
  /// Starts it as fast as the line carries it. Returns why there is none.
  std::string start(Client& client) {
    std::string problem;
    for (const int interval_ms : {4, 8, 16}) {
      {
        const std::lock_guard lock(mutex_);
        samples_.emplace(1e-3 * interval_ms);
      }
      roles::StreamRequest request{};
      auto& interval = roles::stream_interval(request);
      using Interval = std::remove_reference_t<decltype(interval)>;
      interval = Interval(static_cast<typename Interval::raw_type>(interval_ms));
      request.config.flags = msg::RealtimeDataCustomFlag::gyro_data;
      auto stream = client.stream<msg::RealtimeDataCustom>(
          request, [this](const msg::RealtimeDataCustom& data) { take(data); });
      if (stream) {
        subscription_ = *std::move(stream);
        return "";
      }
      problem = stream.error().message;
      if (stream.error().code != ErrorCode::overload) break;
    }
    return problem;
  }
  UniformSamples end() {
    subscription_.cancel();
    const std::lock_guard lock(mutex_);
    return *samples_;
  }

 private:
  void take(const msg::RealtimeDataCustom& data) {
    if (!data.gyro_data) return;
    const std::lock_guard lock(mutex_);
    samples_->add_at(data.timestamp_ms.raw(), {data.gyro_data->roll.degrees_per_second(),
                                               data.gyro_data->pitch.degrees_per_second(),
                                               data.gyro_data->yaw.degrees_per_second()});
  }

  std::mutex mutex_{};
  std::optional<UniformSamples> samples_{};
  Subscription subscription_{};  // destroyed first
};

class Measuring {
 public:
  Measuring(Client& client, std::chrono::milliseconds time,
            const std::function<void(double)>& progress)
      : client_(client), time_(std::chrono::duration<double>(time).count()), progress_(progress) {}

  Measurements run() {
    read_state();
    GyroStream stream;
    const std::string problem = stream.start(client_);
    start_ = MeasuringClock::now();
    if (problem.empty()) {
      result_.sampling = Sampling::stream;
      ask_slowly();
      result_.gyro = stream.end();
    } else {
      result_.sampling = Sampling::polls;
      result_.no_gyro = problem;
      ask_often();
    }
    const SessionStatistics session = client_.statistics().session;
    result_.frames = session.parser.frames;
    result_.damaged_share = line_quality(session).damaged;
    result_.unanswered = session.timeouts;
    return std::move(result_);
  }

 private:
  bool is_over() const { return was_interrupted() || seconds_since(start_) >= time_; }

  /// Reads what does not change. An answer that is missing is not needed.
  void read_state() {
    value_of(Result<msg::RealtimeData3>(client_.call(msg::RealtimeData3Request{})));
    msg::ReadParams3Request parameters;
    parameters.profile_id = msg::ReadParams3Request::active_profile;
    if (const auto read = client_.call(parameters)) result_.parameters = *read;
    msg::CalibInfoRequest calibration;
    calibration.imu_type = msg::SelectedImu::main;
    if (is_supported<msg::CalibInfoRequest>(client_.identity().versions())) {
      if (const auto read = client_.call(calibration)) result_.calibration = *read;
    }
  }

  msg::RealtimeData3 ask() {
    return value_of(Result<msg::RealtimeData3>(client_.call(msg::RealtimeData3Request{})));
  }

  /// Asks for the newest live data that the board has.
  void add_live_data() {
    if (is_supported<msg::RealtimeData4Request>(client_.identity().versions())) {
      result_.add(value_of(Result<msg::RealtimeData4>(client_.call(msg::RealtimeData4Request{}))));
    } else {
      result_.add(ask());
    }
    result_.seconds = seconds_since(start_);
    progress_(result_.seconds);
  }

  /// While a stream has the gyroscope.
  void ask_slowly() {
    constexpr std::chrono::milliseconds pause{100};
    while (!is_over()) {
      add_live_data();
      std::this_thread::sleep_for(pause);
    }
  }

  /// Asks at a fixed rate for the shorter live data. If the board does not keep up, begins again at
  /// half of the rate.
  void ask_often() {
    constexpr int few = 5;
    for (int i = 0; i < few; ++i) add_live_data();
    constexpr double longest = 0.1;
    double interval = time_to_answer();
    while (!ask_every(interval) && interval < longest) interval *= 2;
  }

  /// Returns false as soon as too many samples are missing.
  bool ask_every(double interval) {
    result_.gyro.emplace(interval);
    result_.i2c = result_.serial = {};  // per second of this attempt
    start_ = MeasuringClock::now();
    std::int64_t number = 0;
    while (!is_over()) {
      const msg::RealtimeData3 data = ask();
      result_.seconds = seconds_since(start_);
      // The number of an answer that was late is that of its time, so that others are missing.
      const auto now = static_cast<std::int64_t>(result_.seconds / interval);
      result_.gyro->add(std::max(number, now), gyro_of(data));
      result_.add(data);
      progress_(result_.seconds);
      if (result_.gyro->lost_share() * static_cast<double>(now + 1) >
          most_lost * time_ / interval) {
        return false;
      }
      number = std::max(number, now) + 1;
      std::this_thread::sleep_until(
          start_ + std::chrono::duration_cast<MeasuringClock::duration>(
                       std::chrono::duration<double>(static_cast<double>(number) * interval)));
    }
    return true;
  }

  /// Returns the time in which almost all requests are answered, in seconds.
  double time_to_answer() {
    std::array<double, 20> times{};
    for (double& one : times) {
      const auto start = MeasuringClock::now();
      static_cast<void>(ask());
      one = seconds_since(start);
    }
    std::ranges::sort(times);
    constexpr std::size_t late = 18;
    constexpr double shortest = 0.004;
    return std::max(shortest, std::ceil(1250 * times[late]) * 1e-3);
  }

  Client& client_;
  double time_;
  const std::function<void(double)>& progress_;
  MeasuringClock::time_point start_ = MeasuringClock::now();
  Measurements result_{};
};

}  // namespace

Measurements measure(Client& client, std::chrono::milliseconds time,
                     const std::function<void(double)>& progress) {
  return Measuring(client, time, progress).run();
}

}  // namespace sbgc::tools
