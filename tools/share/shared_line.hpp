/// The line to a gimbal that several programs use.
#pragma once

#include <condition_variable>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <asio/any_io_executor.hpp>
#include <asio/io_context.hpp>

#include <sbgc/client/client.hpp>

#include "board/connection.hpp"
#include "share/bridge_ports.hpp"
#include "share/line_gate.hpp"

namespace sbgc::tools {

/// Sends the requests of a bridge with a client. Events on the client's thread are passed to the
/// bridge on its executor.
class BridgeClient final : public BridgeLine {
 public:
  /// The executor must no longer run when this is destroyed.
  /// The transports of the client pass through the gate.
  BridgeClient(asio::any_io_executor executor, Client client, LineGate& gate);
  BridgeClient(const BridgeClient&) = delete;
  BridgeClient& operator=(const BridgeClient&) = delete;
  ~BridgeClient() override;

  /// Begins to forward the board's messages; `on_change` is called on the executor.
  void begin(BridgePorts& ports, std::function<void(const LinkChange&)> on_change);

  void send(std::uint64_t tag, RawRequest request) override;
  void take_line() override { gate_.take(); }
  void write_raw(std::vector<std::uint8_t> bytes) override { gate_.write(std::move(bytes)); }
  std::size_t raw_waiting() const override { return gate_.waiting(); }
  void give_line_back() override { gate_.give_back(); }
  void release_line() override { gate_.release(); }
  void check() override { client_.check(); }
  void take_over(OwedStop stop) override;
  void drop_stops() override;

  Client& client() { return client_; }

 private:
  void go_on_with_stops(const std::stop_token& end);

  asio::any_io_executor executor_;
  LineGate& gate_;
  BridgePorts* ports_ = nullptr;
  std::function<void(const LinkChange&)> on_change_;
  Client client_;
  Subscription frames_;
  Subscription changes_;

  std::mutex stops_mutex_;
  std::condition_variable_any stops_changed_;
  std::vector<OwedStop> stops_;
  std::uint64_t drops_ = 0;
  std::jthread stopper_;  // waits for the attempts
};

/// A client that reconnects by itself, and ports for programs. Everything but the client is used on
/// the context, which must no longer run when this is destroyed.
class SharedLine {
 public:
  struct Settings {
    bool allows_passwords = false;
    Wrap wrap{};  ///< applied to the transport first
    std::function<void(const std::string&)> log{};
    std::function<void(const LinkChange&)> on_change{};  ///< but not for restarts of the board
  };

  /// Connects. Throws CommandError.
  SharedLine(asio::io_context& context, const GimbalOptions& gimbal, Settings settings);
  SharedLine(const SharedLine&) = delete;
  SharedLine& operator=(const SharedLine&) = delete;
  ~SharedLine() = default;

  Client& client() { return line_.client(); }
  BridgePorts& ports() { return ports_; }
  /// Must be called about ten times per second.
  void tick() { ports_.tick(); }

 private:
  Client connect(const GimbalOptions& gimbal);
  void changed(const LinkChange& change);

  Settings settings_;
  LineGate gate_;
  BridgeClient line_;
  BridgePorts ports_;
};

}  // namespace sbgc::tools
