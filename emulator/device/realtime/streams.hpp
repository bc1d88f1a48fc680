/// Data streams: messages that the board sends at a fixed rate.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <sbgc/messages/control.hpp>
#include <sbgc/messages/realtime.hpp>
#include <sbgc/response_policy.hpp>
#include <sbgc/time.hpp>

namespace sbgc::emulator {

struct Device;

class Streams {
 public:
  enum class Change : std::uint8_t { done, no_room, bad_command };

  /// Starts, changes or ends a stream of a port.
  Change change(Device& device, std::size_t port, const msg::DataStreamInterval& request,
                Instant now);
  void forget(Device& device, std::size_t port, Instant now);
  /// The output buffer of a port may have room again.
  void has_room(Device& device, std::size_t port, Instant now);
  /// Counts the samples skipped until `now`.
  void count_skipped(Device& device, Instant now);

  /// Sends an event to the ports that want it.
  void emit(Device& device, const msg::Event& event, Instant now);
  bool wants_events() const;

  /// The time of the next sample that is not held up.
  Instant next() const;
  void advance(Device& device, Instant now);
  void restart(Device& device, Instant now);

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

  static void skip(Device& device, Stream& stream, Instant now);

  std::vector<Stream> streams_{};
};

}  // namespace sbgc::emulator
