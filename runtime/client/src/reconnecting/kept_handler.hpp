/// A handler that stays registered from one connection to the next.
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <thread>
#include <utility>

#include <sbgc/client/conversation.hpp>

#include "conversation/handlers.hpp"
#include "mutex.hpp"

namespace sbgc::detail {

/// Runs handlers one at a time, on whichever thread. Shared with handlers that outlive the client.
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
  /// Names this thread as long as it lives, also if a handler throws.
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

/// Handlers of one kind, to be called with a pointer to the message.
using KeptHandlers = Handlers<int, void(const void*)>;

/// One handler: how to register it with a connection, and its registration with the current one.
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
  std::uint64_t refused{};     // the connection whose board does not start the stream
  bool is_cancelled = false;
  std::int64_t counted{};  // `messages` when they were last looked at
  Time changed{};          // when the last change of `messages` was noticed
};

}  // namespace sbgc::detail
