// Measures how much of the stack a program has used.
#pragma once

#include <cstddef>
#include <cstdint>

// The linker script defines these. The stack grows down from its beginning.
extern "C" std::uint32_t stack_begin[], stack_end[];

namespace stack {

inline constexpr std::uint32_t unused = 0xdead'beef;

/// Marks the stack below the caller as unused.
inline void mark() {
  std::uint32_t* top = nullptr;
  asm volatile("mov %0, sp" : "=r"(top));
  for (std::uint32_t* word = stack_end; word < top; ++word) *word = unused;
}

/// Returns the most bytes that have been in use.
inline std::size_t used() {
  const std::uint32_t* word = stack_end;
  while (word != stack_begin && *word == unused) ++word;
  return static_cast<std::size_t>(stack_begin - word) * sizeof(std::uint32_t);
}

}  // namespace stack
