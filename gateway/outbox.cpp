#include "gateway/outbox.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "command/remark.hpp"
#include "gateway/reports.hpp"

namespace sbgc::tools {

namespace {

/// The maximum number of unacknowledged messages.
constexpr std::size_t most_unacknowledged = 64;
constexpr std::size_t most_unsent = 256;
/// The pause before a message that the broker has refused, as for a quota, is published again.
constexpr std::chrono::seconds pause_after_refusal{10};
/// Half of the time that a suspension of the broker may remain undetected.
constexpr std::chrono::milliseconds longest_beat_interval{250};
/// The maximum number of events that wait for the thread of the journal.
constexpr std::size_t most_notices = 1'000;
/// The topics of replies are chosen by others.
constexpr std::size_t most_refusals_told = 100;

}  // namespace

Outbox::Outbox(const BrokerSettings& settings, const Topics& topics,
               const DuplicateGatewayDetector& duplicates, Journal& journal, Worker& disk,
               MqttConnection& mqtt)
    : settings_(settings),
      topics_(topics),
      duplicates_(duplicates),
      journal_(journal),
      disk_(disk),
      mqtt_(mqtt) {
  settle_unfinished();
}

/// The results of commands that an earlier gateway had begun are unknown.
void Outbox::settle_unfinished() {
  journal_.begin();
  for (const UnfinishedCommand& one : journal_.unfinished()) {
    const std::size_t end_of_task = one.request.find(' ');
    const std::string rest = one.request.substr(end_of_task + 1);  // of a stop, its key
    const Json result = result_json(
        one.gimbal, one.request.substr(0, end_of_task), one.key.empty() ? rest : one.key,
        {"unknown",
         "gateway_restarted",
         "the gateway ended while the command ran; it may have been carried out",
         {}});
    for (const ReplyAddress& address : journal_.finish(one.id, payload_text(result))) {
      answer(WaitingKind::result, one.gimbal, address, result);
    }
    count("unknown");
  }
  journal_.commit();
  waiting_ = journal_.waiting();
}

void Outbox::notify(WaitingMessage notice) { happen(std::move(notice)); }

void Outbox::finish(std::int64_t command, const std::string& gimbal, const Json& result) {
  happen(Ended{command, gimbal, payload_text(result)});
}

void Outbox::set_at_rest(const std::string& gimbal, std::int64_t command) {
  happen(AtRest{command, gimbal});
}

void Outbox::happen(Happening happening) {
  {
    const std::scoped_lock lock(mutex_);
    const bool is_notice = std::holds_alternative<WaitingMessage>(happening);
    if (is_notice && happenings_.size() >= most_notices) {
      ++overflowed_;
      return;
    }
    happenings_.push_back(std::move(happening));
  }
  disk_.wake();
}

void Outbox::put_sample(std::string topic, std::string payload) {
  if (telemetry_.put(std::move(topic), std::move(payload))) mqtt_.wake();
}

void Outbox::set_state(const std::string& topic, std::string payload) {
  {
    const std::scoped_lock lock(mutex_);
    new_states_[topic] = payload;
    states_[topic] = std::move(payload);
  }
  mqtt_.wake();
}

std::string Outbox::gateway_state(const char* state) const {
  const OutboxStatistics figures = statistics();
  Json json = stamped();
  json["state"] = state;
  duplicates_.sign(json);
  json["waiting"] = figures.waiting;
  json["most_waiting"] = figures.most_waiting;
  json["dropped"] = figures.dropped;
  json["thinned"] = figures.thinned;
  json["ignored"] = figures.ignored;
  return payload_text(json);
}

void Outbox::count(const std::string& status) {
  const std::scoped_lock lock(mutex_);
  ++ended_[status];
}

OutboxStatistics Outbox::statistics() const {
  const std::scoped_lock lock(mutex_);
  const auto ended = [&](const char* status) {
    const auto found = ended_.find(status);
    return found == ended_.end() ? std::uint64_t{0} : found->second;
  };
  return {.thinned = telemetry_.thinned(),
          .dropped = gave_way_ + overflowed_,
          .ignored = ignored_,
          .acknowledged = acknowledged_,
          .waiting = waiting_,
          .most_waiting = settings_.most_waiting,
          .done = ended("done"),
          .failed = ended("failed"),
          .refused = ended("refused"),
          .unknown = ended("unknown")};
}

void Outbox::answer(WaitingKind kind, const std::string& gimbal, const ReplyAddress& address,
                    Json result) {
  WaitingMessage message = answer_to(topics_, gimbal, address, std::move(result));
  message.kind = kind;
  journal_.put(message);
}

void Outbox::connected() {
  refusals_.clear();
  {
    const std::scoped_lock lock(mutex_);
    new_states_ = states_;
  }
  mqtt_.publish({.topic = topics_.of(gateway_level, "state"),
                 .payload = gateway_state("online"),
                 .is_retained = true});
}

void Outbox::acknowledged(int id, const std::string& refused) {
  if (heartbeat_ == id) {
    was_late_ = was_late(MqttConnection::Clock::now());
    heartbeat_.reset();
  }
  const bool is_news =
      !refused.empty() && refusals_.size() < most_refusals_told && refusals_.insert(refused).second;
  if (is_news) remark("sbgc: the broker refuses messages to {}\n", refused);
  const auto found = on_the_way_.find(id);
  if (found == on_the_way_.end()) return;
  {
    const std::scoped_lock lock(mutex_);
    --in_flight_;
    if (refused.empty()) {
      ++acknowledged_;
      delivered_.push_back(found->second);
    } else {
      refused_.push_back({MqttConnection::Clock::now() + pause_after_refusal, found->second});
    }
  }
  on_the_way_.erase(found);
  disk_.wake();
}

bool Outbox::was_late(MqttConnection::Clock::time_point now) {
  const bool is_late = heartbeat_ && now > last_beat_ + GimbalTasks::longest_silence;
  return std::exchange(was_late_, false) || is_late;
}

void Outbox::record() {
  journal_.check_place();
  std::deque<Happening> happenings;
  std::vector<std::int64_t> delivered;
  {
    const std::scoped_lock lock(mutex_);
    happenings.swap(happenings_);
    delivered.swap(delivered_);
  }
  if (!happenings.empty() || !delivered.empty()) {
    journal_.begin();
    for (const std::int64_t id : delivered) journal_.remove(id);
    for (const Happening& happening : happenings) write(happening);
    journal_.commit();
    running_ -= static_cast<std::size_t>(std::ranges::count_if(
        happenings, [](const Happening& one) { return std::holds_alternative<Ended>(one); }));
  }
  waiting_ = journal_.waiting();
  gave_way_ = journal_.dropped();
  load();
}

void Outbox::write(const Happening& happening) {
  if (const auto* const notice = std::get_if<WaitingMessage>(&happening)) {
    journal_.put(*notice);
  } else if (const auto* const rest = std::get_if<AtRest>(&happening)) {
    journal_.set_at_rest(rest->gimbal, rest->command);
  } else if (const auto* const oversized = std::get_if<Oversized>(&happening)) {
    shorten(oversized->message);
  } else {
    const auto& [command, gimbal, result] = std::get<Ended>(happening);
    for (const ReplyAddress& address : journal_.finish(command, result)) {
      answer(WaitingKind::result, gimbal, address, Json::parse(result));
    }
  }
}

void Outbox::shorten(const WaitingMessage& message) {
  remark("sbgc: the broker takes no message of {} bytes to {}\n", message.payload.size(),
         message.topic);
  journal_.remove(message.id);
  if (auto payload = shortened(message.payload)) {
    WaitingMessage rest = message;
    rest.payload = *std::move(payload);
    journal_.put(rest);
  } else {
    ++overflowed_;
  }
}

/// Loads what publish() can send; refused messages that are due come first.
void Outbox::load() {
  std::vector<std::int64_t> again;
  std::size_t room = 0;
  {
    const std::scoped_lock lock(mutex_);
    room = most_unacknowledged - in_flight_;
    const auto now = MqttConnection::Clock::now();
    while (!refused_.empty() && refused_.front().again <= now && again.size() < room) {
      again.push_back(refused_.front().id);
      refused_.pop_front();
    }
  }
  std::vector<WaitingMessage> found;
  for (const std::int64_t id : again) {
    // A notice may have been dropped.
    for (WaitingMessage& one : journal_.waiting_after(id - 1, 1)) {
      if (one.id == id) found.push_back(std::move(one));
    }
  }
  for (WaitingMessage& one : journal_.waiting_after(last_loaded_, room - found.size())) {
    last_loaded_ = one.id;
    found.push_back(std::move(one));
  }
  if (found.empty()) return;
  for (const WaitingMessage& one : found) {
    if (!one.payload.starts_with('{') || !Json::accept(one.payload)) {
      journal_.reject_row("waiting", one.id);
    }
  }
  {
    const std::scoped_lock lock(mutex_);
    in_flight_ += found.size();
    std::ranges::move(found, std::back_inserter(loaded_));
  }
  mqtt_.wake();
}

bool Outbox::publish() {
  publish_waiting();
  publish_states();
  beat();
  return publish_telemetry();
}

void Outbox::publish_waiting() {
  while (true) {
    const WaitingMessage* message = nullptr;  // only this thread removes it
    {
      const std::scoped_lock lock(mutex_);
      const bool is_due =
          !refused_.empty() && refused_.front().again <= MqttConnection::Clock::now();
      if (is_due) disk_.wake();
      if (loaded_.empty()) return;
      message = &loaded_.front();
    }
    const auto id = mqtt_.publish({.topic = message->topic,
                                   .payload = message->payload,
                                   .correlation = message->correlation});
    if (!id) return;
    const bool is_oversized = *id == 0;
    if (is_oversized) {
      happen(Oversized{*message});
    } else {
      on_the_way_[*id] = message->id;
    }
    const std::scoped_lock lock(mutex_);
    if (is_oversized) --in_flight_;
    loaded_.pop_front();
  }
}

void Outbox::publish_states() {
  std::map<std::string, std::string> states;
  {
    const std::scoped_lock lock(mutex_);
    states.swap(new_states_);
  }
  for (auto& [topic, payload] : states) {
    if (mqtt_.publish({.topic = topic, .payload = payload, .is_retained = true})) continue;
    const std::scoped_lock lock(mutex_);
    new_states_.emplace(topic, payload);  // unless there is a newer one
  }
}

/// Returns true if messages are left.
bool Outbox::publish_telemetry() {
  constexpr std::chrono::seconds lifetime{10};
  while (mqtt_.can_publish() && mqtt_.unsent() < most_unsent) {
    std::optional<LatestByTopic::Entry> sample = telemetry_.take();
    if (!sample) return false;
    mqtt_.publish({.topic = std::move(sample->topic),
                   .payload = std::move(sample->payload),
                   .quality = 0,
                   .expiry = lifetime});
  }
  return mqtt_.can_publish();
}

/// A message that the broker must acknowledge shows that it is alive; it also carries statistics.
void Outbox::beat() {
  const auto now = MqttConnection::Clock::now();
  const auto interval = std::min(settings_.stop_after / 4, longest_beat_interval);
  if (heartbeat_ || now < last_beat_ + interval) return;
  last_beat_ = now;
  disk_.wake();  // it checks that the journal still exists
  heartbeat_ = mqtt_.publish(
      {.topic = topics_.of(gateway_level, "heartbeat"), .payload = gateway_state("online")});
}

}  // namespace sbgc::tools
