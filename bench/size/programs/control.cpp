// Commands angles: one framed CMD_CONTROL.

#include <array>

#include <sbgc/message.hpp>
#include <sbgc/messages/control.hpp>

#include "device.hpp"

std::array<std::uint8_t, sbgc::frame_size<sbgc::basic_framing>(sbgc::msg::Control::max_size)> frame;

int main() {
  using namespace sbgc::literals;
  const sbgc::msg::Angle14 pitch{device::input()};
  const sbgc::msg::Control control{.control_mode = sbgc::msg::ControlMode::angle,
                                   .axes = {.roll = {.speed = 10_deg_per_s},
                                            .pitch = {.speed = 10_deg_per_s, .angle = pitch},
                                            .yaw = {.speed = 10_deg_per_s}}};
  device::send({frame.data(), sbgc::encode_frame(control, frame).size});
  return 0;
}
