/// Detects another gateway of the same fleet.
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>

#include <sbgc/json_dom.hpp>

namespace sbgc::tools {

/// Two gateways with one client id take the connection to the broker from each other. Each writes
/// its name into the retained state of the gateway. A gateway that reads its own name there, and
/// then another one, knows that the other is alive: it is not left over from an earlier process.
class DuplicateGatewayDetector {
 public:
  using Clock = std::chrono::steady_clock;

  DuplicateGatewayDetector();

  /// Adds the name of this gateway to its state.
  void sign(Json& state) const;
  /// Processes the payload of a state. Returns true if this gateway must yield, because it started
  /// later.
  bool read(const std::string& state, Clock::time_point now);

 private:
  /// The start time of a gateway, as Unix time in milliseconds, and a random word.
  using Name = std::pair<std::int64_t, std::string>;

  const Name name_;
  bool has_read_own_ = false;
  std::optional<Clock::time_point> noticed_{};
};

}  // namespace sbgc::tools
