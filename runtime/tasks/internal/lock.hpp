/// Locks of an owner with threads, and values shared between threads: tasks and dialogue do not
/// lock anything themselves.
#pragma once

#include <memory>
#include <utility>

namespace sbgc::detail {

/// A recursive lock.
class Lock {
 public:
  Lock() = default;
  Lock(const Lock&) = delete;
  Lock& operator=(const Lock&) = delete;
  virtual ~Lock() = default;

  virtual void lock() = 0;
  virtual void unlock() = 0;
};

using LockPointer = std::unique_ptr<Lock>;
/// Makes a lock; returns null without threads.
using MakeLock = LockPointer (*)();
inline LockPointer no_lock() { return nullptr; }

/// Holds a lock, unless it is null.
class Holding {
 public:
  explicit Holding(const LockPointer& lock) : lock_(lock.get()) {
    if (lock_ != nullptr) lock_->lock();
  }
  Holding(const Holding&) = delete;
  Holding& operator=(const Holding&) = delete;
  ~Holding() {
    if (lock_ != nullptr) lock_->unlock();
  }

 private:
  Lock* lock_;
};

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
  mutable T value_;  // as with a pointer, const does not apply to the value
};

}  // namespace sbgc::detail
