#include "standard_output.hpp"

#include <cstddef>
#include <cstdio>
#include <stdexcept>

namespace sbgc::tools {

StandardOutput::StandardOutput() : block_(65536) {
  provide(block_.data(), block_.data() + block_.size());
}

void StandardOutput::flush() {
  const auto size = static_cast<std::size_t>(end_of_text() - block_.data());
  provide(block_.data(), block_.data() + block_.size());
  const bool is_written = std::fwrite(block_.data(), 1, size, stdout) == size;
  if (!is_written || std::fflush(stdout) != 0) {
    throw std::runtime_error("cannot write to the standard output");
  }
}

}  // namespace sbgc::tools
