#include "gateway/mqtt.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>
#include <mosquitto.h>
#include <mqtt_protocol.h>
#include <openssl/ssl.h>
#include <poll.h>
#include <sys/eventfd.h>
#include <sys/socket.h>
#include <unistd.h>

#include "board/password.hpp"
#include "gateway/payload.hpp"

namespace sbgc::tools {

namespace {

using std::chrono::milliseconds;

/// The interval of calls of on_idle().
constexpr milliseconds mqtt_turn{100};
/// The timeout for the broker to accept the connection.
constexpr std::chrono::seconds mqtt_patience{10};
constexpr milliseconds first_mqtt_pause{250};
constexpr milliseconds longest_mqtt_pause{4'000};
/// The largest packet id; the next is 1.
constexpr int last_mqtt_id = 65'535;
/// The limits of one batch of messages.
constexpr std::size_t most_arrived_bytes = std::size_t{1} << 20U;
/// The largest packet to us, with MQTT 5: the payload, a topic and properties.
constexpr std::uint32_t longest_packet = 2 * longest_payload;

/// The library requires this once, before anything else.
void initialize_mqtt() {
  static const int status = mosquitto_lib_init();
  static_cast<void>(status);
}

void require_mqtt(int status, const std::string& what) {
  if (status == MOSQ_ERR_SUCCESS) return;
  throw std::runtime_error(fmt::format("{}: {}", what, mosquitto_strerror(status)));
}

/// Properties of MQTT 5.
class Properties {
 public:
  Properties() = default;
  Properties(const Properties&) = delete;
  Properties& operator=(const Properties&) = delete;
  ~Properties() { mosquitto_property_free_all(&list_); }

  mosquitto_property** add() noexcept { return &list_; }
  const mosquitto_property* get() const noexcept { return list_; }

 private:
  mosquitto_property* list_ = nullptr;
};

std::string text_property(const mosquitto_property* properties, int identifier) {
  char* value = nullptr;
  if (mosquitto_property_read_string(properties, identifier, &value, false) == nullptr) return "";
  std::string result(value);
  std::free(value);  // NOLINT: the library has allocated it
  return result;
}

std::string bytes_property(const mosquitto_property* properties, int identifier) {
  void* value = nullptr;
  std::uint16_t size = 0;
  if (mosquitto_property_read_binary(properties, identifier, &value, &size, false) == nullptr) {
    return "";
  }
  std::string result(static_cast<const char*>(value), size);
  std::free(value);  // NOLINT: the library has allocated it
  return result;
}

/// Returns the value of the user property with this name; "" if there is none.
std::string user_property(const mosquitto_property* properties, std::string_view wanted) {
  std::string result;
  char* name = nullptr;
  char* value = nullptr;
  bool skips_first = false;
  while ((properties = mosquitto_property_read_string_pair(
              properties, MQTT_PROP_USER_PROPERTY, &name, &value, skips_first)) != nullptr) {
    if (name == wanted && result.empty()) result = value;
    std::free(name);   // NOLINT: the library has allocated it
    std::free(value);  // NOLINT: the same
    skips_first = true;
  }
  return result;
}

std::optional<std::chrono::seconds> expiry_property(const mosquitto_property* properties) {
  std::uint32_t seconds = 0;
  const bool is_there = mosquitto_property_read_int32(properties, MQTT_PROP_MESSAGE_EXPIRY_INTERVAL,
                                                      &seconds, false) != nullptr;
  if (!is_there) return {};
  return std::chrono::seconds(seconds);
}

bool is_readable(int socket) {
  pollfd one{socket, POLLIN, 0};
  return ::poll(&one, 1, 0) > 0;
}

}  // namespace

struct MqttConnection::Callbacks {
  static MqttConnection& of(void* user) { return *static_cast<MqttConnection*>(user); }

  static void connected(mosquitto* /*connection*/, void* user, int code) {
    MqttConnection& self = of(user);
    if (code != 0) {
      self.refusal_ =
          self.settings_.is_mqtt_5 ? mosquitto_reason_string(code) : mosquitto_connack_string(code);
      return;
    }
    // Newer telemetry cannot replace data in the buffer of the socket.
    constexpr int buffer = 65'536;
    static_cast<void>(::setsockopt(mosquitto_socket(self.connection_.get()), SOL_SOCKET, SO_SNDBUF,
                                   &buffer, sizeof buffer));
    self.is_connected_ = true;
    mosquitto_log_callback_set(self.connection_.get(), nullptr);
    self.handlers_.on_connected();
  }
  static void logged(mosquitto* connection, void* user, int /*level*/, const char* line) {
    auto* const tls = static_cast<SSL*>(mosquitto_ssl_get(connection));
    if (tls != nullptr) of(user).tls_.take(line, SSL_get_verify_result(tls));
  }
  static void arrived(mosquitto* /*connection*/, void* user, const mosquitto_message* message,
                      const mosquitto_property* properties) {
    MqttMessage taken{.topic = message->topic, .is_retained = message->retain};
    if (message->payloadlen > 0) {
      // One byte too many shows that it is too long.
      taken.payload.assign(
          static_cast<const char*>(message->payload),
          std::min(static_cast<std::size_t>(message->payloadlen), longest_payload + 1));
    }
    if (properties != nullptr) {
      taken.reply = text_property(properties, MQTT_PROP_RESPONSE_TOPIC);
      taken.correlation = bytes_property(properties, MQTT_PROP_CORRELATION_DATA);
      taken.key = user_property(properties, "key");
      taken.expiry = expiry_property(properties);
    }
    MqttConnection& self = of(user);
    self.arrived_bytes_ += taken.payload.size();
    self.arrived_.push_back(std::move(taken));
  }
  static void published(mosquitto* /*connection*/, void* user, int id, int code,
                        const mosquitto_property* /*properties*/) {
    MqttConnection& self = of(user);
    const auto message = self.unacknowledged_.extract(id);
    if (message.empty()) {
      self.unsent_.erase(id);
      return;
    }
    constexpr int first_failure = 0x80;
    self.handlers_.on_acknowledged(
        id, code < first_failure
                ? ""
                : fmt::format("{}: {}", message.mapped(), mosquitto_reason_string(code)));
  }
  static void subscribed(mosquitto* /*connection*/, void* user, int id, int count,
                         const int* granted) {
    MqttConnection& self = of(user);
    if (id != self.subscription_) return;
    constexpr int first_failure = 0x80;
    for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
      if (granted[i] < first_failure) continue;
      self.refusal_ = "the broker refuses the subscription to " + self.filters_.at(i);
      return;
    }
    self.handlers_.on_subscribed();
  }
};

void MqttConnection::Destroy::operator()(mosquitto* connection) const noexcept {
  mosquitto_destroy(connection);
}

MqttConnection::MqttConnection(BrokerSettings settings, const MqttPublication& will,
                               Handlers handlers)
    : settings_(std::move(settings)),
      handlers_(std::move(handlers)),
      wake_(::eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK)) {
  initialize_mqtt();
  if (!wake_) throw std::runtime_error(std::strerror(errno));
  // Not a clean session: the broker stores messages while the gateway is offline.
  connection_.reset(mosquitto_new(settings_.client_id.c_str(), false, this));
  if (!connection_) throw std::runtime_error(std::strerror(errno));
  set_up(will);
}

MqttConnection::~MqttConnection() {
  is_breaking_ = true;
  wake();
  if (thread_.joinable()) thread_.join();
}

void MqttConnection::set_up(const MqttPublication& will) {
  mosquitto* const connection = connection_.get();
  if (settings_.is_mqtt_5) {
    require_mqtt(mosquitto_int_option(connection, MOSQ_OPT_PROTOCOL_VERSION, MQTT_PROTOCOL_V5),
                 "MQTT 5");
  }
  require_mqtt(mosquitto_int_option(connection, MOSQ_OPT_TCP_NODELAY, 1), "TCP");
  // The library leaves acknowledgments to mosquitto_loop_write(); see can_write().
  require_mqtt(mosquitto_threaded_set(connection, true), "MQTT");
  require_mqtt(mosquitto_max_inflight_messages_set(connection, 0), "MQTT");
  require_mqtt(
      mosquitto_will_set(connection, will.topic.c_str(), static_cast<int>(will.payload.size()),
                         will.payload.data(), will.quality, will.is_retained),
      "the will");
  if (!settings_.user.empty()) {
    const std::string password =
        settings_.password_file.empty() ? "" : read_password(settings_.password_file, "the broker");
    require_mqtt(mosquitto_username_pw_set(connection, settings_.user.c_str(),
                                           password.empty() ? nullptr : password.c_str()),
                 "the user");
  }
  if (!settings_.ca_file.empty()) {
    const auto or_null = [](const std::string& file) {
      return file.empty() ? nullptr : file.c_str();
    };
    require_mqtt(mosquitto_tls_set(connection, settings_.ca_file.c_str(), nullptr,
                                   or_null(settings_.certificate_file), or_null(settings_.key_file),
                                   nullptr),
                 "the files of TLS");
  }
  mosquitto_connect_callback_set(connection, Callbacks::connected);
  mosquitto_message_v5_callback_set(connection, Callbacks::arrived);
  mosquitto_publish_v5_callback_set(connection, Callbacks::published);
  mosquitto_subscribe_callback_set(connection, Callbacks::subscribed);
}

void MqttConnection::start() {
  thread_ = std::thread([this] { run(); });
}

void MqttConnection::close() {
  is_closing_ = true;
  wake();
  if (thread_.joinable()) thread_.join();
}

void MqttConnection::wake() noexcept {
  ::eventfd_write(wake_.get(), 1);  // fails only if the thread will wake up anyway
}

void MqttConnection::subscribe(const std::vector<std::string>& filters, int quality) {
  std::vector<char*> texts;
  texts.reserve(filters.size());
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-const-cast): the library only reads them
  for (const std::string& one : filters) texts.push_back(const_cast<char*>(one.c_str()));
  // With MQTT 3.1.1, a retained message is only marked for later subscribers.
  const int options = settings_.is_mqtt_5 ? MQTT_SUB_OPT_RETAIN_AS_PUBLISHED : 0;
  mosquitto_subscribe_multiple(connection_.get(), &last_id_, static_cast<int>(texts.size()),
                               texts.data(), quality, options, nullptr);
  subscription_ = last_id_;
  filters_ = filters;
}

bool MqttConnection::can_publish() const noexcept {
  const int next = last_id_ % last_mqtt_id + 1;
  return is_connected_ && !unsent_.contains(next) && !unacknowledged_.contains(next);
}

std::optional<int> MqttConnection::publish(const MqttPublication& message) {
  if (!can_publish()) return {};
  Properties properties;
  if (settings_.is_mqtt_5) {
    mosquitto_property_add_byte(properties.add(), MQTT_PROP_PAYLOAD_FORMAT_INDICATOR, 1);
    mosquitto_property_add_string(properties.add(), MQTT_PROP_CONTENT_TYPE, "application/json");
    if (!message.correlation.empty()) {
      mosquitto_property_add_binary(properties.add(), MQTT_PROP_CORRELATION_DATA,
                                    message.correlation.data(),
                                    static_cast<std::uint16_t>(message.correlation.size()));
    }
    if (message.expiry) {
      mosquitto_property_add_int32(properties.add(), MQTT_PROP_MESSAGE_EXPIRY_INTERVAL,
                                   static_cast<std::uint32_t>(message.expiry->count()));
    }
  }
  int id = 0;
  const int status = mosquitto_publish_v5(
      connection_.get(), &id, message.topic.c_str(), static_cast<int>(message.payload.size()),
      message.payload.data(), message.quality, message.is_retained, properties.get());
  if (status == MOSQ_ERR_OVERSIZE_PACKET || status == MOSQ_ERR_PAYLOAD_SIZE ||
      status == MOSQ_ERR_INVAL || status == MOSQ_ERR_MALFORMED_UTF8) {
    return 0;
  }
  if (status != MOSQ_ERR_SUCCESS) return {};
  last_id_ = id;
  if (message.quality == 0) {
    unsent_.insert(id);
  } else {
    unacknowledged_.emplace(id, message.topic);
  }
  return id;
}

void MqttConnection::run() {
  try {
    serve();
  } catch (const std::exception& error) {
    handlers_.on_failure(error.what());
    connection_.reset();
  }
}

void MqttConnection::serve() {
  milliseconds pause = first_mqtt_pause;
  while (!is_closing_ && !is_breaking_) {
    refusal_.clear();
    std::string problem = connect();
    while (problem.empty() && !is_closing_ && !is_breaking_) {
      problem = turn();
      if (!refusal_.empty()) problem = refusal_;
      if (is_connected_) pause = first_mqtt_pause;
    }
    if (problem.empty()) break;
    is_connected_ = false;
    unsent_.clear();
    handlers_.on_lost(problem);
    rest(pause);
    pause = std::min(2 * pause, longest_mqtt_pause);
  }
  if (!is_connected_ || is_breaking_) return;
  handlers_.on_idle();  // for final messages
  mosquitto_disconnect(connection_.get());
  const auto end = Clock::now() + std::chrono::seconds(1);
  while (!can_write() && Clock::now() < end) std::this_thread::sleep_for(milliseconds(10));
  if (!can_write()) return;
  while (mosquitto_socket(connection_.get()) >= 0 && Clock::now() < end) {
    if (mosquitto_loop_write(connection_.get(), 1) != MOSQ_ERR_SUCCESS) break;
  }
}

std::string MqttConnection::problem_of(int status) const {
  const int number = status == MOSQ_ERR_ERRNO ? errno : 0;
  const bool is_closed = status == MOSQ_ERR_CONN_LOST || status == MOSQ_ERR_PROTOCOL ||
                         number == ECONNRESET || number == EPIPE || number == EPROTO;
  std::string known = is_connected_ ? "" : tls_.reason(address_, settings_, is_closed);
  if (!known.empty()) return known;
  return number != 0 ? std::strerror(number) : mosquitto_strerror(status);
}

std::string MqttConnection::connect() {
  begun_ = Clock::now();
  tls_ = {};
  mosquitto_log_callback_set(connection_.get(), Callbacks::logged);
  is_holding_ = false;  // the library has forgotten the acknowledgments
  address_ = settings_.addresses[attempts_++ % settings_.addresses.size()];
  constexpr std::chrono::seconds least_keep_alive{5};  // of the library
  const auto keep_alive = static_cast<int>(
      std::max(std::chrono::ceil<std::chrono::seconds>(settings_.keep_alive), least_keep_alive)
          .count());
  int status = MOSQ_ERR_SUCCESS;
  if (settings_.is_mqtt_5) {
    // Without this, the session would end with the connection.
    Properties properties;
    constexpr std::uint32_t never = 0xFFFFFFFF;
    mosquitto_property_add_int32(properties.add(), MQTT_PROP_SESSION_EXPIRY_INTERVAL, never);
    mosquitto_property_add_int32(properties.add(), MQTT_PROP_MAXIMUM_PACKET_SIZE, longest_packet);
    // A stop must not wait behind unacknowledged messages.
    mosquitto_property_add_int16(properties.add(), MQTT_PROP_RECEIVE_MAXIMUM, 0xFFFF);
    status = mosquitto_connect_bind_v5(connection_.get(), address_.host.c_str(), address_.port,
                                       keep_alive, nullptr, properties.get());
  } else {
    status = mosquitto_connect_async(connection_.get(), address_.host.c_str(), address_.port,
                                     keep_alive);
  }
  return status == MOSQ_ERR_SUCCESS ? "" : problem_of(status);
}

void MqttConnection::forget_wakes() {
  eventfd_t count = 0;
  ::eventfd_read(wake_.get(), &count);  // does not block
}

std::string MqttConnection::turn() {
  mosquitto* const connection = connection_.get();
  const bool writes = can_write() && mosquitto_want_write(connection);
  std::array<pollfd, 2> waiting{
      {{mosquitto_socket(connection), static_cast<short>(POLLIN | (writes ? POLLOUT : 0)), 0},
       {wake_.get(), POLLIN, 0}}};
  const bool is_busy = has_more_ && !writes && !is_holding_;
  const milliseconds longest = is_busy ? milliseconds(0) : mqtt_turn;
  ::poll(waiting.data(), waiting.size(), static_cast<int>(longest.count()));
  forget_wakes();
  const bool can_read = (waiting[0].revents & ~POLLOUT) != 0;
  std::string problem = can_read ? read() : "";
  arrived_bytes_ = 0;
  is_holding_ = is_holding_ || !arrived_.empty();
  handlers_.on_messages(std::exchange(arrived_, {}));
  has_more_ = handlers_.on_idle();
  if (!problem.empty()) return problem;
  if (can_write() && mosquitto_want_write(connection)) {
    const int status = mosquitto_loop_write(connection, 1);
    if (status != MOSQ_ERR_SUCCESS) return problem_of(status);
  }
  const int status = mosquitto_loop_misc(connection);
  if (status != MOSQ_ERR_SUCCESS) return problem_of(status);
  if (mosquitto_socket(connection) < 0) return "the connection was closed";
  if (!is_connected_ && Clock::now() > begun_ + mqtt_patience) return "the broker does not answer";
  return "";
}

bool MqttConnection::can_write() {
  is_holding_ = is_holding_ && !handlers_.is_settled();
  return !is_holding_;
}

/// Reads several messages, so that a single commit to the disk covers them all.
std::string MqttConnection::read() {
  constexpr std::size_t most = 64;
  for (std::size_t i = 0; i < most; ++i) {
    const int status = mosquitto_loop_read(connection_.get(), 1);
    if (status != MOSQ_ERR_SUCCESS) return problem_of(status);
    last_heard_ = Clock::now().time_since_epoch().count();
    const int socket = mosquitto_socket(connection_.get());
    if (socket < 0 || arrived_bytes_ > most_arrived_bytes || !is_readable(socket)) break;
  }
  return "";
}

void MqttConnection::rest(milliseconds pause) {
  const auto end = Clock::now() + pause;
  while (!is_closing_ && !is_breaking_ && Clock::now() < end) {
    pollfd waiting{wake_.get(), POLLIN, 0};
    ::poll(&waiting, 1, static_cast<int>(mqtt_turn.count()));
    forget_wakes();
    handlers_.on_idle();
  }
}

}  // namespace sbgc::tools
