/// The locks of clients with threads.
#pragma once

#include <memory>
#include <mutex>

#include "lock.hpp"

namespace sbgc::detail {

class Mutex final : public Lock {
 public:
  void lock() override { mutex_.lock(); }
  void unlock() override { mutex_.unlock(); }

 private:
  std::recursive_mutex mutex_;
};

inline LockPointer make_mutex() { return std::make_unique<Mutex>(); }

}  // namespace sbgc::detail
