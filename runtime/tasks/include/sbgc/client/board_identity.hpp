/// The identity of a connected board.
#pragma once

#include <optional>
#include <string>

#include <sbgc/availability.hpp>
#include <sbgc/messages/system.hpp>

namespace sbgc {

/// The identity that a board reports when the client connects.
struct BoardIdentity {
  msg::BoardInfo info{};                     ///< board, firmware, features
  std::optional<msg::BoardInfo3> details{};  ///< only of boards that have serial numbers

  /// Its versions, and the features that it lacks.
  constexpr Availability versions() const noexcept {
    Availability result = versions_of(info);
    if (details) result.features |= lacking_features(*details);
    return result;
  }
  /// True if the board has this feature.
  bool has(msg::BoardFeature feature) const noexcept { return info.board_features.has(feature); }
  /// For example "2.59" or "2.43b9".
  std::string firmware_version() const;
  /// For example "3.0".
  std::string board_version() const;
  /// The explanation of an implausible version: "unknown; the sensors are often unplugged" for
  /// 0.00; otherwise "".
  std::string firmware_problem() const;
  /// The serial number in hex digits; "" if the board does not report one.
  std::string serial_number() const;
};

}  // namespace sbgc
