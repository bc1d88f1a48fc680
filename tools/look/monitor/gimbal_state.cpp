#include "look/monitor/gimbal_state.hpp"

#include <utility>

#include <sbgc/analysis/vibration.hpp>

namespace sbgc::tools {

namespace {

/// Adds the vibration in the rates of the gyroscope, `rate` of them per second. They are treated as
/// evenly spaced.
void add_vibration(LiveValues& values, const std::deque<PerAxis>& rates, double rate) {
  std::vector<double> samples(rates.size());
  for (std::size_t axis = 0; axis < values.vibration.size(); ++axis) {
    for (std::size_t i = 0; i < rates.size(); ++i) samples[i] = rates[i][axis];
    const analysis::Vibration found = analysis::vibration_of(samples, rate);
    if (!found.is_known()) return;
    values.vibration[axis] = found.rms;
    values.slowest_vibration = found.slowest;
    values.fastest_vibration = found.fastest;
  }
}

}  // namespace

void GimbalState::add(const LiveMessage& message) {
  using Clock = std::chrono::steady_clock;
  constexpr std::chrono::seconds window{4};
  LiveValues values = std::visit([](const auto& one) { return values_of(one); }, message);
  const auto now = Clock::now();
  const std::lock_guard lock(mutex_);
  arrivals_.push_back(now);
  rates_.push_back(values.rate);
  while (arrivals_.front() + window < now) {
    arrivals_.pop_front();
    rates_.pop_front();
  }
  if (arrivals_.size() > 1 && now > arrivals_.front()) {
    const std::chrono::duration<double> span = now - arrivals_.front();
    state_.rate = static_cast<double>(arrivals_.size() - 1) / span.count();
    add_vibration(values, rates_, state_.rate);
  }
  for (std::size_t i = 0; i < state_.angles.size(); ++i) {
    state_.angles[i].add(values.angle[i]);
    state_.powers[i].add(values.power[i]);
  }
  state_.battery.add(values.battery);
  state_.current.add(values.current);
  state_.values = std::move(values);
  state_.message = message;
}

void GimbalState::add(const Notice& notice) {
  if (notice.kind == NoticeKind::link_lost) return;  // a change of the link reports it, too
  const std::lock_guard lock(mutex_);
  log(notice.message);
}

void GimbalState::add(const LinkChange& change) {
  const std::lock_guard lock(mutex_);
  state_.is_connected = change.state == LinkState::connected;
  state_.rate = 0;
  arrivals_.clear();
  rates_.clear();
  log(change.message);
}

void GimbalState::add(const ClientError& error) {
  const std::lock_guard lock(mutex_);
  log(error.message);
}

void GimbalState::log(std::string text) {
  constexpr std::size_t most = 200;
  state_.log.push_back({std::chrono::system_clock::now(), std::move(text)});
  if (state_.log.size() > most) state_.log.pop_front();
}

GimbalSnapshot GimbalState::snapshot() const {
  const std::lock_guard lock(mutex_);
  return state_;
}

}  // namespace sbgc::tools
