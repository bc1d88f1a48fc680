/// Messages without their frames.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <sbgc/frame.hpp>
#include <sbgc/message.hpp>

namespace sbgc::test {

/// A message without its frame.
struct Packet {
  std::uint8_t id{};
  std::vector<std::uint8_t> body{};
  Framing framing = basic_framing;

  /// The framing does not matter.
  bool operator==(const Packet& other) const { return id == other.id && body == other.body; }
};

using Packets = std::vector<Packet>;

template <class M>
Packet packet(const M& message) {
  Packet result{static_cast<std::uint8_t>(M::command), std::vector<std::uint8_t>(255)};
  result.body.resize(encode(message, result.body).size);
  return result;
}

/// Returns the message in a packet. Precondition: the packet holds an M.
template <class M>
M message(const Packet& packet) {
  M result{};
  static_cast<void>(decode(std::span(packet.body), result));
  return result;
}

template <class M>
bool is(const Packet& packet) {
  return packet.id == static_cast<std::uint8_t>(M::command);
}

/// Returns the frame of a packet.
inline std::vector<std::uint8_t> to_frame(const Packet& packet) {
  std::vector<std::uint8_t> result(max_frame_size);
  result.resize(write_frame(packet.framing, packet.id, packet.body, result).size);
  return result;
}

}  // namespace sbgc::test
