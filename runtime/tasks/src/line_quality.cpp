#include <sbgc/client/statistics.hpp>
#include <sbgc/frame.hpp>

namespace sbgc {

LineQuality line_quality(const SessionStatistics& statistics) noexcept {
  const ParserCounters& parser = statistics.parser;
  const auto noticed = static_cast<double>(parser.body_errors + parser.incomplete);
  const double all = noticed + static_cast<double>(parser.frames);
  LineQuality result;
  if (all == 0) return result;
  result.damaged = noticed / all;
  // Two wrong bits that cancel out in the sums, as measured (bench/line_errors); a CRC-16 misses
  // one damaged frame in 65536.
  result.undetected = has_only_sums(statistics.framing) ? result.damaged * result.damaged / 32
                                                        : result.damaged / 65536;
  return result;
}

}  // namespace sbgc
