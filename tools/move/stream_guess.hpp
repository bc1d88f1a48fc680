/// Data streams of unknown hosts, as their samples tell.
#pragma once

#include <chrono>
#include <vector>

#include <sbgc/frame.hpp>
#include <sbgc/messages/realtime.hpp>

namespace sbgc::tools {

/// The possible requests for a stream with this sample, without the interval: one request if
/// the sample tells, several if it is one of them, none if the sample does not tell. `is_sample` is
/// false for other messages.
struct StreamGuess {
  bool is_sample = false;
  std::vector<msg::DataStreamInterval> requests{};
};
StreamGuess guess_stream(const Frame& frame);

/// When samples of a stream arrived.
class SampleTimes {
 public:
  using Time = std::chrono::steady_clock::time_point;

  void add(Time at) { times_.push_back(at); }
  bool have_interval() const noexcept { return times_.size() > 1; }
  /// The interval between samples, of which some may be lost. Precondition: have_interval().
  msg::Milliseconds interval() const;

 private:
  std::vector<Time> times_{};
};

}  // namespace sbgc::tools
