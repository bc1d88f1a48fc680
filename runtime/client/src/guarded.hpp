/// A value that threads share.
#pragma once

#include <mutex>
#include <utility>

namespace sbgc::detail {

/// Holds its lock while the value is used: `value->member()`, or `*value.lock()`.
template <class T>
class Guarded {
 public:
  class Access {
   public:
    explicit Access(const Guarded& from) : lock_(from.mutex_), value_(from.value_) {}
    T* operator->() const noexcept { return &value_; }
    T& operator*() const noexcept { return value_; }

   private:
    std::unique_lock<std::mutex> lock_;
    T& value_;
  };

  template <class... Arguments>
  explicit Guarded(Arguments&&... arguments) : value_(std::forward<Arguments>(arguments)...) {}

  Access lock() const { return Access(*this); }
  Access operator->() const { return lock(); }

 private:
  // As with a pointer, const says nothing about the value.
  mutable std::mutex mutex_;
  mutable T value_;
};

}  // namespace sbgc::detail
