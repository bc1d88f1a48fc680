/// What a client has seen and done so far.
#pragma once

#include <cstdint>

#include <sbgc/session/event.hpp>

namespace sbgc {

struct ClientStatistics {
  std::uint64_t calls{};        ///< begun
  std::uint64_t failures{};     ///< calls that ended with an error
  std::uint64_t unreadable{};   ///< messages for a subscriber that could not be decoded
  SessionStatistics session{};  ///< frames and noise on the line, retries, late answers
  StreamUsage streams{};        ///< what data streams take of the line
};

}  // namespace sbgc
