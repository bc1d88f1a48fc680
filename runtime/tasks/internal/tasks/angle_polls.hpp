/// Repeated reading of the camera angles during a motion.
#pragma once

#include <optional>

#include <sbgc/client/task.hpp>
#include <sbgc/messages/control.hpp>
#include <sbgc/result.hpp>
#include <sbgc/time.hpp>

namespace sbgc::detail {

/// Reads the angles again and again. After a lost response, the session delays the next request by
/// most of a second, so that a late response cannot answer it. A motion that waited for it would
/// end, so it may go on with the last angles meanwhile.
class AnglePolls {
 public:
  /// Waits for new angles, at most until `until`; they are requested unless that is under way.
  /// Returns false if they have not arrived.
  Task<Result<bool>> update(Instant until = Instant::never);
  /// Drops the angles, and the request that is under way, because another motion begins.
  void forget(TaskMachine& task);

  /// The last angles and the time of their arrival; empty before.
  const std::optional<msg::GetAngles>& last() const noexcept { return last_; }
  Instant time() const noexcept { return time_; }

 private:
  void end_request(TaskMachine& task);

  std::optional<CallId> pending_{};
  std::optional<msg::GetAngles> last_{};
  Instant time_{};
};

}  // namespace sbgc::detail
