/// Recording of frequency responses, at one or several positions of the camera, on a line without
/// data streams.
#pragma once

#include <string>
#include <vector>

#include <sbgc/client/bode.hpp>
#include <sbgc/client/client.hpp>
#include <sbgc/client/motion.hpp>
#include <sbgc/messages/realtime.hpp>

#include "move/moving_gimbal.hpp"

namespace sbgc::tools {

/// The longest recording in seconds. Assumption: anything longer is a mistake.
inline constexpr double longest_recording = 60;

/// A direction of the camera, in degrees. The pan axis stays where it is.
struct RecordingPosition {
  double roll{}, pitch{};
};

/// Parses "ROLL,PITCH" in degrees. Throws CommandError.
RecordingPosition parse_position(const std::string& text);

/// The speed between positions, in deg/s.
inline constexpr double position_speed = 20;

MoveTarget target_of(const RecordingPosition& position);

class BodeRecorder {
 public:
  /// With `motors_off`, the first signal turns the motors off, otherwise the second one.
  BodeRecorder(MovingGimbal& gimbal, const msg::BodeTestStartStopRequest& request, bool motors_off)
      : gimbal_(gimbal), request_(request), motors_off_(motors_off) {}

  /// Records at the present position. The first signal waits for the end. Throws CommandError.
  BodeRecording record() const;
  /// Turns the camera, and waits until it is calm. Throws CommandError.
  void go_to(const RecordingPosition& position) const;

 private:
  [[noreturn]] void turn_motors_off() const;

  MovingGimbal& gimbal_;
  msg::BodeTestStartStopRequest request_;
  bool motors_off_;
};

/// Ends the data streams that an earlier host has left running, and restarts them on destruction.
/// No request lists them: only their samples are known, and the user is told about anything
/// unknown.
class PausedStreams {
 public:
  /// Listens to the line for half a second. Throws CommandError if the board does not respond.
  explicit PausedStreams(Client& client);
  PausedStreams(const PausedStreams&) = delete;
  PausedStreams& operator=(const PausedStreams&) = delete;
  ~PausedStreams();

 private:
  /// Restarts the streams that were running.
  void restart() const;

  Client& client_;
  std::vector<msg::DataStreamInterval> paused_{};
};

}  // namespace sbgc::tools
