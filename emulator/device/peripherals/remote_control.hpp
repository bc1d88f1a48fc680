/// External control of the axes: RC signals and virtual channels.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include <sbgc/enums.hpp>
#include <sbgc/messages/parameters.hpp>
#include <sbgc/messages/peripherals.hpp>
#include <sbgc/time.hpp>

namespace sbgc::emulator {

/// A signal in the finest range, as hosts see it; UNDEFINED if there is none.
msg::FineRcSignal fine_signal(std::optional<double> signal);

class Gimbal;
class Parameters;
struct MenuParts;

/// RC inputs. Only the virtual channels of the API carry signals: nothing is connected to the pins
/// and the serial receivers.
class RemoteControl {
 public:
  static constexpr std::size_t channels = decltype(msg::ApiVirtChControl::val_ch)::capacity();

  /// CMD_API_VIRT_CH_CONTROL and CMD_API_VIRT_CH_HIGH_RES: sets the signals of all virtual channels
  /// until the next message.
  template <class Signals>
  void set_channels(MenuParts& parts, const Signals& signals, Instant now);
  /// The signal of a source of RC_MAP_* or SRC_CH, -1..1; empty if there is none.
  std::optional<double> signal(msg::RcMap source) const;
  /// The raw signal of the source that is mapped to an axis.
  std::optional<double> own(const Parameters& parameters, std::size_t axis) const;
  /// The signal that controls an axis: trimmed, mixed and shaped according to the parameters.
  std::optional<double> axis(const Parameters& in_use, std::size_t axis) const;
  /// In FOLLOW_MODE_FC, the angle of the flight controller that an axis follows; otherwise empty.
  std::optional<double> followed(const Parameters& in_use, std::size_t axis) const;
  /// Shapes a signal, -1..1, by the direction, trim, dead band and curve of an axis.
  static double shaped(const msg::ReadParams3& parameters, std::size_t axis, double signal);
  /// Swaps the signals of two axes until the board restarts; used by the menu.
  void swap(std::size_t one, std::size_t other);
  /// Passes signals and followed angles to the gimbal. Call it after each change of signals or
  /// parameters.
  void apply(const Parameters& parameters, Gimbal& gimbal, Instant now) const;

 private:
  enum class Position : std::uint8_t { none, low, middle, high };

  void follow_command_channel(MenuParts& parts, Instant now);

  std::array<std::optional<double>, channels> signals_{};
  std::array<std::size_t, 3> source_of_axis_{0, 1, 2};
  Position command_ = Position::none;  ///< position of the command channel's switch
};

}  // namespace sbgc::emulator
