/// Variables inside the board that show its state.
#pragma once

#include <sbgc/messages/debug.hpp>
#include <sbgc/time.hpp>

namespace sbgc::board {

struct Machine;

class DebugVariables {
 public:
  /// Names and types, always the same.
  static DebugVarsInfo3 info();
  /// Values, in the order of info().
  DebugVars3 values(Machine& machine, Instant now) const;

  static Instant next() { return Instant::never; }
  static void advance(Machine&, Instant) {}
  void restart(Machine&, Instant now) { start_ = now; }

 private:
  Instant start_{};
};

}  // namespace sbgc::board
