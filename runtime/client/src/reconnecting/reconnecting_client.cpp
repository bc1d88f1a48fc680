#include <string>
#include <utility>

#include <sbgc/client/own_transport.hpp>
#include <sbgc/client/reconnecting_client.hpp>

#include "reconnecting/impl.hpp"

namespace sbgc {

ReconnectingClient::ReconnectingClient(std::shared_ptr<Impl> impl) noexcept
    : impl_(std::move(impl)) {}

ReconnectingClient::ReconnectingClient(ReconnectingClient&&) noexcept = default;

ReconnectingClient& ReconnectingClient::operator=(ReconnectingClient&& other) noexcept {
  if (this != &other) {
    if (impl_) impl_->finish();
    impl_ = std::move(other.impl_);
  }
  return *this;
}

ReconnectingClient::~ReconnectingClient() {
  if (impl_) impl_->finish();
}

Result<ReconnectingClient> ReconnectingClient::connect(const std::string& address,
                                                       const ReconnectOptions& options) {
  return detail::ReconnectingOver::start(address, TransportFactory(), options);
}

Result<ReconnectingClient> reconnecting_over(const TransportFactory& make,
                                             const ReconnectOptions& options) {
  return detail::ReconnectingOver::start(std::string(), make, options);
}

Result<std::shared_ptr<Client>> ReconnectingClient::current(const CallOptions& options) const {
  return impl_->current(options);
}

Result<Reply> ReconnectingClient::use(
    const CallOptions& options,
    const std::function<Result<Reply>(Client&, const CallOptions&)>& call) const {
  return impl_->use(options, call);
}

void ReconnectingClient::start_raw(RawRequest request, const CallOptions& options,
                                   std::function<void(const Result<Reply>&)> handler) {
  impl_->start_raw(std::move(request), options, std::move(handler));
}

Subscription ReconnectingClient::keep(Begin begin, MessageHandler handler) {
  return impl_->keep(std::move(begin), std::move(handler));
}

Result<Subscription> ReconnectingClient::keep_stream(Begin begin, MessageHandler handler,
                                                     std::chrono::microseconds interval,
                                                     const CallOptions& options) {
  return impl_->keep_stream(std::move(begin), std::move(handler), interval, options);
}

Subscription ReconnectingClient::on_notice(std::function<void(const Notice&)> handler) {
  return impl_->on_notice(std::move(handler));
}

Subscription ReconnectingClient::on_change(std::function<void(const LinkChange&)> handler) {
  return impl_->on_change(std::move(handler));
}

void ReconnectingClient::check() { impl_->check(); }

LinkState ReconnectingClient::state() const { return impl_->state(); }
std::uint64_t ReconnectingClient::connections() const { return impl_->connections(); }
BoardIdentity ReconnectingClient::identity() const { return impl_->identity(); }
std::string ReconnectingClient::description() const { return impl_->description(); }
ClientStatistics ReconnectingClient::statistics() const { return impl_->statistics(); }
void ReconnectingClient::close() noexcept { impl_->close(); }

}  // namespace sbgc
