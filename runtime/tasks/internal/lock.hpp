/// Locks of an owner with threads: the tasks and the dialogue lock nothing themselves.
#pragma once

#include <memory>

namespace sbgc::detail {

/// A lock that the thread which holds it may take again.
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
/// Makes a lock; without threads there is none, and it returns null.
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

}  // namespace sbgc::detail
