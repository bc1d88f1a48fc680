/// Data streams: messages that the board sends at a fixed rate.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <sbgc/messages/control.hpp>
#include <sbgc/messages/realtime.hpp>
#include <sbgc/response_policy.hpp>
#include <sbgc/roles.hpp>
#include <sbgc/time.hpp>

namespace sbgc::emulator {

class Ports;
struct MeasuredParts;

/// The cycle of the controller.
inline constexpr Duration cycle = microseconds(roles::stream_cycle_us);

class Streams {
 public:
  /// Starts, changes or ends a stream of a port. Returns false if there are too many.
  bool change(Ports& ports, std::size_t port, const msg::DataStreamInterval& request, Instant now);
  void forget(Ports& ports, std::size_t port, Instant now);
  /// Reports that the output buffer of a port may have room again.
  void has_room(Ports& ports, std::size_t port, Instant now);
  /// Counts the samples skipped until `now`.
  void count_skipped(Ports& ports, Instant now);

  /// Sends an event to the ports that want it.
  void emit(Ports& ports, const msg::Event& event);
  bool wants_events() const;

  /// The time of the next sample that is not held up.
  Instant next() const;
  void advance(Instant now, MeasuredParts& measured, Ports& ports);
  void restart(Instant now, Ports& ports);

 private:
  struct Stream {
    std::size_t port{};
    std::array<std::uint8_t, max_stream_config> config{};
    msg::DataStreamInterval request{};
    std::int64_t interval_us{};
    Instant start{};
    std::int64_t samples{};  ///< number of samples due until now
    bool is_held_up{};       ///< no room until bytes are sent

    Instant due() const;
  };

  static void skip(Ports& ports, Stream& stream, Instant now);

  std::vector<Stream> streams_{};
};

}  // namespace sbgc::emulator
