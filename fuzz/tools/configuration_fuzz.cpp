// Fuzzes configuration files, with bombs (see hostile_text.hpp). A text is a list of gimbals with
// names and ports, or an error with a message, in time in proportion to its size.

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "board/configuration.hpp"
#include "command/command_error.hpp"
#include "hostile_text.hpp"

namespace {

void check(const std::string& text) {
  try {
    for (const sbgc::tools::NamedGimbal& gimbal : sbgc::tools::gimbals_in(text)) {
      if (gimbal.port.empty()) std::abort();
    }
  } catch (const sbgc::tools::CommandError& error) {
    if (*error.what() == '\0') std::abort();
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text = sbgc::fuzz::text_with_bombs({data, size});
  sbgc::fuzz::require_linear_time(text.size(), std::chrono::microseconds(100),
                                  [&] { check(text); });
  return 0;
}
