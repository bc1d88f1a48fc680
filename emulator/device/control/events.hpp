/// Events that hosts want to hear of.
#pragma once

#include <cstdint>
#include <optional>

#include <sbgc/enums.hpp>
#include <sbgc/messages/control.hpp>
#include <sbgc/time.hpp>

namespace sbgc::emulator {

struct MenuParts;

/// Watches the state of the board and sends CMD_EVENT when it changes, to the hosts that have
/// started a stream of such events.
class Events {
 public:
  /// Sends an event now.
  static void emit(MenuParts& parts, msg::EventId id, msg::EventType type);
  /// Sends the events of the changes since the last call.
  void watch(MenuParts& parts, Instant now);

  Instant next() const { return next_; }
  void advance(Instant now, MenuParts& parts);

 private:
  struct State {
    bool motors_on{}, stopped{}, retracted{};
    std::optional<std::uint8_t> script{};
  };

  static State state_of(const MenuParts& parts);

  State state_{};
  Instant next_ = Instant::never;
};

}  // namespace sbgc::emulator
