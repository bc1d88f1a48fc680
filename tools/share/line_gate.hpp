/// A line that can be taken away from its client for a while.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <span>
#include <vector>

#include <sbgc/io/transport.hpp>

namespace sbgc::tools {

/// While the gate is taken, bytes from the line go to a function instead of the client, only bytes
/// of write() go to the line, and the client's writes are dropped. Thread-safe.
class LineGate {
 public:
  using Bytes = std::vector<std::uint8_t>;

  /// `on_bytes` and `on_sent`, after bytes of write(), are called on the thread of the client's
  /// transport.
  LineGate(std::function<void(Bytes)> on_bytes, std::function<void()> on_sent);
  LineGate(const LineGate&) = delete;
  LineGate& operator=(const LineGate&) = delete;
  ~LineGate() = default;

  /// Returns a transport that passes through the gate; the last one is in use.
  std::unique_ptr<io::Transport> pass(std::unique_ptr<io::Transport> transport);

  void take();
  void write(Bytes bytes);
  /// The number of bytes of write() that have not been sent.
  std::size_t waiting() const { return *waiting_; }
  /// Gives the line back: closes it when all bytes have been sent, but after two seconds at the
  /// latest, so that the client reconnects.
  void give_back();
  /// Gives the line back without closing it, unless bytes of write() are waiting.
  void release();

 private:
  class State;
  class Gated;
  /// The transport in use.
  struct Current {
    std::mutex mutex{};
    std::shared_ptr<State> state{};
  };

  /// Calls `use(state)` on the executor of the transport in use; returns false if there is none.
  template <class Use>
  bool post(Use use);

  const std::function<void(Bytes)> on_bytes_;
  const std::function<void()> on_sent_;
  const std::shared_ptr<std::atomic<std::size_t>> waiting_ =
      std::make_shared<std::atomic<std::size_t>>(0);
  const std::shared_ptr<Current> current_ = std::make_shared<Current>();
};

}  // namespace sbgc::tools
