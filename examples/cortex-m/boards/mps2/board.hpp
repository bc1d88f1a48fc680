// The mps2 machines of QEMU: mps2-an386 has a Cortex-M4F, mps2-an500 a Cortex-M7. UART 0 and timer
// 0 of Arm's CMSDK, with a clock of 25 MHz.
#pragma once

#include <cstdint>
#include <span>

namespace board {

struct Uart {
  volatile std::uint32_t data, state, control, interrupt, divider;
};
struct Timer {
  volatile std::uint32_t control, value, reload;
};
inline Uart& uart = *reinterpret_cast<Uart*>(0x4000'4000);
inline Timer& timer = *reinterpret_cast<Timer*>(0x4000'0000);
inline constexpr std::uint32_t clock_hz = 25'000'000;

inline void start() {
  uart.divider = clock_hz / 115'200;
  uart.control = 3;            // sends and receives
  timer.reload = 0xffff'ffff;  // counts down
  timer.value = 0xffff'ffff;
  timer.control = 1;
}

/// Returns whether a byte has arrived, and takes it.
inline bool receive(std::uint8_t& byte) {
  if ((uart.state & 2) == 0) return false;
  byte = static_cast<std::uint8_t>(uart.data);
  return true;
}

inline void send(std::span<const std::uint8_t> bytes) {
  for (const std::uint8_t byte : bytes) {
    while ((uart.state & 1) != 0) {
    }
    uart.data = byte;
  }
}

/// Returns a time that wraps. Call it at least every two minutes.
inline std::uint32_t microseconds() {
  constexpr std::uint32_t per_us = clock_hz / 1'000'000;
  static std::uint32_t counted = 0;
  static std::uint32_t now = 0;
  const std::uint32_t elapsed = (~timer.value - counted) / per_us;
  counted += elapsed * per_us;
  return now += elapsed;
}

}  // namespace board
