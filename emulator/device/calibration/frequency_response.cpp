
#include "device/calibration/frequency_response.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>
#include <utility>

#include "device/calibration/auto_tuning.hpp"
#include "device/ports.hpp"
#include "physics/noise.hpp"

namespace sbgc::emulator {
namespace {

constexpr Duration response_sample_time = microseconds(800);
constexpr std::uint32_t samples_of_message = 20;
/// Assumption, from a recording: the stimulus per count of STIMULUS_GAIN, and the time until it is
/// complete.
constexpr double stimulus_per_gain = 20;
constexpr double fade_in_samples = 375;
/// The amplitude of the camera during a stimulus, in degrees.
constexpr double visible_shake = 0.1;
/// Assumption: the code for a recording that the motors could not finish.
constexpr std::uint16_t motors_are_off = 1;

/// One signal of a message: its limits, and the raw values between them.
struct Scaled {
  float min, max;

  explicit Scaled(std::span<const double> values)
      : min(static_cast<float>(*std::min_element(values.begin(), values.end()))),
        max(static_cast<float>(*std::max_element(values.begin(), values.end()))) {}
  std::uint16_t raw(double value) const {
    constexpr double highest = 65534;
    const double range = static_cast<double>(max) - static_cast<double>(min);
    if (!(range > 0)) return 0;
    return static_cast<std::uint16_t>(
        std::lround(std::clamp((value - static_cast<double>(min)) / range, 0.0, 1.0) * highest));
  }
};

}  // namespace

bool FrequencyResponse::start(CalibrationParts& parts, const msg::BodeTestStartStopRequest& request,
                              std::size_t port, Instant now) {
  if (run_ || parts.calibrations.under_way() || parts.auto_tuning.is_running()) return false;
  if (!parts.gimbal.motors_on()) return false;
  run_.emplace(Run{port, request, AxisResponse(request.system), now, 0, 0});
  return true;
}

Instant FrequencyResponse::next() const {
  if (!run_) return Instant::never;
  const std::uint32_t until =
      std::min(run_->samples + samples_of_message, run_->request.samples_num);
  return run_->start + microseconds(response_sample_time.us * until);
}

void FrequencyResponse::advance(Instant now, CalibrationParts& parts) {
  while (run_ && next() <= now) {
    if (!parts.gimbal.motors_on()) return finish(parts, motors_are_off);
    Run& run = *run_;
    const std::uint32_t count = std::min(samples_of_message, run.request.samples_num - run.samples);
    const auto axis = static_cast<std::size_t>(run.request.axis);
    parts.gimbal.push(
        axis, run.samples / samples_of_message % 2 == 0 ? visible_shake : -visible_shake, now);
    send_samples(parts, run, count);
    if (run.samples == run.request.samples_num) finish(parts, 0);
  }
}

double FrequencyResponse::stimulus(const CalibrationParts& parts, Run& run) const {
  const double amplitude =
      stimulus_per_gain * run.request.stimulus_gain * std::min(1.0, run.samples / fade_in_samples);
  if (run.request.stimulus_type == msg::BodeStimulus::white_noise) {
    return amplitude * (2 * random_share(parts.options.gimbal.seed + 0xB0DE, run.samples) - 1);
  }
  const double from = std::max(1.0, run.request.start_freq.hertz());
  const double to = std::max(from, run.request.end_freq.hertz());
  const double share = static_cast<double>(run.samples) / run.request.samples_num;
  // std::pow would bring its own tables into the WebAssembly module.
  const double frequency = run.request.stimulus_type == msg::BodeStimulus::sine_sweep
                               ? from + (to - from) * share
                               : from * std::exp(share * std::log(to / from));
  run.phase += frequency * AxisResponse::sample_time;
  return amplitude * std::sin(2 * std::numbers::pi * run.phase);
}

void FrequencyResponse::send_samples(CalibrationParts& parts, Run& run, std::uint32_t count) const {
  std::array<double, samples_of_message> input{}, output{};
  msg::BodeTestData data;
  data.sample_counter = static_cast<std::uint8_t>(run.samples);
  const std::uint64_t seed = parts.options.gimbal.seed + 0xB0DF;
  for (std::size_t i = 0; i < count; ++i, ++run.samples) {
    input[i] = stimulus(parts, run);
    output[i] =
        run.system(input[i]) + parts.options.response.noise * random_normal(seed, run.samples);
  }
  const Scaled in(std::span<const double>(input).first(count));
  const Scaled out(std::span<const double>(output).first(count));
  data.input_min = in.min;
  data.input_max = in.max;
  data.output_min = out.min;
  data.output_max = out.max;
  for (std::size_t i = 0; i < count; ++i) {
    // The capacity is larger than a message.
    static_cast<void>(data.samples.push_back({in.raw(input[i]), out.raw(output[i])}));
  }
  // Without room for it, the message is lost.
  if (run.port) static_cast<void>(parts.ports.offer(*run.port, data));
}

void FrequencyResponse::finish(CalibrationParts& parts, std::uint16_t error) {
  msg::BodeTestStartStop end;
  end.samples_count = run_->samples;
  if (parts.options.response.reports_last_index && end.samples_count != 0) --end.samples_count;
  end.error_code = error;
  end.mode = run_->request.mode;
  if (run_->port) parts.ports.send(*run_->port, end);
  run_.reset();
}

void FrequencyResponse::drop_port(std::size_t port) {
  if (run_ && run_->port == port) run_->port.reset();
}

void FrequencyResponse::restart(Instant) { run_.reset(); }

AxisResponse::AxisResponse(msg::BodeSystem system) : system_(system) {
  // The poles of the damped oscillation, rotated in the complex plane by one sample.
  const double turn = 2 * std::numbers::pi * resonance * sample_time;
  const double radius = std::exp(-damping * turn);
  first_ = 2 * radius * std::cos(turn * std::sqrt(1 - damping * damping));
  second_ = -radius * radius;
  // NOLINTNEXTLINE(cppcoreguidelines-prefer-member-initializer): from the other two
  scale_ = gain * (1 - first_ - second_);
}

double AxisResponse::operator()(double input) {
  // The delay comes first, so a closed loop needs only earlier inputs.
  const double output = first_ * output_ + second_ * earlier_output_ + scale_ * input_;
  earlier_output_ = std::exchange(output_, output);
  switch (system_) {
    case msg::BodeSystem::controller: return controller * input;
    case msg::BodeSystem::open_loop_plant:
    case msg::BodeSystem::open_loop_plant_with_filters: input_ = input; break;
    case msg::BodeSystem::closed_loop_plant:
    case msg::BodeSystem::closed_loop_plant_with_filters:
      input_ = input - controller * output;
      break;
    case msg::BodeSystem::open_loop_controller_and_plant: input_ = controller * input; break;
    case msg::BodeSystem::closed_loop_controller_and_plant:
    case msg::BodeSystem::overall: input_ = controller * (input - output); break;
    default: break;
  }
  return output;
}

}  // namespace sbgc::emulator
