// Fuzzes configuration files, with bombs (see hostile_text.hpp), both of the command and of a
// gateway (fleets). A text is a list of gimbals with names and ports, or an error with its place,
// in time proportional to its size.

#include <string_view>

#include "board/configuration.hpp"
#include "command/command_error.hpp"
#include "gateway/fleet.hpp"
#include "hostile_text.hpp"

namespace {

/// Reads the text; an error has a place and a reason.
template <class Read>
void check(Read read) {
  try {
    read();
  } catch (const sbgc::tools::CommandError& error) {
    // "file:line:column: reason"
    const std::string_view text = error.what();
    const std::size_t reason = text.find(": ");
    if (reason == text.npos || std::ranges::count(text.substr(0, reason), ':') < 2) std::abort();
  }
}

void check_both(const std::string& text) {
  check([&] {
    for (const sbgc::tools::NamedGimbal& gimbal : sbgc::tools::gimbals_in(text)) {
      if (gimbal.port.empty()) std::abort();
    }
  });
  check([&] {
    const sbgc::tools::Fleet fleet = sbgc::tools::fleet_in(text, "fleet.toml");
    if (fleet.name.empty() || fleet.gimbals.empty()) std::abort();
    if (fleet.broker && (fleet.broker->addresses.empty() || fleet.broker->journal.empty())) {
      std::abort();
    }
    for (const sbgc::tools::FleetGimbal& gimbal : fleet.gimbals) {
      if (gimbal.line.port.empty()) std::abort();
    }
  });
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text = sbgc::fuzz::text_with_bombs({data, size});
  sbgc::fuzz::require_linear_time(text.size(), std::chrono::microseconds(100),
                                  [&] { check_both(text); });
  return 0;
}
