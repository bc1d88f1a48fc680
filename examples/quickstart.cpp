// Connects to a gimbal, tilts the camera to 30 degrees down, then prints its angles for two
// seconds:
//
//     quickstart /dev/ttyUSB0
//
// It asks before it moves anything, unless the last argument is --yes. Read docs/2-safety.md before
// you move a gimbal.

#include <chrono>
#include <cstdio>
#include <thread>

#include <sbgc/client/client.hpp>
#include <sbgc/client/motion.hpp>
#include <sbgc/messages/control.hpp>
#include <sbgc/messages/realtime.hpp>

#include "careful.hpp"

namespace {

int fail(const sbgc::ClientError& error) {
  std::fprintf(stderr, "%s\n", error.message.c_str());
  return 1;
}

}  // namespace

int main(int argc, char** argv) {
  using namespace sbgc::literals;
  using namespace std::chrono_literals;
  const bool yes = careful::take_yes_flag(argc, argv);
  if (argc != 2) {
    std::fprintf(stderr,
                 "usage: quickstart ADDRESS [--yes], e.g. /dev/ttyUSB0 or tcp:gimbal.local:5000\n");
    return 2;
  }

  auto client = sbgc::Client::connect(argv[1]);
  if (!client) return fail(client.error());
  std::printf("board %s, firmware %s, on %s\n", client->identity().board_version().c_str(),
              client->identity().firmware_version().c_str(), client->description().c_str());

  if (!careful::may_tilt(yes, *client, 30_deg, "This turns the motors on. ")) return 1;
  careful::notice_signals();
  careful::Motors motors(*client);
  if (auto on = motors.turn_on(); !on) return fail(on.error());
  const auto moved =
      client->move_to({.pitch = 30_deg}, {.speed = 10_deg_per_s, .progress = careful::go_on});
  if (!moved) return fail(moved.error());

  const auto stream =
      client->stream<sbgc::msg::RealtimeData4>(100ms, [](const sbgc::msg::RealtimeData4& data) {
        std::printf("roll %6.1f  pitch %6.1f  yaw %6.1f degrees\n", data.angle.roll.degrees(),
                    data.angle.pitch.degrees(), data.angle.yaw.degrees());
      });
  if (!stream) return fail(stream.error());
  std::this_thread::sleep_for(2s);
}
