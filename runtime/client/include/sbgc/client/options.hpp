/// What a caller may decide about connecting and about each call.
#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>

namespace sbgc {

/// How a client connects, and how it behaves afterwards.
struct ConnectOptions {
  /// For all of it: opening, finding the baud rate, reading the board's versions.
  std::chrono::milliseconds timeout{20'000};
  /// Look for the baud rate and parity of a serial line whose address does not say them.
  bool find_line = true;
  /// How often a request is sent again when nothing comes back, if the protocol allows that.
  unsigned retries = 2;
  /// Keep the pause of 10 to 20 ms between commands that the protocol asks for.
  bool pacing = true;
  /// How much of a serial line data streams may take, in percent.
  unsigned stream_share = 80;
  /// How long a frame of the board may come once more, on a line that repeats packets, as UDP may.
  /// A request then waits until no frame can be taken for its answer that was one before; 0: never.
  std::chrono::milliseconds duplicates{0};
  /// How many calls may wait for their turn.
  std::size_t queue = 1024;
  /// How long a call may wait for its turn, unless it has a timeout of its own.
  std::chrono::milliseconds patience{10'000};
  /// Records everything sent and received into this file, unless empty.
  std::string capture{};
};

/// How one call is made.
struct CallOptions {
  /// For the whole call, waiting for its turn included; attempts share it. Without it, what the
  /// protocol says about this command, for each attempt, and ConnectOptions::patience.
  std::optional<std::chrono::milliseconds> timeout{};
  /// Instead of ConnectOptions::retries. Without effect where sending twice could do harm.
  std::optional<unsigned> retries{};
  /// Wait for the confirmation of a command that the board need not confirm. When none comes the
  /// call succeeds all the same; Client::transact() tells the difference.
  bool expect_confirmation = false;
  /// Refuse a request with a value that the protocol does not allow on this board.
  bool validate = true;
  /// Called on the client's thread for each confirmation of a command that has several, with its
  /// number from 1.
  std::function<void(unsigned number)> on_confirmation{};
};

}  // namespace sbgc
