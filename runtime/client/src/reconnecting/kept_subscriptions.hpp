/// Handlers that stay registered across connections.
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

#include <sbgc/client/conversation.hpp>
#include <sbgc/client/subscription.hpp>

#include "conversation/handlers.hpp"
#include "threads.hpp"

namespace sbgc::detail {

/// Runs handlers one at a time, on any thread. Shared with handlers that outlive the client.
class HandlerTurn {
 public:
  template <class Use>
  void take(const Use& use) {
    const std::lock_guard lock(mutex_);
    const Mark mark(thread_);
    use();
  }
  /// True on the thread whose handler is running.
  bool runs_in_this_thread() const { return thread_ == std::this_thread::get_id(); }

 private:
  /// Marks this thread as long as it lives, even if a handler throws.
  class Mark {
   public:
    explicit Mark(std::atomic<std::thread::id>& place) : place_(place) {
      place_.store(std::this_thread::get_id());
    }
    Mark(const Mark&) = delete;
    Mark& operator=(const Mark&) = delete;
    ~Mark() { place_.store(std::thread::id()); }

   private:
    std::atomic<std::thread::id>& place_;
  };

  std::mutex mutex_;
  std::atomic<std::thread::id> thread_{};
};

/// Handlers of one kind, called with a pointer to the message.
using KeptHandlers = Handlers<int, void(const void*)>;

/// One handler: the way to register it with a connection, and its current registration.
struct KeptHandler {
  /// Registers the function with a connection.
  using Begin = std::function<Result<Subscription>(
      const Conversation&, const Conversation::MessageHandler&, const CallOptions&)>;
  using Time = std::chrono::steady_clock::time_point;

  KeptHandler(Begin begun, Conversation::MessageHandler handler)
      : begin(std::move(begun)), membership(handlers->add({}, std::move(handler))) {}

  Begin begin;
  CallOptions options{};  // of `begin`
  std::shared_ptr<KeptHandlers> handlers = std::make_shared<KeptHandlers>(make_mutex);  // with one
  std::unique_ptr<Subscription::Registration> membership;  // of the handler; the owner releases it
  std::chrono::microseconds interval{};                    // of a data stream, else 0
  std::atomic<std::int64_t> messages{};                    // received

  // Guarded by the mutex of the client.
  Subscription current{};
  std::uint64_t connection{};  // that `current` belongs to; 0: none
  std::uint64_t refused{};     // the connection whose board has refused to start the stream
  bool is_cancelled = false;
  std::int64_t counted{};  // `messages` at the last check
  Time changed{};          // when the last change of `messages` was noticed
};

/// Not thread-safe: the mutex of the client guards it. Registrations are returned instead of
/// released, because releasing one waits for its handler, which may wait for its turn.
class KeptSubscriptions {
 public:
  using Kept = std::shared_ptr<KeptHandler>;
  using Time = KeptHandler::Time;

  bool empty() const noexcept { return kept_.empty(); }
  void add(const Kept& kept) { kept_.push_back(kept); }
  void drop(const Kept& kept);

  /// Records the registration of a handler with a connection; the caller releases an earlier one.
  void set(const Kept& kept, Subscription registration, std::uint64_t connection, Time now);

  /// Returns the handlers that need no request.
  std::vector<Kept> without_request() const;
  /// Returns a handler that is not registered with this connection; null if there is none.
  Kept next_to_restore(std::uint64_t connection) const;
  /// Returns a data stream of this connection that has been silent for longer than three intervals
  /// and `longest`; null if there is none.
  Kept silent_stream(std::uint64_t connection, std::chrono::milliseconds longest, Time now);

  /// Returns the registrations to release.
  std::vector<Subscription> take_dropped();
  /// Returns all registrations: the connection has ended.
  std::vector<Subscription> take_all();

 private:
  std::vector<Kept> kept_;
  std::vector<Subscription> dropped_;
};

}  // namespace sbgc::detail
