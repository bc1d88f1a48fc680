// Generated from spec/ by generator/: edit those, then run ./dev generate.

/// The serial line settings that boards use.
/// Source: Message format (L35-L41); Variables L1031.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include <sbgc/line.hpp>

namespace sbgc {

/// Baud rates, the most likely first.
inline constexpr std::array<std::uint32_t, 9> baud_rates{115200, 57600, 38400, 19200, 9600, 256000, 230400, 460800, 921600};
/// The number of leading baud rates that the protocol names; the others are also in use.
inline constexpr std::size_t named_baud_rates = 6;
/// Parities, the most likely first.
inline constexpr std::array<Parity, 2> parities{Parity::none, Parity::even};
/// The settings of a new board.
inline constexpr LineSettings default_line{baud_rates[0], parities[0]};

}  // namespace sbgc
