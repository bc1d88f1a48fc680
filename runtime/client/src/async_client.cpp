#include <memory>
#include <mutex>
#include <utility>

#include <asio/post.hpp>
#include <asio/thread_pool.hpp>

#include <sbgc/client/async_client.hpp>

#include "connect.hpp"
#include "driving/running_tasks.hpp"

namespace sbgc {

class AsyncClient::Impl : public detail::AsyncOperations,
                          public std::enable_shared_from_this<AsyncClient::Impl> {
 public:
  explicit Impl(asio::any_io_executor executor) : executor_(std::move(executor)) {}
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;
  ~Impl() override {
    end(true);
    worker_.join();
  }

  const asio::any_io_executor& executor() const noexcept override { return executor_; }

  void connect(const detail::Opener& opener, const ConnectOptions& options,
               const Completion<Result<void>>& done) {
    asio::post(worker_, [this, opener, options, done] {
      end(false);
      auto conversation =
          detail::connect(executor_, opener, options, [this](const auto& begun) { adopt(begun); });
      if (!conversation) return done(std::move(conversation).error());
      {
        const std::lock_guard lock(mutex_);
        is_connected_ = true;
      }
      done({});
    });
  }
  detail::Stop closer() {
    return [weak = weak_from_this()] {
      if (const auto impl = weak.lock()) impl->end(false);
    };
  }

  detail::Stop call(const Prepare& prepare, const CallOptions& options,
                    const detail::Completion<Result<Reply>>& done) override {
    const auto conversation = connected();
    if (!conversation) return done(conversation.error()), detail::Stop{};
    return stop_of(*conversation, conversation->start(prepare(*conversation), options, done));
  }
  detail::Stop stream(const PrepareStream& prepare, detail::MessageKey key,
                      detail::Conversation::MessageHandler handler, std::chrono::microseconds,
                      const CallOptions& options,
                      const detail::Completion<Result<Subscription>>& done) override {
    const auto conversation = connected();
    if (!conversation) return done(conversation.error()), detail::Stop{};
    return stop_of(*conversation, conversation->start_stream(prepare(*conversation), key,
                                                             std::move(handler), options, done));
  }
  detail::Stop run(const BeginTask& begin,
                   const detail::Completion<std::optional<ClientError>>& done) override {
    const auto conversation = connected();
    if (!conversation) return done(conversation.error()), detail::Stop{};
    return tasks_.run(executor_, *conversation, begin(conversation->identity()),
                      [done] { done(std::nullopt); });
  }

  Subscription subscribe(detail::MessageKey key,
                         detail::Conversation::MessageHandler handler) override {
    const auto conversation = connected();
    return conversation ? conversation->subscribe(key, std::move(handler)) : Subscription();
  }
  Subscription on_notice(std::function<void(const Notice&)> handler) override {
    const auto conversation = connected();
    return conversation ? conversation->on_notice(std::move(handler)) : Subscription();
  }

  bool is_connected() const override { return bool(connected()); }
  BoardIdentity identity() const override {
    const auto conversation = connected();
    return conversation ? conversation->identity() : BoardIdentity{};
  }
  std::string description() const override {
    const auto conversation = connected();
    return conversation ? conversation->description() : std::string();
  }
  ClientStatistics statistics() const override {
    const auto conversation = connected();
    return conversation ? conversation->statistics() : ClientStatistics{};
  }
  void close() noexcept override { end(false); }

 private:
  static detail::Stop stop_of(const detail::Conversation& conversation, CallId id) {
    return [conversation, id] { conversation.cancel(id); };
  }

  Result<detail::Conversation> connected() const {
    const std::lock_guard lock(mutex_);
    if (is_connected_) return conversation_;
    return ClientError{ErrorCode::not_connected, "the client is not connected"};
  }

  void end(bool for_good) noexcept {
    detail::Conversation conversation;
    {
      const std::lock_guard lock(mutex_);
      is_connected_ = false;
      is_closed_ = is_closed_ || for_good;
      conversation = conversation_;
    }
    conversation.close();
    tasks_.cancel_all();
  }

  void adopt(const detail::Conversation& begun) {
    bool is_closed = false;
    {
      const std::lock_guard lock(mutex_);
      conversation_ = begun;
      is_closed = is_closed_;
    }
    if (is_closed) begun.close();
  }

  asio::any_io_executor executor_;
  mutable std::mutex mutex_;
  detail::Conversation conversation_;
  detail::RunningTasks tasks_;
  bool is_connected_ = false;
  bool is_closed_ = false;       // permanently: the client is being destroyed
  asio::thread_pool worker_{1};  // opening a line can block
};

AsyncClient::AsyncClient(const asio::any_io_executor& executor)
    : AsyncClient(std::make_shared<Impl>(executor)) {}

AsyncClient::AsyncClient(const std::shared_ptr<Impl>& impl) : AsyncCalls(impl), impl_(impl) {}

auto AsyncClient::begin_connect(Impl& impl, const std::string& address,
                                const ConnectOptions& options, const Completion<Result<void>>& done)
    -> detail::Stop {
  impl.connect(detail::opener_of(address, options), options, done);
  return impl.closer();
}

auto AsyncClient::begin_connect(Impl& impl, const TransportFactory& make,
                                const ConnectOptions& options, const Completion<Result<void>>& done)
    -> detail::Stop {
  impl.connect(detail::opener_of(make, options), options, done);
  return impl.closer();
}

}  // namespace sbgc
