/// The commands of motion that a client may still send.
#pragma once

#include <algorithm>
#include <functional>
#include <map>
#include <utility>
#include <vector>

#include <sbgc/client/request.hpp>

namespace sbgc::detail {

/// A stop, and any later motion, supersedes the motion of tasks that began before: these send none
/// any more. A stop is superseded by a later motion, but not by a later stop.
class MotionOrder {
 public:
  /// Called when a later task, with this number, supersedes one.
  using Superseded = std::function<void(TaskNumber by)>;
  using Calls = std::vector<std::function<void()>>;

  /// Numbers a task that begins.
  TaskNumber begin() noexcept { return ++last_; }

  /// Called once if the task is superseded, until leave().
  void join(TaskNumber task, Superseded superseded) {
    tasks_.insert_or_assign(task, Entry{std::move(superseded)});
  }
  void leave(TaskNumber task) { tasks_.erase(task); }

  /// True if the task may send no more motion.
  bool is_superseded(TaskNumber task) const noexcept {
    return task < std::max(last_motion_, last_stop_);
  }

  /// Returns false if the task may not send this command of motion, else notes that it does, and
  /// appends the calls that tell the tasks which it supersedes.
  bool admit(TaskNumber task, bool stops, Calls& calls) {
    if (task < last_motion_ || (!stops && task < last_stop_)) return false;
    TaskNumber& last = stops ? last_stop_ : last_motion_;
    last = std::max(last, task);
    const auto own = tasks_.find(task);
    if (own != tasks_.end() && !stops) own->second.has_moved = true;
    std::erase_if(tasks_, [&](auto& one) {
      const bool is_superseded = one.first < task && (!stops || one.second.has_moved);
      if (is_superseded) {
        calls.push_back([tell = std::move(one.second.superseded), task] { tell(task); });
      }
      return is_superseded;
    });
    return true;
  }

 private:
  struct Entry {
    Superseded superseded{};
    bool has_moved = false;
  };

  TaskNumber last_{};
  TaskNumber last_motion_{};  // the latest task that has moved the camera
  TaskNumber last_stop_{};
  std::map<TaskNumber, Entry> tasks_{};
};

}  // namespace sbgc::detail
