#include "gateway/broker.hpp"

#include <algorithm>
#include <atomic>
#include <csignal>
#include <map>
#include <mutex>
#include <optional>
#include <set>
#include <stdexcept>
#include <thread>
#include <utility>

#include <unistd.h>

#include "command/remark.hpp"
#include "gateway/admission.hpp"
#include "gateway/duplicate_gateway_detector.hpp"
#include "gateway/gimbal_tasks.hpp"
#include "gateway/journal.hpp"
#include "gateway/mqtt.hpp"
#include "gateway/outbox.hpp"
#include "gateway/payload.hpp"
#include "gateway/reports.hpp"
#include "gateway/worker.hpp"

namespace sbgc::tools {

namespace {

/// The timeout for stopping all gimbals; a service manager may kill the gateway soon after.
constexpr std::chrono::seconds longest_stop{8};

BrokerSettings with_client_id(const Fleet& fleet) {
  BrokerSettings settings = *fleet.broker;
  if (settings.client_id.empty()) settings.client_id = "sbgc-" + fleet.name;
  return settings;
}

}  // namespace

class Broker::Impl {
 public:
  Impl(const Fleet& fleet, const std::vector<std::unique_ptr<Gimbal>>& gimbals);

  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;
  ~Impl() { disk_.finish(); }

  void start() {
    disk_.start();
    disk_.wake();  // for messages left by an earlier gateway
    mqtt_.start();
  }
  void close();
  Statistics statistics() const;
  std::string failure() const;
  bool has_duplicate() const noexcept { return has_rival_; }
  bool has_left_moving() const noexcept { return has_left_moving_; }

 private:
  MqttConnection::Handlers mqtt_handlers();
  MqttPublication will() const;
  void add_station(Gimbal& gimbal, std::optional<std::int64_t> moved_by);

  // On the thread of the connection.
  void take(std::vector<MqttMessage> messages);
  void connected();
  void lost(const std::string& reason);
  bool idle();
  void fail(const std::string& problem);

  // On any thread.
  bool is_there() const;

  const BrokerSettings settings_;
  const bool has_metrics_;
  const Topics topics_;
  const std::string state_topic_;
  DuplicateGatewayDetector duplicates_{};
  Journal journal_;
  Stations stations_{};
  Outbox outbox_;
  Admission admission_;
  std::atomic<bool> is_connected_{false};
  std::atomic<bool> has_rival_{false};
  bool has_left_moving_ = false;
  mutable std::mutex mutex_{};
  std::string failure_{};
  std::set<std::string> problems_{};  // of the addresses since the last connection, on its thread

  Worker disk_;
  MqttConnection mqtt_;  // last: its thread uses the others
};

Broker::Impl::Impl(const Fleet& fleet, const std::vector<std::unique_ptr<Gimbal>>& gimbals)
    : settings_(with_client_id(fleet)),
      has_metrics_(fleet.metrics.has_value()),
      topics_(fleet.name),
      state_topic_(topics_.of(gateway_level, "state")),
      journal_(settings_.journal, {.most_waiting = settings_.most_waiting,
                                   .history = settings_.history,
                                   .keep = settings_.longest_deadline + 2 * settings_.clock_skew}),
      outbox_(settings_, topics_, duplicates_, journal_, disk_, mqtt_),
      admission_(settings_, topics_, stations_, journal_, disk_, outbox_, mqtt_),
      disk_(
          [this] {
            admission_.settle();
            outbox_.record();
          },
          [this] { mqtt_.wake(); }),
      mqtt_(settings_, will(), mqtt_handlers()) {
  const std::map<std::string, std::int64_t> moved_by = journal_.moving();
  for (const auto& gimbal : gimbals) {
    const auto found = moved_by.find(gimbal->name());
    add_station(*gimbal, found == moved_by.end() ? std::optional<std::int64_t>() : found->second);
  }
}

MqttConnection::Handlers Broker::Impl::mqtt_handlers() {
  return {.on_messages = [this](std::vector<MqttMessage> messages) { take(std::move(messages)); },
          .is_settled = [this] { return admission_.is_settled(); },
          .on_connected = [this] { connected(); },
          .on_lost = [this](const std::string& reason) { lost(reason); },
          .on_subscribed = [this] { admission_.subscribed(); },
          .on_acknowledged =
              [this](int id, const std::string& refused) { outbox_.acknowledged(id, refused); },
          .on_idle = [this] { return idle(); },
          .on_failure = [this](const std::string& problem) { fail(problem); }};
}

MqttPublication Broker::Impl::will() const {
  // Without a time: the broker stores it until it is needed.
  Json json{{"version", payload_version}, {"state", "offline"}};
  duplicates_.sign(json);
  return {.topic = state_topic_, .payload = payload_text(json), .is_retained = true};
}

void Broker::Impl::add_station(Gimbal& gimbal, std::optional<std::int64_t> moved_by) {
  const std::string& name = gimbal.name();
  const auto tell = [this, topic = topics_.of(name, "event")](const GimbalEvent& event,
                                                              Gimbal::Time time) {
    outbox_.notify(
        {.kind = WaitingKind::notice, .topic = topic, .payload = event_text(event, time)});
  };
  const auto notify = [tell](const std::string& kind, const std::string& message) {
    tell({kind, message}, std::chrono::system_clock::now());
  };
  const auto at_rest = [this, name](std::int64_t command) { outbox_.set_at_rest(name, command); };
  auto tasks = std::make_shared<GimbalTasks>(
      gimbal,
      GimbalTasks::Hooks{[this] { return is_there(); }, notify, at_rest, settings_.stop_after},
      moved_by);
  gimbal.on_event([tasks](const GimbalEvent& event, Gimbal::Time) {
    if (event.kind == board_reset_event) tasks->board_restarted();
  });
  gimbal.on_status([this, tasks, topic = topics_.of(name, "state"),
                    allow = gimbal.settings().allow](const GimbalStatus& state) {
    tasks->link_changed(state.link == GimbalLink::online);
    Json json = stamped();
    json["state"] = sbgc::tools::name(state.link);
    if (!state.reason.empty()) json["reason"] = state.reason;
    if (state.is_stopping) json["stopping"] = true;
    json["firmware"] = state.firmware;
    json["board"] = state.board;
    json["serial_number"] = state.serial_number;
    json["connections"] = state.connections;
    json["allow"] = allow;
    outbox_.set_state(topic, payload_text(json));
  });
  gimbal.on_telemetry([this, prefix = topics_.of(name, "telemetry/"),
                       has_units = gimbal.settings().has_units](const AnyMessage& message,
                                                                Gimbal::Time time) {
    outbox_.put_sample(prefix + message.type().info->name, sample_text(message, time, has_units));
  });
  gimbal.on_event(tell);
  stations_[name] = {&gimbal, std::move(tasks)};
}

void Broker::Impl::take(std::vector<MqttMessage> messages) {
  for (const MqttMessage& one : messages) {
    if (one.topic != state_topic_ ||
        !duplicates_.read(one.payload, DuplicateGatewayDetector::Clock::now()))
      continue;
    has_rival_ = true;
    throw std::runtime_error("another gateway of this fleet is at the broker, and was there first");
  }
  admission_.take(std::move(messages));
}

void Broker::Impl::connected() {
  is_connected_ = true;
  if (!problems_.empty()) remark("sbgc: connected to the broker\n");
  problems_.clear();
  mqtt_.subscribe({state_topic_}, 0);
  admission_.connected();
  outbox_.connected();
}

void Broker::Impl::lost(const std::string& reason) {
  is_connected_ = false;
  admission_.lost();
  constexpr std::size_t longest_reason = 450;
  if (!problems_.insert(reason).second) return;
  remark("sbgc: no connection to the broker: {}\n", abridged(reason, longest_reason));
}

bool Broker::Impl::idle() {
  disk_.check();
  if (!mqtt_.is_connected()) return false;
  admission_.watch_barriers();
  return outbox_.publish();
}

/// Stops serving the broker; metrics continue. Moving gimbals stop, because the broker is gone.
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

bool Broker::Impl::is_there() const {
  return is_connected_ && MqttConnection::Clock::now() <= mqtt_.last_heard() + settings_.stop_after;
}

void Broker::Impl::close() {
  admission_.close();
  constexpr std::chrono::milliseconds interval{20};
  const auto wait_until = [&](auto is_done, std::chrono::milliseconds longest) {
    const auto end = std::chrono::steady_clock::now() + longest;
    while (!is_done() && std::chrono::steady_clock::now() < end) {
      std::this_thread::sleep_for(interval);
    }
  };
  std::map<std::string, std::shared_ptr<std::atomic<bool>>> at_rest;
  for (auto& [name, station] : stations_) {
    const auto rests = at_rest[name] = std::make_shared<std::atomic<bool>>(false);
    station.tasks->shut_down([rests] { *rests = true; });
  }
  const bool has_failed = !failure().empty();  // then the remaining work is no longer tracked
  wait_until(
      [&] {
        return (has_failed || outbox_.running() == 0) &&
               std::ranges::all_of(at_rest, [](const auto& one) { return one.second->load(); });
      },
      longest_stop);
  for (const auto& [name, rests] : at_rest) {
    if (*rests) continue;
    has_left_moving_ = true;
    remark("sbgc: {} may still turn: its stop has not succeeded; the next gateway tries again\n",
           name);
    stations_[name].tasks->give_up();
  }
  outbox_.set_state(state_topic_, outbox_.gateway_state("offline"));
  wait_until([&] { return !is_connected_ || outbox_.statistics().waiting == 0; },
             std::chrono::seconds(1));
  mqtt_.close();
  disk_.finish();
}

Broker::Statistics Broker::Impl::statistics() const {
  return {outbox_.statistics(), is_connected_, !failure().empty()};
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

bool Broker::has_left_moving() const { return impl_->has_left_moving(); }

bool Broker::has_duplicate() const { return impl_->has_duplicate(); }

}  // namespace sbgc::tools
