// The start of a program, the end of one that fails, and four functions of a C library.

#include <cstddef>
#include <cstdint>

#include "semihosting.hpp"
#include "stack.hpp"

extern "C" {
// Addresses that the linker script defines.
extern std::uint32_t data_in_flash[], data_begin[], data_end[], bss_begin[], bss_end[];
extern void (*const constructors_begin[])();
extern void (*const constructors_end[])();

int main();

[[noreturn]] void reset() {
#if defined(__ARM_FP)
  *reinterpret_cast<volatile std::uint32_t*>(0xe000'ed88) = 0xf0'0000;  // CPACR: enables the FPU
  asm volatile("dsb; isb");
#endif
  const std::uint32_t* from = data_in_flash;
  for (std::uint32_t* to = data_begin; to != data_end; ++to) *to = *from++;
  for (std::uint32_t* to = bss_begin; to != bss_end; ++to) *to = 0;
  stack::mark();
  for (auto construct = constructors_begin; construct != constructors_end; ++construct) {
    (*construct)();
  }
  semihosting::exit(main());
}

[[noreturn]] void fault() {
  semihosting::print("fault\n");
  semihosting::exit(1);
}

// The entry point of the processor, and the handlers of exceptions. A firmware with interrupts
// continues this table with their handlers.
using Handler = void (*)();
struct Vectors {
  std::uint32_t* stack;
  Handler handlers[15];
};
[[gnu::section(".vectors"), gnu::used]] extern const Vectors vectors{
    stack_begin,
    {reset, fault, fault, fault, fault, fault, nullptr, nullptr, nullptr, nullptr, fault, fault,
     nullptr, fault, fault}};
}

// The four functions that a freestanding compiler calls. A firmware with a C library has them.
extern "C" {

void* memcpy(void* to, const void* from, std::size_t size) {
  auto* out = static_cast<unsigned char*>(to);
  const auto* in = static_cast<const unsigned char*>(from);
  while (size-- != 0) *out++ = *in++;
  return to;
}

void* memmove(void* to, const void* from, std::size_t size) {
  auto* out = static_cast<unsigned char*>(to);
  const auto* in = static_cast<const unsigned char*>(from);
  if (out <= in) return memcpy(to, from, size);
  while (size-- != 0) out[size] = in[size];
  return to;
}

void* memset(void* to, int value, std::size_t size) {
  auto* out = static_cast<unsigned char*>(to);
  while (size-- != 0) *out++ = static_cast<unsigned char>(value);
  return to;
}

int memcmp(const void* left, const void* right, std::size_t size) {
  const auto* a = static_cast<const unsigned char*>(left);
  const auto* b = static_cast<const unsigned char*>(right);
  for (; size != 0; --size, ++a, ++b) {
    if (*a != *b) return *a < *b ? -1 : 1;
  }
  return 0;
}
}
