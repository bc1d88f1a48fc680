// Tests of recording a frequency response.

#include "device/calibration/frequency_response.hpp"

#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <vector>

#include "recorded_axis.hpp"
#include "replies.hpp"

namespace sbgc::test {
namespace {

using emulator::AxisResponse;

/// A host of a board whose motors are on.
struct Recorder : Host {
  explicit Recorder(emulator::BoardOptions options = {}) : Host(std::move(options)) {
    listen(seconds(1));
  }
};

TEST(FrequencyResponse, SendsEverySampleInOrderAndThenTheEnd) {
  Recorder host;
  Packets packets = host.ask(recording(5003));
  EXPECT_EQ(confirmations<msg::BodeTestStartStopRequest>(packets), 1);
  for (const auto& packet : host.listen(milliseconds(4100))) packets.push_back(packet);
  std::size_t samples = 0;
  for (const msg::BodeTestData& data : all<msg::BodeTestData>(packets)) {
    EXPECT_EQ(data.sample_counter, samples % 256);
    samples += data.samples.size();
  }
  EXPECT_EQ(samples, 5003U);
  const auto ends = all<msg::BodeTestStartStop>(packets);
  ASSERT_THAT(ends, SizeIs(1));
  EXPECT_EQ(ends[0].samples_count, 5003U);
  EXPECT_EQ(ends[0].error_code, 0);
  EXPECT_EQ(packets.back().id, 37);
}

TEST(FrequencyResponse, SomeFirmwareConfirmsNothingAndCountsFrom0) {
  emulator::BoardOptions options;
  options.response.is_confirmed = false;
  options.response.reports_last_index = true;
  Recorder host(options);
  Packets packets = host.ask(recording());
  for (const auto& packet : host.listen(seconds(5))) packets.push_back(packet);
  EXPECT_EQ(confirmations<msg::BodeTestStartStopRequest>(packets), 0);
  EXPECT_EQ(all<msg::BodeTestStartStop>(packets).at(0).samples_count, 4999U);
}

/// The response of a system to a lasting sine, which is measured at its end.
std::complex<double> measured(msg::BodeSystem of, double frequency) {
  AxisResponse system(of);
  const double step = 2 * std::numbers::pi * frequency * AxisResponse::sample_time;
  std::complex<double> sum;
  constexpr int settled = 20'000;
  constexpr int measured = 12'500;  // 10 s: whole periods of these frequencies
  for (int i = 0; i < settled + measured; ++i) {
    const double output = system(std::cos(step * i));
    if (i >= settled) sum += output * std::polar(2.0 / measured, -step * i);
  }
  return sum;
}

TEST(FrequencyResponse, SystemsRespondAsDescribed) {
  using System = msg::BodeSystem;
  for (const double frequency : {1.0, 6.0, 39.5, 80.0, 200.0}) {
    const std::complex<double> p = plant(frequency);
    const std::complex<double> loop = 100.0 * p;
    const auto expect = [&](System system, std::complex<double> expected) {
      EXPECT_LT(std::abs(measured(system, frequency) / expected - 1.0), 1e-4)
          << static_cast<int>(system) << " at " << frequency;
    };
    expect(System::controller, 100.0);
    expect(System::open_loop_plant, p);
    expect(System::open_loop_plant_with_filters, p);
    expect(System::closed_loop_plant, p / (1.0 + loop));
    expect(System::closed_loop_plant_with_filters, p / (1.0 + loop));
    expect(System::open_loop_controller_and_plant, loop);
    expect(System::closed_loop_controller_and_plant, loop / (1.0 + loop));
    expect(System::overall, loop / (1.0 + loop));
  }
}

}  // namespace
}  // namespace sbgc::test
