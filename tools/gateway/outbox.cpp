#include "gateway/outbox.hpp"

#include <utility>

#include "command/remark.hpp"
#include "gateway/reports.hpp"

namespace sbgc::tools {

namespace {

/// Messages on the way to the broker.
constexpr std::size_t most_unacknowledged = 64;
constexpr std::size_t most_unsent = 256;
/// After which a message that the broker has refused, as for a quota, is published again.
constexpr std::chrono::seconds pause_after_refusal{10};
/// Events that wait for the thread of the broker.
constexpr std::size_t most_notices = 1'000;

}  // namespace

Outbox::Outbox(const BrokerSettings& settings, const Topics& topics, const Rivals& rivals,
               Journal& journal, MqttConnection& mqtt)
    : settings_(settings), topics_(topics), rivals_(rivals), journal_(journal), mqtt_(mqtt) {
  settle_unfinished();
}

/// Nobody knows what became of commands that an earlier gateway had begun.
void Outbox::settle_unfinished() {
  journal_.begin();
  for (const UnfinishedCommand& one : journal_.unfinished()) {
    const Json result =
        result_json(one.gimbal, one.request.substr(0, one.request.find(' ')), one.key,
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

void Outbox::finish(std::int64_t command, const CommandTopic& topic, const std::string& key,
                    const TaskOutcome& outcome) {
  happen(Ended{command, topic.gimbal,
               payload_text(result_json(topic.gimbal, topic.task, key, outcome))});
  count(outcome.status);
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
  mqtt_.wake();
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
  rivals_.sign(json);
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
  {
    const std::scoped_lock lock(mutex_);
    new_states_ = states_;
  }
  mqtt_.publish({.topic = topics_.of(gateway_level, "state"),
                 .payload = gateway_state("online"),
                 .is_retained = true});
}

void Outbox::acknowledged(int id, const std::string& refused) {
  if (heartbeat_ == id) heartbeat_.reset();
  const bool is_news = refused != std::exchange(last_refusal_, refused);
  if (is_news && !refused.empty()) remark("sbgc: the broker refuses messages: {}\n", refused);
  const auto found = on_the_way_.find(id);
  if (found == on_the_way_.end()) return;
  if (refused.empty()) {
    ++acknowledged_;
    delivered_.push_back(found->second);
  } else {
    refused_.push_back({MqttConnection::Clock::now() + pause_after_refusal, found->second});
  }
  on_the_way_.erase(found);
}

void Outbox::record() {
  std::deque<Happening> happenings;
  {
    const std::scoped_lock lock(mutex_);
    happenings.swap(happenings_);
  }
  if (happenings.empty() && delivered_.empty()) return;
  journal_.begin();
  for (const std::int64_t id : std::exchange(delivered_, {})) journal_.remove(id);
  std::size_t ended = 0;
  for (const Happening& happening : happenings) {
    if (const auto* const notice = std::get_if<WaitingMessage>(&happening)) {
      journal_.put(*notice);
    } else if (const auto* const rest = std::get_if<AtRest>(&happening)) {
      journal_.set_at_rest(rest->gimbal, rest->command);
    } else {
      const auto& [command, gimbal, result] = std::get<Ended>(happening);
      ++ended;
      for (const ReplyAddress& address : journal_.finish(command, result)) {
        answer(WaitingKind::result, gimbal, address, Json::parse(result));
      }
    }
  }
  journal_.commit();
  running_ -= ended;
  waiting_ = journal_.waiting();
  gave_way_ = journal_.dropped();
}

bool Outbox::publish() {
  publish_waiting();
  publish_states();
  beat();
  return publish_telemetry();
}

void Outbox::publish_waiting() {
  const auto now = MqttConnection::Clock::now();
  while (!refused_.empty() && refused_.front().again <= now &&
         on_the_way_.size() < most_unacknowledged) {
    const std::int64_t id = refused_.front().id;
    const std::vector<WaitingMessage> found = journal_.waiting_after(id - 1, 1);
    // A notice may have given way.
    const bool is_there = !found.empty() && found.front().id == id;
    if (is_there && !publish_one(found.front())) return;
    refused_.pop_front();
  }
  if (on_the_way_.size() >= most_unacknowledged) return;
  for (const WaitingMessage& one :
       journal_.waiting_after(last_published_, most_unacknowledged - on_the_way_.size())) {
    if (!publish_one(one)) return;
    last_published_ = one.id;
  }
}

/// Returns false if it cannot be sent now.
bool Outbox::publish_one(const WaitingMessage& message) {
  const auto id = mqtt_.publish(
      {.topic = message.topic, .payload = message.payload, .correlation = message.correlation});
  if (!id) return false;
  if (*id == 0) {
    shorten(message);
  } else {
    on_the_way_[*id] = message.id;
  }
  return true;
}

/// The broker never takes it as it is.
void Outbox::shorten(const WaitingMessage& message) {
  remark("sbgc: the broker takes no message of {} bytes to {}\n", message.payload.size(),
         message.topic);
  journal_.begin();
  journal_.remove(message.id);
  if (auto payload = shortened(message.payload)) {
    WaitingMessage rest = message;
    rest.payload = *std::move(payload);
    journal_.put(rest);
  } else {
    ++overflowed_;
  }
  journal_.commit();
  waiting_ = journal_.waiting();
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

/// Returns true if some is left.
bool Outbox::publish_telemetry() {
  constexpr std::chrono::seconds lifetime{10};
  while (mqtt_.can_publish() && mqtt_.unsent() < most_unsent) {
    std::optional<Newest::Entry> sample = telemetry_.take();
    if (!sample) return false;
    mqtt_.publish({.topic = std::move(sample->topic),
                   .payload = std::move(sample->payload),
                   .quality = 0,
                   .expiry = lifetime});
  }
  return mqtt_.can_publish();
}

/// A message that the broker must acknowledge shows that it is there; it also carries figures.
void Outbox::beat() {
  const auto now = MqttConnection::Clock::now();
  if (heartbeat_ || now < last_beat_ + settings_.stop_after / 4) return;
  last_beat_ = now;
  heartbeat_ = mqtt_.publish(
      {.topic = topics_.of(gateway_level, "heartbeat"), .payload = gateway_state("online")});
}

}  // namespace sbgc::tools
