// Encodes a command that turns the camera slowly to 45 degrees, then decodes it.

#include <array>
#include <cstdint>
#include <cstdio>

#include <sbgc/message.hpp>
#include <sbgc/parser.hpp>
#include <sbgc/visit.hpp>

using namespace sbgc::literals;
namespace msg = sbgc::msg;

int main() {
  // Speed 0 selects the speed in the board's parameters, so every axis gets one.
  const msg::Control control{.control_mode = msg::ControlMode::angle,
                             .axes = {.roll = {.speed = 10_deg_per_s},
                                      .pitch = {.speed = 10_deg_per_s},
                                      .yaw = {.speed = 10_deg_per_s, .angle = 45_deg}}};
  std::array<std::uint8_t, sbgc::max_frame_size> frame{};
  const auto written = sbgc::encode_frame(control, frame);  // send written.size bytes of frame

  sbgc::Parser parser;  // accepts chunks of any size
  parser.feed({frame.data(), written.size}, [](const sbgc::Frame& found) {
    sbgc::visit(found, sbgc::Direction::to_board, [](const msg::Control& message) {
      std::printf("yaw: %g degrees\n", message.axes.yaw.angle.degrees());
    });
  });
}
