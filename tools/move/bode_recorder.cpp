#include "move/bode_recorder.hpp"

#include <chrono>
#include <cstdint>
#include <string_view>

#include <fmt/format.h>

#include <sbgc/client/motion.hpp>
#include <sbgc/internal/parse_number.hpp>
#include <sbgc/messages/control.hpp>
#include <sbgc/messages/realtime.hpp>

#include "board/progress_bar.hpp"
#include "command/interruption.hpp"
#include "command/remark.hpp"
#include "move/motor_state.hpp"
#include "move/move_way.hpp"
#include "values/axis_values.hpp"

namespace sbgc::tools {

namespace {

/// The speed between positions, and the time until the camera is calm.
constexpr std::chrono::seconds settling{2};

std::string recording_seconds(std::size_t samples) {
  return fmt::format("{:.1f}", static_cast<double>(samples) / bode_sample_rate);
}

}  // namespace

RecordingPosition parse_position(const std::string& text) {
  const std::size_t comma = text.find(',');
  const auto number = [&](std::string_view part) {
    const auto read = detail::parse_number<double>(part);
    // No -0, which file names would show.
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
  constexpr std::chrono::seconds margin{30};  // the library gives up before
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

}  // namespace sbgc::tools
