#include "line_search.hpp"

#include <algorithm>
#include <utility>

namespace sbgc::detail {

void LineSearch::on_done(Done done) {
  const std::lock_guard lock(mutex_);
  done_ = std::move(done);
}

void LineSearch::report(const Outcome& outcome) {
  Done done;
  {
    const std::lock_guard lock(mutex_);
    done = std::exchange(done_, nullptr);
  }
  if (done) done(outcome);
}

LineSearch::Outcome LineSearch::so_far() const {
  const std::lock_guard lock(mutex_);
  return so_far_;
}

DetectorStep LineSearch::next_step(Instant now) {
  const DetectorStep step = detector_->next(now);
  const std::lock_guard lock(mutex_);
  std::ranges::copy(detector_->trials(), so_far_.trials.begin());
  return step;
}

bool LineSearch::advance(Channel& channel, Instant now) {
  while (channel.can_write()) {
    const DetectorStep step = next_step(now);
    switch (step.kind) {
      case DetectorStep::Kind::set_line:
        if (channel.transport().line()->set(step.line)) detector_->refuse();
        break;
      case DetectorStep::Kind::write: channel.write(step.bytes); break;
      case DetectorStep::Kind::wait: channel.wake_at(step.until); return false;
      case DetectorStep::Kind::found:
        found_ = true;
        line_ = step.line;
        return true;
      case DetectorStep::Kind::failed: return true;
    }
  }
  return false;
}

LineSearch::Outcome LineSearch::take_outcome() {
  Outcome outcome{found_, {}};
  std::ranges::copy(detector_->trials(), outcome.trials.begin());
  detector_.reset();
  return outcome;
}

}  // namespace sbgc::detail
