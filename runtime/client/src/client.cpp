#include <functional>
#include <memory>
#include <string>
#include <thread>
#include <utility>

#include <asio/executor_work_guard.hpp>
#include <asio/io_context.hpp>

#include <sbgc/client/client.hpp>
#include <sbgc/client/own_transport.hpp>

#include "connection.hpp"
#include "reconnecting/reconnection.hpp"

namespace sbgc {

namespace {

/// The I/O thread of a client and its execution context.
class Loop {
 public:
  Loop()
      : context_(std::make_shared<asio::io_context>(1)),
        work_(context_->get_executor()),
        thread_([context = context_] { context->run(); }) {}
  Loop(const Loop&) = delete;
  Loop& operator=(const Loop&) = delete;
  /// Joins the thread, whose connection is closed. If the destructor runs on the thread itself,
  /// detaches it instead.
  ~Loop() {
    work_.reset();
    if (thread_.get_id() == std::this_thread::get_id()) {
      thread_.detach();
    } else {
      thread_.join();
    }
  }

  asio::any_io_executor executor() const { return context_->get_executor(); }

 private:
  std::shared_ptr<asio::io_context> context_;
  asio::executor_work_guard<asio::io_context::executor_type> work_;
  std::thread thread_;
};

}  // namespace

Result<std::shared_ptr<detail::Connection>> detail::connect_with_thread(
    const Opener& opener, const ConnectOptions& options, const OnStarted& on_begun) {
  const auto loop = std::make_shared<Loop>();
  auto conversation = detail::connect(loop->executor(), opener, options, on_begun);
  if (!conversation) return std::move(conversation).error();
  return std::make_shared<Connection>(loop, loop->executor(), *std::move(conversation));
}

namespace {

Result<Client> connect_once(const detail::Opener& opener, const ConnectOptions& options) {
  auto connection = detail::connect_with_thread(opener, options);
  if (!connection) return std::move(connection).error();
  return Client(*std::move(connection));
}

Result<Client> connect_again(const std::string& address, const TransportFactory& make,
                             const ReconnectOptions& options) {
  const auto reconnection = std::make_shared<detail::Reconnection>(address, make, options);
  if (auto started = reconnection->start(); !started) return std::move(started).error();
  return Client(detail::owner_of(reconnection));
}

}  // namespace

Result<Client> Client::connect(const std::string& address, const ConnectOptions& options) {
  return connect_once(detail::opener_of(address, options), options);
}

Result<Client> Client::keep_connected(const std::string& address, const ReconnectOptions& options) {
  return connect_again(address, TransportFactory(), options);
}

Result<Client> connect_over(const TransportFactory& make, const ConnectOptions& options) {
  return connect_once(detail::opener_of(make, options), options);
}

Result<Client> detail::keep_connected_over(const TransportFactory& make,
                                           const ReconnectOptions& options) {
  return connect_again(std::string(), make, options);
}

void Client::start_raw(RawRequest request, const CallOptions& options,
                       std::function<void(const Result<Reply>&)> handler) {
  const auto current = link_->connected();
  if (!current) return handler(current.error());
  (*current)->conversation().start(detail::Conversation::prepare(std::move(request)), options,
                                   std::move(handler));
}

}  // namespace sbgc
