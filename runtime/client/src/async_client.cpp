#include <memory>
#include <mutex>
#include <utility>

#include <asio/post.hpp>
#include <asio/thread_pool.hpp>

#include <sbgc/client/async_client.hpp>

#include "connect.hpp"

namespace sbgc {

class AsyncClient::Impl : public std::enable_shared_from_this<AsyncClient::Impl> {
 public:
  explicit Impl(asio::any_io_executor executor) : executor_(std::move(executor)) {}
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;
  /// What waits for the worker still ends, but quickly: there is no line.
  ~Impl() {
    close(true);
    worker_.join();
  }

  const asio::any_io_executor& executor() const noexcept { return executor_; }

  /// Null before the client has begun to connect; it may not be connected yet.
  detail::Conversation conversation() const {
    const std::lock_guard lock(mutex_);
    return conversation_;
  }
  bool is_connected() const {
    const std::lock_guard lock(mutex_);
    return is_connected_;
  }

  void connect(const detail::Opener& opener, const ConnectOptions& options,
               const Completion<void>& done) {
    asio::post(worker_, [this, opener, options, done] {
      close(false);
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

  void run(std::function<void(Result<Client>)> task) {
    asio::post(worker_, [this, task = std::move(task)] {
      if (!is_connected()) return task(not_connected());
      task(detail::ClientMaker::make(nullptr, conversation()));
    });
  }

  void close(bool for_good) noexcept {
    detail::Conversation conversation;
    {
      const std::lock_guard lock(mutex_);
      is_connected_ = false;
      is_closed_ = is_closed_ || for_good;
      conversation = conversation_;
    }
    conversation.close();
  }

  Stop closer() {
    return [weak = weak_from_this()] {
      if (const auto impl = weak.lock()) impl->close(false);
    };
  }

  static ClientError not_connected() {
    return {ErrorCode::not_connected, "the client is not connected"};
  }

 private:
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
  bool is_connected_ = false;
  bool is_closed_ = false;  // for good: the client is being destroyed
  asio::thread_pool worker_{1};
};

AsyncClient::AsyncClient(const asio::any_io_executor& executor)
    : impl_(std::make_shared<Impl>(executor)) {}

asio::any_io_executor AsyncClient::executor() const { return impl_->executor(); }

auto AsyncClient::begin_connect(Impl& impl, const std::string& address,
                                const ConnectOptions& options, const Completion<void>& done)
    -> Stop {
  impl.connect(detail::opener_of(address, options), options, done);
  return impl.closer();
}

auto AsyncClient::begin_connect(Impl& impl, const TransportFactory& make,
                                const ConnectOptions& options, const Completion<void>& done)
    -> Stop {
  impl.connect(detail::opener_of(make, options), options, done);
  return impl.closer();
}

auto AsyncClient::begin_call(Impl& impl, detail::FrameBytes frame, const CallOptions& options,
                             Completion<Reply> done) -> Stop {
  if (!impl.is_connected()) return done(Impl::not_connected()), Stop{};
  const detail::Conversation conversation = impl.conversation();
  const auto ticket = conversation.start(frame, options, std::move(done));
  return [conversation, ticket] { conversation.cancel(ticket); };
}

auto AsyncClient::begin_stream(Impl& impl, detail::FrameBytes frame, detail::MessageKey key,
                               detail::Conversation::MessageHandler handler,
                               const CallOptions& options, Completion<Subscription> done) -> Stop {
  if (!impl.is_connected()) return done(Impl::not_connected()), Stop{};
  const detail::Conversation conversation = impl.conversation();
  const auto ticket =
      conversation.start_stream(frame, key, std::move(handler), options, std::move(done));
  return [conversation, ticket] { conversation.cancel(ticket); };
}

void AsyncClient::run(Impl& impl, std::function<void(Result<Client>)> task) {
  impl.run(std::move(task));
}

Subscription AsyncClient::subscribe_to(detail::MessageKey key,
                                       detail::Conversation::MessageHandler handler) {
  if (!is_connected()) return {};
  return impl_->conversation().subscribe(key, std::move(handler));
}

Subscription AsyncClient::on_notice(std::function<void(const Notice&)> handler) {
  if (!is_connected()) return {};
  return impl_->conversation().on_notice(std::move(handler));
}

bool AsyncClient::is_connected() const { return impl_->is_connected(); }

BoardIdentity AsyncClient::board() const {
  return is_connected() ? impl_->conversation().board() : BoardIdentity{};
}

std::string AsyncClient::description() const {
  return is_connected() ? impl_->conversation().description() : std::string();
}

ClientStatistics AsyncClient::statistics() const {
  return is_connected() ? impl_->conversation().statistics() : ClientStatistics{};
}

void AsyncClient::close() noexcept { impl_->close(false); }

}  // namespace sbgc
