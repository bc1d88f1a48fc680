// Decodes a frame whose type the program does not know, and lists its values: a logger in ten
// lines.

#include <array>
#include <cstdint>
#include <cstdio>

#include <sbgc/any.hpp>
#include <sbgc/message.hpp>
#include <sbgc/parser.hpp>

int main() {
  using namespace sbgc;
  using namespace sbgc::literals;
  std::array<std::uint8_t, max_frame_size> bytes{};
  const auto written = encode_frame(msg::GetAngles{.axes = {.yaw = {.imu_angle = 45_deg}}}, bytes);

  Parser parser;
  parser.feed({bytes.data(), written.size}, [](const Frame& frame) {
    const MessageType* const type =
        find_message(Direction::from_board, frame.id, frame.body.size());
    if (type == nullptr) return;
    AnyMessage message = type->make();
    if (!message.decode(frame.body)) return;
    std::printf("%s\n", type->info->name);
    message.for_each_leaf([](const Leaf& leaf) {
      std::printf("  %s = %s\n", to_string(leaf.path).c_str(), value_text(leaf).c_str());
    });
  });
}
