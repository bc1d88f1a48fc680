// Commands angles and reads them, with a session.

#include <sbgc/messages/control.hpp>
#include <sbgc/responses/control.hpp>

#include "device.hpp"
#include "session.hpp"

SmallSession<sbgc::msg::Control::max_size> session;
decltype(sbgc::msg::GetAngles::axes) axes{};

void take(const sbgc::Event& event) {
  if (event.outcome != sbgc::Outcome::answered) return;
  sbgc::msg::GetAngles angles;
  if (sbgc::decode(event.frame.body, angles)) axes = angles.axes;
  device::use(axes);
}

void send_requests() {
  using namespace sbgc::literals;
  const sbgc::msg::Angle14 pitch{device::input()};
  session.send(sbgc::msg::Control{.control_mode = sbgc::msg::ControlMode::angle,
                                  .axes = {.roll = {.speed = 10_deg_per_s},
                                           .pitch = {.speed = 10_deg_per_s, .angle = pitch},
                                           .yaw = {.speed = 10_deg_per_s}}});
  session.send(sbgc::msg::GetAnglesRequest{});
}

int main() {
  while (true) {
    send_requests();
    session.feed(device::received(), device::now(), take);
    device::send(session.poll(device::now(), take).bytes);
  }
}
