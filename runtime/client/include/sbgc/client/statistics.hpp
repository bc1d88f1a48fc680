/// Counters of a client.
#pragma once

#include <cstdint>

#include <sbgc/session/event.hpp>

namespace sbgc {

struct ClientStatistics {
  std::uint64_t calls{};        ///< started
  std::uint64_t failures{};     ///< ended with an error
  std::uint64_t unreadable{};   ///< messages for a subscriber that could not be decoded
  SessionStatistics session{};  ///< frames and noise on the line, retries, late replies
  StreamUsage streams{};        ///< the share of the line that data streams use
};

}  // namespace sbgc
