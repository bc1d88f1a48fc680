#include "share/web_socket.hpp"

#include <algorithm>
#include <cstdint>
#include <span>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include <asio/post.hpp>
#include <fmt/format.h>

#include "hosts/listen.hpp"
#include "share/web_socket_server.hpp"

namespace sbgc::tools {

namespace {

using Block = WebSocketServer::Bytes;
using SessionId = WebSocketServer::SessionId;

constexpr std::size_t most_per_write = 4096;

/// Transfers bytes between sessions and ports. Events on the server's thread are passed to the
/// executor.
class WebSocketEndpoint final : public hosts::Endpoint {
 public:
  WebSocketEndpoint(asio::any_io_executor executor, hosts::HostPorts& ports,
                    const hosts::ListenAddress& address, const WebSocketAccess& access,
                    hosts::EndpointLogs logs)
      : executor_(std::move(executor)),
        ports_(ports),
        logs_(std::move(logs)),
        server_(hosts::address_of(address).to_string(), address.port, access, events()) {
    if (!server_.is_loopback()) logs_.warning(server_.address() + " is open to any other machine");
  }
  WebSocketEndpoint(const WebSocketEndpoint&) = delete;
  WebSocketEndpoint& operator=(const WebSocketEndpoint&) = delete;
  ~WebSocketEndpoint() override {
    for (const auto& [id, host] : hosts_) ports_.disconnect(host.port);
  }

  std::string address() const override { return server_.address(); }

 private:
  struct Host {
    std::string name{};
    std::size_t port{};
    Block input{};
    bool is_reading = true;  // the session waits for the next message
    bool is_writing = false;
  };

  WebSocketServer::Events events() {
    // The executor no longer runs when this is destroyed.
    const auto hand_over = [this](auto function) { asio::post(executor_, std::move(function)); };
    return {
        .opened = [=, this](SessionId id,
                            const std::string& name) { hand_over([=, this] { open(id, name); }); },
        .received =
            [=, this](SessionId id, Block bytes) {
              hand_over([this, id, bytes = std::move(bytes)]() mutable {
                const auto host = hosts_.find(id);
                if (host == hosts_.end()) return;
                host->second.input = std::move(bytes);
                host->second.is_reading = false;
                pump(id);
              });
            },
        .written =
            [=, this](SessionId id) {
              hand_over([=, this] {
                const auto host = hosts_.find(id);
                if (host == hosts_.end()) return;
                host->second.is_writing = false;
                pump(id);
              });
            },
        .closed = [=, this](SessionId id) { hand_over([=, this] { close(id); }); },
        .refused =
            [=, this](const std::string& reason) {
              hand_over([=, this] { logs_.warning(reason); });
            },
    };
  }

  void open(SessionId id, const std::string& name) {
    const auto port = ports_.connect(false, [this, id] { pump(id); });
    if (!port) {
      logs_.warning(name + " refused: all places are in use");
      return server_.close(id, "all places are in use");
    }
    hosts_[id] = {name, *port};
    logs_.event(fmt::format("{} is host {}", name, *port));
  }

  void close(SessionId id) {
    const auto host = hosts_.find(id);
    if (host == hosts_.end()) return;
    ports_.disconnect(host->second.port);
    logs_.event(host->second.name + " has left");
    hosts_.erase(host);
  }

  void pump(SessionId id) {
    const auto place = hosts_.find(id);
    if (place == hosts_.end()) return;
    Host& host = place->second;
    while (!host.input.empty() && ports_.room(host.port) != 0) {
      const std::size_t size = std::min(ports_.room(host.port), host.input.size());
      const auto end = host.input.begin() + static_cast<std::ptrdiff_t>(size);
      const Block part(host.input.begin(), end);
      host.input.erase(host.input.begin(), end);  // first, because the ports may call back
      ports_.receive(host.port, part);
    }
    if (host.input.empty() && !std::exchange(host.is_reading, true)) server_.read_next(id);
    const std::span<const std::uint8_t> waiting = ports_.output(host.port);
    if (waiting.empty() && !host.is_writing && ports_.must_leave(host.port)) {
      // Deferred, because this may be a call from the ports.
      return asio::post(executor_, [this, id] {
        server_.close(id, "it did not read in time, or it was silent and its place is needed");
        close(id);
      });
    }
    if (waiting.empty() || std::exchange(host.is_writing, true)) return;
    const std::size_t size = std::min(waiting.size(), most_per_write);
    Block bytes(waiting.begin(), waiting.begin() + static_cast<std::ptrdiff_t>(size));
    ports_.take(host.port, size);
    server_.write(id, std::move(bytes));
  }

  asio::any_io_executor executor_;
  hosts::HostPorts& ports_;
  hosts::EndpointLogs logs_;
  std::unordered_map<SessionId, Host> hosts_{};
  WebSocketServer server_;  // last: its thread ends first
};

}  // namespace

std::unique_ptr<hosts::Endpoint> listen_web_socket(const asio::any_io_executor& executor,
                                                   hosts::HostPorts& ports,
                                                   const hosts::ListenAddress& address,
                                                   const WebSocketAccess& access,
                                                   const hosts::EndpointLogs& logs) {
  return std::make_unique<WebSocketEndpoint>(executor, ports, address, access, logs);
}

}  // namespace sbgc::tools
