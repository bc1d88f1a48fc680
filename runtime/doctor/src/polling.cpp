#include "polling.hpp"

#include <algorithm>
#include <array>
#include <cstdint>

namespace sbgc::doctor {

namespace {

Task<Result<Duration>> time_to_answer(Ask ask) {
  TaskMachine& task = co_await tasks::this_task();
  std::array<Duration, 20> times{};
  for (Duration& one : times) {
    const Instant start = task.now();
    const auto answer = co_await ask();
    if (!answer) co_return answer.error();
    one = task.now() - start;
  }
  std::sort(times.begin(), times.end());
  constexpr std::size_t late = 18;
  // Longer by a quarter, in whole milliseconds.
  constexpr std::int64_t shortest = 4;
  co_return milliseconds(std::max(shortest, (5 * times[late].us + 3999) / 4000));
}

}  // namespace

Task<Result<analysis::UniformSamples>> poll_at(Ask ask, Duration interval, Duration time) {
  TaskMachine& task = co_await tasks::this_task();
  analysis::UniformSamples samples(in_seconds(interval));
  const Instant start = task.now();
  std::int64_t number = 0;
  while (task.now() - start < time) {
    const Result<Axes<double>> values = co_await ask();
    if (!values) co_return values.error();
    const std::int64_t now = (task.now() - start).us / interval.us;
    samples.add(std::max(number, now), *values);
    const double lost = samples.lost_share() * static_cast<double>(now + 1);
    if (lost > analysis::most_lost * in_seconds(time) / in_seconds(interval)) co_return samples;
    number = std::max(number, now) + 1;
    const Result<void> waited =
        co_await tasks::wait_until(start + microseconds(number * interval.us));
    if (!waited) co_return waited.error();
  }
  co_return samples;
}

Task<Result<analysis::UniformSamples>> poll_often(Ask ask, Duration time) {
  constexpr Duration longest = milliseconds(100);
  const Result<Duration> shortest = co_await time_to_answer(ask);
  if (!shortest) co_return shortest.error();
  Duration interval = *shortest;
  Result<analysis::UniformSamples> samples = co_await poll_at(ask, interval, time);
  while (samples && !samples->is_usable() && interval < longest) {
    interval = interval + interval;
    samples = co_await poll_at(ask, interval, time);
  }
  co_return samples;
}

}  // namespace sbgc::doctor
