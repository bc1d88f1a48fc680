/// What a handler of requests has to work with.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include <sbgc/board/board.hpp>
#include <sbgc/message.hpp>
#include <sbgc/messages.hpp>
#include <sbgc/time.hpp>

namespace sbgc::board {

struct Machine;

/// Reasons in CMD_ERROR. Ours: the specification does not publish the codes of real boards.
enum class Refusal : std::uint8_t {
  bad_parameter = 1,  ///< a value that the command does not have
  bad_address = 2,    ///< outside the memory, or not aligned
  no_device = 3,      ///< nothing answers on the bus
  no_room = 4,        ///< a table is full
  not_possible = 5,   ///< not in the present state
  no_script = 6,      ///< the slot is empty
};

/// One request while it is carried out. A handler is
///     Outcome handle(Turn& turn, const M& request);
/// found by overload (handlers.hpp). It answers through the turn and says what has come of it. A
/// message without a handler is answered as the model says (default_answer.hpp).
class Turn {
 public:
  Turn(Machine& machine, std::size_t port, std::uint8_t command, Instant now)
      : machine(machine), port(port), command(command), now(now) {}

  Machine& machine;
  const std::size_t port;
  const std::uint8_t command;  ///< id of the request
  const Instant now;

  /// Sends a message back.
  template <Message M>
  Outcome answer(const M& message);
  /// CMD_CONFIRM that names the request, with these data.
  Outcome confirm(std::span<const std::uint8_t> data = {});
  /// CMD_ERROR that names the request.
  Outcome refuse(Refusal reason, std::uint32_t detail = 0);
  /// Says nothing, where the specification wants that.
  static Outcome ignore() { return Outcome::refused; }
};

}  // namespace sbgc::board
