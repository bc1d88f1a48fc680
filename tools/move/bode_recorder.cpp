#include "move/bode_recorder.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <string_view>
#include <thread>
#include <vector>

#include <fmt/format.h>

#include <sbgc/client/motion.hpp>
#include <sbgc/client/typed.hpp>
#include <sbgc/frame.hpp>
#include <sbgc/internal/parse_number.hpp>
#include <sbgc/messages.hpp>
#include <sbgc/messages/control.hpp>
#include <sbgc/messages/realtime.hpp>
#include <sbgc/roles.hpp>
#include <sbgc/text.hpp>

#include "board/connection.hpp"
#include "board/progress_bar.hpp"
#include "command/interruption.hpp"
#include "command/remark.hpp"
#include "move/move_way.hpp"
#include "move/moving_gimbal.hpp"
#include "values/axis_values.hpp"

namespace sbgc::tools {

namespace {

/// The time until the camera is calm after a turn.
constexpr std::chrono::seconds settling{2};

std::string recording_seconds(std::size_t samples) {
  return fmt::format("{:.1f}", static_cast<double>(samples) / bode_sample_rate);
}

}  // namespace

RecordingPosition parse_position(const std::string& text) {
  const std::size_t comma = text.find(',');
  const auto number = [&](std::string_view part) {
    const auto read = detail::parse_number<double>(part);
    // Avoid -0, which file names would show.
    if (comma != std::string::npos && read && *read >= -180 && *read <= 180) return *read + 0.0;
    throw CommandError(
        fmt::format("'{}' is not ROLL,PITCH in degrees, such as 0,-30", clipped(text)),
        wrong_usage);
  };
  const std::string_view whole = text;
  return {number(whole.substr(0, comma)),
          number(whole.substr(comma == std::string::npos ? 0 : comma + 1))};
}

MoveTarget target_of(const RecordingPosition& position) {
  return {.roll = to_angle(position.roll, "--at"), .pitch = to_angle(position.pitch, "--at")};
}

BodeRecording BodeRecorder::record() const {
  if (gimbal_.must_stop()) gimbal_.give_up({});
  constexpr std::chrono::seconds margin{30};  // the library times out earlier
  const std::chrono::seconds length(
      static_cast<std::int64_t>(request_.samples_num / bode_sample_rate));
  const MustFinish recording(length + margin, "the axis may still shake, until its time is over");
  const CutShort second;
  ProgressBar bar;
  bool has_told = false, may_move = false;
  BodeOptions options;
  options.progress = [&](const BodeProgress& seen) {
    if (!seen.is_sent) return !gimbal_.must_stop();
    may_move = true;
    const bool must_end = motors_off_ ? was_interrupted() : was_cut_short();
    if (must_end) return false;
    if (was_interrupted() && !has_told) {
      has_told = true;
      remark(
          "Interrupted. No command ends a recording; it is over in {} s. Ctrl-C again turns the "
          "motors "
          "off: hold the camera.\n",
          recording_seconds(seen.total - std::min(seen.samples, seen.total)));
    }
    bar.show(fmt::format("recording: {} of {} s{}", recording_seconds(seen.samples),
                         recording_seconds(seen.total),
                         seen.lost == 0 ? "" : fmt::format(", {} samples lost", seen.lost)));
    return true;
  };
  const auto recorded = gimbal_.client().record_bode(request_, options);
  bar.clear();
  if (!recorded && recorded.error().code == ErrorCode::cancelled) {
    if (!may_move) gimbal_.give_up(recorded.error());
    turn_motors_off();
  }
  if (!recorded && !may_move && recorded.error().code == ErrorCode::board_error) {
    gimbal_.has_stopped();  // the board has not begun
    throw CommandError(fmt::format("{}; a recording of this command lasts at most {} s",
                                   recorded.error().message, longest_recording));
  }
  return value_of(recorded);
}

void BodeRecorder::turn_motors_off() const {
  const Result<void> done(gimbal_.client().call(msg::MotorsOff{}, confirming()));
  if (!done) {
    throw CommandError("interrupted; the motors may still be on: " + done.error().message,
                       interrupted);
  }
  gimbal_.has_stopped();
  throw CommandError("interrupted; the motors are off", interrupted);
}

void BodeRecorder::go_to(const RecordingPosition& position) const {
  require_motors(gimbal_.client());  // somebody may have turned them off during a recording
  const auto state = value_of(Result<msg::GetAngles>(gimbal_.client().get_angles()));
  const MoveTarget target = target_of(position);
  MoveOptions options;
  options.speed = to_speed(position_speed, "--at");
  options.timeout = time_for_move(target, angles_of(state), options.speed);
  options.stop_on_failure = false;  // give_up() stops it
  ProgressBar bar;
  options.progress = [&](const MoveProgress&) {
    bar.show(fmt::format("turning to roll {}, pitch {}", position.roll, position.pitch));
    return !gimbal_.must_stop();
  };
  const Result<MoveProgress> moved = gimbal_.client().move_to(target, options);
  if (!moved) gimbal_.give_up(moved.error());
  const auto end = std::chrono::steady_clock::now() + settling;
  while (!gimbal_.must_stop()) {
    const auto left =
        std::chrono::ceil<std::chrono::milliseconds>(end - std::chrono::steady_clock::now());
    if (left.count() <= 0) return;
    gimbal_.wait(left);
  }
  gimbal_.give_up({});
}

namespace {

/// The possible requests for a stream with this sample, without the interval: one if the sample
/// identifies it, several if it is one of them, none if it is unknown. `is_sample` is false for
/// other messages.
struct StreamGuess {
  bool is_sample = false;
  std::vector<msg::DataStreamInterval> requests{};
};

/// Records the arrival times of a stream's samples.
class SampleTimes {
 public:
  using Time = std::chrono::steady_clock::time_point;

  void add(Time at) { times_.push_back(at); }
  bool have_interval() const noexcept { return times_.size() > 1; }
  /// The interval between samples, some of which may be lost. Precondition: have_interval().
  msg::Milliseconds interval() const;

 private:
  std::vector<Time> times_{};
};

using Configs = std::vector<msg::StreamConfig>;

Configs configs_of(const msg::RealtimeData3& /*sample*/) { return {{}}; }
Configs configs_of(const msg::RealtimeData4& /*sample*/) { return {{}}; }
Configs configs_of(const msg::AhrsHelper& /*sample*/) {
  Configs both(2);
  both[0].imu_type = msg::ImuIndex::main;
  both[1].imu_type = msg::ImuIndex::frame;
  return both;
}
Configs configs_of(const msg::RealtimeDataCustom& sample) {
  Configs known(sample.flags ? 1 : 0);
  for (msg::StreamConfig& one : known) one.flags = sample.flags;
  return known;
}
Configs configs_of(const msg::RealtimeDataCustom2& sample) {
  Configs known(sample.flags ? 1 : 0);
  for (msg::StreamConfig& one : known) one.custom2_flags = sample.flags;
  return known;
}
Configs configs_of(const msg::ExtMotorsState& sample) {
  Configs known(1);
  known[0].motor = sample.motor_id;
  known[0].data_set = sample.data_set;
  return known;
}
/// Their samples show only a part of the request.
Configs configs_of(const msg::Event& /*sample*/) { return {}; }
Configs configs_of(const msg::CanDrvTelemetry& /*sample*/) { return {}; }

StreamGuess guess_stream(const Frame& frame) {
  StreamGuess guess;
  roles::StreamMessages::for_each([&]<class M>(Type<M>) {
    if (static_cast<std::uint8_t>(M::command) != frame.id) return;
    guess.is_sample = true;
    M sample;
    if constexpr (requires { typename M::Context; }) {
      // Without the flags of its request, a sample decodes only if it repeats them.
      if (!decode(frame.body, sample, typename M::Context{})) return;
    } else {
      if (!decode(frame.body, sample)) return;
    }
    for (const msg::StreamConfig& config : configs_of(sample)) {
      msg::DataStreamInterval& request = guess.requests.emplace_back();
      detail::choose_stream<M>(request);
      request.config = config;
    }
  });
  return guess;
}

msg::Milliseconds SampleTimes::interval() const {
  std::vector<double> gaps;
  for (std::size_t i = 1; i < times_.size(); ++i) {
    gaps.push_back(std::chrono::duration<double, std::milli>(times_[i] - times_[i - 1]).count());
  }
  const auto middle = gaps.begin() + static_cast<std::ptrdiff_t>(gaps.size() / 2);
  std::nth_element(gaps.begin(), middle, gaps.end());
  const double all =
      std::chrono::duration<double, std::milli>(times_.back() - times_.front()).count();
  const auto heard = static_cast<double>(gaps.size());
  // A gap that is twice as long as most has lost a sample. If most seem to be lost, the machine was
  // busy, and they arrived in bunches.
  const double sent = *middle > 0 ? std::round(all / *middle) : heard;
  const double count = sent >= 1 && sent <= 2 * heard ? sent : heard;
  const long rounded = std::clamp(std::lround(all / count), 1L, 1000L);
  return msg::Milliseconds(static_cast<msg::Milliseconds::raw_type>(rounded));
}

/// A stream on the line.
struct HeardStream {
  msg::CommandFromBoard command{};
  std::vector<msg::DataStreamInterval> requests{};
  SampleTimes times{};
};

/// Returns the streams with several samples within this time: others do not matter.
std::vector<HeardStream> heard_streams(Client& client, std::chrono::milliseconds time) {
  std::vector<HeardStream> heard;
  {
    const Subscription listening = client.on_frame([&](const BoardFrame& one) {
      if (one.belongs_to_call || one.is_late) return;
      const StreamGuess guess = guess_stream(one.frame);
      if (!guess.is_sample) return;
      const auto command = static_cast<msg::CommandFromBoard>(one.frame.id);
      auto stream = std::ranges::find_if(heard, [&](const HeardStream& other) {
        return other.command == command && other.requests == guess.requests;
      });
      if (stream == heard.end()) stream = heard.insert(heard.end(), {command, guess.requests, {}});
      stream->times.add(std::chrono::steady_clock::now());
    });
    std::this_thread::sleep_for(time);
  }
  std::erase_if(heard, [](const HeardStream& one) { return !one.times.have_interval(); });
  return heard;
}

bool still_runs(Client& client, const HeardStream& stream) {
  const std::chrono::milliseconds interval(stream.times.interval().raw());
  const auto heard = heard_streams(client, 4 * interval + std::chrono::milliseconds(50));
  return std::ranges::any_of(heard, [&](const HeardStream& other) {
    return other.command == stream.command && other.requests == stream.requests;
  });
}

}  // namespace

PausedStreams::PausedStreams(Client& client) : client_(client) {
  for (const HeardStream& stream : heard_streams(client, std::chrono::milliseconds(500))) {
    bool runs = true;
    for (auto request = stream.requests.begin(); runs && request != stream.requests.end();
         ++request) {
      msg::DataStreamInterval end = *request;
      end.interval_ms = {};
      const Result<void> ended(client_.call(end));
      if (!ended) restart();  // restart the earlier ones: the destructor will not run
      value_of(ended);
      runs = still_runs(client, stream);
      if (runs) continue;
      paused_.push_back(*request);
      paused_.back().interval_ms = stream.times.interval();
    }
    if (runs) {
      remark(
          "A data stream of {} goes on, because only its host knows how to end it: samples may be "
          "lost.\n",
          to_string(stream.command));
    } else {
      remark(
          "The data stream of {} is paused. It goes on afterwards, every {} ms as measured: what "
          "its host asked for is unknown.\n",
          to_string(stream.command), paused_.back().interval_ms.raw());
    }
  }
}

PausedStreams::~PausedStreams() { restart(); }

void PausedStreams::restart() const {
  for (const msg::DataStreamInterval& request : paused_) {
    const Result<void> started(client_.call(request));
    if (started) continue;
    remark("The data stream of {} does not run any more: {}\n", to_string(request.cmd_id),
           started.error().message);
  }
}

}  // namespace sbgc::tools
