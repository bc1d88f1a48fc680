/// What controls the axes from outside: RC signals and virtual channels.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <tuple>

#include <sbgc/enums.hpp>
#include <sbgc/messages/parameters.hpp>
#include <sbgc/messages/peripherals.hpp>
#include <sbgc/time.hpp>

namespace sbgc::emulator {

struct Device;

/// RC inputs. Only the virtual channels of the API carry signals: nothing is connected to the pins
/// and to the serial receivers.
class RemoteControl {
 public:
  static constexpr std::size_t channels = decltype(msg::ApiVirtChControl::val_ch)::capacity();

  /// CMD_API_VIRT_CH_CONTROL: new signals of all virtual channels, until the next ones.
  void set_channels(Device& device, const msg::ApiVirtChControl& signals, Instant now);
  /// The signal of a source as RC_MAP_* and SRC_CH name it, -1..1; nothing if there is none.
  std::optional<double> signal(msg::RcMap source) const;
  /// The signal of the source that is mapped to an axis, as it comes.
  std::optional<double> own(const Device& device, std::size_t axis) const;
  /// What an axis is controlled with: its signal, trimmed, mixed and bent as the parameters say.
  std::optional<double> axis(const Device& device, std::size_t axis) const;
  /// In FOLLOW_MODE_FC the angle that the flight controller has an axis follow; nothing if it does
  /// not concern that axis.
  std::optional<double> followed(const Device& device, std::size_t axis) const;
  /// A signal, -1..1, as the parameters in use bend that of an axis: direction, trim, dead band,
  /// curve.
  static double bent(const msg::ReadParams3& parameters, std::size_t axis, double signal);
  /// The menu swaps the signals of two axes, until the board restarts.
  void swap(std::size_t one, std::size_t other);
  /// Hands signals and followed angles to the gimbal; after each change of signals or parameters.
  void apply(Device& device, Instant now) const;

  static Instant next() { return Instant::never; }
  static void advance(Device&, Instant) {}
  void restart(Device& device, Instant now);

 private:
  enum class Position : std::uint8_t { none, low, middle, high };

  void follow_command_channel(Device& device, Instant now);

  std::array<std::optional<double>, channels> signals_{};
  std::array<std::size_t, 3> source_of_axis_{0, 1, 2};
  Position command_ = Position::none;  ///< of the command channel's switch
};

}  // namespace sbgc::emulator
