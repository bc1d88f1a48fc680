// The search for the settings of the line.

#include <algorithm>
#include <utility>

#include <sbgc/io/clock.hpp>

#include "conversation_state.hpp"

namespace sbgc::detail {

void Conversation::State::detect(const std::function<void(Detection)>& done) {
  bool is_open = false;
  {
    const std::lock_guard lock(mutex_);
    is_open = phase_ == Phase::open;
    if (is_open) detected_ = done;
  }
  if (!is_open) return done({});
  post([this] {
    if (!transport_ || is_shut_ || transport_->line() == nullptr) return report({});
    detector_.emplace();
    advance();
  });
}

void Conversation::State::stop_detecting() {
  post([this] {
    if (detector_) end_detection(false);
  });
}

void Conversation::State::advance_detection() {
  while (!is_writing_) {
    const DetectorStep step = detector_->next(io::now());
    switch (step.kind) {
      case DetectorStep::Kind::set_line:
        if (transport_->line()->set(step.line)) detector_->refuse();
        break;
      case DetectorStep::Kind::write: write(step.bytes); break;
      case DetectorStep::Kind::wait: return arm(step.until);
      case DetectorStep::Kind::found: session_.set_line(step.line); return end_detection(true);
      case DetectorStep::Kind::failed: return end_detection(false);
    }
  }
}

void Conversation::State::end_detection(bool found) {
  Detection detection{found, {}};
  std::copy(detector_->trials().begin(), detector_->trials().end(), detection.trials.begin());
  detector_.reset();
  {
    const std::lock_guard lock(mutex_);
    description_ = transport_->description();
  }
  report(detection);
}

void Conversation::State::report(const Detection& detection) {
  std::function<void(Detection)> detected;
  {
    const std::lock_guard lock(mutex_);
    detected = std::exchange(detected_, nullptr);
  }
  if (detected) detected(detection);  // else the conversation has been closed
}

}  // namespace sbgc::detail
