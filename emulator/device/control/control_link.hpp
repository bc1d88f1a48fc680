/// Serial control: the controlling port, its timeout, and its configuration.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include <sbgc/emulator/board.hpp>
#include <sbgc/messages/control.hpp>
#include <sbgc/time.hpp>

namespace sbgc::emulator {

class QuaternionControl;
struct Modes;

/// The configuration of CMD_CONTROL_CONFIG, valid until the board restarts. The filters and curves
/// have no effect on the simulation.
class ControlLink {
 public:
  /// Ports 0 to 3 are UART1, RC_SERIAL, UART2 and USB_VCP or UART3. Assumption.
  void configure(Modes& modes, const msg::ControlConfig& config, std::size_t port, Instant now);
  /// True if control commands of this port are accepted: no other port has a higher priority.
  bool admits(std::size_t port) const;
  /// Restarts the timeout after a control command was executed.
  void commanded(Instant now);
  bool confirms() const { return confirms_; }
  /// Changes the tuning of the gimbal by this configuration.
  void adjust(Tuning& tuning) const;

  void drop_port(std::size_t port) { priority_[port] = 0; }

  Instant next() const { return end_; }
  void advance(Instant now, QuaternionControl& quaternions, Gimbal& gimbal);

 private:
  std::array<std::uint8_t, Board::max_ports> priority_{};
  std::array<std::uint16_t, 3> acceleration_{};  ///< deg/s^2; 0: as in the parameters
  std::optional<msg::EulerOrder> order_{};
  Duration timeout_{};  ///< 0: none
  Instant end_ = Instant::never;
  bool is_active_ = false;  ///< there was a control command since the start or the last timeout
  bool confirms_ = true;
};

}  // namespace sbgc::emulator
