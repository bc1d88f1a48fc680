#include "motion/paused_streams.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>
#include <thread>

#include <fmt/format.h>

#include <sbgc/roles.hpp>
#include <sbgc/text.hpp>

#include "board/connection.hpp"
#include "command/remark.hpp"

namespace sbgc::tools {

namespace {

using Time = std::chrono::steady_clock::time_point;

/// The samples of a stream.
struct Heard {
  Time first{}, last{};
  int count = 0;

  std::uint16_t milliseconds() const {
    const double length = std::chrono::duration<double, std::milli>(last - first).count();
    return static_cast<std::uint16_t>(std::clamp(std::lround(length / (count - 1)), 1L, 1000L));
  }
};

bool can_be_stream(std::uint8_t id) {
  bool can_be = false;
  roles::StreamMessages::for_each(
      [&]<class M>(Type<M>) { can_be = can_be || id == static_cast<std::uint8_t>(M::command); });
  return can_be;
}

/// True if the interval is all that a stream of this message needs.
bool needs_no_more(msg::CommandFromBoard command) {
  return command == msg::RealtimeData3::command || command == msg::RealtimeData4::command;
}

}  // namespace

PausedStreams::PausedStreams(Client& client) : client_(client) {
  std::map<std::uint8_t, Heard> heard;
  {
    const Subscription listening = client.on_frame([&](const BoardFrame& one) {
      if (one.belongs_to_call || one.is_late || !can_be_stream(one.frame.id)) return;
      Heard& stream = heard[one.frame.id];
      stream.last = std::chrono::steady_clock::now();
      if (stream.count++ == 0) stream.first = stream.last;
    });
    std::this_thread::sleep_for(std::chrono::milliseconds(500));
  }
  for (const auto& [id, stream] : heard) {
    if (stream.count < 2) continue;  // too slow to matter
    const auto command = static_cast<msg::CommandFromBoard>(id);
    if (!needs_no_more(command)) {
      throw CommandError(
          fmt::format("a data stream of {} runs on this line, and only its host can start it "
                      "again: end it first",
                      to_string(command)));
    }
    msg::DataStreamInterval request;
    request.cmd_id = command;
    request.interval_ms = msg::Milliseconds(stream.milliseconds());
    running_.push_back(request);
  }
  for (msg::DataStreamInterval request : running_) {
    request.interval_ms = {};
    const Result<void> stopped(client_.call(request));
    if (stopped) continue;
    restart();  // those before it; the destructor will not run
    value_of(stopped);
  }
}

PausedStreams::~PausedStreams() { restart(); }

void PausedStreams::restart() const {
  for (const msg::DataStreamInterval& request : running_) {
    const Result<void> started(client_.call(request));
    if (started) continue;
    remark("The data stream of {} does not run any more: {}\n", to_string(request.cmd_id),
           started.error().message);
  }
}

}  // namespace sbgc::tools
