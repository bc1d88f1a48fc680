#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <utility>

#include <asio/post.hpp>
#include <asio/thread_pool.hpp>

#include <sbgc/client/async_client.hpp>

#include "connection.hpp"
#include "reconnecting/reconnection.hpp"

namespace sbgc {

/// The link of the last async_connect().
class AsyncClient::Links {
 public:
  using Link = std::shared_ptr<detail::Link>;
  using Done = detail::Completion<Result<void>>;

  explicit Links(asio::any_io_executor executor) : executor_(std::move(executor)) {}
  Links(const Links&) = delete;
  Links& operator=(const Links&) = delete;
  ~Links() {
    end();
    if (worker_) worker_->join();
  }

  void connect(const detail::Opener& opener, const ConnectOptions& options, const Done& done) {
    const std::uint64_t attempt = end();
    {
      const std::lock_guard lock(mutex_);
      if (!worker_) worker_.emplace(1);
    }
    asio::post(*worker_, [this, attempt, opener, options, done] {
      const auto adopt = [this, attempt](const detail::Conversation& begun) {
        const std::lock_guard lock(mutex_);
        dialling_ = begun;
        if (attempt != ends_) begun.close();
      };
      auto conversation = detail::connect(executor_, opener, options, adopt);
      if (!conversation) return done(std::move(conversation).error());
      Link link =
          std::make_shared<detail::Connection>(nullptr, executor_, *std::move(conversation));
      done(swap(link, attempt) ? Result<void>() : closed_meanwhile());
    });
  }
  detail::Stop connect(const std::string& address, const TransportFactory& make,
                       const ReconnectOptions& options, const Done& done) {
    const auto begun = std::make_shared<detail::Reconnection>(address, make, options, executor_);
    Link link = detail::owner_of(begun);
    if (!swap(link, end())) return done(closed_meanwhile()), detail::Stop{};
    begun->start(std::move(link), done);
    return [weak = std::weak_ptr(begun)] {
      if (const auto connecting = weak.lock()) connecting->close();
    };
  }

  /// Null before the first connection.
  Link current() const {
    const std::lock_guard lock(mutex_);
    return link_;
  }

  /// Closes the link, and ends connect(). Returns how many times it has been called.
  std::uint64_t end() noexcept {
    detail::Conversation dialling;
    Link link;
    std::uint64_t ends = 0;
    {
      const std::lock_guard lock(mutex_);
      ends = ++ends_;
      dialling = dialling_;
      link = link_;
    }
    dialling.close();
    if (link) link->close();
    return ends;
  }

 private:
  static ClientError closed_meanwhile() { return {ErrorCode::cancelled, "the client was closed"}; }
  /// Makes this the link, and returns the previous one in its place, unless end() has been called
  /// since. Returns whether it did so.
  bool swap(Link& link, std::uint64_t attempt) {
    const std::lock_guard lock(mutex_);
    if (attempt != ends_) return false;
    link_.swap(link);
    return true;
  }

  const asio::any_io_executor executor_;
  mutable std::mutex mutex_;
  Link link_;
  detail::Conversation dialling_;
  std::uint64_t ends_ = 0;
  std::optional<asio::thread_pool> worker_{};  // opening a line can block
};

AsyncClient::AsyncClient(const asio::any_io_executor& executor)
    : executor_(executor), links_(std::make_shared<Links>(executor)) {}

detail::Stop AsyncClient::connect(const std::shared_ptr<Links>& links, const std::string& address,
                                  const TransportFactory& make, const ConnectOptions& options,
                                  const Links::Done& done) {
  links->connect(make ? detail::opener_of(make, options) : detail::opener_of(address, options),
                 options, done);
  return [weak = std::weak_ptr(links)] {
    if (const auto connecting = weak.lock()) connecting->end();
  };
}

detail::Stop AsyncClient::connect(const std::shared_ptr<Links>& links, const std::string& address,
                                  const TransportFactory& make, const ReconnectOptions& options,
                                  const Links::Done& done) {
  return links->connect(address, make, options, done);
}

std::shared_ptr<detail::Link> AsyncClient::current(const Links& links) { return links.current(); }

Subscription AsyncClient::subscribe(detail::MessageKey key, detail::Link::MessageHandler handler) {
  const auto link = links_->current();
  return link ? link->subscribe(key, std::move(handler)) : Subscription();
}

Subscription AsyncClient::on_notice(std::function<void(const Notice&)> handler) {
  const auto link = links_->current();
  return link ? link->on_notice(std::move(handler)) : Subscription();
}

Subscription AsyncClient::on_change(std::function<void(const LinkChange&)> handler) {
  const auto link = links_->current();
  return link ? link->on_change(std::move(handler)) : Subscription();
}

void AsyncClient::check() {
  if (const auto link = links_->current()) link->check();
}

LinkState AsyncClient::state() const {
  const auto link = links_->current();
  return link ? link->state() : LinkState::closed;
}

std::uint64_t AsyncClient::connections() const {
  const auto link = links_->current();
  return link ? link->connections() : 0;
}

BoardIdentity AsyncClient::identity() const {
  const auto link = links_->current();
  return link ? link->identity() : BoardIdentity{};
}

std::string AsyncClient::description() const {
  const auto link = links_->current();
  return link ? link->description() : std::string();
}

ClientStatistics AsyncClient::statistics() const {
  const auto link = links_->current();
  return link ? link->statistics() : ClientStatistics{};
}

void AsyncClient::close() noexcept { links_->end(); }

}  // namespace sbgc
