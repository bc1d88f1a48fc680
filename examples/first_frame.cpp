// Encodes the angles of a gimbal as a frame, then finds and decodes it again.

#include <array>
#include <cstdint>
#include <cstdio>

#include <sbgc/message.hpp>
#include <sbgc/parser.hpp>
#include <sbgc/visit.hpp>

int main() {
  using namespace sbgc;
  using namespace sbgc::literals;
  std::array<std::uint8_t, max_frame_size> bytes{};
  const auto written = encode_frame(msg::GetAngles{.axes = {.yaw = {.imu_angle = 45_deg}}}, bytes);

  Parser parser;  // accepts chunks of any size
  parser.feed({bytes.data(), written.size}, [](const Frame& frame) {
    visit(frame, Direction::from_board, [](const msg::GetAngles& angles) {
      std::printf("yaw: %g degrees\n", angles.axes.yaw.imu_angle.degrees());
    });
  });
}
