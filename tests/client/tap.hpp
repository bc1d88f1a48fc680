/// What a board gets and what it answers, for tests that look at it or change it.
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include <sbgc/io/transport.hpp>
#include <sbgc/parser.hpp>

#include "packet.hpp"

namespace sbgc::test {

class Tap;

/// What happens to packets between a host and the board. Used on the board's thread only.
struct TapHooks {
  /// All requests, in order.
  Packets log{};
  /// Whether a request is lost on its way.
  std::function<bool(const Packet&)> is_lost{};
  /// Whether what the board sends between this request and the next one is lost on its way.
  std::function<bool(const Packet&)> is_answer_lost{};
  /// Changes what the board sends, before it is sent.
  std::function<void(Packets&)> tamper{};
  /// Called when the board has dealt with a request, before its answers are sent.
  std::function<void(const Packet&)> after{};

  Tap* tap = nullptr;  ///< of the present host
};

/// A transport with hooks at packet level: requests are read from it one by one, and bytes that are
/// no frames are left out. Who owns it tells when the board has dealt with a request.
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

  /// The board has dealt with what it has got. What it has sent meanwhile leaves now.
  void dealt_with();
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

  /// Makes the next request that is not lost ready to be read; false if there is none.
  bool prepare();
  void deliver(std::span<std::uint8_t> into, Handler& handler);
  void send(Writing writing);

  std::unique_ptr<io::Transport> inner_;
  TapHooks& hooks_;
  bool is_closed_ = false;

  // From the host
  std::array<std::uint8_t, 4096> in_{};
  Parser requests_;
  std::deque<Packet> arrived_{};
  std::optional<Packet> request_{};  // the last one
  std::vector<std::uint8_t> ready_;  // what is left of its frame

  // From the board
  Parser answers_;
  Packets leaving_{};
  std::vector<std::uint8_t> out_;

  // While the board deals with a request
  bool is_busy_ = false;
  std::optional<Reading> reading_{};
  std::optional<Writing> writing_{};
};

}  // namespace sbgc::test
