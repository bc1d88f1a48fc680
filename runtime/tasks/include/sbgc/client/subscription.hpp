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
  class Registration {
   public:
    Registration() = default;
    Registration(const Registration&) = delete;
    Registration& operator=(const Registration&) = delete;
    virtual ~Registration() = default;
  };

  Subscription() noexcept = default;
  /// For the library itself.
  explicit Subscription(std::unique_ptr<Registration> registration) noexcept
      : registration_(std::move(registration)) {}

  /// Ends the subscription now; no handler runs afterwards.
  void cancel() noexcept { registration_.reset(); }
  /// True until it is canceled; false for an empty one.
  explicit operator bool() const noexcept { return registration_ != nullptr; }

 private:
  std::unique_ptr<Registration> registration_;
};

}  // namespace sbgc
