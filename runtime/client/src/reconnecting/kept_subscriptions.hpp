/// The handlers that stay registered from one connection to the next.
#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <vector>

#include <sbgc/client/subscription.hpp>

#include "reconnecting/kept_handler.hpp"

namespace sbgc::detail {

/// Not thread-safe: the mutex of the client guards it. Registrations are handed out instead of
/// released, because releasing one waits for its handler, which may wait for its turn.
class KeptSubscriptions {
 public:
  using Kept = std::shared_ptr<KeptHandler>;
  using Time = KeptHandler::Time;

  bool empty() const noexcept { return kept_.empty(); }
  void add(const Kept& kept) { kept_.push_back(kept); }
  void drop(const Kept& kept);

  /// Records the registration of a handler with a connection; an earlier one is to be released.
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
