/// The standard output of the command.
#pragma once

#include <vector>

#include <sbgc/text_output.hpp>

namespace sbgc::tools {

/// Collects text for the standard output and writes it in blocks. Throws std::runtime_error if that
/// fails.
class StandardOutput final : public TextOutput {
 public:
  StandardOutput();

  /// Writes what is collected, because a reader may be waiting for it.
  void flush();

 private:
  void make_room() override { flush(); }

  std::vector<char> block_;
};

/// Throws CommandError if the standard output is a terminal, which must not get bytes of the
/// protocol. `instead` is what the user can do.
void require_no_terminal(const char* instead);

}  // namespace sbgc::tools
