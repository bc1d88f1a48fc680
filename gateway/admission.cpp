#include "gateway/admission.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include "command/remark.hpp"
#include "command/wording.hpp"
#include "gateway/payload.hpp"
#include "gateway/reports.hpp"

namespace sbgc::tools {

namespace {

using WallTime = std::chrono::system_clock::time_point;

constexpr const char* stop_task = "stop";

/// The timeout for receiving our own message of a barrier.
constexpr std::chrono::seconds barrier_patience{10};
/// The rate limit of answered refusals: garbage must not keep the disk busy.
constexpr double refusals_per_second = 50;
constexpr int most_refusals_at_once = 500;
/// The limits of the queue for the disk. A flood of garbage must not fill it during a commit.
constexpr std::size_t most_received = 10'000;
constexpr std::size_t most_received_bytes = std::size_t{8} << 20U;

}  // namespace

Admission::Admission(const BrokerSettings& settings, const Topics& topics, const Stations& stations,
                     Journal& journal, Worker& disk, Outbox& outbox, MqttConnection& mqtt)
    : settings_(settings),
      topics_(topics),
      stations_(stations),
      journal_(journal),
      disk_(disk),
      outbox_(outbox),
      mqtt_(mqtt),
      barriers_{SubscriptionBarrier(topics_.of(gateway_level, "cmd/fence")),
                SubscriptionBarrier(topics_.of(gateway_level, "raw"))},
      echo_(barriers_[0].topic()),
      refusals_(refusals_per_second, most_refusals_at_once) {}

void Admission::take(std::vector<MqttMessage> messages) {
  const auto now = GimbalTasks::Clock::now();
  watch_delays(now);
  for (MqttMessage& message : messages) {
    if (see_barrier(message)) continue;
    std::optional<CommandTopic> topic = topics_.command(message.topic);
    if (!topic || stop_at_once(*topic, message)) continue;
    queue(*std::move(topic), std::move(message), now);
  }
}

/// While the gateway, the broker or the path between them is suspended, commands wait unnoticed.
/// Messages stored by the broker arrive in order, and so before one of ours; messages that senders
/// could not deliver arrive soon afterwards.
void Admission::watch_delays(GimbalTasks::Clock::time_point now) {
  const bool was_late = outbox_.was_late(now);
  if (was_late || now > last_turn_ + GimbalTasks::longest_silence) {
    speeds_from_ = now + GimbalTasks::longest_silence;
    echo_.close("");
  } else if (echo_.token().empty() && barriers_[0].is_open()) {
    const std::string token = fmt::format("{}-{}", barriers_[0].token(), ++echoes_);
    if (mqtt_.publish({.topic = echo_.topic(), .payload = token})) echo_.close(token);
  }
  last_turn_ = now;
}

bool Admission::see_barrier(const MqttMessage& message) {
  if (message.topic == echo_.topic()) echo_.saw(message.payload);
  for (SubscriptionBarrier& barrier : barriers_) {
    if (message.topic == barrier.topic()) return barrier.saw(message.payload), true;
  }
  return false;
}

/// Stops a gimbal, regardless of other commands, and of errors in the payload. Returns false if the
/// message is not a `stop` or must be refused.
bool Admission::stop_at_once(const CommandTopic& topic, const MqttMessage& message) {
  if (topic.task != stop_task) return false;
  try {
    const Station& station = station_for(topic, message.is_retained);
    station.tasks->run({.order = {.what = StopOrder()}, .done = answer_of_stop(topic, message)});
    return true;
  } catch (const Refusal&) {
    return false;
  }
}

void Admission::queue(CommandTopic topic, MqttMessage message,
                      GimbalTasks::Clock::time_point arrived) {
  const auto station = stations_.find(topic.gimbal);
  const SubscriptionBarrier& barrier = barriers_[topic.task == "raw" ? 1 : 0];
  Received received{.arrived = arrived,
                    .time = std::chrono::system_clock::now(),
                    .connected_at = connected_at_,
                    .barrier = barrier.is_open() ? nullptr : &barrier,
                    .may_be_old = arrived < speeds_from_ || !echo_.is_open(),
                    .stops = station == stations_.end() ? 0 : station->second.tasks->stops()};
  received.topic = std::move(topic);
  received.message = std::move(message);
  const std::size_t size = received.message.payload.size();
  {
    const std::scoped_lock lock(mutex_);
    received.is_excess =
        received_.size() >= most_received || received_bytes_ + size > most_received_bytes;
    const bool is_lost = received.is_excess && !refusals_.take(arrived);
    if (!is_lost) {
      received_bytes_ += size;
      received_.push_back(std::move(received));
      disk_.wake();
      return;
    }
  }
  outbox_.count("refused");
  outbox_.count_dropped();
}

bool Admission::is_settled() const {
  const std::scoped_lock lock(mutex_);
  return received_.empty() && !is_settling_;
}

void Admission::settle() {
  std::vector<Received> received;
  {
    const std::scoped_lock lock(mutex_);
    if (received_.empty()) return;
    received.swap(received_);
    received_bytes_ = 0;
    is_settling_ = true;
  }
  std::vector<Admitted> admitted;
  journal_.begin();
  for (const Received& one : received) {
    if (one.stop) {
      record_stop(one);
    } else if (auto command = settle_one(one)) {
      admitted.push_back(std::move(*command));
    }
  }
  journal_.commit();
  for (const Received& one : received) {
    if (!one.stop) continue;
    finish_stop(one.topic.gimbal, *one.stop);
    if (const auto id = one.stop->id) stations_.at(one.topic.gimbal).tasks->recorded(*id);
  }
  for (Admitted& one : admitted) one.station->tasks->run(std::move(one.job));
  {
    const std::scoped_lock lock(mutex_);
    is_settling_ = false;
  }
  mqtt_.wake();
}

/// Invalid stops are answered at the same rate as refusals.
GimbalTasks::Done Admission::answer_of_stop(const CommandTopic& topic, const MqttMessage& message) {
  CommandPayload payload = addressed_payload(message, {});
  const auto ignored = read_stop_payload(message.payload, topics_, payload);
  if (!ignored.empty()) {
    outbox_.count_ignored();
    if (!may_answer()) {
      outbox_.count_dropped();
      return [this](const TaskOutcome& outcome) { outbox_.count(outcome.status); };
    }
  }
  auto stop = std::make_shared<Stop>();
  stop->key = payload.key;
  stop->reply = {payload.reply, payload.correlation};
  {
    const std::scoped_lock lock(mutex_);
    stop->is_settled = received_.size() >= most_received;
    if (!stop->is_settled) received_.push_back({.stop = stop, .message = {}, .topic = topic});
  }
  disk_.wake();
  return
      [this, gimbal = topic.gimbal, key = payload.key, ignored, stop](const TaskOutcome& outcome) {
        Json result = result_json(gimbal, stop_task, key, outcome);
        if (!ignored.empty()) result["ignored"] = ignored;
        {
          const std::scoped_lock lock(stop->mutex);
          stop->result = std::move(result);
        }
        finish_stop(gimbal, *stop);
        outbox_.count(outcome.status);
      };
}

/// Lets the next gateway continue it and report a result. Its key does not make it a duplicate.
void Admission::record_stop(const Received& received) {
  const Stop& stop = *received.stop;
  const auto id = journal_.admit(
      {received.topic.gimbal, "", fmt::format("{} {}", stop_task, stop.key), stop.reply},
      std::chrono::system_clock::now());
  if (id) {
    journal_.set_moving(received.topic.gimbal, *id);
    outbox_.has_begun();
  }
  const std::scoped_lock lock(received.stop->mutex);
  received.stop->id = id;
  received.stop->is_settled = true;
}

/// If there is no room, the result of a stop that is not in the journal may be dropped.
void Admission::finish_stop(const std::string& gimbal, Stop& stop) {
  const std::scoped_lock lock(stop.mutex);
  if (!stop.is_settled || !stop.result) return;
  Json result = *std::exchange(stop.result, {});
  if (stop.id) {
    outbox_.finish(*stop.id, gimbal, result);
  } else {
    outbox_.notify(answer_to(topics_, gimbal, stop.reply, std::move(result)));
  }
}

std::optional<Admission::Admitted> Admission::settle_one(const Received& received) {
  CommandPayload payload = addressed_payload(received.message, received.time);
  try {
    if (received.topic.task == stop_task) {
      read_stop_payload(received.message.payload, topics_, payload);
    } else {
      read_payload(received.message.payload, topics_, payload);
    }
    const Station& station = station_for(received.topic, received.message.is_retained);
    return admit(received, payload, station);
  } catch (const Refusal& refusal) {
    refuse(received.topic, payload, refusal.code(), refusal.what());
    return {};
  }
}

/// Adds the properties of the message to the payload.
CommandPayload Admission::addressed_payload(const MqttMessage& message, WallTime time) const {
  CommandPayload payload;
  payload.correlation = message.correlation.substr(0, longest_correlation);
  if (topics_.is_reply(message.reply)) payload.reply = message.reply;
  if (is_key(message.key)) payload.key = message.key;
  if (message.expiry) payload.deadline = time + *message.expiry;
  return payload;
}

/// Returns the station that may execute the command. Throws Refusal.
const Station& Admission::station_for(const CommandTopic& topic, bool is_retained) const {
  const auto found = stations_.find(topic.gimbal);
  if (found == stations_.end()) {
    throw Refusal("unknown_gimbal", fmt::format("the fleet has no gimbal '{}'", topic.gimbal));
  }
  const FleetGimbal& settings = found->second.gimbal->settings();
  // Anyone who may command a gimbal may stop it.
  if (topic.task == stop_task ? settings.allow.empty() : !settings.allows(topic.task)) {
    throw Refusal("not_allowed", fmt::format("the configuration does not allow '{}' for '{}'",
                                             clipped(topic.task), topic.gimbal));
  }
  if (is_retained) throw Refusal("retained", "commands must not be retained");
  return found->second;
}

/// Throws Refusal.
std::optional<Admission::Admitted> Admission::admit(const Received& received,
                                                    const CommandPayload& payload,
                                                    const Station& station) {
  const CommandTopic& topic = received.topic;
  const JournalCommand command{topic.gimbal,
                               payload.key,
                               topic.task + ' ' + payload_text(payload.parameters),
                               {payload.reply, payload.correlation}};
  // Before checking times: a broker repeats commands whose acknowledgments it has missed.
  const RecognizedCommand recognized = journal_.recognize(command);
  switch (recognized.recognition) {
    case Recognition::unknown: break;
    case Recognition::running: return {};
    case Recognition::finished: {
      Json result = Json::parse(recognized.result, nullptr, false);
      if (!result.is_object()) journal_.reject_row("commands", recognized.id);
      result["repeated"] = true;
      outbox_.answer(WaitingKind::notice, topic.gimbal, command.reply, std::move(result));
      return {};
    }
    case Recognition::reused: throw Refusal("key_reused", "another command has the same key");
    case Recognition::full: throw Refusal("overload", "too much waits for the broker");
  }
  if (is_closing_) throw Refusal("closing", "the gateway ends");
  if (received.is_excess) throw Refusal("overload", "too much waits for the disk");
  check_times(received, payload);
  Order order = read_order(topic.task, payload.parameters, station.gimbal->settings().raw_effects);
  if (order.must_not_wait) check_freshness(received, payload);
  if (std::holds_alternative<SpeedOrder>(order.what)) check_speed(received, payload);
  const auto id = journal_.admit(command, std::chrono::system_clock::now());
  if (!id) throw Refusal("overload", "too much waits for the broker");
  if (order.sets_in_motion()) journal_.set_moving(topic.gimbal, *id);
  outbox_.has_begun();
  const auto done = [this, id = *id, topic, key = payload.key](const TaskOutcome& outcome) {
    outbox_.finish(id, topic.gimbal, result_json(topic.gimbal, topic.task, key, outcome));
    outbox_.count(outcome.status);
  };
  std::optional<WallTime> deadline = payload.deadline;
  if (deadline) *deadline += settings_.clock_skew;
  return Admitted{&station,
                  {.command = *id,
                   .order = std::move(order),
                   .deadline = deadline,
                   .arrived = received.arrived,
                   .stops = received.stops,
                   .done = done}};
}

/// The clocks of senders may differ from ours by `clock_skew`. Throws Refusal.
void Admission::check_times(const Received& received, const CommandPayload& payload) const {
  if (payload.key.empty()) throw Refusal("invalid", "'key' is missing");
  if (!payload.deadline) throw Refusal("invalid", "'deadline' is missing");
  const auto left = *payload.deadline - received.time;
  if (left < -settings_.clock_skew) throw Refusal("expired", "its deadline has passed");
  if (left > settings_.longest_deadline + settings_.clock_skew) {
    throw Refusal("deadline_too_far",
                  fmt::format("its deadline is more than {} s ahead",
                              std::chrono::duration<double>(settings_.longest_deadline).count()));
  }
}

/// Brokers store commands while the gateway is offline, and some redeliver them long afterwards.
/// Throws Refusal.
void Admission::check_freshness(const Received& received, const CommandPayload& payload) const {
  if (!payload.sent) throw Refusal("invalid", "'sent' is missing");
  if (*payload.sent > received.time + settings_.clock_skew) {
    throw Refusal("sent_in_future", "the clock of its sender is ahead");
  }
  if (*payload.sent < received.connected_at - settings_.clock_skew) {
    throw Refusal("queued", "it was published while the gateway was not connected");
  }
  if (received.barrier != nullptr) {
    throw Refusal(
        "queued",
        fmt::format("it may have waited: the broker has not yet returned a message to {}, "
                    "which the gateway must be allowed to write and to read",
                    received.barrier->topic()));
  }
}

/// A speed is only valid immediately; other motion has its deadline. Throws Refusal.
void Admission::check_speed(const Received& received, const CommandPayload& payload) const {
  const auto age = received.time - *payload.sent;
  if (received.may_be_old || age > GimbalTasks::longest_silence + settings_.clock_skew) {
    throw Refusal("expired", "it may have waited, and a speed that waits is not wanted");
  }
}

bool Admission::may_answer() {
  const std::scoped_lock lock(mutex_);
  return refusals_.take(GimbalTasks::Clock::now());
}

void Admission::refuse(const CommandTopic& topic, const CommandPayload& payload, const char* code,
                       const std::string& message) {
  outbox_.count("refused");
  // Only the fleet's gimbals have topics for events.
  if (payload.reply.empty() && !stations_.contains(topic.gimbal)) return;
  if (!may_answer()) {
    outbox_.count_dropped();
    return;
  }
  outbox_.answer(WaitingKind::notice, topic.gimbal, {payload.reply, payload.correlation},
                 result_json(clipped(topic.gimbal), clipped(topic.task), payload.key,
                             {"refused", code, message, {}}));
}

void Admission::connected() {
  connected_at_ = std::chrono::system_clock::now();
  const auto now = unix_milliseconds(connected_at_);
  for (SubscriptionBarrier& barrier : barriers_)
    barrier.close(fmt::format("{}-{}", ::getpid(), now));
  echo_.close(barriers_[0].token());
  last_turn_ = GimbalTasks::Clock::now();
  speeds_from_ = last_turn_ + GimbalTasks::longest_silence;
  mqtt_.subscribe({topics_.of("+", "cmd/+"), topics_.of("+", "raw")}, 1);
}

void Admission::subscribed() {
  for (const SubscriptionBarrier& barrier : barriers_)
    mqtt_.publish({.topic = barrier.topic(), .payload = barrier.token()});
  barred_ = MqttConnection::Clock::now();
}

void Admission::lost() {
  for (SubscriptionBarrier& barrier : barriers_) barrier.close("");
  echo_.close("");
  barred_.reset();
}

void Admission::watch_barriers() {
  if (!barred_ || MqttConnection::Clock::now() < *barred_ + barrier_patience) return;
  barred_.reset();
  for (const SubscriptionBarrier& barrier : barriers_) {
    if (barrier.is_open()) continue;
    remark(
        "sbgc: warning: motion is refused, because the broker has not returned a message to {}: "
        "the gateway must be allowed to write and to read it\n",
        barrier.topic());
  }
}

}  // namespace sbgc::tools
