/// Runs a program as a user does, for tests of the examples.
#pragma once

#include <array>
#include <cstdio>
#include <string>

#include <sys/wait.h>

namespace sbgc::test {

struct ProgramResult {
  int status{};
  std::string output{};  ///< of both streams
};

/// Runs a shell command to its end.
inline ProgramResult run_program(const std::string& command) {
  ProgramResult result;
  std::FILE* const pipe = ::popen((command + " 2>&1").c_str(), "r");
  std::array<char, 4096> block{};
  for (std::size_t size = 1; size > 0;) {
    size = std::fread(block.data(), 1, block.size(), pipe);
    result.output.append(block.data(), size);
  }
  result.status = WEXITSTATUS(::pclose(pipe));
  return result;
}

}  // namespace sbgc::test
