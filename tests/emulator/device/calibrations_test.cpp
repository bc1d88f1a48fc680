// Tests of calibrations, automatic tuning and recording of a frequency response: their progress,
// their results, and what the memory keeps.

#include <complex>
#include <cstdlib>
#include <numbers>

#include "device/calibration/frequency_response.hpp"
#include "host.hpp"
#include "recorded_axis.hpp"

namespace sbgc::test {
namespace {

using emulator::Memory;

msg::CalibInfo info(Host& host, msg::SelectedImu imu = msg::SelectedImu::main) {
  return host.get<msg::CalibInfo>(msg::CalibInfoRequest{.imu_type = imu});
}

TEST(Calibrations, ErasingTheEepromForgetsThem) {
  Memory memory;
  memory.battery_factor = 1.5;
  memory.imus[1].acc_limits = 0x3F;
  memory.sensors[1].acc_limits = 0x15;
  Host host({}, memory);
  EXPECT_TRUE(is_confirmed(host, msg::UseDefaults{.profile_id = msg::UseDefaults::erase_eeprom}));
  const Memory& after = host.board.memory();
  EXPECT_EQ(after.battery_factor, 1);
  EXPECT_EQ(info(host, msg::SelectedImu::frame).acc_limits_info, msg::CalibratedLimits{});
  EXPECT_EQ(after.sensors[1].acc_limits, 0x15) << "that is another EEPROM";
}

constexpr msg::AutoPidFlags pitch_with_progress =
    msg::AutoPidFlag::pitch | msg::AutoPidFlag::send_gui;

msg::AutoPidRequest tune(msg::AutoPidFlags flags, std::uint8_t profile = 0,
                         std::uint8_t gain = 127) {
  return {.profile_id = profile, .cfg_flags = flags, .gain_vs_stability = gain};
}

msg::ReadParams3 parameters(Host& host, std::uint8_t profile) {
  return host.get<msg::ReadParams3>(msg::ReadParams3Request{.profile_id = profile});
}
msg::ReadParamsExt filters(Host& host, std::uint8_t profile) {
  return host.get<msg::ReadParamsExt>(msg::ReadParamsExtRequest{.profile_id = profile});
}

TEST(AutoTuning, ReportsTwiceASecondAndStoresWhatItFound) {
  Host host;
  const msg::ReadParams3 before = parameters(host, 0);
  EXPECT_TRUE(is_confirmed(host, tune(pitch_with_progress)));
  EXPECT_EQ(all<msg::AutoPid>(host.listen(seconds(4))).size(), 8U);
  const auto rest = all<msg::AutoPid>(host.listen(seconds(30)));
  ASSERT_FALSE(rest.empty());
  const msg::ReadParams3 after = parameters(host, 0);
  EXPECT_NE(after.axes.pitch, before.axes.pitch);
  EXPECT_EQ(after.axes.pitch.p, rest.back().p.pitch);
  EXPECT_EQ(after.axes.pitch.i.raw(), rest.back().i.pitch);
  EXPECT_EQ(after.axes.pitch.d, rest.back().d.pitch);
  EXPECT_EQ(after.axes.roll, before.axes.roll) << "not tuned";
  EXPECT_EQ(filters(host, 0).lpf_freq.pitch.raw(), rest.back().lpf_freq.pitch);
}

TEST(AutoTuning, GainsConverge) {
  Host host;
  host.ask(tune(pitch_with_progress));
  const auto rounds = all<msg::AutoPid>(host.listen(seconds(30)));
  ASSERT_GT(rounds.size(), 10U);
  const int last = rounds.back().p.pitch;
  int distance = 255;
  std::uint16_t number = 0;
  for (const msg::AutoPid& one : rounds) {
    EXPECT_EQ(one.iter_num, ++number);
    EXPECT_LE(std::abs(one.p.pitch - last), distance);
    distance = std::abs(one.p.pitch - last);
    EXPECT_GT(one.axes.pitch.tracking_error, 0);
    EXPECT_EQ(one.axes.roll.tracking_error, 0);
  }
  EXPECT_LT(rounds.back().axes.pitch.tracking_error, rounds.front().axes.pitch.tracking_error / 4);
  EXPECT_LT(rounds.front().p.pitch, last);
}

TEST(AutoTuning, TheSameSeedFindsTheSame) {
  Host one, two;
  for (Host* host : {&one, &two}) {
    host->ask(tune(msg::AutoPidFlag::pitch));
    host->listen(seconds(30));
  }
  EXPECT_EQ(parameters(one, 0), parameters(two, 0));
  Host three({.gimbal = {.seed = 77}});
  three.ask(tune(msg::AutoPidFlag::pitch));
  three.listen(seconds(30));
  EXPECT_NE(parameters(one, 0), parameters(three, 0));
}

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
