// A tour of a gimbal: connects, saves the parameters, turns the camera to 30 degrees down and back,
// and measures the effect of stabilization. All traffic is recorded to a capture:
//
//     tour ADDRESS CAPTURE BACKUP
//
// ADDRESS is a serial port such as /dev/ttyUSB0, or tcp:host:port. It asks before it moves
// anything, unless the last argument is --yes. Read docs/2-safety.md before you move a gimbal.

#include <algorithm>
#include <array>
#include <chrono>
#include <cstddef>
#include <cstdio>
#include <thread>
#include <utility>

#include <sbgc/client/backup.hpp>
#include <sbgc/client/client.hpp>
#include <sbgc/client/motion.hpp>
#include <sbgc/messages/control.hpp>
#include <sbgc/messages/realtime.hpp>

#include "careful.hpp"

namespace {

using namespace sbgc::literals;
using namespace std::chrono_literals;

int fail(const sbgc::ClientError& error) {
  std::fprintf(stderr, "%s\n", error.message.c_str());
  return 1;
}

sbgc::Result<sbgc::MoveProgress> tilt(sbgc::Client& client, sbgc::msg::Angle14 pitch) {
  std::printf("pitch to %.0f degrees\n", pitch.degrees());
  return client.move_to({.pitch = pitch}, {.speed = 15_deg_per_s, .progress = careful::go_on});
}

/// The swing of a body: the range of angles seen on each axis.
class Swing {
 public:
  void see(const sbgc::Axes<sbgc::msg::Angle14>& angles) {
    for (std::size_t i = 0; i < lowest_.size(); ++i) {
      const double degrees = angles[i].degrees();
      lowest_[i] = is_empty_ ? degrees : std::min(lowest_[i], degrees);
      highest_[i] = is_empty_ ? degrees : std::max(highest_[i], degrees);
    }
    is_empty_ = false;
  }
  double of(std::size_t axis) const { return highest_[axis] - lowest_[axis]; }
  double widest() const { return std::max({of(0), of(1), of(2)}); }

 private:
  std::array<double, 3> lowest_{};
  std::array<double, 3> highest_{};
  bool is_empty_ = true;
};

/// The motion of frame and camera during a measurement.
struct Stabilization {
  Swing frame;
  Swing camera;
  int samples = 0;
};

void show(const Stabilization& seen) {
  std::printf("%d samples; peak-to-peak swing in degrees:\n", seen.samples);
  for (const auto& [name, swing] : {std::pair{"frame", &seen.frame}, {"camera", &seen.camera}}) {
    std::printf("  %-8s roll %6.2f   pitch %6.2f   yaw %6.2f\n", name, swing->of(0), swing->of(1),
                swing->of(2));
  }
  const double frame = seen.frame.widest();
  const double camera = seen.camera.widest();
  if (frame < 0.5) {
    std::printf("the frame stood still, or has no IMU: nothing to stabilize\n");
  } else if (camera > 0) {
    std::printf("the frame swings by %.1f degrees, the camera by %.2f: %.0f times less\n", frame,
                camera, frame / camera);
  } else {
    std::printf("the frame swings by %.1f degrees, the camera not at all\n", frame);
  }
}

sbgc::Result<void> measure(sbgc::Client& client, std::chrono::milliseconds time) {
  std::printf("measuring frame and camera for %.0f seconds\n",
              std::chrono::duration<double>(time).count());
  Stabilization seen;
  {
    const auto start = [&](std::chrono::milliseconds interval) {
      return client.stream<sbgc::msg::RealtimeData4>(interval,
                                                     [&seen](const sbgc::msg::RealtimeData4& data) {
                                                       seen.frame.see(data.frame_imu_angle);
                                                       seen.camera.see(data.angle);
                                                       ++seen.samples;
                                                     });
    };
    auto stream = start(40ms);
    if (!stream) stream = start(250ms);  // a slow line has no bandwidth for more
    if (!stream) return stream.error();
    std::this_thread::sleep_for(time);
  }  // the stream has ended, so no more samples arrive
  show(seen);
  return {};
}

/// The part for which the motors are on.
sbgc::Result<void> move(sbgc::Client& client) {
  careful::Motors motors(client);
  if (auto on = motors.turn_on(); !on) return on;
  constexpr sbgc::msg::Angle14 down = 30_deg;
  constexpr sbgc::msg::Angle14 level = 0_deg;
  for (const sbgc::msg::Angle14 pitch : {down, level}) {
    const auto moved = tilt(client, pitch);
    if (!moved) return moved.error();
    std::printf("pitch is %.1f degrees\n", moved->angles.pitch.degrees());
  }
  if (auto measured = measure(client, 4s); !measured) return measured;
  return client.release();
}

}  // namespace

int main(int argc, char** argv) {
  const bool yes = careful::take_yes_flag(argc, argv);
  if (argc != 4) {
    std::fprintf(stderr, "usage: tour ADDRESS CAPTURE BACKUP [--yes]\n");
    return 2;
  }

  // Detects baud rate and parity; traffic is recorded from here on. Many retries tolerate a host
  // that stalls for a second or two.
  auto client = sbgc::Client::connect(argv[1], {.retries = 9, .capture = argv[2]});
  if (!client) return fail(client.error());
  std::printf("board %s, firmware %s, on %s\n", client->identity().board_version().c_str(),
              client->identity().firmware_version().c_str(), client->description().c_str());

  const auto backup = client->make_backup();
  if (!backup) return fail(backup.error());
  if (auto saved = sbgc::save_backup(*backup, argv[3]); !saved) return fail(saved.error());
  std::printf("the parameters of %zu messages saved in %s\n", backup->parameters.all().size(),
              argv[3]);

  using namespace sbgc::literals;
  if (!careful::may_tilt(yes, *client, 30_deg,
                         "This turns the motors on; at the end the camera turns to pitch 0. "))
    return 1;
  careful::notice_signals();
  if (auto moved = move(*client); !moved) return fail(moved.error());
}
