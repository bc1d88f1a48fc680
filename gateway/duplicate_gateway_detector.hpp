/// Notices another gateway of the same fleet.
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>

#include <sbgc/json_dom.hpp>

namespace sbgc::tools {

/// Two gateways with one client id take the connection to the broker from each other. Each puts its
/// name into the retained state of the gateway. Who has read its own name there, and then the
/// other's, knows that the other is alive: it is not what an earlier process has left behind.
class DuplicateGatewayDetector {
 public:
  using Clock = std::chrono::steady_clock;

  DuplicateGatewayDetector();

  /// Puts the name of this gateway into its state.
  void sign(Json& state) const;
  /// Takes the payload of a state. Returns true if this gateway gives way: the one that has started
  /// later does.
  bool read(const std::string& state, Clock::time_point now);

 private:
  /// When a gateway has started, as Unix time in milliseconds, and a random word.
  using Name = std::pair<std::int64_t, std::string>;

  const Name name_;
  bool has_read_own_ = false;
  std::optional<Clock::time_point> noticed_{};
};

}  // namespace sbgc::tools
