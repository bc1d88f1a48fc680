#include <memory>
#include <thread>
#include <utility>

#include <asio/executor_work_guard.hpp>
#include <asio/io_context.hpp>

#include <sbgc/client/client.hpp>
#include <sbgc/client/own_transport.hpp>

#include "connect.hpp"

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
  /// Joins the thread. If the destructor runs on the thread itself, detaches it instead.
  ~Loop() {
    conversation_.close();
    work_.reset();
    if (thread_.get_id() == std::this_thread::get_id()) {
      thread_.detach();
    } else {
      thread_.join();
    }
  }

  asio::any_io_executor executor() const { return context_->get_executor(); }
  void set_conversation(const detail::Conversation& conversation) { conversation_ = conversation; }

 private:
  std::shared_ptr<asio::io_context> context_;
  asio::executor_work_guard<asio::io_context::executor_type> work_;
  detail::Conversation conversation_;
  std::thread thread_;
};

}  // namespace

Result<Client> detail::connect_client(const Opener& opener, const ConnectOptions& options,
                                      const OnStarted& on_begun) {
  const auto loop = std::make_shared<Loop>();
  auto conversation = detail::connect(loop->executor(), opener, options, on_begun);
  if (!conversation) return std::move(conversation).error();
  loop->set_conversation(*conversation);
  return ClientMaker::make(loop, *std::move(conversation));
}

Result<Client> Client::connect(const std::string& address, const ConnectOptions& options) {
  return detail::connect_client(detail::opener_of(address, options), options);
}

Result<Client> connect_over(const TransportFactory& make, const ConnectOptions& options) {
  return detail::connect_client(detail::opener_of(make, options), options);
}

}  // namespace sbgc
