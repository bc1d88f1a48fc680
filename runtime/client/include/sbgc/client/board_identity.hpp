/// Which board is connected.
#pragma once

#include <optional>
#include <string>

#include <sbgc/availability.hpp>
#include <sbgc/messages/system.hpp>

namespace sbgc {

/// What a board has told about itself when the client connected.
struct BoardIdentity {
  msg::BoardInfo info{};
  std::optional<msg::BoardInfo3> details{};  ///< of boards that have serial numbers

  constexpr Availability versions() const noexcept { return versions_of(info); }
  bool has(msg::BoardFeature feature) const noexcept { return info.board_features.has(feature); }
  /// "2.59", "2.43b9".
  std::string firmware_version() const;
  /// "3.0".
  std::string board_version() const;
  /// Its serial number in hex digits; "" if the board has not told it.
  std::string serial_number() const;
};

}  // namespace sbgc
