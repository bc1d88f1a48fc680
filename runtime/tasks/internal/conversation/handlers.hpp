/// Lists of handlers.
#pragma once

#include <algorithm>
#include <functional>
#include <iterator>
#include <memory>
#include <utility>
#include <vector>

#include <sbgc/client/subscription.hpp>

#include "lock.hpp"

namespace sbgc::detail {

/// Handlers with keys that can be removed at any time. Thread-safe with locks.
template <class Key, class Signature>
class Handlers : public std::enable_shared_from_this<Handlers<Key, Signature>> {
 public:
  using Function = std::function<Signature>;

  struct Entry {
    Entry(const Key& wanted, Function called, LockPointer lock)
        : key(wanted), running(std::move(lock)), function(std::move(called)) {}

    const Key key;
    const LockPointer running;  // held while the function runs, which may remove itself
    bool is_member = true;
    bool is_running = false;
    Function function;
  };

  explicit Handlers(MakeLock make_lock) : make_lock_(make_lock) {}

  /// Keeps `function` registered as long as the result lives. After that the function is not
  /// running, never runs again, and is destroyed; a function that removes itself runs to its end.
  std::unique_ptr<Subscription::Registration> add(const Key& key, Function function) {
    auto entry = std::make_shared<Entry>(key, std::move(function), make_lock_());
    const Holding holding(lock_);
    entries_.push_back(entry);
    return std::make_unique<Membership>(this->shared_from_this(), std::move(entry));
  }

  /// Returns the current handlers with this key.
  std::vector<std::shared_ptr<Entry>> with_key(const Key& key) {
    std::vector<std::shared_ptr<Entry>> result;
    const Holding holding(lock_);
    std::copy_if(entries_.begin(), entries_.end(), std::back_inserter(result),
                 [&](const auto& entry) { return entry->key == key; });
    return result;
  }

  /// Returns the number of handlers for whose key `holds(key)` is true.
  template <class Holds>
  std::size_t count(const Holds& holds) {
    const Holding holding(lock_);
    return static_cast<std::size_t>(std::count_if(
        entries_.begin(), entries_.end(), [&](const auto& entry) { return holds(entry->key); }));
  }

  /// Calls `use(function)` for each handler that is still registered.
  template <class Use>
  static void call(const std::vector<std::shared_ptr<Entry>>& entries, const Use& use) {
    for (const auto& entry : entries) {
      const Holding running(entry->running);
      if (!entry->is_member) continue;
      entry->is_running = true;
      use(entry->function);
      entry->is_running = false;
    }
  }

 private:
  class Membership : public Subscription::Registration {
   public:
    Membership(std::shared_ptr<Handlers> handlers, std::shared_ptr<Entry> entry)
        : handlers_(std::move(handlers)), entry_(std::move(entry)) {}
    Membership(const Membership&) = delete;
    Membership& operator=(const Membership&) = delete;
    ~Membership() override { handlers_->remove(entry_); }

   private:
    std::shared_ptr<Handlers> handlers_;
    std::shared_ptr<Entry> entry_;
  };

  void remove(const std::shared_ptr<Entry>& entry) noexcept {
    {
      const Holding holding(lock_);
      std::erase(entries_, entry);
    }
    Function released;
    const Holding running(entry->running);
    entry->is_member = false;
    if (!entry->is_running) released = std::move(entry->function);
  }

  const MakeLock make_lock_;
  const LockPointer lock_ = make_lock_();
  std::vector<std::shared_ptr<Entry>> entries_;
};

}  // namespace sbgc::detail
