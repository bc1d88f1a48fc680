/// The serial interfaces of the board: what waits to be carried out and what waits to be sent.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include <sbgc/board/board.hpp>
#include <sbgc/message.hpp>
#include <sbgc/parser.hpp>

namespace sbgc::board {

/// A request that waits for its turn.
struct Waiting {
  std::uint8_t id{};
  std::vector<std::uint8_t> body{};
};

class Ports {
 public:
  explicit Ports(const Options& options);

  std::optional<std::size_t> open(bool is_usb);
  void close(std::size_t port);
  bool is_open(std::size_t port) const;
  bool is_usb(std::size_t port) const;

  /// Sends a message, even if it has to wait for room; nothing happens if the port is closed.
  template <Message M>
  void send(std::size_t port, const M& message) {
    std::array<std::uint8_t, max_frame_size> frame{};
    const WriteResult written = encode_frame(message, frame);
    if (written) send_frame(port, std::span(frame).first(written.size));
  }
  /// The same for a sample of a stream: false, and nothing is sent, if there is no room for it now.
  template <Message M>
  bool offer(std::size_t port, const M& message) {
    std::array<std::uint8_t, max_frame_size> frame{};
    const WriteResult written = encode_frame(message, frame);
    if (!written || written.size > room(port)) return false;
    send_frame(port, std::span(frame).first(written.size));
    return true;
  }
  void send_frame(std::size_t port, std::span<const std::uint8_t> frame);
  /// Bytes that fit into the output buffer now.
  std::size_t room(std::size_t port) const;
};

}  // namespace sbgc::board
