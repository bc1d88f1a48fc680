// Commands angles and reads them, without a session.

#include <array>

#include <sbgc/message.hpp>
#include <sbgc/messages/control.hpp>
#include <sbgc/small_parser.hpp>

#include "device.hpp"

sbgc::SmallParser parser;
decltype(sbgc::msg::GetAngles::axes) axes{};
std::array<std::uint8_t, 2 * sbgc::frame_size<sbgc::basic_framing>(sbgc::msg::Control::max_size)>
    out;

std::size_t write_requests() {
  using namespace sbgc::literals;
  const sbgc::msg::Angle14 pitch{device::input()};
  const sbgc::msg::Control control{.control_mode = sbgc::msg::ControlMode::angle,
                                   .axes = {.roll = {.speed = 10_deg_per_s},
                                            .pitch = {.speed = 10_deg_per_s, .angle = pitch},
                                            .yaw = {.speed = 10_deg_per_s}}};
  const std::size_t size = sbgc::encode_frame(control, out).size;
  return size +
         sbgc::encode_frame(sbgc::msg::GetAnglesRequest{}, std::span(out).subspan(size)).size;
}

int main() {
  while (true) {
    device::send({out.data(), write_requests()});
    parser.feed(device::received(), [](const sbgc::Frame& frame) noexcept {
      if (frame.id != static_cast<std::uint8_t>(sbgc::msg::GetAngles::command)) return;
      sbgc::msg::GetAngles angles;
      if (sbgc::decode(frame.body, angles)) axes = angles.axes;
      device::use(axes);
    });
  }
}
