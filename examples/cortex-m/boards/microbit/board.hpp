// The BBC micro:bit, whose nRF51822 has a Cortex-M0: the same instructions as a Cortex-M0+.
#pragma once

#include <cstdint>
#include <span>

namespace board {

inline volatile std::uint32_t& at(std::uintptr_t address) {
  return *reinterpret_cast<volatile std::uint32_t*>(address);
}

inline constexpr std::uintptr_t uart = 0x4000'2000;
inline constexpr std::uintptr_t timer = 0x4000'8000;

inline void start() {
  at(uart + 0x50c) = 24;           // pin of TXD
  at(uart + 0x514) = 25;           // pin of RXD
  at(uart + 0x524) = 0x01d7'e000;  // 115200 baud
  at(uart + 0x500) = 4;            // enabled
  at(uart + 0x000) = 1;            // start receiving
  at(uart + 0x008) = 1;            // start sending
  at(timer + 0x508) = 3;           // 32 bits
  at(timer + 0x510) = 4;           // 16 MHz / 2^4
  at(timer + 0x000) = 1;           // start
}

/// Returns whether a byte has arrived, and takes it.
inline bool receive(std::uint8_t& byte) {
  if (at(uart + 0x108) == 0) return false;
  at(uart + 0x108) = 0;
  byte = static_cast<std::uint8_t>(at(uart + 0x518));
  return true;
}

inline void send(std::span<const std::uint8_t> bytes) {
  for (const std::uint8_t byte : bytes) {
    at(uart + 0x51c) = byte;
    while (at(uart + 0x11c) == 0) {
    }
    at(uart + 0x11c) = 0;
  }
}

/// Returns a time that wraps.
inline std::uint32_t microseconds() {
  at(timer + 0x040) = 1;  // capture
  return at(timer + 0x540);
}

}  // namespace board
