/// Counters of a client.
#pragma once

#include <cstdint>

#include <sbgc/session/event.hpp>

namespace sbgc {

/// The quality of the line from the board, by its counters: shares of its frames, 0 to 1.
struct LineQuality {
  double damaged{};  ///< frames whose damage was noticed; they are missing
  /// An estimate of the frames whose damage no check notices, so that their values are wrong. It
  /// assumes single wrong bits; lost and repeated bytes pass the checks more often.
  double undetected{};
};

/// Returns what the counters of a session say about the line.
LineQuality line_quality(const SessionStatistics& statistics) noexcept;

/// Counters of a client since it was made.
struct ClientStatistics {
  std::uint64_t calls{};        ///< started
  std::uint64_t failures{};     ///< ended with an error
  std::uint64_t unreadable{};   ///< messages for a subscriber that could not be decoded
  SessionStatistics session{};  ///< frames and noise on the line, retries, late replies
  StreamUsage streams{};        ///< the share of the line that data streams use
};

}  // namespace sbgc
