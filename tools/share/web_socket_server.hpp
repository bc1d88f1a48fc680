/// A WebSocket server on its own thread.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "share/web_access.hpp"

namespace sbgc::tools {

/// The only user of Boost.Beast. This header does not mention Boost: Boost's Asio and the library's
/// cannot be included in one file.
class WebSocketServer {
 public:
  using Bytes = std::vector<std::uint8_t>;
  using SessionId = std::uint64_t;

  /// Called on the thread of the server, from the first opened() to closed().
  struct Events {
    std::function<void(SessionId, const std::string& name)> opened{};
    /// A message; the next one is read after read_next().
    std::function<void(SessionId, Bytes)> received{};
    std::function<void(SessionId)> written{};
    std::function<void(SessionId)> closed{};
    /// A client could not connect, for the reason in this sentence.
    std::function<void(const std::string&)> refused{};
  };

  /// `host` is a numeric address. Throws std::runtime_error if it cannot listen there.
  WebSocketServer(const std::string& host, std::uint16_t port, WebSocketAccess access,
                  Events events);
  WebSocketServer(const WebSocketServer&) = delete;
  WebSocketServer& operator=(const WebSocketServer&) = delete;
  /// Closes all sessions, without events.
  ~WebSocketServer();

  /// For example "ws://127.0.0.1:5001".
  std::string address() const;
  bool is_loopback() const;

  // On any thread; nothing happens if the session is closed.

  void read_next(SessionId session);
  /// Sends one message; the next one may be sent after Events::written.
  void write(SessionId session, Bytes bytes);
  void close(SessionId session, const std::string& reason);

 private:
  class Impl;

  std::shared_ptr<Impl> impl_;
};

}  // namespace sbgc::tools
