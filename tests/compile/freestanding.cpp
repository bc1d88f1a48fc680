// Compiled, not run: the core as built for a microcontroller, without exceptions, RTTI or a hosted
// library. CMakeLists.txt sets the flags.

#include <cstddef>
#include <cstdint>
#include <span>

#include <sbgc/checksum.hpp>
#include <sbgc/frame.hpp>
#include <sbgc/framing.hpp>
#include <sbgc/parser.hpp>
#include <sbgc/status.hpp>
#include <sbgc/wire.hpp>

struct Receiver {
  sbgc::Parser parser;
  std::uint16_t newest{};
};

void on_byte(Receiver& receiver, std::uint8_t byte) {
  receiver.parser.feed({&byte, 1}, [&](const sbgc::Frame& frame) noexcept {
    if (frame.body.size() < 2) return;
    receiver.newest = sbgc::wire::load<std::uint16_t>(frame.body.data());
  });
}

void on_idle(Receiver& receiver) {
  receiver.parser.flush([](const sbgc::Frame&) noexcept {});
}

std::size_t answer(const Receiver& receiver, std::span<std::uint8_t> out) {
  std::uint8_t body[2];
  sbgc::wire::store(body, receiver.newest);
  return sbgc::write_frame(86, body, out).size;
}
