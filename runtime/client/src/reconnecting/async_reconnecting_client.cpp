#include <memory>
#include <mutex>
#include <utility>

#include <sbgc/client/async_reconnecting_client.hpp>

#include "reconnecting/reconnection.hpp"

namespace sbgc {

/// The connection of the last async_connect().
class AsyncReconnectingClient::Impl : public detail::AsyncOperations {
 public:
  using Reconnection = std::shared_ptr<detail::Reconnection>;

  explicit Impl(asio::any_io_executor executor) : executor_(std::move(executor)) {}
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;
  ~Impl() override {
    if (reconnection_) reconnection_->finish();
  }

  const asio::any_io_executor& executor() const noexcept override { return executor_; }

  detail::Stop connect(const std::string& address, const TransportFactory& make,
                       const ReconnectOptions& options,
                       const detail::Completion<Result<void>>& done) {
    auto begun = std::make_shared<detail::Reconnection>(address, make, options, executor_);
    Reconnection previous;
    {
      const std::lock_guard lock(mutex_);
      previous = std::exchange(reconnection_, begun);
    }
    if (previous) previous->close();
    begun->start(std::move(previous), done);
    return [weak = std::weak_ptr(begun)] {
      if (const auto connecting = weak.lock()) connecting->close();
    };
  }

  detail::Stop call(const Prepare& prepare, const CallOptions& options,
                    const detail::Completion<Result<Reply>>& done) override {
    if (const auto one = reconnection()) return one->start(prepare, options, done);
    return done(not_connected()), detail::Stop{};
  }
  detail::Stop stream(const PrepareStream& prepare, detail::MessageKey key,
                      detail::Conversation::MessageHandler handler,
                      std::chrono::microseconds interval, const CallOptions& options,
                      const detail::Completion<Result<Subscription>>& done) override {
    if (const auto one = reconnection()) {
      return one->start_stream(prepare, key, std::move(handler), interval, options, done);
    }
    return done(not_connected()), detail::Stop{};
  }
  detail::Stop run(const BeginTask& begin,
                   const detail::Completion<std::optional<ClientError>>& done) override {
    if (const auto one = reconnection()) return one->run(begin, done);
    return done(not_connected()), detail::Stop{};
  }

  Subscription subscribe(detail::MessageKey key,
                         detail::Conversation::MessageHandler handler) override {
    const auto one = reconnection();
    return one ? one->keep(key, std::move(handler)) : Subscription();
  }
  Subscription on_notice(std::function<void(const Notice&)> handler) override {
    const auto one = reconnection();
    return one ? one->on_notice(std::move(handler)) : Subscription();
  }

  bool is_connected() const override {
    const auto one = reconnection();
    return one && one->state() == LinkState::connected;
  }
  BoardIdentity identity() const override {
    const auto one = reconnection();
    return one ? one->identity() : BoardIdentity{};
  }
  std::string description() const override {
    const auto one = reconnection();
    return one ? one->description() : std::string();
  }
  ClientStatistics statistics() const override {
    const auto one = reconnection();
    return one ? one->statistics() : ClientStatistics{};
  }
  void close() noexcept override {
    if (const auto one = reconnection()) one->close();
  }

  /// Null before the first connect().
  Reconnection reconnection() const {
    const std::lock_guard lock(mutex_);
    return reconnection_;
  }

  static ClientError not_connected() {
    return {ErrorCode::not_connected, "the client is not connected"};
  }

 private:
  const asio::any_io_executor executor_;
  mutable std::mutex mutex_;
  Reconnection reconnection_;
};

AsyncReconnectingClient::AsyncReconnectingClient(const asio::any_io_executor& executor)
    : AsyncReconnectingClient(std::make_shared<Impl>(executor)) {}

AsyncReconnectingClient::AsyncReconnectingClient(const std::shared_ptr<Impl>& impl)
    : AsyncCalls(impl), impl_(impl) {}

auto AsyncReconnectingClient::connect(Impl& impl, const std::string& address,
                                      const TransportFactory& make, const ReconnectOptions& options,
                                      const Completion<Result<void>>& done) -> detail::Stop {
  return impl.connect(address, make, options, done);
}

Result<std::shared_ptr<Client>> AsyncReconnectingClient::connected() const {
  const auto one = impl_->reconnection();
  if (!one) return Impl::not_connected();
  return one->connected();
}

Subscription AsyncReconnectingClient::on_change(std::function<void(const LinkChange&)> handler) {
  const auto one = impl_->reconnection();
  return one ? one->on_change(std::move(handler)) : Subscription();
}

void AsyncReconnectingClient::check() {
  if (const auto one = impl_->reconnection()) one->check();
}

LinkState AsyncReconnectingClient::state() const {
  const auto one = impl_->reconnection();
  return one ? one->state() : LinkState::closed;
}

std::uint64_t AsyncReconnectingClient::connections() const {
  const auto one = impl_->reconnection();
  return one ? one->connections() : 0;
}

}  // namespace sbgc
