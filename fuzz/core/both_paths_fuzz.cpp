// Fuzzes code with a path for constant expressions beside the one at run time: the same bytes have
// the same results on both. framing_paths.cpp and messages_paths.cpp define the inputs.

#include <cstddef>
#include <cstdlib>

#include "core/both_paths.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (results_at_run_time({data, size}) != results_as_constant({data, size})) std::abort();
  return 0;
}
