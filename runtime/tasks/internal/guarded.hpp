/// A value that threads may share.
#pragma once

#include <utility>

#include "lock.hpp"

namespace sbgc::detail {

/// Holds its lock while the value is used: `value->member()`, or `*value.lock()`.
template <class T>
class Guarded {
 public:
  class Access {
   public:
    explicit Access(const Guarded& from) : holding_(from.lock_), value_(from.value_) {}
    T* operator->() const noexcept { return &value_; }
    T& operator*() const noexcept { return value_; }

   private:
    Holding holding_;
    T& value_;
  };

  template <class... Arguments>
  explicit Guarded(LockPointer lock, Arguments&&... arguments)
      : lock_(std::move(lock)), value_(std::forward<Arguments>(arguments)...) {}

  Access lock() const { return Access(*this); }
  Access operator->() const { return lock(); }

 private:
  LockPointer lock_;
  mutable T value_;  // as with a pointer, const says nothing about the value
};

}  // namespace sbgc::detail
