// Talks to a gimbal: identifies the board, tilts the camera 10 degrees down and watches it arrive,
// then reads its angles until the line has been dead for a while and works again.
//
// The camera moves if CMake is configured with -DCORTEX_M_MAY_MOVE=ON; otherwise the program leaves
// out the tilt. Read docs/2-safety.md before you connect a real gimbal.

#include <sbgc/availability.hpp>
#include <sbgc/messages/control.hpp>
#include <sbgc/messages/system.hpp>
#include <sbgc/responses/control.hpp>
#include <sbgc/responses/system.hpp>

#include "gimbal.hpp"
#include "semihosting.hpp"
#include "stack.hpp"

namespace {

using namespace sbgc::literals;
using sbgc::Outcome;
namespace msg = sbgc::msg;

constexpr msg::Angle14 target = 10_deg;
constexpr msg::Angle14 tolerance = 0.5_deg;

// Not on the stack, whose size is hard to know.
Gimbal gimbal;

void print(const char* name, std::int32_t value, const char* unit) {
  semihosting::print(name);
  semihosting::print(value);
  semihosting::print(unit);
}

/// Without floating point: 16384 units are a full turn.
void print(const char* name, msg::Angle14 angle) {
  print(name, angle.raw() * 45 * 1000 / 2048, " millidegrees\n");
}

bool read_pitch(msg::Angle14& pitch) {
  msg::GetAngles angles;
  if (gimbal.ask(msg::GetAnglesRequest{}, angles) != Outcome::answered) return false;
  pitch = angles.axes.pitch.imu_angle;
  return true;
}

bool identify() {
  msg::BoardInfo info;
  // The session sends each request up to three times. A board that has just started needs longer.
  for (int attempt = 0; attempt < 2; ++attempt) {
    if (gimbal.ask(msg::BoardInfoRequest{}, info) != Outcome::answered) continue;
    print("board ", info.board_ver.raw(), "");
    print(", firmware ", info.firmware_ver.raw(), "\n");
    if (sbgc::is_supported<msg::ControlExt>(info)) return true;
    semihosting::print("its firmware is too old for this program\n");
    return false;
  }
  semihosting::print("no board answers\n");
  return false;
}

/// Turns one axis; the others stay as they are. The camera stops at an angle by itself, even if
/// this program dies.
[[maybe_unused]] bool tilt() {
  constexpr msg::ControlExt control{
      .control_mode = {.pitch = msg::ControlMode::angle},
      .axes = {.pitch = {.speed = 10_deg_per_s, .angle = target}},
  };
  const sbgc::Instant end = gimbal.now() + sbgc::seconds(20);
  while (gimbal.now() < end) {
    // Again and again, because a command can be lost. To repeat a target is harmless.
    gimbal.tell(control);
    gimbal.wait(sbgc::milliseconds(50));
    msg::Angle14 pitch;
    if (!read_pitch(pitch)) continue;
    const int distance = pitch.raw() - target.raw();
    if (distance > tolerance.raw() || distance < -tolerance.raw()) continue;
    print("arrived at ", pitch);
    return true;
  }
  semihosting::print("the camera did not arrive\n");
  return false;
}

/// Speed 0 stops the camera wherever it is.
[[maybe_unused]] void stop() {
  for (int repetition = 0; repetition < 3; ++repetition) {
    gimbal.tell(msg::Control{.control_mode = msg::ControlMode::speed});
  }
}

/// Reads the angles until the line has been dead for a while. A dead line needs no treatment: each
/// request ends with a timeout, the loop goes on, and the next request shows whether the line is
/// back.
void watch() {
  msg::Angle14 pitch;
  semihosting::print("watching\n");
  while (read_pitch(pitch)) gimbal.wait(sbgc::milliseconds(50));
  semihosting::print("the line is dead\n");
  const std::uint32_t turns = gimbal.turns();
  while (!read_pitch(pitch)) {
  }
  print("the line is back, after ", static_cast<std::int32_t>(gimbal.turns() - turns), " turns\n");
  print("pitch ", pitch);
}

}  // namespace

int main() {
  board::start();
  msg::Angle14 pitch;
  if (!identify() || !read_pitch(pitch)) return 1;
  print("pitch ", pitch);
  if constexpr (CORTEX_M_MAY_MOVE) {  // a firmware cannot ask, so whoever builds it agrees
    const bool has_arrived = tilt();
    stop();
    if (!has_arrived) return 1;
  } else {
    semihosting::print("no tilt: configure with -DCORTEX_M_MAY_MOVE=ON\n");
  }
  watch();
  print("stack ", static_cast<std::int32_t>(stack::used()), " bytes\n");
  return 0;
}
