/// What a client has seen and done so far.
#pragma once

#include <cstdint>

namespace sbgc {

struct ClientStatistics {
  std::uint64_t calls{};       ///< begun
  std::uint64_t failures{};    ///< calls that ended with an error
  std::uint64_t bytes_in{};    ///< received
  std::uint64_t bytes_out{};   ///< sent
  std::uint64_t unreadable{};  ///< messages for a subscriber that could not be decoded
};

}  // namespace sbgc
