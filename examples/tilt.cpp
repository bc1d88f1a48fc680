// Tilts the camera to 30 degrees down, slowly: tilt ADDRESS, such as /dev/ttyUSB0. The motors must
// be on.

#include <iostream>

#include "careful.hpp"

int main(int argc, char** argv) {
  using namespace sbgc::literals;
  if (argc != 2) return 1;
  auto gimbal = sbgc::Client::connect(argv[1]);
  if (!gimbal) return std::cerr << gimbal.error().message << '\n', 1;
  if (!careful::may_tilt(false, *gimbal, 30_deg)) return 1;
  careful::notice_signals();
  const auto moved =
      gimbal->move_to({.pitch = 30_deg}, {.speed = 10_deg_per_s, .progress = careful::go_on});
  if (!moved) return std::cerr << moved.error().message << '\n', 1;
}
