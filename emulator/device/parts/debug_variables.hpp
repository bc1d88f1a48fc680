/// Variables inside the board that show its state.
#pragma once

#include <sbgc/messages/debug.hpp>
#include <sbgc/time.hpp>

namespace sbgc::board {

struct Machine;

class DebugVariables {
 public:
  /// Names and types, always the same.
  static msg::DebugVarsInfo3 info();
  /// Values, in the order of info().
  static msg::DebugVars3 values(Machine& machine, Instant now);

  static Instant next() { return Instant::never; }
  static void advance(Machine&, Instant) {}
  static void restart(Machine&, Instant) {}
};

}  // namespace sbgc::board
