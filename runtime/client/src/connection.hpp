/// A client's link that ends with its line, and its setup: from an address to an identified board.
#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <string>

#include <asio/any_io_executor.hpp>

#include <sbgc/client/conversation.hpp>
#include <sbgc/client/link.hpp>
#include <sbgc/client/own_transport.hpp>

#include "driving/task_driver.hpp"

namespace sbgc::detail {

class Connection final : public Link, public std::enable_shared_from_this<Connection> {
 public:
  /// `keeper` lives as long as the connection.
  Connection(std::shared_ptr<const void> keeper, asio::any_io_executor executor,
             Conversation conversation);
  Connection(const Connection&) = delete;
  Connection& operator=(const Connection&) = delete;
  ~Connection() override;

  const Conversation& conversation() const noexcept { return conversation_; }

  Result<Reply> call(const Prepare& prepare, const CallOptions& options) override;
  Stop start(const Prepare& prepare, const CallOptions& options,
             const Completion<Result<Reply>>& done) override;
  Result<Subscription> stream(const Stream& stream, const CallOptions& options) override;
  Stop start_stream(const Stream& stream, const CallOptions& options,
                    const Completion<Result<Subscription>>& done) override;
  std::optional<ClientError> run(const BeginTask& begin, Clock& clock) override;
  Stop start_task(const BeginTask& begin,
                  const Completion<std::optional<ClientError>>& done) override;

  Subscription subscribe(MessageKey key, MessageHandler handler) override;
  Subscription on_frame(std::function<void(const BoardFrame&)> handler) override;
  Subscription on_notice(std::function<void(const Notice&)> handler) override;
  Subscription on_change(std::function<void(const LinkChange&)> handler) override;

  Result<std::shared_ptr<Connection>> connected() override { return shared_from_this(); }
  void check() override {}
  LinkState state() const override;
  std::uint64_t connections() const override { return 1; }
  BoardIdentity identity() const override { return conversation_.identity(); }
  std::string description() const override { return conversation_.description(); }
  ClientStatistics statistics() const override { return conversation_.statistics(); }
  void close() noexcept override;

 private:
  const std::shared_ptr<const void> keeper_;
  const asio::any_io_executor executor_;
  const Conversation conversation_;
  RunningTasks tasks_;
};

/// Opens the transport of a client; `open` may block for at most `timeout`.
struct Opener {
  std::function<io::OpenResult(const asio::any_io_executor& executor,
                               std::chrono::milliseconds timeout)>
      open;
  bool detect_line = false;  ///< only if the transport has a LineControl
};

Opener opener_of(const std::string& address, const ConnectOptions& options);
Opener opener_of(const TransportFactory& make, const ConnectOptions& options);

/// Receives the conversation before connect() can block. Closing it ends connect().
using OnStarted = std::function<void(const Conversation&)>;

/// Opens the line and reads the identity of the board. Blocks for at most options.timeout; another
/// thread must run the executor meanwhile.
Result<Conversation> connect(const asio::any_io_executor& executor, const Opener& opener,
                             const ConnectOptions& options, const OnStarted& on_begun = {});

/// Connects with its own I/O thread; see connect().
Result<std::shared_ptr<Connection>> connect_with_thread(const Opener& opener,
                                                        const ConnectOptions& options,
                                                        const OnStarted& on_begun = {});

}  // namespace sbgc::detail
