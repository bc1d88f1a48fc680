/// Internal variables of the board.
#pragma once

#include <sbgc/messages/debug.hpp>
#include <sbgc/time.hpp>

namespace sbgc::emulator {

struct Device;

class DebugVariables {
 public:
  /// Names and types, always the same.
  static msg::DebugVarsInfo3 info();
  /// Values, in the order of info().
  static msg::DebugVars3 values(Device& device, Instant now);

  static Instant next() { return Instant::never; }
  static void advance(Device&, Instant) {}
  static void restart(Device&, Instant) {}
};

}  // namespace sbgc::emulator
