/// Plays a capture as if the board were there.
#pragma once

#include <cstdint>
#include <string>

#include <asio/any_io_executor.hpp>

#include <sbgc/io/transport.hpp>

namespace sbgc::io {

enum class ReplayTiming : std::uint8_t {
  original,  ///< as long after the first read as it was after the start; no pause between sessions
  fast,      ///< as fast as it is read
};

/// What the board said, in the pieces in which it was received. What is written is ignored. The end
/// of the file is Errc::end_of_stream, and so is what can not be read. A file that is no capture is
/// taken for raw bytes of the board.
OpenResult open_replay(const asio::any_io_executor& executor, const std::string& path,
                       ReplayTiming timing = ReplayTiming::original);

}  // namespace sbgc::io
