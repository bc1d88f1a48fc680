/// Statistics of the board's whole life.
#pragma once

#include <sbgc/emulator/board_options.hpp>
#include <sbgc/emulator/memory.hpp>
#include <sbgc/messages/system.hpp>
#include <sbgc/time.hpp>

namespace sbgc::emulator {

class Parameters;

/// CMD_READ_STATE_VARS. The board counts in its memory, but stores the counters only when a host
/// writes them or, each minute, with SAVE_SYSTEM_STAT.
class StateVariables {
 public:
  static bool are_supported(const BoardOptions& options);

  /// The current values.
  msg::ReadStateVars values(Gimbal& gimbal, Instant now);
  void write(Memory& memory, const msg::ReadStateVars& values, Instant now);

  Instant next() const { return next_; }
  void advance(Instant now, Gimbal& gimbal, const Parameters& parameters, Memory& memory);
  /// Called when the board has started.
  void start(const BoardOptions& options, Memory& memory, const Parameters& parameters,
             Instant now);

 private:
  void set(const msg::ReadStateVars& values, Instant now);
  void count(Gimbal& gimbal, Instant now);
  void store(Memory& memory) const;

  msg::ReadStateVars values_{};
  double work_time_{};  ///< seconds; the wire has whole ones
  double energy_time_{}, current_time_{};
  double energy_{};   ///< watt hours
  double current_{};  ///< average, milliamperes
  Instant counted_{};
  Instant stored_{};
  Instant next_ = Instant::never;
};

}  // namespace sbgc::emulator
