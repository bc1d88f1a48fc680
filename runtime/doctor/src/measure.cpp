#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <type_traits>
#include <utility>

#include <sbgc/availability.hpp>
#include <sbgc/doctor/measure.hpp>
#include <sbgc/doctor/measurements.hpp>
#include <sbgc/roles.hpp>

#include "polling.hpp"

namespace sbgc::doctor {

namespace {

/// A data stream that contains only the gyroscope, so that samples are short.
class GyroStream {
 public:
  explicit GyroStream(TaskMachine& task) : task_(task) {}
  GyroStream(const GyroStream&) = delete;
  GyroStream& operator=(const GyroStream&) = delete;
  ~GyroStream() { task_.end(id_); }

  /// Starts it with the shortest of these intervals that the line can carry. Returns false if there
  /// is none.
  Task<Result<bool>> start(std::span<const int> intervals_ms) {
    for (const int interval_ms : intervals_ms) {
      samples_.emplace(1e-3 * interval_ms);
      roles::StreamRequest request{};
      auto& interval = roles::stream_interval(request);
      using Interval = std::remove_reference_t<decltype(interval)>;
      interval = Interval(static_cast<typename Interval::raw_type>(interval_ms));
      request.config.flags = flags;
      id_ = task_.begin_stream<msg::RealtimeDataCustom>(request);
      const Result<void> waited = co_await tasks::wait_for_call(id_, Instant::never);
      if (!waited) co_return waited.error();
      const Result<Reply>& started = *task_.reply(id_);
      if (started) co_return true;
      const bool is_too_much = started.error().code == ErrorCode::overload;
      task_.end(id_);
      if (!is_too_much) break;
    }
    co_return false;
  }
  /// Collects the samples that have arrived.
  void take() {
    for (const auto& body : task_.take_series(id_)) {
      msg::RealtimeDataCustom data;
      if (!decode(std::span(body), data, {flags}) || !data.gyro_data) continue;
      samples_->add_at(data.timestamp_ms.raw(), {data.gyro_data->roll.degrees_per_second(),
                                                 data.gyro_data->pitch.degrees_per_second(),
                                                 data.gyro_data->yaw.degrees_per_second()});
    }
  }
  analysis::UniformSamples end() {
    take();
    task_.end(id_);
    return *std::move(samples_);
  }

 private:
  static constexpr auto flags = msg::RealtimeDataCustomFlag::gyro_data;

  TaskMachine& task_;
  CallId id_{};
  std::optional<analysis::UniformSamples> samples_{};
};

class Measuring {
 public:
  Measuring(TaskMachine& task, const MeasureOptions& options)
      : task_(task), options_(options), time_(milliseconds(options.time.count())) {}

  Task<Result<Measurements>> run() {
    if (const auto read = co_await read_state(); !read) co_return read.error();
    start_ = task_.now();
    const Result<void> sampled = co_await sample();
    if (!sampled && !is_silence(sampled)) co_return sampled.error();
    // With lost answers there is less information, but the counters of the line show that.
    if (result_.seconds == 0) co_return sampled ? silence_ : sampled.error();
    co_return std::move(result_);
  }

 private:
  Duration half() const { return {time_.us / 2}; }

  template <class T>
  static bool is_silence(const Result<T>& result) {
    return !result && result.error().code == ErrorCode::timeout;
  }

  Task<Result<void>> sample() {
    const Result<bool> has_streams = co_await use_streams();
    if (!has_streams) co_return has_streams.error();
    if (!*has_streams) co_return co_await use_requests();
    co_return Result<void>();
  }

  /// Reads constant information. Missing answers are not needed.
  Task<Result<void>> read_state() {
    constexpr int attempts = 3;  // on a noisy line, all repetitions of a call may be lost
    auto live = co_await tasks::call(msg::RealtimeData3Request{});
    for (int i = 1; i < attempts && is_silence(live); ++i) {
      live = co_await tasks::call(msg::RealtimeData3Request{});
    }
    if (!live) co_return live.error();
    const BoardIdentity& board = task_.identity();
    result_.firmware = board.firmware_version();
    result_.firmware_problem = board.firmware_problem();
    result_.has_battery_meter = board.has(msg::BoardFeature::bat_monitoring);
    msg::ReadParams3Request parameters;
    parameters.profile_id = msg::ReadParams3Request::active_profile;
    if (const auto read = co_await tasks::call(parameters)) result_.parameters = *read;
    msg::CalibInfoRequest calibration;
    calibration.imu_type = msg::SelectedImu::main;
    if (is_supported<msg::CalibInfoRequest>(board.versions())) {
      if (const auto read = co_await tasks::call(calibration)) result_.calibration = *read;
    }
    co_return Result<void>();
  }

  /// Samples the first half with one interval and the second half with another. Returns false if
  /// there is no stream.
  Task<Result<bool>> use_streams() {
    static constexpr std::array first{4, 8, 16};
    static constexpr std::array second{5, 10, 20};
    {
      GyroStream stream(task_);
      const Result<bool> has_stream = co_await stream.start(first);
      if (!has_stream || !*has_stream) co_return has_stream;
      result_.sampling = Sampling::stream;
      if (const auto asked = co_await ask_slowly(stream, half()); !asked) {
        co_return asked.error();
      }
      result_.gyro = stream.end();
    }
    GyroStream other(task_);
    const Result<bool> has_other = co_await other.start(second);
    if (!has_other) co_return has_other;
    if (const auto asked = co_await ask_slowly(other, time_); !asked) co_return asked.error();
    if (*has_other) result_.again = other.end();
    co_return true;
  }

  /// Adds the newest kind of live data that the board has.
  Task<Result<void>> add_live_data() {
    if (is_supported<msg::RealtimeData4Request>(task_.identity().versions())) {
      const auto data = co_await tasks::call(msg::RealtimeData4Request{});
      if (!data) co_return data.error();
      co_return add(*data);
    }
    const auto data = co_await tasks::call(msg::RealtimeData3Request{});
    if (!data) co_return data.error();
    co_return add(*data);
  }
  template <class M>
  Result<void> add(const M& data) {
    result_.add(data);
    result_.seconds = in_seconds(task_.now() - start_);
    if (!options_.progress || options_.progress(result_.seconds)) return {};
    return ClientError{ErrorCode::cancelled, "interrupted: measuring"};
  }

  /// Polls live data until `end`, while a stream samples the gyroscope. Answers may be missing.
  Task<Result<void>> ask_slowly(GyroStream& stream, Duration end) {
    constexpr Duration pause = milliseconds(100);
    while (task_.now() - start_ < end) {
      const Result<void> added = co_await add_live_data();
      if (!added && !is_silence(added)) co_return added;
      if (!added) silence_ = added.error();
      const Result<void> waited = co_await tasks::wait_until(task_.now() + pause);
      if (!waited) co_return waited;
      stream.take();
    }
    co_return Result<void>();
  }

  /// Polls the shorter live data, at one rate and then at another.
  Task<Result<void>> use_requests() {
    result_.sampling = Sampling::polls;
    constexpr int few = 5;
    for (int i = 0; i < few; ++i) {
      if (auto added = co_await add_live_data(); !added) co_return added;
    }
    const Ask ask = [this] { return ask_for_rates(); };
    Result<analysis::UniformSamples> samples = co_await poll_often(ask, half());
    if (!samples) co_return samples.error();
    result_.gyro = *std::move(samples);
    // Longer by a quarter.
    const Duration interval = microseconds(std::llround(1.25e6 / result_.gyro->rate()));
    samples = co_await poll_at(ask, interval, half());
    if (!samples) co_return samples.error();
    result_.again = *std::move(samples);
    co_return Result<void>();
  }
  Task<Result<Axes<double>>> ask_for_rates() {
    const auto data = co_await tasks::call(msg::RealtimeData3Request{});
    if (!data) co_return data.error();
    if (auto added = add(*data); !added) co_return added.error();
    co_return gyro_of(*data);
  }

  TaskMachine& task_;
  const MeasureOptions& options_;
  Duration time_;
  Instant start_{};
  ClientError silence_{};  // the last missing answer
  Measurements result_{};
};

}  // namespace

template <class M>
void Measurements::add_common(const M& data) {
  errors = errors | data.system_error;
  if (data.system_sub_error != msg::SystemSubError{}) sub_error = data.system_sub_error;
  i2c.add(data.i2c_error_count);
  serial.add(data.serial_error_cnt);
  constexpr double full = std::numeric_limits<std::uint8_t>::max();
  for (std::size_t axis = 0; axis < power.size(); ++axis) {
    power[axis].add(100 * data.motor_power[axis] / full);
  }
  cycle.add(data.cycle_time.real());
  const double volts = data.bat_level.volts();
  lowest_battery = std::min(lowest_battery.value_or(volts), volts);
  const bool is_on = data.other_flags.has(msg::OtherFlag::motors_on);
  has_motors_on = messages == 0 ? is_on : has_motors_on && is_on;
  profile = data.cur_profile + 1U;
  ++messages;
}

template void Measurements::add_common(const msg::RealtimeData3& data);

void Measurements::add(const msg::RealtimeData4& data) {
  add_common(data);
  for (std::size_t axis = 0; axis < balance.size(); ++axis) {
    balance[axis].add(std::abs(data.balance_error[axis].percent()));
  }
  gravity_error.add(data.imu_g_err.degrees());
  if (data.calib_mode != msg::CalibMode{}) task = data.calib_mode;
}

void Measurements::add(const SessionStatistics& session) {
  damaged_share = line_quality(session).damaged;
  unanswered = session.timeouts;
}

std::optional<Axes<AxisVibration>> Measurements::vibration() const {
  if (!gyro || !gyro->is_usable()) return {};
  Axes<AxisVibration> result;
  for (std::size_t axis = 0; axis < result.size(); ++axis) {
    const analysis::Vibration first = analysis::vibration_of(gyro->axis(axis), gyro->rate());
    if (!first.is_known()) return {};
    analysis::Vibration second;
    if (again && again->is_usable())
      second = analysis::vibration_of(again->axis(axis), again->rate());
    result[axis] = {first.rms, frequencies_of(first, second)};
  }
  return result;
}

}  // namespace sbgc::doctor

namespace sbgc::tasks {

Task<Result<doctor::Measurements>> measure(MeasureOptions options) {
  doctor::Measuring measuring(co_await this_task(), options);
  co_return co_await measuring.run();
}

}  // namespace sbgc::tasks
