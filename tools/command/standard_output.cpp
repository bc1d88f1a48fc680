#include "command/standard_output.hpp"

#include <cstddef>
#include <cstdio>
#include <stdexcept>

#include <fmt/format.h>

#include "command/command_error.hpp"
#include "command/system.hpp"

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

void require_no_terminal(const char* instead) {
  if (!is_terminal(stdout)) return;
  throw CommandError(
      fmt::format("the output is not text; redirect it to a file or a program, or use {}", instead),
      wrong_usage);
}

}  // namespace sbgc::tools
