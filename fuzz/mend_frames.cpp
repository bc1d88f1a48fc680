// The mutator of fuzzers whose inputs contain frames: half of the mutations have valid checksums.

#include "mend_frames.hpp"

#include <cstddef>
#include <cstdint>

/// A function of libFuzzer.
extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t max_size);

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t max_size, unsigned seed) {
  const std::size_t mutated = LLVMFuzzerMutate(data, size, max_size);
  if (seed % 2 == 0) sbgc::fuzz::mend_frames({data, mutated});
  return mutated;
}
