/// Counters of a client.
#pragma once

#include <cstdint>

#include <sbgc/frame.hpp>
#include <sbgc/session/event.hpp>

namespace sbgc {

/// The quality of the line from the board, by its counters: shares of its frames, 0 to 1.
struct LineQuality {
  double damaged{};  ///< detectably damaged frames; they are missing
  /// An estimate of the frames with undetected damage, whose values are wrong. It assumes single
  /// bit errors; lost and repeated bytes pass the checks more often.
  double undetected{};
};

/// Returns the line quality that the counters of a session show.
inline LineQuality line_quality(const SessionStatistics& statistics) noexcept {
  const ParserCounters& parser = statistics.parser;
  const auto noticed = static_cast<double>(parser.body_errors + parser.incomplete);
  const double all = noticed + static_cast<double>(parser.frames);
  LineQuality result;
  if (all == 0) return result;
  result.damaged = noticed / all;
  // Two bit errors that cancel out in the checksums, as measured (bench/line_errors); a CRC-16
  // misses one damaged frame in 65536.
  result.undetected = has_only_sums(statistics.framing) ? result.damaged * result.damaged / 32
                                                        : result.damaged / 65536;
  return result;
}

/// Counters of a client since its construction.
struct ClientStatistics {
  std::uint64_t calls{};        ///< started
  std::uint64_t failures{};     ///< ended with an error
  std::uint64_t unreadable{};   ///< messages for a subscriber that could not be decoded
  SessionStatistics session{};  ///< frames and noise on the line, retries, late replies
  StreamUsage streams{};        ///< the share of the line that data streams use
};

}  // namespace sbgc
