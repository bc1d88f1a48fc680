/// The line between client and board: its kind, which is the same in all tests of a program, and
/// hooks into its traffic, for tests that inspect or modify it.
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <asio/any_io_executor.hpp>

#include <sbgc/client/own_transport.hpp>
#include <sbgc/frame.hpp>
#include <sbgc/io/transport.hpp>
#include <sbgc/message.hpp>
#include <sbgc/parser.hpp>

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

class Tap;

/// Hooks for the packets between a host and the board. Used on the board's thread only.
struct TapHooks {
  /// All requests, in order.
  Packets log{};
  /// Returns true if a request is to be lost on the line.
  std::function<bool(const Packet&)> is_lost{};
  /// Returns true if everything the board sends between this request and the next is to be lost.
  std::function<bool(const Packet&)> is_answer_lost{};
  /// Modifies the board's messages before they are sent.
  std::function<void(Packets&)> tamper{};
  /// Called when the board has executed a request, before its responses are sent.
  std::function<void(const Packet&)> after{};

  Tap* tap = nullptr;  ///< of the current host
};

/// A transport with hooks at packet level: it delivers requests one by one and discards bytes
/// outside of frames. Its owner reports when the board has executed a request.
class Tap final : public io::Transport {
 public:
  Tap(std::unique_ptr<io::Transport> inner, TapHooks& hooks);
  Tap(const Tap&) = delete;
  Tap& operator=(const Tap&) = delete;
  ~Tap() override;

  void async_read(std::span<std::uint8_t> into, Handler handler) override;
  void async_write(std::span<const std::uint8_t> bytes, Handler handler) override;
  void close() override;
  asio::any_io_executor executor() override { return inner_->executor(); }
  std::string description() const override { return inner_->description(); }
  io::LineControl* line() override { return inner_->line(); }

  /// Reports that the board has executed the delivered requests. Its responses are sent now.
  void request_executed();
  /// Breaks the line.
  void unplug() { inner_->close(); }

 private:
  struct Reading {
    std::span<std::uint8_t> into{};
    Handler handler{};
  };
  struct Writing {
    std::size_t size{};
    Handler handler{};
  };

  /// Prepares the next request that is not lost for reading; returns false if there is none.
  bool prepare();
  void deliver(std::span<std::uint8_t> into, Handler& handler);
  void send(Writing writing);

  std::unique_ptr<io::Transport> inner_;
  TapHooks& hooks_;
  bool is_closed_ = false;

  // From the host
  std::array<std::uint8_t, 4096> in_{};
  ParserOfAll requests_;
  std::deque<Packet> arrived_{};
  std::optional<Packet> request_{};  // the last one
  std::vector<std::uint8_t> ready_;  // the remaining bytes of its frame

  // From the board
  ParserOfAll answers_;
  Packets leaving_{};
  std::vector<std::uint8_t> out_;

  // While the board executes a request
  bool is_busy_ = false;
  std::optional<Reading> reading_{};
  std::optional<Writing> writing_{};
};

enum class LineKind : std::uint8_t { memory, terminal, tcp };

/// Returns the kind given by the environment variable SBGC_TEST_LINE: "memory" (the default), "pty"
/// or "tcp". Throws std::runtime_error for any other value.
LineKind line_kind();

/// Opens an address. Throws std::runtime_error on failure.
TransportFactory over(std::string address);

/// Listens on a free port of this machine, on `executor`, and calls `serve` with the first
/// connection. Returns the address.
std::string accept_once(const asio::any_io_executor& executor,
                        std::function<void(std::unique_ptr<io::Transport>)> serve);

}  // namespace sbgc::test
