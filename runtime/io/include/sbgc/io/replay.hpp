/// Replays a capture in place of a board.
#pragma once

#include <cstdint>
#include <string>

#include <asio/any_io_executor.hpp>

#include <sbgc/io/transport.hpp>

namespace sbgc::io {

/// The times at which the bytes of a capture arrive.
enum class ReplayTiming : std::uint8_t {
  original,  ///< at the recorded time after the first read; no pause between sessions
  answers,   ///< as original, but not before the program has written as often as the recorded one
             ///< had by then; after a second without that, at the recorded times
  fast,      ///< as fast as it is read
};

/// Opens a transport that delivers the bytes from the board in the recorded pieces and ignores
/// writes. At the end of the file, or at a read error, reads fail with Errc::end_of_stream. A file
/// that is not a capture is treated as raw bytes from the board. Except with ReplayTiming::fast,
/// the recorded times are divided by `speed`, which must be positive.
OpenResult open_replay(const asio::any_io_executor& executor, const std::string& path,
                       ReplayTiming timing = ReplayTiming::original, double speed = 1);

}  // namespace sbgc::io
