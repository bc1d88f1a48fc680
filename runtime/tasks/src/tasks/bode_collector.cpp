#include "tasks/bode_collector.hpp"

#include <cmath>
#include <limits>
#include <utility>

#include <fmt/format.h>

namespace sbgc::detail {
namespace {

/// The range of the sample counter, after which it wraps.
constexpr std::size_t counter_range = 256;

constexpr double lost_sample = std::numeric_limits<double>::quiet_NaN();

/// Returns the value with the precision of the board; NaN if there is none.
double bode_value(std::uint16_t raw, float min, float max) {
  constexpr double highest = 65534;
  const double value = static_cast<double>(min) +
                       raw * (static_cast<double>(max) - static_cast<double>(min)) / highest;
  const bool is_number = std::abs(value) <= static_cast<double>(std::numeric_limits<float>::max());
  return is_number ? static_cast<double>(static_cast<float>(value)) : lost_sample;
}

}  // namespace

void BodeCollector::add(const msg::BodeTestData& data) {
  if (last_ && data == *last_) return;
  last_ = data;
  add_gap(static_cast<std::uint8_t>(data.sample_counter - samples()));
  for (const msg::BodeSample& sample : data.samples) {
    const double input = bode_value(sample.input, data.input_min, data.input_max);
    const double output = bode_value(sample.output, data.output_min, data.output_max);
    if (std::isnan(input) || std::isnan(output)) {
      add_gap(1);
    } else {
      recording_.input.push_back(input);
      recording_.output.push_back(output);
    }
  }
}

void BodeCollector::add_gap(std::size_t samples) {
  recording_.lost += samples;
  recording_.input.insert(recording_.input.end(), samples, lost_sample);
  recording_.output.insert(recording_.output.end(), samples, lost_sample);
}

bool BodeCollector::has_too_many() const noexcept {
  return samples() > recording_.request.samples_num + counter_range;
}

Result<BodeRecording> BodeCollector::finish(const msg::BodeTestStartStop& end) && {
  const std::size_t counted = end.samples_count;
  if (end.error_code != msg::BodeTestStartStop::bode_success) {
    return ClientError{ErrorCode::board_error,
                       fmt::format("the board ended the recording with error {} after {} samples",
                                   end.error_code, counted),
                       end.error_code};
  }
  if (counted + 1 < recording_.request.samples_num) {
    return ClientError{ErrorCode::bad_response,
                       fmt::format("the board reports an end after {} of {} samples, as of another "
                                   "recording",
                                   counted, recording_.request.samples_num)};
  }
  // Some firmware sends the index of the last sample, which is one less.
  if (counted + 1 < samples()) {
    return ClientError{ErrorCode::bad_response,
                       fmt::format("{} samples arrived, but the board has sent {}: the line "
                                   "repeats or exchanges messages",
                                   samples(), counted)};
  }
  if (counted >= samples() + counter_range) {
    return ClientError{ErrorCode::bad_response,
                       fmt::format("{} of {} samples were lost, more in one place than their "
                                   "counter can show",
                                   counted - samples() + lost(), counted)};
  }
  if (counted > samples()) add_gap(counted - samples());
  return std::move(recording_);
}

Result<BodeRecording> BodeCollector::finish_without_end(ClientError reason, bool is_over) && {
  const std::size_t total = recording_.request.samples_num;
  if (samples() > total) return reason;
  const std::size_t missing = total - samples();
  if (missing >= counter_range || (missing != 0 && !is_over)) return reason;
  add_gap(missing);
  recording_.is_end_lost = true;
  return std::move(recording_);
}

}  // namespace sbgc::detail
