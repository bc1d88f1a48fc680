/// The implementation of ReconnectingClient: keeps a Client and replaces it when its line is lost.
#pragma once

#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <utility>

#include <sbgc/client/own_transport.hpp>
#include <sbgc/client/reconnecting_client.hpp>

#include "connect.hpp"
#include "reconnecting/adapter.hpp"
#include "reconnecting/kept_subscriptions.hpp"
#include "reconnecting/search.hpp"

namespace sbgc {

/// One thread searches, registers handlers again and releases what others have cancelled.
class ReconnectingClient::Impl : public std::enable_shared_from_this<ReconnectingClient::Impl> {
 public:
  using ClientPointer = std::shared_ptr<Client>;
  using Kept = detail::KeptSubscriptions::Kept;

  /// Without a factory, connects to the address.
  Impl(std::string address, TransportFactory make, ReconnectOptions options);
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;
  ~Impl() = default;

  /// Makes the first connection and starts the thread.
  Result<void> start();
  /// Closes the client and ends the thread.
  void finish() noexcept;
  void close() noexcept;

  Result<ClientPointer> current(const CallOptions& options);
  Result<Reply> use(const CallOptions& options,
                    const std::function<Result<Reply>(Client&, const CallOptions&)>& call);
  void start_raw(RawRequest request, const CallOptions& options,
                 std::function<void(const Result<Reply>&)> handler);

  Subscription keep(Begin begin, MessageHandler handler);
  Result<Subscription> keep_stream(Begin begin, MessageHandler handler,
                                   std::chrono::microseconds interval, const CallOptions& options);
  Subscription on_notice(std::function<void(const Notice&)> handler);
  Subscription on_change(std::function<void(const LinkChange&)> handler);

  void check();

  LinkState state() const;
  std::uint64_t connections() const;
  BoardIdentity identity() const;
  std::string description() const;
  ClientStatistics statistics() const;

 private:
  class Hold;
  using Lock = std::unique_lock<std::mutex>;
  using Time = Clock::TimePoint;

  // On any thread.
  Time call_deadline(const CallOptions& options) const;
  static CallOptions with_time_left(CallOptions options, Time deadline);
  ClientError no_connection() const;
  Result<ClientPointer> wait_for_client(Time deadline);
  MessageHandler passer_to(const Kept& kept);
  Subscription hold(const Kept& kept, std::unique_ptr<Subscription::Registration> membership);
  void subscribe(const Kept& kept);
  void drop(const Kept& kept) noexcept;
  void noticed(const Notice& notice, std::uint64_t connection);
  void lose(const std::string& reason, std::uint64_t connection, bool is_restarting);

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
  Result<Client> dial();
  Result<Client> dial_same_board(detail::Search& search);
  void adopt(Lock& lock, Client client);
  void enter(Lock& lock, const LinkChange& change);
  void tell(const LinkChange& change);

  const ReconnectOptions options_;
  const std::string address_;
  const TransportFactory make_;
  detail::Adapter adapter_;
  const std::shared_ptr<detail::HandlerTurn> turn_ = std::make_shared<detail::HandlerTurn>();
  const std::shared_ptr<detail::KeptHandlers> notices_ = std::make_shared<detail::KeptHandlers>();
  const std::shared_ptr<detail::KeptHandlers> changes_ = std::make_shared<detail::KeptHandlers>();

  mutable std::mutex mutex_;
  std::condition_variable changed_;
  LinkState state_ = LinkState::searching;
  ClientPointer client_;           // null unless connected
  Subscription client_notices_;    // of client_
  detail::Conversation dialling_;  // of the attempt in progress
  bool is_opening_ = false;        // the attempt may block for a while
  std::uint64_t connections_ = 0;
  std::optional<std::string> loss_;  // why the current connection is to be replaced
  bool is_restarting_ = false;       // the board, which is the reason
  bool is_check_wanted_ = false;
  bool is_closing_ = false;
  BoardIdentity board_;
  std::string description_;
  ClientStatistics statistics_;  // of the last connection
  std::string problem_;          // of the last attempt
  detail::KeptSubscriptions kept_;
  Time next_look_{};

  std::thread thread_;
};

/// Makes the client, also for reconnecting_over(), whose types would bring Asio into the class; and
/// names its implementation for callers that must not wait.
struct detail::ReconnectingOver {
  using Impl = ReconnectingClient::Impl;

  static Result<ReconnectingClient> start(const std::string& address, const TransportFactory& make,
                                          const ReconnectOptions& options) {
    const auto impl = std::make_shared<Impl>(address, make, options);
    if (auto started = impl->start(); !started) return std::move(started).error();
    return ReconnectingClient(impl);
  }
};

}  // namespace sbgc
