// A tour of a gimbal: finds it, saves its settings, turns the camera 30 degrees down and back while
// it shows the angles, and keeps all that was said in a capture:
//
//     tour ADDRESS CAPTURE BACKUP
//
// ADDRESS is a serial port such as /dev/ttyUSB0, or tcp:host:port.

#include <chrono>
#include <cstdio>

#include <sbgc/client/backup.hpp>
#include <sbgc/client/client.hpp>
#include <sbgc/client/motion.hpp>
#include <sbgc/messages/control.hpp>
#include <sbgc/messages/realtime.hpp>

namespace {

using namespace std::chrono_literals;

int fail(const sbgc::ClientError& error) {
  std::fprintf(stderr, "%s\n", error.message.c_str());
  return 1;
}

void show(const sbgc::RealtimeData4& data) {
  std::printf("  roll %7.2f   pitch %7.2f   yaw %7.2f\n", data.angle.roll.degrees(),
              data.angle.pitch.degrees(), data.angle.yaw.degrees());
}

sbgc::Result<sbgc::MoveProgress> tilt(sbgc::Client& client, sbgc::Angle14 pitch) {
  std::printf("pitch to %.0f degrees\n", pitch.degrees());
  return sbgc::move_to(client, {.pitch = pitch}, sbgc::ControlSpeed::from_degrees_per_second(25.0));
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 4) {
    std::fprintf(stderr, "usage: tour ADDRESS CAPTURE BACKUP\n");
    return 2;
  }

  // The baud rate and the parity are found by trying; what is said from here on is recorded. A
  // machine that stands still for a second or two is no reason to end.
  auto client = sbgc::Client::connect(argv[1], {.retries = 9, .capture = argv[2]});
  if (!client) return fail(client.error());
  std::printf("board %s, firmware %s, on %s\n", client->board().board().c_str(),
              client->board().firmware().c_str(), client->description().c_str());

  const auto backup = sbgc::make_backup(*client);
  if (!backup) return fail(backup.error());
  if (auto saved = sbgc::save_backup(*backup, argv[3]); !saved) return fail(saved.error());
  std::printf("%zu blocks of settings saved in %s\n", backup->settings.blocks().size(), argv[3]);

  if (auto on = client->motors_on(); !on) return fail(on.error());
  const auto stream = client->stream<sbgc::RealtimeData4>(250ms, show);
  if (!stream) return fail(stream.error());
  constexpr sbgc::Angle14 down = sbgc::Angle14::from_degrees(-30.0);
  constexpr sbgc::Angle14 level = sbgc::Angle14::from_degrees(0.0);
  for (const sbgc::Angle14 pitch : {down, level}) {
    const auto moved = tilt(*client, pitch);
    if (!moved) return fail(moved.error());
    std::printf("pitch is %.1f degrees\n", moved->angles.pitch.degrees());
  }
  if (auto released = sbgc::release(*client); !released) return fail(released.error());
}
