#include "device/realtime/streams.hpp"

#include <algorithm>

#include <sbgc/responses/realtime.hpp>
#include <sbgc/roles.hpp>

#include "device/ports.hpp"
#include "device/realtime/live_data.hpp"

namespace sbgc::emulator {

namespace {

bool is_of_events(const msg::DataStreamInterval& request) {
  return request.cmd_id == msg::Event::command;
}

/// The interval of a stream that counts attitudes of the IMU, one in each cycle.
std::int64_t interval_of(const msg::DataStreamInterval& request, const StreamChange& change) {
  if (change.interval_us == 0 || request.sync_to_data != msg::StreamSync::imu_attitude) {
    return change.interval_us;
  }
  return cycle.us * request.interval_ms.raw();
}

}  // namespace

Instant Streams::Stream::due() const {
  if (is_of_events(request)) return Instant::never;
  return start + microseconds(samples * interval_us) + microseconds(interval_us);
}

bool Streams::change(Ports& ports, std::size_t port, const msg::DataStreamInterval& request,
                     Instant now) {
  const StreamChange change = stream_change(request);
  const std::int64_t interval = interval_of(request, change);
  auto stream = std::find_if(streams_.begin(), streams_.end(), [&](const Stream& other) {
    return other.port == port && other.request.cmd_id == request.cmd_id &&
           other.config == change.config;
  });
  if (change.interval_us == 0) {
    if (stream != streams_.end()) {
      skip(ports, *stream, now);
      streams_.erase(stream);
    }
    return true;
  }
  if (stream == streams_.end()) {
    if (streams_.size() == roles::stream_limit) return false;
    stream = streams_.emplace(streams_.end());
  } else {
    skip(ports, *stream, now);
  }
  *stream = {port, change.config, request, interval, now, 0, false};
  return true;
}

void Streams::emit(Ports& ports, const msg::Event& event) {
  for (const Stream& stream : streams_) {
    if (!is_of_events(stream.request)) continue;
    // Assumption: 0 means all events and all kinds of them.
    const msg::StreamConfig& config = stream.request.config;
    const msg::EventId id = config.event_id ? *config.event_id : msg::EventId{};
    const msg::EventTypes types = config.event_type ? *config.event_type : msg::EventTypes{};
    const bool wants_id = id == msg::EventId{} || id == event.event_id;
    const bool wants_type = types.raw() == 0 || (types.raw() & event.event_type.raw()) != 0;
    if (wants_id && wants_type) static_cast<void>(ports.offer(stream.port, event));
  }
}

bool Streams::wants_events() const {
  return std::any_of(streams_.begin(), streams_.end(),
                     [](const Stream& stream) { return is_of_events(stream.request); });
}

void Streams::skip(Ports& ports, Stream& stream, Instant now) {
  if (!stream.is_held_up || now < stream.start) return;
  const std::int64_t due = (now - stream.start).us / stream.interval_us;
  ports.counters.skipped += static_cast<std::uint64_t>(due - stream.samples);
  stream.samples = due;
}

void Streams::forget(Ports& ports, std::size_t port, Instant now) {
  count_skipped(ports, now);
  std::erase_if(streams_, [port](const Stream& stream) { return stream.port == port; });
}

void Streams::has_room(Ports& ports, std::size_t port, Instant now) {
  for (Stream& stream : streams_) {
    if (stream.port != port) continue;
    skip(ports, stream, now);
    stream.is_held_up = false;
  }
}

void Streams::count_skipped(Ports& ports, Instant now) {
  for (Stream& stream : streams_) skip(ports, stream, now);
}

Instant Streams::next() const {
  Instant next = Instant::never;
  for (const Stream& stream : streams_) {
    if (!stream.is_held_up) next = earlier(next, stream.due());
  }
  return next;
}

void Streams::advance(Instant now, MeasuredParts& measured, Ports& ports) {
  for (Stream& stream : streams_) {
    if (stream.is_held_up || now < stream.due()) continue;
    if (offer_sample(measured, stream.port, stream.request, now)) {
      ++stream.samples;
    } else {
      // There is no room until bytes are sent, so do not check for each sample.
      stream.is_held_up = true;
      skip(ports, stream, now);
    }
  }
}

void Streams::restart(Instant now, Ports& ports) {
  count_skipped(ports, now);
  streams_.clear();
}

}  // namespace sbgc::emulator
