/// The owner of a handler.
#pragma once

#include <functional>
#include <memory>
#include <utility>

namespace sbgc {

/// Keeps a handler subscribed, and a data stream running, as long as it lives.
///
/// When it has been destroyed or cancelled, the handler is not running and will not run again;
/// cancelling waits for that, except from inside the handler itself. It may outlive the client.
class [[nodiscard]] Subscription {
 public:
  /// Something that ends when its owner lets go of it.
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
