// Tests of `sbgc doctor` on emulated boards in virtual time: a healthy board has no finding, and
// each fault has one.

#include <array>
#include <set>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "../emulator/device/host.hpp"
#include "doctor/findings.hpp"
#include "serving/faults.hpp"

namespace sbgc::tools {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr std::uint16_t interval_ms = 4;

/// Measures a board for some seconds, as measure() does with a data stream.
Measurements measured(const emulator::BoardOptions& options, int tenths = 30,
                      const std::function<void(test::Host&)>& disturb = {}) {
  test::Host host(options);
  host.listen(milliseconds(100 * tenths));
  Measurements result;
  result.parameters = host.get<msg::ReadParams3>(
      msg::ReadParams3Request{.profile_id = msg::ReadParams3Request::active_profile});
  result.gyro.emplace(1e-3 * interval_ms);
  msg::DataStreamInterval stream;
  stream.cmd_id = msg::CommandFromBoard::realtime_data_custom;
  stream.interval_ms = decltype(stream.interval_ms)(interval_ms);
  stream.config.flags = msg::RealtimeDataCustomFlag::gyro_data;
  host.ask(stream);
  for (int i = 0; i < tenths; ++i) {
    if (disturb) disturb(host);
    host.send(msg::RealtimeData4Request{});
    for (const test::Packet& packet : host.listen(milliseconds(100))) {
      if (test::is<msg::RealtimeData4>(packet))
        result.add(test::message<msg::RealtimeData4>(packet));
      msg::RealtimeDataCustom data;
      if (packet.id != static_cast<std::uint8_t>(msg::RealtimeDataCustom::command)) continue;
      EXPECT_TRUE(decode(std::span(packet.body), data, {*stream.config.flags}));
      result.gyro->add_at(data.timestamp_ms.raw(), {data.gyro_data->roll.degrees_per_second(),
                                                    data.gyro_data->pitch.degrees_per_second(),
                                                    data.gyro_data->yaw.degrees_per_second()});
    }
  }
  result.seconds = 0.1 * tenths;
  return result;
}

Measurements with_faults(const std::string& faults) {
  emulator::BoardOptions options;
  serving::add_faults(faults, options);
  return measured(options);
}

std::vector<std::string> ids_of(const std::vector<Finding>& findings) {
  std::vector<std::string> ids;
  for (const Finding& one : findings) {
    ids.push_back(one.id + (one.axis ? ":" + std::to_string(*one.axis) : ""));
  }
  return ids;
}

TEST(Doctor, AHealthyBoardHasNoFindingIn100Runs) {
  for (std::uint32_t seed = 1; seed <= 100; ++seed) {
    emulator::BoardOptions options;
    options.gimbal.seed = seed;
    const Measurements healthy = measured(options, 10);
    ASSERT_EQ(healthy.messages, 10U);
    ASSERT_GT(healthy.gyro->size(), 240U);
    ASSERT_EQ(healthy.gyro->lost_share(), 0);
    EXPECT_THAT(ids_of(findings_of(healthy)), IsEmpty()) << "seed " << seed;
  }
}

TEST(Doctor, EachFaultHasItsFindingAlone) {
  const std::vector<std::pair<std::string, std::string>> expected{
      {"low-battery", "battery"},
      {"low-bat2", "battery"},
      {"imu", "ERR_NO_SENSOR"},
      {"missed-steps", "ERR_MISS_STEPS"},
      {"calib-acc", "ERR_CALIB_ACC"},
      {"calib-poles", "ERR_CALIB_POLES"},
      {"set-power", "ERR_SET_POWER"},
      {"protection", "ERR_PROTECTION"},
      {"serial", "ERR_SERIAL"},
      {"gui-version", "ERR_GUI_VERSION"},
      {"system", "ERR_SYSTEM"},
      {"emergency-stop", "ERR_EMERGENCY_STOP"},
      {"imbalance=0.3:pitch", "balance:1"},
      {"imbalance=-0.3:roll", "balance:0"},
      {"overload=yaw", "motor-power:2"},
      {"resonance=37Hz:0.1:pitch", "vibration:1"},
      {"resonance=90Hz:2:roll", "vibration:0"},
      {"i2c-errors", "i2c"},
      {"slow-cycle", "cycle-time"},
      {"drift", "attitude"},
  };
  for (const auto& [fault, id] : expected) {
    const std::vector<Finding> findings = findings_of(with_faults(fault));
    EXPECT_THAT(ids_of(findings), ElementsAre(id)) << fault;
    for (const Finding& one : findings) {
      EXPECT_FALSE(one.advice.empty()) << fault;
      EXPECT_TRUE(one.sentence.ends_with('.')) << one.sentence;
    }
  }
}

TEST(Doctor, ANoisyLine) {
  const auto damage = [](test::Host& host) {
    // A request whose body checksum is wrong.
    host.send_bytes(std::array<std::uint8_t, 6>{0x3E, 21, 1, 22, 255, 0});
  };
  EXPECT_THAT(ids_of(findings_of(measured({}, 20, damage))), ElementsAre("line"));
  Measurements healthy = measured({}, 5);
  healthy.damaged_share = 0.005;
  EXPECT_THAT(ids_of(findings_of(healthy)), ElementsAre("line"));
}

TEST(Doctor, SeveralFaultsHaveSeveralFindings) {
  EXPECT_THAT(ids_of(findings_of(with_faults("low-battery,imu,overload=roll"))),
              ElementsAre("ERR_NO_SENSOR", "battery", "motor-power:0"));
}

TEST(Doctor, NamesAResonanceWithin1Hz) {
  const Measurements shaking = with_faults("resonance=37Hz:0.1:yaw");
  const auto vibration = shaking.vibration();
  ASSERT_TRUE(vibration && !vibration->yaw.peaks.empty());
  EXPECT_NEAR(vibration->yaw.peaks.front().frequency, 37, 1);
  EXPECT_NEAR(vibration->yaw.peaks.front().amplitude, 0.1, 0.03);
  const std::vector<Finding> findings = findings_of(shaking);
  ASSERT_EQ(findings.size(), 1U);
  EXPECT_THAT(findings[0].sentence, testing::AnyOf(HasSubstr(" at 36."), HasSubstr(" at 37.")));
}

TEST(Doctor, LostSamplesAreRefusedAbove1Percent) {
  Measurements shaking = with_faults("resonance=37Hz:1:pitch");
  const UniformSamples all = *shaking.gyro;
  const auto without = [&](std::size_t each) {
    UniformSamples some(1 / all.rate());
    const std::array values{all.axis(0), all.axis(1), all.axis(2)};
    for (std::size_t i = 0; i < values[0].size(); ++i) {
      if (i % each != each - 1) {
        some.add(static_cast<std::int64_t>(i), {values[0][i], values[1][i], values[2][i]});
      }
    }
    return some;
  };
  shaking.gyro = without(120);
  EXPECT_THAT(ids_of(findings_of(shaking)), ElementsAre("vibration:1"));
  shaking.gyro = without(80);
  EXPECT_THAT(findings_of(shaking), IsEmpty());
  EXPECT_FALSE(shaking.vibration());
}

TEST(Doctor, ThresholdsHaveNamesAndMeanings) {
  std::set<std::string> names;
  for (const Threshold& one : thresholds()) {
    EXPECT_TRUE(names.insert(one.name).second) << one.name;
    EXPECT_STRNE(one.meaning, "");
    EXPECT_EQ(threshold(one.limit), one.value);
  }
}

}  // namespace
}  // namespace sbgc::tools
