// The rest of a firmware: its UART, its clock, its values. The programs call it, but it does not
// count.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include <sbgc/time.hpp>

extern "C" {
std::size_t device_receive(const std::uint8_t** bytes);
void device_send(const std::uint8_t* bytes, std::size_t size);
std::uint32_t device_time();
std::int16_t device_input();
}

namespace device {

/// Returns what has arrived in the buffer that the DMA fills.
inline std::span<const std::uint8_t> received() {
  const std::uint8_t* bytes = nullptr;
  const std::size_t size = device_receive(&bytes);
  return {bytes, size};
}

/// Starts the DMA that sends these bytes.
inline void send(std::span<const std::uint8_t> bytes) { device_send(bytes.data(), bytes.size()); }

inline sbgc::Instant now() { return {std::int64_t{device_time()}}; }

/// Returns a value that the compiler does not know.
inline std::int16_t input() { return device_input(); }

/// The whole value is used: the compiler cannot leave out a part.
template <class T>
void use(const T& value) {
  asm volatile("" : : "r"(&value) : "memory");
}

/// Room for a message, which does not count.
inline void* const memory = reinterpret_cast<void*>(0x3000'0000);

}  // namespace device
