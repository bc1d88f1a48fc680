#include "gateway/broker.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <csignal>
#include <deque>
#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <thread>
#include <unordered_map>
#include <utility>

#include <fmt/format.h>
#include <unistd.h>

#include "command/remark.hpp"
#include "command/wording.hpp"
#include "gateway/allowance.hpp"
#include "gateway/gimbal_tasks.hpp"
#include "gateway/journal.hpp"
#include "gateway/mqtt.hpp"
#include "gateway/newest.hpp"
#include "gateway/payload.hpp"

namespace sbgc::tools {

namespace {

using std::chrono::milliseconds;
using WallTime = std::chrono::system_clock::time_point;

/// The level of the gateway's own topics.
constexpr const char* gateway_level = "gateway";
constexpr const char* stop_task = "stop";

/// Messages on the way to the broker.
constexpr std::size_t most_unacknowledged = 64;
constexpr std::size_t most_unsent = 256;
/// After which a message that the broker has refused, as for a quota, is published again.
constexpr std::chrono::seconds pause_after_refusal{10};
/// How long our own message of a fence may take.
constexpr std::chrono::seconds fence_patience{10};
/// Events that wait for the thread of the broker.
constexpr std::size_t most_notices = 1'000;
/// Refusals that are answered: garbage must not keep the disk busy.
constexpr double refusals_per_second = 50;
constexpr int most_refusals_at_once = 500;

std::int64_t unix_milliseconds(WallTime time) {
  return std::chrono::duration_cast<milliseconds>(time.time_since_epoch()).count();
}

/// The beginning of every payload.
Json stamped(WallTime time = std::chrono::system_clock::now()) {
  return {{"version", payload_version}, {"time", unix_milliseconds(time)}};
}

BrokerSettings with_client_id(const Fleet& fleet) {
  BrokerSettings settings = *fleet.broker;
  if (settings.client_id.empty()) settings.client_id = "sbgc-" + fleet.name;
  return settings;
}

std::string payload_text(const Json& json) { return detail::json_text(json); }

std::string sample_text(const AnyMessage& message, WallTime time) {
  return fmt::format(R"({{"version":{},"time":{},"message":"{}","fields":{}}})", payload_version,
                     unix_milliseconds(time), message.type().info->name, message.to_json());
}

/// What all results have; those of a command with a key are kept without the address.
Json result_json(const std::string& gimbal, const std::string& task, const std::string& key,
                 const TaskOutcome& outcome) {
  Json result = stamped();
  result["gimbal"] = gimbal;
  result["task"] = task;
  if (!key.empty()) result["key"] = key;
  result["status"] = outcome.status;
  if (!outcome.code.empty()) {
    result["error"] = {{"code", outcome.code}, {"message", outcome.message}};
  }
  if (!outcome.result.is_null()) result["result"] = outcome.result;
  return result;
}

/// Leaves out what a result or an event reports at length; nothing if there is no such thing.
std::optional<std::string> shortened(const std::string& payload) {
  Json json = Json::parse(payload);
  Json& result = json.contains("event") && json.contains("result") ? json["result"] : json;
  const std::size_t erased = json.erase("report") + result.erase("result");
  if (erased == 0) return {};
  json["shortened"] = true;
  return payload_text(json);
}

bool is_utf8(std::string_view text) {
  bool is_valid = true;
  detail::for_each_sequence(text, [&](std::string_view, bool valid) { is_valid &= valid; });
  return is_valid;
}

}  // namespace

/// Detects what was published before a subscription: commands come in their order, so those that
/// come before our own message have waited at the broker.
class Broker::Fence {
 public:
  explicit Fence(std::string topic) : topic_(std::move(topic)) {}

  const std::string& topic() const noexcept { return topic_; }
  bool is_open() const noexcept { return is_open_; }
  void close(std::string token) {
    token_ = std::move(token);
    is_open_ = false;
  }
  void saw(const std::string& payload) { is_open_ = is_open_ || payload == token_; }
  const std::string& token() const noexcept { return token_; }

 private:
  std::string topic_;
  std::string token_{};
  bool is_open_ = false;
};

class Broker::Impl {
 public:
  Impl(const Fleet& fleet, const std::vector<std::unique_ptr<Gimbal>>& gimbals);

  void start() { mqtt_.start(); }
  void close();
  Statistics statistics() const;
  std::string failure() const;

 private:
  struct Station {
    Gimbal* gimbal{};
    std::shared_ptr<GimbalTasks> tasks{};
  };
  /// A message of the journal that the broker has not taken.
  struct RefusedMessage {
    MqttConnection::Clock::time_point again{};
    std::int64_t id{};
  };
  /// The end of a command or of a motion, or a notice, on its way to the thread of the broker.
  struct Happening {
    std::int64_t command{};  // or 0
    std::string result{};
    std::string at_rest{};  // the gimbal that `command` and those before do not move any more
    MqttPublication notice{};
  };
  /// A command that is to be carried out once it is on the disk.
  struct Admitted {
    Station* station{};
    GimbalTasks::Job job{};
  };

  /// True if a later `stop` for the gimbal has come with a command.
  using IsOvertaken = std::function<bool(const Station&)>;

  MqttConnection::Handlers mqtt_handlers();
  MqttPublication will() const;
  void add_station(Gimbal& gimbal, std::optional<std::int64_t> moved_by);

  // On the thread of the broker.
  void settle_unfinished();
  void take(std::vector<MqttMessage> messages);
  const Station* stop_at_once(const MqttMessage& message);
  std::optional<Admitted> take_one(const MqttMessage& message, const IsOvertaken& is_overtaken);
  CommandPayload addressed_payload(const MqttMessage& message) const;
  Station& station_for(const CommandTopic& topic, bool is_retained);
  std::optional<Admitted> admit(const CommandTopic& topic, const CommandPayload& payload,
                                Station& station, bool is_overtaken);
  void check_times(const CommandPayload& payload) const;
  void check_freshness(const CommandTopic& topic, const CommandPayload& payload) const;
  void refuse(const CommandTopic& topic, const CommandPayload& payload, const char* code,
              const std::string& message);
  WaitingMessage answer_to(const std::string& gimbal, const ReplyAddress& address,
                           Json result) const;
  void answer(WaitingKind kind, const std::string& gimbal, const ReplyAddress& address,
              Json result);
  void connected();
  void subscribed();
  void lost(const std::string& reason);
  bool idle();
  void record_happenings();
  void publish_waiting();
  bool publish_one(const WaitingMessage& message);
  void shorten(const WaitingMessage& message);
  void publish_states();
  bool publish_telemetry();
  void beat();
  void watch_fences();
  void fail(const std::string& problem);

  // On any thread.
  void happen(Happening happening);
  void set_state(const std::string& topic, std::string payload);
  void count(const std::string& status);
  bool is_there() const;
  std::string gateway_state(const char* state) const;

  const BrokerSettings settings_;
  const bool has_metrics_;
  const milliseconds longest_deadline_;
  const Topics topics_;
  Journal journal_;
  std::map<std::string, Station> stations_{};
  std::array<Fence, 2> fences_;

  // Shared:
  Newest telemetry_{};
  mutable std::mutex mutex_{};
  std::deque<Happening> happenings_{};
  std::map<std::string, std::string> states_{};      // by topic
  std::map<std::string, std::string> new_states_{};  // that are not published
  std::uint64_t overflowed_ = 0;                     // notices that gave way in memory
  std::string failure_{};
  std::map<std::string, std::uint64_t> ended_{};  // commands by status
  std::atomic<bool> is_connected_{false};
  std::atomic<bool> is_closing_{false};
  std::atomic<std::uint64_t> acknowledged_{0};
  std::atomic<std::size_t> waiting_{0};
  std::atomic<std::uint64_t> dropped_{0};
  std::atomic<std::size_t> running_{0};

  // Of the thread of the broker:
  std::unordered_map<int, std::int64_t> on_the_way_{};  // messages of the journal by their MQTT id
  std::vector<std::int64_t> delivered_{};               // of these, acknowledged
  std::deque<RefusedMessage> refused_{};                // of these, the others
  std::string last_refusal_{};
  std::int64_t last_published_ = 0;
  std::optional<int> heartbeat_{};
  MqttConnection::Clock::time_point last_beat_{};
  std::optional<MqttConnection::Clock::time_point> fenced_{};
  std::string last_problem_{};
  WallTime connected_at_{};
  Allowance refusals_{refusals_per_second, most_refusals_at_once};

  MqttConnection mqtt_;  // last: its thread uses the others
};

Broker::Impl::Impl(const Fleet& fleet, const std::vector<std::unique_ptr<Gimbal>>& gimbals)
    : settings_(with_client_id(fleet)),
      has_metrics_(fleet.metrics.has_value()),
      longest_deadline_(settings_.longest_deadline),
      topics_(fleet.name),
      journal_(settings_.journal, {.most_waiting = settings_.most_waiting,
                                   .history = settings_.history,
                                   .keep = settings_.longest_deadline + 2 * settings_.clock_skew}),
      fences_{Fence(topics_.of(gateway_level, "cmd/fence")),
              Fence(topics_.of(gateway_level, "raw"))},
      mqtt_(settings_, will(), mqtt_handlers()) {
  settle_unfinished();
  const std::map<std::string, std::int64_t> moved_by = journal_.moving();
  for (const auto& gimbal : gimbals) {
    const auto found = moved_by.find(gimbal->name());
    add_station(*gimbal, found == moved_by.end() ? std::optional<std::int64_t>() : found->second);
  }
}

MqttConnection::Handlers Broker::Impl::mqtt_handlers() {
  return {.on_messages = [this](std::vector<MqttMessage> messages) { take(std::move(messages)); },
          .on_connected = [this] { connected(); },
          .on_lost = [this](const std::string& reason) { lost(reason); },
          .on_subscribed = [this] { subscribed(); },
          .on_acknowledged =
              [this](int id, const std::string& refused) {
                if (heartbeat_ == id) heartbeat_.reset();
                const bool is_news = refused != std::exchange(last_refusal_, refused);
                if (is_news && !refused.empty()) {
                  remark("sbgc: the broker refuses messages: {}\n", refused);
                }
                const auto found = on_the_way_.find(id);
                if (found == on_the_way_.end()) return;
                if (refused.empty()) {
                  ++acknowledged_;
                  delivered_.push_back(found->second);
                } else {
                  refused_.push_back(
                      {MqttConnection::Clock::now() + pause_after_refusal, found->second});
                }
                on_the_way_.erase(found);
              },
          .on_idle = [this] { return idle(); },
          .on_failure = [this](const std::string& problem) { fail(problem); }};
}

MqttPublication Broker::Impl::will() const {
  // Without a time: the broker keeps it until it is needed.
  return {.topic = topics_.of(gateway_level, "state"),
          .payload = payload_text({{"version", payload_version}, {"state", "offline"}}),
          .is_retained = true};
}

void Broker::Impl::add_station(Gimbal& gimbal, std::optional<std::int64_t> moved_by) {
  const std::string& name = gimbal.name();
  const std::string event_topic = topics_.of(name, "event");
  const auto notify = [this, event_topic](const std::string& kind, const std::string& message) {
    Json event = stamped();
    event["event"] = kind;
    event["message"] = message;
    happen({.notice = {.topic = event_topic, .payload = payload_text(event)}});
  };
  const auto at_rest = [this, name](std::int64_t command) {
    happen({.command = command, .at_rest = name});
  };
  auto tasks = std::make_shared<GimbalTasks>(
      gimbal, GimbalTasks::Hooks{[this] { return is_there(); }, notify, at_rest}, moved_by);
  gimbal.on_status([this, tasks, topic = topics_.of(name, "state"),
                    allow = gimbal.settings().allow](const GimbalStatus& state) {
    tasks->link_changed(state.link == GimbalLink::online);
    Json json = stamped();
    json["state"] = sbgc::tools::name(state.link);
    if (!state.reason.empty()) json["reason"] = state.reason;
    json["firmware"] = state.firmware;
    json["board"] = state.board;
    json["serial_number"] = state.serial_number;
    json["connections"] = state.connections;
    json["allow"] = allow;
    set_state(topic, payload_text(json));
  });
  gimbal.on_telemetry(
      [this, prefix = topics_.of(name, "telemetry/")](const AnyMessage& message, WallTime time) {
        if (telemetry_.put(prefix + message.type().info->name, sample_text(message, time))) {
          mqtt_.wake();
        }
      });
  gimbal.on_event([this, event_topic](const GimbalEvent& event, WallTime time) {
    Json json = stamped(time);
    json["event"] = event.kind;
    json["message"] = event.message;
    if (event.report != nullptr) {
      json["report"] = {{"message", event.report->type().info->name},
                        {"fields", Json::parse(event.report->to_json())}};
    }
    happen({.notice = {.topic = event_topic, .payload = payload_text(json)}});
  });
  stations_[name] = {&gimbal, std::move(tasks)};
}

/// Nobody knows what became of commands that an earlier gateway had begun.
void Broker::Impl::settle_unfinished() {
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

void Broker::Impl::take(std::vector<MqttMessage> messages) {
  const auto arrived = GimbalTasks::Clock::now();
  // Before the disk is asked, and before all that has come with them.
  std::map<const Station*, std::size_t> stops;  // the last one of each gimbal
  std::vector<const Station*> stopped(messages.size());
  for (std::size_t i = 0; i < messages.size(); ++i) {
    stopped[i] = stop_at_once(messages[i]);
    if (stopped[i] != nullptr) stops[stopped[i]] = i;
  }
  std::vector<Admitted> admitted;
  journal_.begin();
  for (std::size_t i = 0; i < messages.size(); ++i) {
    if (stopped[i] != nullptr) continue;
    const auto is_overtaken = [&](const Station& station) {
      const auto found = stops.find(&station);
      return found != stops.end() && i < found->second;
    };
    if (auto one = take_one(messages[i], is_overtaken)) admitted.push_back(std::move(*one));
  }
  journal_.commit();
  for (Admitted& one : admitted) {
    one.job.arrived = arrived;
    one.station->tasks->run(std::move(one.job));
  }
}

/// Stops a gimbal, whatever waits or was commanded before. Returns null if the message is no `stop`
/// or is refused, which take_one() does.
const Broker::Impl::Station* Broker::Impl::stop_at_once(const MqttMessage& message) {
  const std::optional<CommandTopic> topic = topics_.command(message.topic);
  if (!topic || topic->task != stop_task) return nullptr;
  CommandPayload payload = addressed_payload(message);
  try {
    read_payload(message.payload, topics_, payload);
    Station& station = station_for(*topic, message.is_retained);
    Order order = read_order(stop_task, payload.parameters, {});
    const auto done =
        [this, gimbal = topic->gimbal, key = payload.key,
         reply = ReplyAddress{payload.reply, payload.correlation}](const TaskOutcome& outcome) {
          WaitingMessage result =
              answer_to(gimbal, reply, result_json(gimbal, stop_task, key, outcome));
          happen({.notice = {.topic = std::move(result.topic),
                             .payload = std::move(result.payload),
                             .correlation = std::move(result.correlation)}});
          count(outcome.status);
        };
    station.tasks->run({.order = std::move(order), .done = done});
    return &station;
  } catch (const Refusal&) {
    return nullptr;
  }
}

std::optional<Broker::Impl::Admitted> Broker::Impl::take_one(const MqttMessage& message,
                                                             const IsOvertaken& is_overtaken) {
  for (Fence& fence : fences_) {
    if (message.topic == fence.topic()) return fence.saw(message.payload), std::nullopt;
  }
  const std::optional<CommandTopic> topic = topics_.command(message.topic);
  if (!topic) return {};
  CommandPayload payload = addressed_payload(message);
  try {
    read_payload(message.payload, topics_, payload);
    Station& station = station_for(*topic, message.is_retained);
    return admit(*topic, payload, station, is_overtaken(station));
  } catch (const Refusal& refusal) {
    refuse(*topic, payload, refusal.code(), refusal.what());
    return {};
  }
}

/// With what the properties of the message say.
CommandPayload Broker::Impl::addressed_payload(const MqttMessage& message) const {
  CommandPayload payload;
  payload.correlation = message.correlation.substr(0, longest_correlation);
  if (topics_.is_reply(message.reply)) payload.reply = message.reply;
  if (is_key(message.key)) payload.key = message.key;
  if (message.expiry) payload.deadline = std::chrono::system_clock::now() + *message.expiry;
  return payload;
}

/// Returns the one that may carry out the command. Throws Refusal.
Broker::Impl::Station& Broker::Impl::station_for(const CommandTopic& topic, bool is_retained) {
  const auto found = stations_.find(topic.gimbal);
  if (found == stations_.end()) {
    throw Refusal("unknown_gimbal", fmt::format("the fleet has no gimbal '{}'", topic.gimbal));
  }
  const FleetGimbal& settings = found->second.gimbal->settings();
  // Whoever may command a gimbal may stop it.
  if (topic.task == stop_task ? settings.allow.empty() : !settings.allows(topic.task)) {
    throw Refusal("not_allowed", fmt::format("the configuration does not allow '{}' for '{}'",
                                             clipped(topic.task), topic.gimbal));
  }
  if (is_retained) throw Refusal("retained", "commands must not be retained");
  return found->second;
}

/// Throws Refusal.
std::optional<Broker::Impl::Admitted> Broker::Impl::admit(const CommandTopic& topic,
                                                          const CommandPayload& payload,
                                                          Station& station, bool is_overtaken) {
  const JournalCommand command{topic.gimbal,
                               payload.key,
                               topic.task + ' ' + payload_text(payload.parameters),
                               {payload.reply, payload.correlation}};
  // Before the times: a broker repeats commands whose acknowledgments it has missed.
  const RecognizedCommand recognized = journal_.recognize(command);
  switch (recognized.recognition) {
    case Recognition::unknown: break;
    case Recognition::running: return {};
    case Recognition::finished: {
      Json result = Json::parse(recognized.result);
      result["repeated"] = true;
      answer(WaitingKind::notice, topic.gimbal, command.reply, std::move(result));
      return {};
    }
    case Recognition::reused: throw Refusal("key_reused", "another command has the same key");
    case Recognition::full: throw Refusal("overload", "too much waits for the broker");
  }
  if (is_closing_) throw Refusal("closing", "the gateway ends");
  check_times(payload);
  Order order = read_order(topic.task, payload.parameters, station.gimbal->settings().raw_effects);
  if (order.must_not_wait && is_overtaken && !order.is_urgent) {
    throw Refusal("superseded", "a later command stops the camera");
  }
  if (order.must_not_wait) check_freshness(topic, payload);
  const auto id = journal_.admit(command, std::chrono::system_clock::now());
  if (!id) throw Refusal("overload", "too much waits for the broker");
  if (order.sets_in_motion()) journal_.set_moving(topic.gimbal, *id);
  ++running_;
  const auto done = [this, id = *id, topic, key = payload.key](const TaskOutcome& outcome) {
    happen({.command = id,
            .result = payload_text(result_json(topic.gimbal, topic.task, key, outcome)),
            .notice = {.topic = topic.gimbal}});
    count(outcome.status);
  };
  std::optional<WallTime> deadline = payload.deadline;
  if (deadline) *deadline += settings_.clock_skew;
  return Admitted{&station,
                  {.command = *id, .order = std::move(order), .deadline = deadline, .done = done}};
}

/// The clocks of senders may differ from ours by `clock_skew`. Throws Refusal.
void Broker::Impl::check_times(const CommandPayload& payload) const {
  if (payload.key.empty()) throw Refusal("invalid", "'key' is missing");
  if (!payload.deadline) throw Refusal("invalid", "'deadline' is missing");
  const auto left = *payload.deadline - std::chrono::system_clock::now();
  if (left < -settings_.clock_skew) throw Refusal("expired", "its deadline has passed");
  if (left > longest_deadline_ + settings_.clock_skew) {
    throw Refusal("deadline_too_far",
                  fmt::format("its deadline is more than {} s ahead",
                              std::chrono::duration<double>(longest_deadline_).count()));
  }
}

/// Brokers keep commands while the gateway is away, and some deliver them again long afterwards.
/// Throws Refusal.
void Broker::Impl::check_freshness(const CommandTopic& topic, const CommandPayload& payload) const {
  if (!payload.sent) throw Refusal("invalid", "'sent' is missing");
  if (*payload.sent > std::chrono::system_clock::now() + settings_.clock_skew) {
    throw Refusal("sent_in_future", "the clock of its sender is ahead");
  }
  if (*payload.sent < connected_at_ - settings_.clock_skew ||
      !fences_[topic.task == "raw" ? 1 : 0].is_open()) {
    throw Refusal("queued", "it was published while the gateway was not connected");
  }
}

void Broker::Impl::refuse(const CommandTopic& topic, const CommandPayload& payload,
                          const char* code, const std::string& message) {
  count("refused");
  // Only the fleet's gimbals have topics for events.
  if (payload.reply.empty() && !stations_.contains(topic.gimbal)) return;
  if (!refusals_.take(GimbalTasks::Clock::now())) {
    const std::scoped_lock lock(mutex_);
    ++overflowed_;
    return;
  }
  answer(WaitingKind::notice, topic.gimbal, {payload.reply, payload.correlation},
         result_json(clipped(topic.gimbal), clipped(topic.task), payload.key,
                     {"refused", code, message, {}}));
}

/// A result: to the address or, without one, among the events of the gimbal.
WaitingMessage Broker::Impl::answer_to(const std::string& gimbal, const ReplyAddress& address,
                                       Json result) const {
  if (!address.correlation.empty() && is_utf8(address.correlation)) {
    result["correlation"] = address.correlation;
  }
  WaitingMessage message{.correlation = address.correlation};
  if (address.topic.empty()) {
    Json event = stamped();
    event["event"] = "result";
    event["result"] = std::move(result);
    message.topic = topics_.of(gimbal, "event");
    message.payload = payload_text(event);
  } else {
    message.topic = address.topic;
    message.payload = payload_text(result);
  }
  return message;
}

/// Puts a result on the disk.
void Broker::Impl::answer(WaitingKind kind, const std::string& gimbal, const ReplyAddress& address,
                          Json result) {
  WaitingMessage message = answer_to(gimbal, address, std::move(result));
  message.kind = kind;
  journal_.put(message);
}

void Broker::Impl::connected() {
  is_connected_ = true;
  if (!last_problem_.empty()) remark("sbgc: connected to the broker\n");
  last_problem_.clear();
  connected_at_ = std::chrono::system_clock::now();
  const auto now = unix_milliseconds(connected_at_);
  for (Fence& fence : fences_) fence.close(fmt::format("{}-{}", ::getpid(), now));
  {
    const std::scoped_lock lock(mutex_);
    new_states_ = states_;
  }
  mqtt_.subscribe({topics_.of("+", "cmd/+"), topics_.of("+", "raw")});
  mqtt_.publish({.topic = topics_.of(gateway_level, "state"),
                 .payload = gateway_state("online"),
                 .is_retained = true});
}

void Broker::Impl::subscribed() {
  for (const Fence& fence : fences_)
    mqtt_.publish({.topic = fence.topic(), .payload = fence.token()});
  fenced_ = MqttConnection::Clock::now();
}

void Broker::Impl::lost(const std::string& reason) {
  is_connected_ = false;
  for (Fence& fence : fences_) fence.close("");
  fenced_.reset();
  if (reason != last_problem_) remark("sbgc: no connection to the broker: {}\n", reason);
  last_problem_ = reason;
}

bool Broker::Impl::idle() {
  record_happenings();
  if (!mqtt_.is_connected()) return false;
  publish_waiting();
  publish_states();
  beat();
  watch_fences();
  return publish_telemetry();
}

/// One commit for all that has ended, happened or was acknowledged.
void Broker::Impl::record_happenings() {
  std::deque<Happening> happenings;
  std::uint64_t overflowed = 0;
  {
    const std::scoped_lock lock(mutex_);
    happenings.swap(happenings_);
    overflowed = overflowed_;
  }
  if (happenings.empty() && delivered_.empty()) return;
  journal_.begin();
  for (const std::int64_t id : std::exchange(delivered_, {})) journal_.remove(id);
  std::size_t ended = 0;
  for (Happening& one : happenings) {
    if (one.command == 0) {
      journal_.put({.kind = WaitingKind::notice,
                    .topic = std::move(one.notice.topic),
                    .payload = std::move(one.notice.payload),
                    .correlation = std::move(one.notice.correlation)});
      continue;
    }
    if (!one.at_rest.empty()) {
      journal_.set_at_rest(one.at_rest, one.command);
      continue;
    }
    ++ended;
    for (const ReplyAddress& address : journal_.finish(one.command, one.result)) {
      answer(WaitingKind::result, one.notice.topic, address, Json::parse(one.result));
    }
  }
  journal_.commit();
  running_ -= ended;
  waiting_ = journal_.waiting();
  dropped_ = journal_.dropped() + overflowed;
}

void Broker::Impl::publish_waiting() {
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
bool Broker::Impl::publish_one(const WaitingMessage& message) {
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
void Broker::Impl::shorten(const WaitingMessage& message) {
  remark("sbgc: the broker takes no message of {} bytes to {}\n", message.payload.size(),
         message.topic);
  journal_.begin();
  journal_.remove(message.id);
  if (auto payload = shortened(message.payload)) {
    WaitingMessage rest = message;
    rest.payload = *std::move(payload);
    journal_.put(rest);
  } else {
    const std::scoped_lock lock(mutex_);
    ++overflowed_;
  }
  journal_.commit();
  waiting_ = journal_.waiting();
}

void Broker::Impl::publish_states() {
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
bool Broker::Impl::publish_telemetry() {
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
void Broker::Impl::beat() {
  const auto now = MqttConnection::Clock::now();
  if (heartbeat_ || now < last_beat_ + settings_.stop_after / 4) return;
  last_beat_ = now;
  heartbeat_ = mqtt_.publish(
      {.topic = topics_.of(gateway_level, "heartbeat"), .payload = gateway_state("online")});
}

/// Who may command, but not read the topic of a fence, would wonder why nothing moves.
void Broker::Impl::watch_fences() {
  if (!fenced_ || MqttConnection::Clock::now() < *fenced_ + fence_patience) return;
  fenced_.reset();
  for (const Fence& fence : fences_) {
    if (fence.is_open()) continue;
    remark(
        "sbgc: warning: motion is refused, because the broker has not returned a message to {}: "
        "the gateway must be allowed to write and to read it\n",
        fence.topic());
  }
}

/// The metrics go on. The gimbals that move stop, because the broker is gone.
void Broker::Impl::fail(const std::string& problem) {
  is_connected_ = false;
  remark("sbgc: {}: {}\n",
         has_metrics_ ? "nothing goes to the broker or comes from it any more" : "the gateway ends",
         problem);
  {
    const std::scoped_lock lock(mutex_);
    failure_ = problem;
  }
  if (!has_metrics_) ::kill(::getpid(), SIGTERM);
}

void Broker::Impl::happen(Happening happening) {
  {
    const std::scoped_lock lock(mutex_);
    const bool is_notice = happening.command == 0;
    if (is_notice && happenings_.size() >= most_notices) {
      ++overflowed_;
      return;
    }
    happenings_.push_back(std::move(happening));
  }
  mqtt_.wake();
}

void Broker::Impl::set_state(const std::string& topic, std::string payload) {
  {
    const std::scoped_lock lock(mutex_);
    new_states_[topic] = payload;
    states_[topic] = std::move(payload);
  }
  mqtt_.wake();
}

void Broker::Impl::count(const std::string& status) {
  const std::scoped_lock lock(mutex_);
  ++ended_[status];
}

bool Broker::Impl::is_there() const {
  return is_connected_ && MqttConnection::Clock::now() <= mqtt_.last_heard() + settings_.stop_after;
}

std::string Broker::Impl::gateway_state(const char* state) const {
  const Statistics figures = statistics();
  Json json = stamped();
  json["state"] = state;
  json["waiting"] = figures.waiting;
  json["most_waiting"] = figures.most_waiting;
  json["dropped"] = figures.dropped;
  json["thinned"] = figures.thinned;
  return payload_text(json);
}

void Broker::Impl::close() {
  is_closing_ = true;
  constexpr milliseconds interval{20};
  const auto wait_until = [&](auto is_done, milliseconds longest) {
    const auto end = std::chrono::steady_clock::now() + longest;
    while (!is_done() && std::chrono::steady_clock::now() < end) {
      std::this_thread::sleep_for(interval);
    }
  };
  const auto at_rest = std::make_shared<std::atomic<std::size_t>>(0);
  for (auto& [name, station] : stations_) station.tasks->shut_down([at_rest] { ++*at_rest; });
  const StopOptions stopping;
  const bool has_failed = !failure().empty();  // then nobody counts what ends
  wait_until([&] { return *at_rest == stations_.size() && (has_failed || running_ == 0); },
             stopping.timeout + std::chrono::seconds(1));
  set_state(topics_.of(gateway_level, "state"), gateway_state("offline"));
  wait_until([&] { return !is_connected_ || waiting_ == 0; }, std::chrono::seconds(2));
  mqtt_.close();
}

Broker::Statistics Broker::Impl::statistics() const {
  const std::scoped_lock lock(mutex_);
  const auto ended = [&](const char* status) {
    const auto found = ended_.find(status);
    return found == ended_.end() ? std::uint64_t{0} : found->second;
  };
  return {.is_connected = is_connected_,
          .has_failed = !failure_.empty(),
          .thinned = telemetry_.thinned(),
          .dropped = dropped_,
          .acknowledged = acknowledged_,
          .waiting = waiting_,
          .most_waiting = settings_.most_waiting,
          .done = ended("done"),
          .failed = ended("failed"),
          .refused = ended("refused"),
          .unknown = ended("unknown")};
}

std::string Broker::Impl::failure() const {
  const std::scoped_lock lock(mutex_);
  return failure_;
}

Broker::Broker(const Fleet& fleet, const std::vector<std::unique_ptr<Gimbal>>& gimbals)
    : impl_(std::make_unique<Impl>(fleet, gimbals)) {}

Broker::~Broker() = default;

void Broker::start() { impl_->start(); }

void Broker::close() { impl_->close(); }

Broker::Statistics Broker::statistics() const { return impl_->statistics(); }

std::string Broker::failure() const { return impl_->failure(); }

}  // namespace sbgc::tools
