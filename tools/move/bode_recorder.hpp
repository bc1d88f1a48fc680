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

/// How many seconds a recording may take. Assumption: what is longer is a mistake.
inline constexpr double longest_recording = 60;

/// A direction of the camera, in degrees. The pan axis stays where it is.
struct RecordingPosition {
  double roll{}, pitch{};
};

/// Reads "ROLL,PITCH" in degrees. Throws CommandError.
RecordingPosition parse_position(const std::string& text);

/// The speed between positions, in deg/s.
inline constexpr double position_speed = 20;

MoveTarget target_of(const RecordingPosition& position);

class BodeRecorder {
 public:
  /// With `motors_off`, the first signal turns the motors off, otherwise the second.
  BodeRecorder(MovingGimbal& gimbal, const msg::BodeTestStartStopRequest& request, bool motors_off)
      : gimbal_(gimbal), request_(request), motors_off_(motors_off) {}

  /// Records where the camera is. The first signal waits for the end. Throws CommandError.
  BodeRecording record() const;
  /// Turns the camera, and waits until it is calm. Throws CommandError.
  void go_to(const RecordingPosition& position) const;

 private:
  [[noreturn]] void turn_motors_off() const;

  MovingGimbal& gimbal_;
  msg::BodeTestStartStopRequest request_;
  bool motors_off_;
};

/// Ends the data streams that run on the line, as an earlier host has left them, and starts them
/// again at the end of its life. No request lists them: what is known of them is what their samples
/// tell, and the user reads what is not.
class PausedStreams {
 public:
  /// Listens to the line for half a second. Throws CommandError if the board does not respond.
  explicit PausedStreams(Client& client);
  PausedStreams(const PausedStreams&) = delete;
  PausedStreams& operator=(const PausedStreams&) = delete;
  ~PausedStreams();

 private:
  /// Starts the streams again that were running.
  void restart() const;

  Client& client_;
  std::vector<msg::DataStreamInterval> paused_{};
};

}  // namespace sbgc::tools
