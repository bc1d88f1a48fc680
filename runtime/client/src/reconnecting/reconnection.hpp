/// A client's link that is restored when it breaks.
#pragma once

#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <asio/any_io_executor.hpp>
#include <asio/strand.hpp>

#include <sbgc/client/link.hpp>
#include <sbgc/client/own_transport.hpp>

#include "connection.hpp"
#include "driving/task_driver.hpp"
#include "reconnecting/awaited_client.hpp"
#include "reconnecting/kept_subscriptions.hpp"
#include "reconnecting/search.hpp"

namespace sbgc::detail {

/// One thread searches, re-registers handlers and releases canceled ones. Each connection has its
/// own thread for calling the handlers; or with an executor, everything but the search happens
/// there.
class Reconnection final : public Link, public std::enable_shared_from_this<Reconnection> {
 public:
  using Pointer = std::shared_ptr<Connection>;
  using Kept = KeptSubscriptions::Kept;

  /// Without a factory, connects to the address.
  Reconnection(std::string address, TransportFactory make, ReconnectOptions options,
               asio::any_io_executor executor = {});
  Reconnection(const Reconnection&) = delete;
  Reconnection& operator=(const Reconnection&) = delete;
  ~Reconnection() override = default;

  /// Makes the first connection and starts the thread.
  Result<void> start();
  /// Starts the thread, which releases `previous` and makes the first connection.
  void start(std::shared_ptr<Link> previous, const Completion<Result<void>>& done);
  /// Closes the client and ends the thread.
  void finish() noexcept;

  // The functions that return a Stop need the executor.

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

  Result<Pointer> connected() override;
  void check() override;
  LinkState state() const override;
  std::uint64_t connections() const override;
  BoardIdentity identity() const override;
  std::string description() const override;
  ClientStatistics statistics() const override;
  void close() noexcept override;

 private:
  class Hold;
  struct PendingCall;
  using Lock = std::unique_lock<std::mutex>;
  using Time = Clock::TimePoint;

  // On any thread.
  Time call_deadline(const CallOptions& options) const;
  static CallOptions with_time_left(CallOptions options, Time deadline);
  ClientError no_connection() const;
  std::optional<Result<Pointer>> decision() const;
  Result<Pointer> wait_for_client(Time deadline);
  void await_client(Time deadline, CurrentStop& stop, const AwaitedClient::Use& use);
  bool may_begin_again(const Result<Reply>& reply, const Pointer& client, Time deadline);
  void begin(const std::shared_ptr<PendingCall>& call);
  MessageHandler passer_to(const Kept& kept);
  Subscription hold(const Kept& kept);
  Subscription keep(KeptHandler::Begin begin, MessageHandler handler);
  static Kept kept_stream(const Stream& stream, const CallOptions& options);
  Result<Subscription> keep_begun(const Kept& kept, Result<Subscription> begun,
                                  const Pointer& client);
  void register_now(const Kept& kept);
  void drop(const Kept& kept) noexcept;
  void noticed(const Notice& notice, std::uint64_t connection);
  void lose(const std::string& reason, std::uint64_t connection, bool is_restarting);
  void announce_change();
  void show(const Notice& notice);
  void deliver(std::function<void()> call);
  Result<void> connect_first();

  // On the thread that connects.
  void run();
  void begin_again(Lock& lock, const Kept& kept, bool is_running);
  void look_after_streams(Lock& lock);
  bool shows_life(Lock& lock);
  void release_dropped(Lock& lock);
  void recover(Lock& lock);
  void disconnect(Lock& lock);
  bool search(Lock& lock);
  bool pause(Lock& lock, std::chrono::milliseconds time);
  Result<Pointer> dial();
  Result<Pointer> connect_to(const Opener& opener);
  Result<Pointer> dial_same_board(Search& search);
  void adopt(Lock& lock, Pointer connection);
  void enter(Lock& lock, const LinkChange& change);
  void tell(const LinkChange& change);

  const ReconnectOptions options_;
  const std::string address_;
  const TransportFactory make_;
  const asio::any_io_executor executor_;                         // may be empty
  std::optional<asio::strand<asio::any_io_executor>> strand_{};  // of the executor
  Adapter adapter_;
  const std::shared_ptr<HandlerTurn> turn_ = std::make_shared<HandlerTurn>();
  const std::shared_ptr<KeptHandlers> notices_ = std::make_shared<KeptHandlers>(make_mutex);
  const std::shared_ptr<KeptHandlers> changes_ = std::make_shared<KeptHandlers>(make_mutex);
  RunningTasks tasks_;

  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<std::weak_ptr<AwaitedClient>> awaited_;  // like threads that wait for `changed_`
  LinkState state_ = LinkState::searching;
  Pointer client_;               // null unless connected
  Subscription client_notices_;  // of client_
  Conversation dialling_;        // of the attempt in progress
  bool is_opening_ = false;      // the attempt may block for a while
  std::uint64_t connections_ = 0;
  std::optional<std::string> loss_;  // why the current connection must be replaced
  bool is_restarting_ = false;       // the board is restarting, which is the reason
  bool is_check_wanted_ = false;
  bool is_closing_ = false;
  BoardIdentity board_;
  std::string description_;
  ClientStatistics statistics_;  // of the last connection
  std::string problem_;          // of the last attempt
  KeptSubscriptions kept_;
  Time next_look_{};

  std::thread thread_;
};

/// Returns an object whose release ends the thread.
inline std::shared_ptr<Link> owner_of(const std::shared_ptr<Reconnection>& reconnection) {
  return {reconnection.get(), [reconnection](Link*) { reconnection->finish(); }};
}

}  // namespace sbgc::detail
