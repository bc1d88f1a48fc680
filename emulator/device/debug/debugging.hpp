/// Debugging for hosts: internal variables of the board, and copies of the messages on other ports.
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include <sbgc/emulator/board.hpp>
#include <sbgc/enums.hpp>
#include <sbgc/frame.hpp>
#include <sbgc/messages/debug.hpp>
#include <sbgc/time.hpp>
#include <sbgc/units.hpp>

namespace sbgc::emulator {

class Ports;
struct MeasuredParts;

/// The names and types, which never change.
msg::DebugVarsInfo3 debug_variables_info(std::size_t first = 0);
/// The values, in the same order.
msg::DebugVars3 debug_variable_values(MeasuredParts& parts, Instant now);

/// CMD_SET_DEBUG_PORT. Assumption: a copy is lost if there is no room for it.
class DebugCopies {
 public:
  /// Starts or, without a filter, ends the copies to a port. Messages in the filter are left out.
  void set(std::size_t port, std::optional<msg::DebugPortCommands> filter) {
    filters_[port] = filter;
  }
  /// Copies a message on a port to the others.
  void copy(Ports& ports, msg::MillisecondClock time, std::size_t port, const Frame& frame,
            bool is_to_host);
  void drop_port(std::size_t port) { filters_[port].reset(); }

 private:
  std::array<std::optional<msg::DebugPortCommands>, Board::max_ports> filters_{};
};

}  // namespace sbgc::emulator
