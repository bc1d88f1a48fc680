#include "care/doctor/measuring.hpp"

#include <array>
#include <mutex>
#include <optional>
#include <span>
#include <thread>
#include <type_traits>

#include <sbgc/roles.hpp>

#include "board/connection.hpp"
#include "care/doctor/polling.hpp"
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
  /// Starts it with one of these intervals, the shortest that the line carries. Returns false if
  /// there is none.
  bool start(Client& client, std::span<const int> intervals_ms) {
    for (const int interval_ms : intervals_ms) {
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
        return true;
      }
      if (stream.error().code != ErrorCode::overload) break;
    }
    return false;
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
    start_ = MeasuringClock::now();
    if (!use_streams()) use_requests();
    const SessionStatistics session = client_.statistics().session;
    result_.frames = session.parser.frames;
    result_.damaged_share = line_quality(session).damaged;
    result_.unanswered = session.timeouts;
    return std::move(result_);
  }

 private:
  /// Reads what does not change. An answer that is missing is not needed.
  void read_state() {
    value_of(Result<msg::RealtimeData3>(client_.call(msg::RealtimeData3Request{})));
    result_.firmware = client_.identity().firmware_version();
    result_.firmware_problem = client_.identity().firmware_problem();
    result_.has_battery_meter = client_.identity().has(msg::BoardFeature::bat_monitoring);
    msg::ReadParams3Request parameters;
    parameters.profile_id = msg::ReadParams3Request::active_profile;
    if (const auto read = client_.call(parameters)) result_.parameters = *read;
    msg::CalibInfoRequest calibration;
    calibration.imu_type = msg::SelectedImu::main;
    if (is_supported<msg::CalibInfoRequest>(client_.identity().versions())) {
      if (const auto read = client_.call(calibration)) result_.calibration = *read;
    }
  }

  /// Samples the first half with one interval and the second half with another. Returns false if
  /// there is no stream.
  bool use_streams() {
    constexpr std::array first{4, 8, 16};
    constexpr std::array second{5, 10, 20};
    GyroStream stream;
    if (!stream.start(client_, first)) return false;
    result_.sampling = Sampling::stream;
    ask_slowly(time_ / 2);
    result_.gyro = stream.end();
    GyroStream other;
    if (was_interrupted()) return true;
    const bool has_other = other.start(client_, second);
    ask_slowly(time_);
    if (has_other) result_.again = other.end();
    return true;
  }

  msg::RealtimeData3 ask() {
    return value_of(Result<msg::RealtimeData3>(client_.call(msg::RealtimeData3Request{})));
  }

  /// Takes the newest live data that the board has.
  void add_live_data() {
    if (is_supported<msg::RealtimeData4Request>(client_.identity().versions())) {
      add(value_of(Result<msg::RealtimeData4>(client_.call(msg::RealtimeData4Request{}))));
    } else {
      add(ask());
    }
  }
  template <class M>
  void add(const M& data) {
    result_.add(data);
    result_.seconds = seconds_since(start_);
    progress_(result_.seconds);
  }

  /// While a stream has the gyroscope, until `end`.
  void ask_slowly(double end) {
    constexpr std::chrono::milliseconds pause{100};
    while (!was_interrupted() && seconds_since(start_) < end) {
      add_live_data();
      std::this_thread::sleep_for(pause);
    }
  }

  /// Asks for the shorter live data, at one rate and then at another.
  void use_requests() {
    result_.sampling = Sampling::polls;
    constexpr int few = 5;
    for (int i = 0; i < few; ++i) add_live_data();
    const PollingParts parts{
        .now = [this] { return seconds_since(start_); },
        .wait_until =
            [this](double time) {
              std::this_thread::sleep_until(start_ +
                                            std::chrono::duration_cast<MeasuringClock::duration>(
                                                std::chrono::duration<double>(time)));
            },
        .ask =
            [this] {
              const msg::RealtimeData3 data = ask();
              add(data);
              return gyro_of(data);
            },
        .must_end = [] { return was_interrupted(); }};
    result_.gyro = poll_often(parts, time_ / 2);
    constexpr double longer = 1.25;
    result_.again = poll_at(parts, longer / result_.gyro->rate(), time_ / 2);
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
