/// Options and state changes of a client that reconnects.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <string>

#include <sbgc/client/board_identity.hpp>
#include <sbgc/client/clock.hpp>
#include <sbgc/client/options.hpp>
#include <sbgc/io/ports.hpp>

namespace sbgc {

/// The action if the line leads to another board than before.
enum class OtherBoard : std::uint8_t {
  refuse,  ///< close the line again and go on searching
  accept,  ///< use it
};

/// The behavior of a call while there is no connection.
enum class OutagePolicy : std::uint8_t {
  fail,  ///< it fails at once with ErrorCode::not_connected
  wait,  ///< it waits for a connection, up to its timeout or ConnectOptions::queue_timeout
};

/// Options of Client::connect(), for a client that reconnects.
struct ReconnectOptions {
  /// For each connection. The timeout is that of each attempt; a capture gets a new session for
  /// each connection.
  ConnectOptions connection{};
  /// The pause before the second attempt; it doubles from one attempt to the next.
  std::chrono::milliseconds first_pause{250};
  /// The upper limit of the pause.
  std::chrono::milliseconds longest_pause{4'000};
  /// The number of attempts that may fail in one outage; 0 means any number.
  unsigned attempts = 0;
  /// The action if the line leads to another board.
  OtherBoard other_board = OtherBoard::refuse;
  /// The behavior of calls during an outage.
  OutagePolicy calls = OutagePolicy::fail;
  /// If a data stream is silent for this long and for three of its intervals, the client checks
  /// that the board is alive. If it is not, the connection counts as lost; otherwise the stream is
  /// restarted. 0 means never.
  std::chrono::milliseconds longest_silence{3'000};
  /// Lists the ports in which a re-plugged adapter is searched for.
  std::function<io::PortList()> list_ports = io::list_ports;
  /// The clock for the pauses. Must outlive the client.
  Clock* clock = &Clock::system();
};

/// The state of a connection that is restored when it breaks.
enum class LinkState : std::uint8_t {
  connected,    ///< the board has answered
  lost,         ///< the line broke, or the board is silent or restarting
  searching,    ///< attempts to connect are being made
  other_board,  ///< another board was found; see OtherBoard
  given_up,     ///< all attempts have failed; final
  closed,       ///< by close(); final
};

/// The name of a state, such as "searching".
constexpr const char* name(LinkState state) noexcept {
  switch (state) {
    case LinkState::connected: return "connected";
    case LinkState::lost: return "lost";
    case LinkState::searching: return "searching";
    case LinkState::other_board: return "other_board";
    case LinkState::given_up: return "given_up";
    case LinkState::closed: return "closed";
  }
  return "unknown";
}

/// A change of the state of a connection.
struct LinkChange {
  LinkState state{};      ///< the new one
  std::string message{};  ///< for people: a sentence without a final period
  BoardIdentity board{};  ///< of `connected` and `other_board`
};

}  // namespace sbgc
