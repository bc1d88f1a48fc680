/// The line to a gimbal that several programs use.
#pragma once

#include <functional>
#include <memory>

#include <asio/io_context.hpp>

#include "board/reconnecting.hpp"
#include "share/bridge_client.hpp"
#include "share/bridge_ports.hpp"
#include "share/line_gate.hpp"

namespace sbgc::tools {

/// A client that connects again by itself, and ports for programs. All but the client is used on
/// the context, which must not run any more when this is destroyed.
class SharedLine {
 public:
  struct Settings {
    bool allows_passwords = false;
    Wrap wrap{};  ///< applied to the transport first
    std::function<void(const std::string&)> log{};
    std::function<void(const LinkChange&)> on_change{};  ///< but not for a restart of the board
  };

  /// Connects. Throws CommandError.
  SharedLine(asio::io_context& context, const GimbalOptions& gimbal, Settings settings);
  SharedLine(const SharedLine&) = delete;
  SharedLine& operator=(const SharedLine&) = delete;
  ~SharedLine() = default;

  Client& client() { return line_.client(); }
  BridgePorts& ports() { return ports_; }
  /// To be called about ten times per second.
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
