#include "move/stream_guess.hpp"

#include <algorithm>
#include <cmath>

#include <sbgc/client/typed.hpp>
#include <sbgc/messages.hpp>
#include <sbgc/roles.hpp>

namespace sbgc::tools {

namespace {

using Configs = std::vector<msg::StreamConfig>;

Configs configs_of(const msg::RealtimeData3& /*sample*/) { return {{}}; }
Configs configs_of(const msg::RealtimeData4& /*sample*/) { return {{}}; }
Configs configs_of(const msg::AhrsHelper& /*sample*/) {
  Configs both(2);
  both[0].imu_type = msg::ImuIndex::main;
  both[1].imu_type = msg::ImuIndex::frame;
  return both;
}
Configs configs_of(const msg::RealtimeDataCustom& sample) {
  Configs known(sample.flags ? 1 : 0);
  for (msg::StreamConfig& one : known) one.flags = sample.flags;
  return known;
}
Configs configs_of(const msg::RealtimeDataCustom2& sample) {
  Configs known(sample.flags ? 1 : 0);
  for (msg::StreamConfig& one : known) one.custom2_flags = sample.flags;
  return known;
}
Configs configs_of(const msg::ExtMotorsState& sample) {
  Configs known(1);
  known[0].motor = sample.motor_id;
  known[0].data_set = sample.data_set;
  return known;
}
/// Only a part of what was requested for these is in their samples.
Configs configs_of(const msg::Event& /*sample*/) { return {}; }
Configs configs_of(const msg::CanDrvTelemetry& /*sample*/) { return {}; }

}  // namespace

StreamGuess guess_stream(const Frame& frame) {
  StreamGuess guess;
  roles::StreamMessages::for_each([&]<class M>(Type<M>) {
    if (static_cast<std::uint8_t>(M::command) != frame.id) return;
    guess.is_sample = true;
    M sample;
    if constexpr (requires { typename M::Context; }) {
      // Without the flags of its request, a sample decodes only if it repeats them.
      if (!decode(frame.body, sample, typename M::Context{})) return;
    } else {
      if (!decode(frame.body, sample)) return;
    }
    for (const msg::StreamConfig& config : configs_of(sample)) {
      msg::DataStreamInterval& request = guess.requests.emplace_back();
      detail::choose_stream<M>(request);
      request.config = config;
    }
  });
  return guess;
}

msg::Milliseconds SampleTimes::interval() const {
  std::vector<double> gaps;
  for (std::size_t i = 1; i < times_.size(); ++i) {
    gaps.push_back(std::chrono::duration<double, std::milli>(times_[i] - times_[i - 1]).count());
  }
  const auto middle = gaps.begin() + static_cast<std::ptrdiff_t>(gaps.size() / 2);
  std::nth_element(gaps.begin(), middle, gaps.end());
  const double all =
      std::chrono::duration<double, std::milli>(times_.back() - times_.front()).count();
  // A gap that is twice as long as most has lost a sample.
  const double count =
      *middle > 0 ? std::max(1.0, std::round(all / *middle)) : static_cast<double>(gaps.size());
  const long rounded = std::clamp(std::lround(all / count), 1L, 1000L);
  return msg::Milliseconds(static_cast<msg::Milliseconds::raw_type>(rounded));
}

}  // namespace sbgc::tools
