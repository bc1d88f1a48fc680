#include "device.hpp"

namespace {

volatile std::uint32_t& at(std::uintptr_t address) {
  return *reinterpret_cast<volatile std::uint32_t*>(address);
}

}  // namespace

std::size_t device_receive(const std::uint8_t** bytes) {
  *bytes = reinterpret_cast<const std::uint8_t*>(0x3000'0000);
  return at(0x4000'0000);
}

void device_send(const std::uint8_t* bytes, std::size_t size) {
  at(0x4000'0004) = static_cast<std::uint32_t>(reinterpret_cast<std::uintptr_t>(bytes));
  at(0x4000'0008) = size;
}

std::uint32_t device_time() { return at(0x4000'000c); }

std::int16_t device_input() { return static_cast<std::int16_t>(at(0x4000'0010)); }
