#include "streams.hpp"

#include <algorithm>

#include <sbgc/responses/realtime.hpp>
#include <sbgc/roles.hpp>

#include "live_data.hpp"
#include "machine.hpp"

namespace sbgc::board {

Instant Streams::Stream::due() const {
  return start + microseconds(samples * interval_us) + microseconds(interval_us);
}

Streams::Change Streams::change(Machine& machine, std::size_t port,
                                const msg::DataStreamInterval& request, Instant now) {
  const StreamChange change = stream_change(request);
  if (!can_stream(machine, request, now)) return Change::bad_command;
  auto stream = std::find_if(streams_.begin(), streams_.end(), [&](const Stream& other) {
    return other.port == port && other.request.cmd_id == request.cmd_id &&
           other.config == change.config;
  });
  if (change.interval_us == 0) {
    if (stream != streams_.end()) {
      skip(machine, *stream, now);
      streams_.erase(stream);
    }
    return Change::done;
  }
  if (stream == streams_.end()) {
    if (streams_.size() == roles::stream_limit) return Change::no_room;
    stream = streams_.emplace(streams_.end());
  } else {
    skip(machine, *stream, now);
  }
  *stream = {port, change.config, request, change.interval_us, now, 0, false};
  return Change::done;
}

void Streams::skip(Machine& machine, Stream& stream, Instant now) {
  if (!stream.is_held_up || now < stream.start) return;
  const std::int64_t due = (now - stream.start).us / stream.interval_us;
  machine.ports.counters.skipped += static_cast<std::uint64_t>(due - stream.samples);
  stream.samples = due;
}

void Streams::forget(Machine& machine, std::size_t port, Instant now) {
  count_skipped(machine, now);
  std::erase_if(streams_, [port](const Stream& stream) { return stream.port == port; });
}

void Streams::has_room(Machine& machine, std::size_t port, Instant now) {
  for (Stream& stream : streams_) {
    if (stream.port != port) continue;
    skip(machine, stream, now);
    stream.is_held_up = false;
  }
}

void Streams::count_skipped(Machine& machine, Instant now) {
  for (Stream& stream : streams_) skip(machine, stream, now);
}

Instant Streams::next() const {
  Instant next = Instant::never;
  for (const Stream& stream : streams_) {
    if (!stream.is_held_up) next = earlier(next, stream.due());
  }
  return next;
}

void Streams::advance(Machine& machine, Instant now) {
  for (Stream& stream : streams_) {
    if (stream.is_held_up || now < stream.due()) continue;
    if (offer_sample(machine, stream.port, stream.request, now)) {
      ++stream.samples;
    } else {
      // Until bytes have been sent there is no room: no need to look at each sample.
      stream.is_held_up = true;
      skip(machine, stream, now);
    }
  }
}

void Streams::restart(Machine& machine, Instant now) {
  count_skipped(machine, now);
  streams_.clear();
}

}  // namespace sbgc::board
