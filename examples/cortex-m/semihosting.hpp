// Output and exit by way of a debugger or an emulator. Without either, the processor stops here: a
// firmware for use does not call these.
#pragma once

#include <cstdint>

namespace semihosting {

inline std::uintptr_t call(std::uintptr_t operation, const void* argument) {
  register std::uintptr_t r0 asm("r0") = operation;
  register const void* r1 asm("r1") = argument;
  asm volatile("bkpt 0xab" : "+r"(r0) : "r"(r1) : "memory");
  return r0;
}

inline void print(const char* text) { call(0x04, text); }

inline void print(std::int32_t number) {
  char digits[12];
  char* first = digits + sizeof digits;
  *--first = '\0';
  const bool is_negative = number < 0;
  auto rest =
      is_negative ? 0U - static_cast<std::uint32_t>(number) : static_cast<std::uint32_t>(number);
  do {
    *--first = static_cast<char>('0' + rest % 10);
    rest /= 10;
  } while (rest != 0);
  if (is_negative) *--first = '-';
  print(first);
}

/// Ends the emulation, or returns to the debugger.
[[noreturn]] inline void exit(int status) {
  const std::uintptr_t argument[] = {0x20026, static_cast<std::uintptr_t>(status)};
  call(0x20, argument);
  while (true) {
  }
}

}  // namespace semihosting
