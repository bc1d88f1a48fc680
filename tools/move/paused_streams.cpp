#include "move/paused_streams.hpp"

#include <algorithm>
#include <chrono>
#include <thread>

#include <sbgc/text.hpp>

#include "board/connection.hpp"
#include "command/remark.hpp"
#include "move/stream_guess.hpp"

namespace sbgc::tools {

namespace {

/// A stream on the line.
struct HeardStream {
  msg::CommandFromBoard command{};
  std::vector<msg::DataStreamInterval> requests{};
  SampleTimes times{};
};

/// Returns the streams of which several samples arrive within this time: others do not matter.
std::vector<HeardStream> heard_streams(Client& client, std::chrono::milliseconds time) {
  std::vector<HeardStream> heard;
  {
    const Subscription listening = client.on_frame([&](const BoardFrame& one) {
      if (one.belongs_to_call || one.is_late) return;
      const StreamGuess guess = guess_stream(one.frame);
      if (!guess.is_sample) return;
      const auto command = static_cast<msg::CommandFromBoard>(one.frame.id);
      auto stream = std::ranges::find_if(heard, [&](const HeardStream& other) {
        return other.command == command && other.requests == guess.requests;
      });
      if (stream == heard.end()) stream = heard.insert(heard.end(), {command, guess.requests, {}});
      stream->times.add(std::chrono::steady_clock::now());
    });
    std::this_thread::sleep_for(time);
  }
  std::erase_if(heard, [](const HeardStream& one) { return !one.times.have_interval(); });
  return heard;
}

bool still_runs(Client& client, const HeardStream& stream) {
  const std::chrono::milliseconds interval(stream.times.interval().raw());
  const auto heard = heard_streams(client, 4 * interval + std::chrono::milliseconds(50));
  return std::ranges::any_of(heard, [&](const HeardStream& other) {
    return other.command == stream.command && other.requests == stream.requests;
  });
}

}  // namespace

PausedStreams::PausedStreams(Client& client) : client_(client) {
  for (const HeardStream& stream : heard_streams(client, std::chrono::milliseconds(500))) {
    bool runs = true;
    for (auto request = stream.requests.begin(); runs && request != stream.requests.end();
         ++request) {
      msg::DataStreamInterval end = *request;
      end.interval_ms = {};
      const Result<void> ended(client_.call(end));
      if (!ended) restart();  // those before it: the destructor will not run
      value_of(ended);
      runs = still_runs(client, stream);
      if (runs) continue;
      paused_.push_back(*request);
      paused_.back().interval_ms = stream.times.interval();
    }
    if (runs) {
      remark(
          "A data stream of {} goes on, because only its host knows how to end it: samples may be "
          "lost.\n",
          to_string(stream.command));
    } else {
      remark(
          "The data stream of {} is paused. It goes on afterwards, every {} ms as measured: what "
          "its host asked for is unknown.\n",
          to_string(stream.command), paused_.back().interval_ms.raw());
    }
  }
}

PausedStreams::~PausedStreams() { restart(); }

void PausedStreams::restart() const {
  for (const msg::DataStreamInterval& request : paused_) {
    const Result<void> started(client_.call(request));
    if (started) continue;
    remark("The data stream of {} does not run any more: {}\n", to_string(request.cmd_id),
           started.error().message);
  }
}

}  // namespace sbgc::tools
