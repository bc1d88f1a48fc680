#include <string>
#include <utility>

#include <sbgc/client/own_transport.hpp>
#include <sbgc/client/reconnecting_client.hpp>

#include "reconnecting/reconnection.hpp"

namespace sbgc {

/// Makes the client, also for reconnecting_over(), whose types would bring Asio into the class.
struct detail::ReconnectingMaker {
  static Result<ReconnectingClient> start(const std::string& address, const TransportFactory& make,
                                          const ReconnectOptions& options) {
    const auto reconnection = std::make_shared<Reconnection>(address, make, options);
    if (auto started = reconnection->start(); !started) return std::move(started).error();
    return ReconnectingClient(reconnection);
  }
};

ReconnectingClient::ReconnectingClient(std::shared_ptr<detail::Reconnection> reconnection) noexcept
    : reconnection_(std::move(reconnection)) {}

ReconnectingClient::ReconnectingClient(ReconnectingClient&&) noexcept = default;

ReconnectingClient& ReconnectingClient::operator=(ReconnectingClient&& other) noexcept {
  if (this != &other) {
    if (reconnection_) reconnection_->finish();
    reconnection_ = std::move(other.reconnection_);
  }
  return *this;
}

ReconnectingClient::~ReconnectingClient() {
  if (reconnection_) reconnection_->finish();
}

Result<ReconnectingClient> ReconnectingClient::connect(const std::string& address,
                                                       const ReconnectOptions& options) {
  return detail::ReconnectingMaker::start(address, TransportFactory(), options);
}

Result<ReconnectingClient> reconnecting_over(const TransportFactory& make,
                                             const ReconnectOptions& options) {
  return detail::ReconnectingMaker::start(std::string(), make, options);
}

Result<std::shared_ptr<Client>> ReconnectingClient::connected() const {
  return reconnection_->connected();
}

Result<std::shared_ptr<Client>> ReconnectingClient::current(const CallOptions& options) const {
  return reconnection_->current(options);
}

Result<Reply> ReconnectingClient::use(
    const CallOptions& options,
    const std::function<Result<Reply>(Client&, const CallOptions&)>& call) const {
  return reconnection_->use(options, call);
}

void ReconnectingClient::start_raw(RawRequest request, const CallOptions& options,
                                   std::function<void(const Result<Reply>&)> handler) {
  reconnection_->start_raw(std::move(request), options, std::move(handler));
}

Subscription ReconnectingClient::keep(detail::MessageKey key, MessageHandler handler) {
  return reconnection_->keep(key, std::move(handler));
}

Result<Subscription> ReconnectingClient::keep_stream(PrepareStream prepare, detail::MessageKey key,
                                                     MessageHandler handler,
                                                     std::chrono::microseconds interval,
                                                     const CallOptions& options) {
  return reconnection_->keep_stream(std::move(prepare), key, std::move(handler), interval, options);
}

Subscription ReconnectingClient::on_frame(std::function<void(const BoardFrame&)> handler) {
  return reconnection_->keep_frames(detail::typed_handler<BoardFrame>(std::move(handler)));
}

Subscription ReconnectingClient::on_notice(std::function<void(const Notice&)> handler) {
  return reconnection_->on_notice(std::move(handler));
}

Subscription ReconnectingClient::on_change(std::function<void(const LinkChange&)> handler) {
  return reconnection_->on_change(std::move(handler));
}

void ReconnectingClient::check() { reconnection_->check(); }

LinkState ReconnectingClient::state() const { return reconnection_->state(); }
std::uint64_t ReconnectingClient::connections() const { return reconnection_->connections(); }
BoardIdentity ReconnectingClient::identity() const { return reconnection_->identity(); }
std::string ReconnectingClient::description() const { return reconnection_->description(); }
ClientStatistics ReconnectingClient::statistics() const { return reconnection_->statistics(); }
void ReconnectingClient::close() noexcept { reconnection_->close(); }

}  // namespace sbgc
