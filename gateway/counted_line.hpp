/// Counters of a line over all its connections.
#pragma once

#include <cstdint>

#include <sbgc/client/statistics.hpp>

namespace sbgc::tools {

/// Adds the counters of two connections.
inline ClientStatistics sum_of(const ClientStatistics& a, const ClientStatistics& b) {
  ClientStatistics sum = b;
  sum.calls += a.calls;
  sum.failures += a.failures;
  sum.unreadable += a.unreadable;
  SessionStatistics& session = sum.session;
  session.parser = a.session.parser + b.session.parser;
  session.sent_frames += a.session.sent_frames;
  session.sent_bytes += a.session.sent_bytes;
  session.retries += a.session.retries;
  session.timeouts += a.session.timeouts;
  session.late_replies += a.session.late_replies;
  session.unsolicited += a.session.unsolicited;
  session.board_errors += a.session.board_errors;
  session.resets += a.session.resets;
  session.refused += a.session.refused;
  return sum;
}

/// A client counts anew with each connection; this adds them up, so that no counter decreases.
class CountedLine {
 public:
  /// Takes the counters of the connection with this number, and returns the sum.
  ClientStatistics total(std::uint64_t connection, const ClientStatistics& counters) {
    if (connection != connection_) {
      earlier_ = sum_of(earlier_, current_);
      connection_ = connection;
    }
    current_ = counters;
    return sum_of(earlier_, current_);
  }

 private:
  std::uint64_t connection_ = 0;
  ClientStatistics earlier_{};
  ClientStatistics current_{};
};

}  // namespace sbgc::tools
