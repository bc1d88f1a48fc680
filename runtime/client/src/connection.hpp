/// A client's link that ends with its line.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include <asio/any_io_executor.hpp>

#include <sbgc/client/link.hpp>

#include "driving/running_tasks.hpp"

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

}  // namespace sbgc::detail
