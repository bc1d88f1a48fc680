#include <memory>
#include <mutex>
#include <utility>
#include <vector>

#include <asio/post.hpp>
#include <asio/thread_pool.hpp>

#include <sbgc/client/async_client.hpp>

#include "connect.hpp"
#include "driving/asio_driver.hpp"

namespace sbgc {

class AsyncClient::Impl : public std::enable_shared_from_this<AsyncClient::Impl> {
 public:
  explicit Impl(asio::any_io_executor executor) : executor_(std::move(executor)) {}
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;
  ~Impl() {
    close(true);
    worker_.join();
  }

  const asio::any_io_executor& executor() const noexcept { return executor_; }

  /// Null before the first connect; not necessarily connected.
  detail::Conversation conversation() const {
    const std::lock_guard lock(mutex_);
    return conversation_;
  }
  bool is_connected() const {
    const std::lock_guard lock(mutex_);
    return is_connected_;
  }

  void connect(const detail::Opener& opener, const ConnectOptions& options,
               const Completion<Result<void>>& done) {
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

  Stop run(const detail::Conversation& conversation, TaskMachine& task,
           std::function<void()> done) {
    const auto driver =
        std::make_shared<detail::AsioDriver>(executor_, conversation, task, std::move(done));
    {
      const std::lock_guard lock(mutex_);
      std::erase_if(drivers_, [](const auto& one) { return one.expired(); });
      drivers_.push_back(driver);
    }
    driver->start();
    return [weak = std::weak_ptr(driver)] {
      if (const auto running = weak.lock()) running->put(cancel);
    };
  }

  void close(bool for_good) noexcept {
    detail::Conversation conversation;
    std::vector<std::weak_ptr<detail::AsioDriver>> drivers;
    {
      const std::lock_guard lock(mutex_);
      is_connected_ = false;
      is_closed_ = is_closed_ || for_good;
      conversation = conversation_;
      drivers.swap(drivers_);
    }
    conversation.close();
    for (const auto& weak : drivers) {
      if (const auto driver = weak.lock()) driver->put(cancel);
    }
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
  static void cancel(TaskMachine& task) { task.cancel(); }

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
  std::vector<std::weak_ptr<detail::AsioDriver>> drivers_;  // of the running tasks
  bool is_connected_ = false;
  bool is_closed_ = false;       // permanently: the client is being destroyed
  asio::thread_pool worker_{1};  // opening a line can block
};

AsyncClient::AsyncClient(const asio::any_io_executor& executor)
    : impl_(std::make_shared<Impl>(executor)) {}

asio::any_io_executor AsyncClient::executor() const { return impl_->executor(); }

auto AsyncClient::begin_connect(Impl& impl, const std::string& address,
                                const ConnectOptions& options, const Completion<Result<void>>& done)
    -> Stop {
  impl.connect(detail::opener_of(address, options), options, done);
  return impl.closer();
}

auto AsyncClient::begin_connect(Impl& impl, const TransportFactory& make,
                                const ConnectOptions& options, const Completion<Result<void>>& done)
    -> Stop {
  impl.connect(detail::opener_of(make, options), options, done);
  return impl.closer();
}

Result<detail::Conversation> AsyncClient::conversation_of(const Impl& impl) {
  if (!impl.is_connected()) return Impl::not_connected();
  return impl.conversation();
}

auto AsyncClient::run(Impl& impl, const detail::Conversation& conversation, TaskMachine& task,
                      std::function<void()> done) -> Stop {
  return impl.run(conversation, task, std::move(done));
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

BoardIdentity AsyncClient::identity() const {
  return is_connected() ? impl_->conversation().identity() : BoardIdentity{};
}

std::string AsyncClient::description() const {
  return is_connected() ? impl_->conversation().description() : std::string();
}

ClientStatistics AsyncClient::statistics() const {
  return is_connected() ? impl_->conversation().statistics() : ClientStatistics{};
}

void AsyncClient::close() noexcept { impl_->close(false); }

}  // namespace sbgc
