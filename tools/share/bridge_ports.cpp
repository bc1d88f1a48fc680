#include "share/bridge_ports.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include <sbgc/any.hpp>
#include <sbgc/messages/realtime.hpp>
#include <sbgc/messages/system.hpp>
#include <sbgc/meta/enums.hpp>
#include <sbgc/roles.hpp>
#include <sbgc/surplus.hpp>
#include <sbgc/text.hpp>

namespace sbgc::tools {

namespace {

/// Unlike responses, samples and unsolicited messages must leave part of a host's output free.
constexpr std::size_t room_of_exclusive_host = 2048;
constexpr std::size_t most_for_samples = BridgePorts::max_output / 4;

std::span<const std::uint8_t> body_of(const RawRequest& request) {
  return {request.body.data(), request.body.size()};
}

std::optional<Received<roles::StreamRequest>> as_stream_request(const RawRequest& request) {
  if (!request.policy.changes_stream() ||
      request.id != static_cast<std::uint8_t>(roles::StreamRequest::command)) {
    return std::nullopt;
  }
  Received<roles::StreamRequest> message{};
  if (!decode(body_of(request), message)) return std::nullopt;
  return message;
}

/// True if the board uses the same protocol after the restart.
bool is_plain_restart(const RawRequest& request) {
  const MessageType* const type =
      find_message(Direction::to_board, request.id, request.body.size());
  return request.policy.restarts_board && type != nullptr &&
         !type->info->effects.has(Effect::disconnects);
}

std::vector<std::uint8_t> question_of_introduction() {
  std::vector<std::uint8_t> bytes(max_frame_size);
  bytes.resize(encode_frame(basic_framing, roles::IntroductionRequest{}, bytes).size);
  return bytes;
}

bool was_not_sent(ErrorCode failure) {
  return failure == ErrorCode::superseded || failure == ErrorCode::overload ||
         failure == ErrorCode::not_connected;
}

/// Returns the time between two samples.
std::int64_t microseconds_of(std::int64_t interval) {
  return interval == std::int64_t{roles::stream_cycle}
             ? std::int64_t{roles::stream_cycle_us}
             : interval * std::int64_t{roles::stream_interval_us};
}

/// Returns the request with another interval.
RawRequest with_interval(const RawRequest& request, std::int64_t interval) {
  auto message = as_stream_request(request);
  if (!message) return request;
  auto& place = roles::stream_interval(*message);
  using Interval = std::remove_reference_t<decltype(place)>;
  place = Interval(static_cast<typename Interval::raw_type>(interval));
  std::array<std::uint8_t, max_body_size> body{};
  const WriteResult written = encode(*message, std::span(body));
  if (!written) return request;
  auto changed = raw_request(request.id, std::span(body).first(written.size));
  return changed ? *std::move(changed) : request;
}

}  // namespace

// The hosts' side.

std::optional<std::size_t> BridgePorts::connect(bool, std::function<void()> wake) {
  auto* const free = std::ranges::find_if(hosts_, [](const auto& host) { return host == nullptr; });
  if (free == hosts_.end()) return std::nullopt;
  const auto port = static_cast<std::size_t>(free - hosts_.begin());
  const auto [is_heard, replaced] =
      places_.come(port, now(), [this](std::size_t other) { return silent_since(other); });
  if (!is_heard) return std::nullopt;
  *free = std::make_unique<Host>();
  const auto is_taken = [this](const auto& host) { return host && host->id == last_host_; };
  do {
    ++last_host_;
  } while (last_host_ == 0 || std::ranges::any_of(hosts_, is_taken));  // 0 is the bridge itself
  (*free)->id = last_host_;
  (*free)->wake = std::move(wake);
  (*free)->counters.port = port;
  (*free)->heard = (*free)->told = now();
  if (replaced) expel(*replaced, "it is silent, and another needs its place");
  return port;
}

Instant BridgePorts::silent_since(std::size_t port) const {
  const Host& host = *hosts_[port];
  const bool has_stream = std::ranges::any_of(
      streams_, [&](const auto& one) { return one.second.shares.contains(port); });
  const bool has_line = exclusive_ && exclusive_->port == port;
  const bool is_busy =
      host.pending != 0 || has_stream || has_line || owners_.awaits_answer(port, now());
  return is_busy ? Instant::never : later(host.heard, host.told);
}

void BridgePorts::expel(std::size_t port, const char* reason) {
  hosts_[port]->must_leave = true;
  places_.give_up(port);
  log_expelled_(fmt::format("host {} must leave: {}", port, reason));
  wake(port);
}

void BridgePorts::disconnect(std::size_t port) {
  hosts_[port].reset();
  places_.leave(port);
  owners_.left(port);
  for (OwedStop& stop : stops_.left(port)) {
    log(fmt::format("host {} has left before its stop was done: the bridge goes on with it", port));
    line_.take_over(std::move(stop));
  }
  std::erase_if(calls_, [&](const auto& one) { return one.second.asker.port == port; });
  for (auto place = streams_.begin(); place != streams_.end();) {
    Stream& stream = place->second;
    const std::int64_t before = stream.interval();
    const bool had_share = stream.shares.erase(port) != 0;
    const std::int64_t after = stream.interval();
    if (had_share && before != after) send(std::nullopt, with_interval(stream.request, after));
    place = end_if_unused(place);
  }
  if (exclusive_ && exclusive_->port == port && exclusive_->is_watched()) {
    exclusive_->port = max_ports;
  } else if (exclusive_ && exclusive_->port == port) {
    end_exclusive();
  } else {
    begin_exclusive();
  }
}

void BridgePorts::end_input(std::size_t port) {
  Host& host = *hosts_[port];
  const bool is_raw = exclusive_host() == port;  // the board has got the bytes already
  host.parser.flush([&](const Frame& frame) {
    if (!is_raw) take_request(port, frame);
  });
}

std::size_t BridgePorts::queued_bytes(std::size_t port) const {
  return room(port) == 0 ? 1 : 0;  // the exact number does not matter
}

std::size_t BridgePorts::room(std::size_t port) const {
  const Host& host = *hosts_[port];
  if (host.must_leave) return 0;
  if (must_wait(port)) return 0;
  if (exclusive_ && exclusive_->port == port) {
    const std::size_t waiting = line_.raw_waiting();
    if (host.output.size() >= max_output || waiting >= max_raw) return 0;
    return std::min(room_of_exclusive_host, max_raw - waiting);
  }
  if (host.pending >= max_requests || host.output.size() >= max_output) return 0;
  // Even if they are all shortest requests, there must not be too many.
  return (max_requests - host.pending) * frame_size(basic_framing, 0);
}

bool BridgePorts::is_quiet(std::size_t port) const {
  const Host& host = *hosts_[port];
  const bool is_restarting = exclusive_ && exclusive_->port == port && !exclusive_->is_active;
  return host.pending == 0 && host.output.empty() && !is_restarting &&
         !owners_.awaits_answer(port, now());
}

void BridgePorts::receive(std::size_t port, std::span<const std::uint8_t> bytes) {
  Host& host = *hosts_[port];
  if (host.must_leave) return;
  host.heard = now();
  if (exclusive_ && exclusive_->port == port && exclusive_->is_active) return receive_raw(bytes);
  host.parser.feed(bytes, [&](const Frame& frame) { take_request(port, frame); });
}

std::span<const std::uint8_t> BridgePorts::output(std::size_t port) const {
  return hosts_[port]->output;
}

void BridgePorts::take(std::size_t port, std::size_t size) {
  std::vector<std::uint8_t>& output = hosts_[port]->output;
  hosts_[port]->told = now();
  output.erase(output.begin(), output.begin() + static_cast<std::ptrdiff_t>(size));
}

void BridgePorts::tick() {
  for (std::size_t port = 0; port < hosts_.size(); ++port) {
    if (!hosts_[port]) continue;
    if (room(port) == 0) hosts_[port]->heard = now();  // it is not silent, but not read
    if (now() - hosts_[port]->heard > idle) end_input(port);
  }
  for (const std::size_t port : places_.overdue(now())) expel(port, "all places are taken");
  if (!exclusive_) start_silent_streams();
  if (!exclusive_ && unanswered_ >= most_unanswered) {
    unanswered_ = 0;
    line_.check();
  }
  if (!exclusive_ || !exclusive_->is_active) return;
  if (exclusive_->is_watched()) return watch_restart();
  const bool is_only_restart = !exclusive_->is_raw && now() - exclusive_->begin > restart_time;
  if (exclusive_->is_back || is_only_restart || now() - exclusive_->last > longest_silence)
    end_exclusive();
}

// A host with exclusive use of the line.

std::optional<std::size_t> BridgePorts::exclusive_host() const {
  if (!exclusive_ || !exclusive_->is_active || exclusive_->port == max_ports) return std::nullopt;
  return exclusive_->port;
}

/// A board that still answers will go down soon: later requests then get an error at once.
bool BridgePorts::must_wait(std::size_t port) const {
  if (!exclusive_) return false;
  if (exclusive_->port == port) return !exclusive_->is_active;
  return !exclusive_->is_watched() || !exclusive_->is_alive;
}

/// Checks that the board is alive if another host may be waiting for it, or after a while.
void BridgePorts::watch_restart() {
  Exclusive& restart = *exclusive_;
  const Duration passed = now() - restart.begin;
  const bool is_silent = restart.unanswered_since != Instant::never &&
                         now() - restart.unanswered_since >= longest_answer;
  if (is_silent) {
    restart.was_down = true;
    restart.is_alive = false;
    restart.introductions.clear();
  }
  if (passed > restart_time + restart_time) return end_exclusive();
  const bool is_alone = std::ranges::none_of(
      hosts_, [&](const auto& host) { return host && host->counters.port != restart.port; });
  const bool is_due = !is_alone || restart.port == max_ports || passed > restart_time;
  if (!is_due || line_.raw_waiting() != 0) return;
  if (restart.unanswered_since == Instant::never) restart.unanswered_since = now();
  restart.introductions.push_back(true);
  line_.write_raw(question_of_introduction());
}

/// Processes bytes of a restarting board; the host gets all but the answers to the bridge.
void BridgePorts::take_sign_of_life(std::span<const std::uint8_t> bytes) {
  Exclusive& restart = *exclusive_;
  bool is_back = false;
  restart.from_board.feed(bytes, [&](const Frame& frame) {
    restart.unanswered_since = Instant::never;
    restart.is_alive = true;
    is_back = is_back || restart.was_down || now() - restart.begin > restart_time ||
              (roles::is_error(frame) && roles::failed_command(frame) == restart.command);
    if (roles::is_introduction(frame) && !restart.introductions.empty()) {
      const bool is_of_bridge = restart.introductions.front();
      restart.introductions.pop_front();
      if (is_of_bridge) return;
    }
    if (is_streamed(frame.id)) {
      give_sample(frame);
    } else if (restart.port != max_ports) {
      give({restart.port, frame.framing}, frame, false);
    }
  });
  const bool is_between_requests =
      line_.raw_waiting() == 0 &&
      (restart.port == max_ports || hosts_[restart.port]->parser.waiting_bytes() == 0);
  if (!is_back || !is_between_requests) return wake_all();
  log("the board has restarted: all hosts have the line again");
  line_.release_line();
  forget_exclusive();
  restart_streams();
}

void BridgePorts::begin_exclusive() {
  if (!exclusive_ || exclusive_->is_active) return;
  const auto is_due_soon = [](const auto& one) { return one.second.is_due_soon; };
  if (std::ranges::any_of(calls_, is_due_soon)) return;
  exclusive_->is_active = true;
  exclusive_->begin = exclusive_->last = now();
  log(fmt::format("host {} has the line for itself while the board restarts", exclusive_->port));
  line_.take_line();
  line_.write_raw(std::move(exclusive_->first));
  wake(exclusive_->port);
}

/// Records a request of the host that restarts the board.
void BridgePorts::note_exclusive(const RawRequest& request) {
  if (request.id == static_cast<std::uint8_t>(msg::BoardInfoRequest::command)) {
    exclusive_->introductions.push_back(false);
  }
  if (!request.policy.restarts_board) return;
  exclusive_->is_plain = exclusive_->is_plain && is_plain_restart(request);
}

void BridgePorts::receive_raw(std::span<const std::uint8_t> bytes) {
  Host& host = *hosts_[exclusive_->port];
  const std::uint64_t skipped = host.parser.counters().skipped_bytes;
  bool is_allowed = true;
  host.parser.feed(bytes, [&](const Frame& frame) {
    ++host.counters.requests;
    is_allowed = may_pass(exclusive_->port, frame) && is_allowed;
    if (const auto request = raw_request(frame.id, frame.body)) note_exclusive(*request);
  });
  if (host.parser.counters().skipped_bytes != skipped) exclusive_->is_raw = true;
  exclusive_->last = now();
  if (!is_allowed) return;  // without its end, the frame is invalid
  line_.write_raw({bytes.begin(), bytes.end()});
}

void BridgePorts::raw_arrived(std::span<const std::uint8_t> bytes) {
  if (!exclusive_ || !exclusive_->is_active) return;
  if (exclusive_->is_watched()) return take_sign_of_life(bytes);
  Host& host = *hosts_[exclusive_->port];
  exclusive_->last = now();
  if (host.output.size() + bytes.size() > max_raw_output) return expel_exclusive();
  host.output.insert(host.output.end(), bytes.begin(), bytes.end());
  bool is_back = false;
  exclusive_->from_board.feed(bytes, [&](const Frame& frame) {
    ++host.counters.messages;
    is_back = is_back || roles::is_introduction(frame);
  });
  // An introduction before the restart does not count as one after it.
  if (is_back && now() - exclusive_->begin > restart_delay) exclusive_->is_back = true;
  wake(exclusive_->port);
}

void BridgePorts::raw_sent() {
  if (exclusive_host()) wake(exclusive_->port);
}

bool BridgePorts::line_lost() {
  unanswered_ = 0;
  if (exclusive_) forget_exclusive();
  return !std::exchange(is_reopening_, false);
}

void BridgePorts::end_exclusive() {
  is_reopening_ = exclusive_->is_active;
  if (exclusive_->is_active) {
    log("the line is opened again for all hosts");
    line_.give_line_back();
  }
  forget_exclusive();
}

void BridgePorts::forget_exclusive() {
  Host* const host = exclusive_->port == max_ports ? nullptr : hosts_[exclusive_->port].get();
  // The rest of its raw bytes is not a request.
  if (host != nullptr && exclusive_->is_active) host->parser.flush([](const Frame&) {});
  exclusive_.reset();
  wake_all();
}

/// Reading the line more slowly would not help: a board's UART does not wait for its reader, so the
/// bytes would be lost there, unnoticed.
void BridgePorts::expel_exclusive() {
  const std::size_t port = exclusive_->port;
  expel(port, "it does not read what the board sends");
  end_exclusive();
}

void BridgePorts::wake_all() {
  for (std::size_t port = 0; port < hosts_.size(); ++port) wake(port);
}

void BridgePorts::take_request(std::size_t port, const Frame& frame) {
  Host& host = *hosts_[port];
  if (host.must_leave) return;
  host.framing = frame.framing;
  ++host.counters.requests;
  places_.speak(port);
  if (!may_pass(port, frame)) {
    return give_error({port, host.framing}, static_cast<msg::CommandToBoard>(frame.id),
                      msg::BoardErrorCode::wrong_state);
  }
  Result<RawRequest> request = raw_request(frame.id, frame.body);
  if (!request) return;
  if (!places_.serves(port, *request)) {
    give_error({port, host.framing}, static_cast<msg::CommandToBoard>(frame.id),
               roles::ErrorReason::temporary);
    if (places_.has_none(port)) expel(port, "all places are taken");
    return;
  }
  const bool is_exclusive = exclusive_ && exclusive_->port == port;
  if (exclusive_ && exclusive_->is_watched() && !is_exclusive) {
    const auto command = static_cast<msg::CommandToBoard>(frame.id);
    return give_error({port, host.framing}, command, roles::ErrorReason::temporary);
  }
  if (is_exclusive || (!exclusive_ && request->policy.restarts_board)) {
    if (!exclusive_) {
      exclusive_ = Exclusive{.port = port, .is_plain = true, .command = request->id};
    }
    note_exclusive(*request);
    std::array<std::uint8_t, max_frame_size> bytes{};
    const std::size_t size = write_frame(host.framing, frame.id, frame.body, bytes).size;
    const auto whole = std::span(bytes).first(size);
    if (exclusive_->is_active) return line_.write_raw({whole.begin(), whole.end()});
    exclusive_->first.insert(exclusive_->first.end(), whole.begin(), whole.end());
    return begin_exclusive();
  }
  if (as_stream_request(*request)) return take_stream_request(port, *request);
  send(port, *std::move(request));
}

void BridgePorts::take_stream_request(std::size_t port, const RawRequest& request) {
  const StreamKey key{request.policy.stream.command, request.policy.stream.config};
  if (has_other_configuration(key)) {
    return refuse_stream({port, hosts_[port]->framing}, key,
                         "one with another configuration is running");
  }
  const auto ended = ended_streams_.find(key.first);
  const bool has_just_ended =
      ended != ended_streams_.end() && now() - ended->second < end_of_stream_time;
  const bool may_mix = !streams_.contains(key) && (has_just_ended || is_streamed(key.first));
  const std::uint64_t tag = send(port, merged(port, request));
  calls_[tag].stream = key;
  const auto stream = streams_.find(key);
  // Until the board confirms, samples belong to the previous stream.
  if (may_mix && stream != streams_.end()) stream->second.starting = tag;
}

void BridgePorts::refuse_stream(const RequestOwner& asker, const StreamKey& key,
                                const char* reason) {
  give_error(asker, roles::StreamRequest::command, roles::ErrorReason::temporary);
  log(fmt::format("host {}: a stream of {} is refused, because {}", asker.port,
                  to_string(static_cast<msg::CommandFromBoard>(key.first)), reason));
}

void BridgePorts::give_error(const RequestOwner& asker, msg::CommandToBoard command,
                             roles::ErrorReason reason) {
  msg::ErrorExt error;
  error.cmd_id = command;
  error.error_code = reason;
  std::array<std::uint8_t, max_body_size> body{};
  const std::size_t size = encode(error, std::span(body)).size;
  const auto id = static_cast<std::uint8_t>(msg::ErrorExt::command);
  give(asker, {.id = id, .body = std::span(body).first(size)}, false);
}

/// Returns false, after reporting it, for a request with a password that is not allowed.
bool BridgePorts::may_pass(std::size_t port, const Frame& request) {
  if (allows_passwords_ || !holds_secret(Direction::to_board, request.id, request.body)) {
    return true;
  }
  log(
      fmt::format("host {}: {} with a password is refused, because it would count for all hosts; "
                  "--allow-passwords lets it pass",
                  port, to_string(static_cast<msg::CommandToBoard>(request.id))));
  return false;
}

bool BridgePorts::has_other_configuration(const StreamKey& key) const {
  return std::ranges::any_of(streams_, [&](const auto& one) {
    return one.first.first == key.first && one.first.second != key.second && one.second.is_wanted();
  });
}

RawRequest BridgePorts::merged(std::size_t port, const RawRequest& request) {
  const StreamChange& change = request.policy.stream;
  const StreamKey key{change.command, change.config};
  const auto message = as_stream_request(request);
  const std::int64_t wanted = roles::stream_interval(*message).raw();
  Stream& stream = streams_[key];
  stream.size = change.size;
  stream.request = request;
  stream.heard = now();
  const auto share = stream.shares.find(port);
  if (wanted != roles::stream_end) {
    // A stream that is ending does not continue if its next start is refused.
    const bool goes_on = share != stream.shares.end() && share->second.end == 0;
    const std::int64_t before = goes_on ? share->second.interval : 0;
    stream.shares[port] = {.interval = wanted, .before = before};
  } else if (share != stream.shares.end()) {
    // Until the board confirms, its samples go to the host, as on a line to the board.
    share->second.end = last_tag_ + 1;
  }
  RawRequest result = with_interval(request, stream.interval());
  if (stream.shares.empty()) streams_.erase(key);
  return result;
}

bool BridgePorts::Stream::is_wanted() const {
  return std::ranges::any_of(shares, [](const auto& one) { return one.second.end == 0; });
}

std::int64_t BridgePorts::Stream::interval() const {
  std::int64_t least = std::numeric_limits<std::int64_t>::max();
  for (const auto& [port, share] : shares) {
    if (share.end == 0) least = std::min(least, share.interval);
  }
  return is_wanted() ? least : roles::stream_end;
}

std::int64_t BridgePorts::Stream::pace() const {
  std::int64_t least = std::numeric_limits<std::int64_t>::max();
  for (const auto& [port, share] : shares) least = std::min(least, share.interval);
  return least;
}

std::uint64_t BridgePorts::send(std::optional<std::size_t> port, RawRequest request) {
  const std::uint64_t tag = ++last_tag_;
  if (port) {
    Host& host = *hosts_[*port];
    const RequestOwner asker{*port, host.framing};
    const bool is_due_soon = !request.policy.is_answered_at_end();
    calls_[tag] = {.asker = asker, .id = request.id, .is_due_soon = is_due_soon};
    owners_.asked(tag, asker, request, now());
    stops_.asked(*port, tag, request);
    if (request.policy.moves && !request.policy.stops) line_.drop_stops();
    ++host.pending;
    request.host = host.id;
  }
  line_.send(tag, std::move(request));
  return tag;
}

// The board's side.

void BridgePorts::answered(std::uint64_t tag, const Frame& frame) {
  owners_.answered(tag, frame, now());
  stops_.answered(tag, frame);
  const auto place = calls_.find(tag);
  if (place == calls_.end()) return;
  Call& call = place->second;
  call.is_due_soon = false;  // a calibration may continue
  if (call.stream && roles::is_error(frame)) refused(tag, call);
  give(call.asker, frame, false);
  begin_exclusive();
}

void BridgePorts::refused_by_line(std::uint64_t tag, const Call& call) {
  if (call.stream) {
    refused(tag, call);
    return refuse_stream(call.asker, *call.stream, "the line has no room for it");
  }
  const auto command = static_cast<msg::CommandToBoard>(call.id);
  give_error(call.asker, command, roles::ErrorReason::temporary);
  log(
      fmt::format("host {}: {} is refused, because a stream of the same message leaves no time for "
                  "it, or the line is overloaded",
                  call.asker.port, to_string(command)));
}

/// Handles the board's refusal of a change of a stream.
void BridgePorts::refused(std::uint64_t tag, const Call& call) {
  const auto stream = streams_.find(*call.stream);
  if (stream == streams_.end()) return;
  const auto share = stream->second.shares.find(call.asker.port);
  if (share == stream->second.shares.end()) return;
  if (share->second.end == tag) {
    share->second.end = 0;
    return;
  }
  if (share->second.before != 0) {
    share->second.interval = share->second.before;
    return;
  }
  stream->second.shares.erase(share);
  if (stream->second.shares.empty()) streams_.erase(stream);
}

void BridgePorts::ended(std::uint64_t tag, std::optional<ErrorCode> failure) {
  const bool timed_out = failure == ErrorCode::timeout;
  if (timed_out) ++unanswered_;
  if (failure && was_not_sent(*failure)) {
    owners_.withdrawn(tag);
  } else {
    owners_.ended(tag, timed_out, now());
  }
  for (auto place = streams_.begin(); place != streams_.end();) {
    Stream& stream = place->second;
    if (stream.starting == tag) stream.starting = 0;
    std::erase_if(stream.shares, [&](const auto& one) { return one.second.end == tag; });
    place = end_if_unused(place);
  }
  // Removed first, because answers wake the host, which may send at once.
  const auto call = calls_.extract(tag);
  if (call.empty()) return;
  const RequestOwner asker = call.mapped().asker;
  const std::size_t port = asker.port;
  if (failure == ErrorCode::overload) refused_by_line(tag, call.mapped());
  if (failure == ErrorCode::superseded) {
    give_error(asker, static_cast<msg::CommandToBoard>(call.mapped().id),
               roles::ErrorReason::wrong_state);
  }
  if (room(port) == 0) hosts_[port]->heard = now();
  --hosts_[port]->pending;
  begin_exclusive();
  wake(port);
}

/// Returns the next stream.
auto BridgePorts::end_if_unused(Streams::iterator place) -> Streams::iterator {
  if (!place->second.shares.empty()) return std::next(place);
  ended_streams_[place->first.first] = now();
  return streams_.erase(place);
}

void BridgePorts::arrived(const BoardFrame& message) {
  const Frame& frame = message.frame;
  heard_ = now();
  unanswered_ = 0;
  stops_.arrived(frame, now());
  if (message.belongs_to_call) {
    if (message.sample == sbgc::Sample::yes) give_sample(frame);
    return;
  }
  if (message.sample == sbgc::Sample::doubtful) return;
  const bool is_answer = message.sample == sbgc::Sample::no || message.is_late;
  if (!is_answer && is_streamed(frame.id)) return give_sample(frame);
  const auto ended = ended_streams_.find(frame.id);
  if (ended != ended_streams_.end() && now() - ended->second < end_of_stream_time) return;
  give_unclaimed(frame);
}

/// Passes on a message that answers no open request: unsolicited, or a late answer.
void BridgePorts::give_unclaimed(const Frame& frame) {
  const RequestOwners::Claim claim = owners_.claim(frame, now());
  // A late answer may be dropped, like an unsolicited message.
  if (claim.asker) return give(*claim.asker, frame, !claim.is_awaited);
  if (claim.is_answer) return;
  is_streamed(frame.id) ? give_sample(frame) : give_all(frame);
}

void BridgePorts::restart_streams() {
  for (auto& [key, stream] : streams_) {
    if (!stream.is_wanted()) continue;
    send(std::nullopt, with_interval(stream.request, stream.interval()));
    stream.heard = now();
    stream.is_started_again = false;
  }
}

void BridgePorts::start_silent_streams() {
  bool is_silent = false;
  for (auto& [key, stream] : streams_) {
    const Duration three_intervals = microseconds(3 * microseconds_of(stream.interval()));
    if (!stream.is_wanted() || now() - stream.heard <= std::max(silence_of_stream, three_intervals))
      continue;
    // Not even the last start was confirmed.
    is_silent = is_silent || (stream.is_started_again && heard_ < stream.heard);
    send(std::nullopt, with_interval(stream.request, stream.interval()));
    stream.heard = now();
    stream.is_started_again = true;
  }
  if (is_silent) line_.check();
}

bool BridgePorts::is_streamed(std::uint8_t id) const {
  return std::ranges::any_of(streams_, [&](const auto& one) { return one.first.first == id; });
}

void BridgePorts::give_sample(const Frame& frame) {
  const auto is_of = [&](const auto& one) {
    return one.first.first == frame.id && one.second.size == frame.body.size();
  };
  // A message with an undocumented size can belong to any stream with this id.
  const bool has_size = std::ranges::any_of(streams_, is_of);
  std::array<bool, max_ports> is_due{};
  for (auto& one : streams_) {
    if (one.first.first != frame.id || (has_size && !is_of(one))) continue;
    if (one.second.starting != 0) continue;
    one.second.heard = now();
    one.second.is_started_again = false;
    const std::int64_t passed = microseconds_of(one.second.pace());
    for (auto& [port, share] : one.second.shares) {
      const std::int64_t wanted = microseconds_of(share.interval);
      share.credit += passed;
      if (share.credit < wanted) continue;
      share.credit = std::min(share.credit - wanted, wanted);
      is_due[port] = true;
    }
  }
  for (std::size_t port = 0; port < is_due.size(); ++port) {
    if (is_due[port]) give(port, frame, true);
  }
}

void BridgePorts::give_all(const Frame& frame) {
  for (std::size_t port = 0; port < hosts_.size(); ++port) {
    if (hosts_[port]) give(port, frame, true);
  }
}

void BridgePorts::give(std::size_t port, const Frame& frame, bool may_be_dropped) {
  give({port, hosts_[port]->framing}, frame, may_be_dropped);
}

void BridgePorts::give(const RequestOwner& to, const Frame& frame, bool may_be_dropped) {
  Host& host = *hosts_[to.port];
  if (host.must_leave) return;
  if (may_be_dropped && host.output.size() > most_for_samples) {
    ++host.counters.dropped;
    return;
  }
  std::array<std::uint8_t, max_frame_size> bytes{};
  const WriteResult written = write_frame(to.framing, frame.id, frame.body, bytes);
  if (!written) return;
  host.output.insert(host.output.end(), bytes.begin(),
                     bytes.begin() + static_cast<std::ptrdiff_t>(written.size));
  ++host.counters.messages;
  wake(to.port);
}

void BridgePorts::log(const std::string& text) const {
  if (log_) log_(text);
}

void BridgePorts::wake(std::size_t port) {
  if (hosts_[port] && hosts_[port]->wake) hosts_[port]->wake();
}

auto BridgePorts::counters() const -> std::vector<HostCounters> {
  std::vector<HostCounters> result;
  for (const auto& host : hosts_) {
    if (host) result.push_back(host->counters);
  }
  return result;
}

}  // namespace sbgc::tools
