/// One host at a port of a board.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <system_error>
#include <vector>

#include <asio/steady_timer.hpp>

#include <sbgc/io/clock.hpp>
#include <sbgc/io/transport.hpp>

#include "hosts/endpoint.hpp"

namespace sbgc::hosts {

/// Transfers bytes between a transport and a port. Reads no faster than the board's line and
/// buffers a few KiB for a slow host. After the end of its input, a host still receives its
/// responses, unless it does not read them for some seconds.
class Host : public std::enable_shared_from_this<Host> {
 public:
  /// Connects a host to the board; returns null if all ports are in use.
  static std::shared_ptr<Host> connect(HostPorts& board, std::unique_ptr<io::Transport> transport);

  /// Called once at the end, except after close(). No error means that the host has left.
  std::function<void(std::error_code)> on_end{};
  /// Called before bytes are transferred in either direction, to check the line settings of the
  /// host.
  std::function<void(std::size_t port)> before_bytes{};

  void start();
  void close();

  std::size_t port() const { return port_; }

 private:
  Host(HostPorts& board, std::unique_ptr<io::Transport> transport);

  void wake();
  void read();
  void write();
  void finish_reading(std::error_code error);
  void end_or_linger();
  void linger();
  void end(std::error_code error);

  HostPorts& board_;
  std::unique_ptr<io::Transport> transport_;
  asio::steady_timer linger_;
  io::Clock::time_point written_at_{};  // the last start or end of a write, or the end of the input
  std::size_t port_ = 0;
  std::array<std::uint8_t, 2048> input_{};
  std::vector<std::uint8_t> output_{};  // being written
  bool is_reading_ = false;
  bool is_writing_ = false;
  bool has_read_all_ = false;  // or has stopped reading
  bool is_closed_ = true;
};

}  // namespace sbgc::hosts
