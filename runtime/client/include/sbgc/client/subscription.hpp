/// RAII handle of a subscription.
#pragma once

#include <functional>
#include <memory>
#include <utility>

namespace sbgc {

/// Keeps a handler subscribed, and its data stream active, as long as it lives.
///
/// After destruction or cancellation the handler is not running and never runs again; both wait for
/// a running handler, except from inside that handler. A subscription may outlive the client.
class [[nodiscard]] Subscription {
 public:
  /// A resource that its destructor releases.
  class Hold {
   public:
    Hold() = default;
    Hold(const Hold&) = delete;
    Hold& operator=(const Hold&) = delete;
    virtual ~Hold() = default;
  };

  Subscription() noexcept = default;
  explicit Subscription(std::unique_ptr<Hold> hold) noexcept : hold_(std::move(hold)) {}

  void cancel() noexcept { hold_.reset(); }
  explicit operator bool() const noexcept { return hold_ != nullptr; }

 private:
  std::unique_ptr<Hold> hold_;
};

}  // namespace sbgc
