// Reads telemetry: finds the frames of CMD_REALTIME_DATA_4 and decodes them.

#include <sbgc/message.hpp>
#include <sbgc/messages/realtime.hpp>
#include <sbgc/small_parser.hpp>

#include "device.hpp"

sbgc::SmallParser parser;
sbgc::msg::RealtimeData4 newest{};  // with {}, g++ needs no code to initialize it

int main() {
  while (true) {
    parser.feed(device::received(), [](const sbgc::Frame& frame) noexcept {
      if (frame.id != static_cast<std::uint8_t>(sbgc::msg::RealtimeData4::command)) return;
      if (sbgc::decode(frame.body, newest)) device::use(newest);
    });
  }
}
