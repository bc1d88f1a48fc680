// Turns the camera slowly to 45 degrees, then reads what comes back over the line.

#include <array>
#include <cstdint>
#include <cstdio>
#include <type_traits>

#include <sbgc/message.hpp>
#include <sbgc/parser.hpp>
#include <sbgc/visit.hpp>

int main() {
  sbgc::msg::Control control;
  control.control_mode.set_mode(sbgc::msg::ControlModeKind::angle);
  // Speed 0 is the speed of the settings, so every axis gets one.
  for (auto* axis : {&control.axes.roll, &control.axes.pitch, &control.axes.yaw})
    axis->speed = sbgc::msg::ControlSpeed::from_degrees_per_second(10);
  control.axes.yaw.angle = sbgc::msg::Angle14::from_degrees(45);
  std::array<std::uint8_t, sbgc::max_frame_size> frame{};
  const auto written =
      sbgc::encode_frame(control, frame);  // to be sent: written.size bytes of frame

  sbgc::Parser parser;  // fed with whatever the line delivers, in pieces of any size
  parser.feed({frame.data(), written.size}, [](const sbgc::Frame& found) {
    sbgc::visit(found, sbgc::Direction::to_board, []<class M>(const M& message) {
      if constexpr (std::is_same_v<M, sbgc::msg::Control>) {
        std::printf("yaw: %g degrees\n", message.axes.yaw.angle.degrees());
      }
    });
  });
}
