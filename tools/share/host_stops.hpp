/// The stops of hosts of a bridge, and whether they are done.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <sbgc/client/raw_request.hpp>
#include <sbgc/frame.hpp>
#include <sbgc/time.hpp>

#include "move/owed_stop.hpp"

namespace sbgc::tools {

/// A stop is done when the board has reported speed 0 for half a second, motors off when the board
/// has confirmed it. Motion that any host commands later ends both.
class HostStops {
 public:
  static constexpr Duration rest = sbgc::milliseconds(500);

  void asked(std::size_t port, std::uint64_t tag, const RawRequest& request);
  /// A frame has answered the request.
  void answered(std::uint64_t tag, const Frame& frame);
  /// Every frame of the board.
  void arrived(const Frame& frame, Instant now);
  /// The host has left: returns what it has commanded and what is not done.
  std::vector<OwedStop> left(std::size_t port);

 private:
  struct Debt {
    std::size_t port{};
    std::uint64_t tag{};
    OwedStop owed{};
  };

  std::vector<Debt> debts_{};
  Instant still_since_ = Instant::never;
};

}  // namespace sbgc::tools
