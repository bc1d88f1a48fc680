// Tests of adjustable variables: their effect on the parameters in use, and how long it lasts.

#include <cstdint>
#include <random>
#include <set>

#include <gtest/gtest.h>

#include <sbgc/meta/variables.hpp>

#include "random_input.hpp"

namespace sbgc::test {
namespace {

using emulator::factory_parameters;
using emulator::Memory;

TEST(Variables, AreWhatWasSet) {
  Memory memory;
  Parameters parameters(memory);
  const Memory before = memory;
  std::mt19937 random(7);
  for (const VariableInfo& variable : variables) {
    const auto lowest = static_cast<std::int32_t>(variable.range.lowest);
    const auto highest = static_cast<std::int32_t>(variable.range.highest);
    for (int i = 0; i < 20; ++i) {
      const auto width = static_cast<unsigned>(highest - lowest) + 1;
      const auto value = i == 0   ? lowest
                         : i == 1 ? highest
                                  : lowest + static_cast<std::int32_t>(random() % width);
      ASSERT_TRUE(parameters.set_variable(variable.id, value)) << variable.name << ' ' << value;
      EXPECT_EQ(parameters.variable(variable.id), value) << variable.name;
    }
    EXPECT_FALSE(parameters.set_variable(variable.id, lowest - 1)) << variable.name;
    EXPECT_FALSE(parameters.set_variable(variable.id, highest + 1)) << variable.name;
  }
  EXPECT_EQ(memory, before) << "variables are volatile";
}

TEST(Variables, ThoseThatThereAreNot) {
  Memory memory;
  Parameters parameters(memory);
  std::set<msg::VariableId> known;
  for (const VariableInfo& variable : variables) known.insert(variable.id);
  for (int id = 0; id <= 255; ++id) {
    const auto variable = static_cast<msg::VariableId>(id);
    EXPECT_EQ(parameters.variable(variable).has_value(), known.contains(variable)) << id;
    if (known.contains(variable)) continue;
    EXPECT_FALSE(parameters.set_variable(variable, 0)) << id;
  }
}

TEST(Variables, ACoarserSettingHasTheNearestStep) {
  Memory memory;
  Parameters parameters(memory);
  ASSERT_TRUE(parameters.set_variable(msg::VariableId::acc_limiter_roll, 12));
  EXPECT_EQ(parameters.variable(msg::VariableId::acc_limiter_roll), 12);
  EXPECT_EQ(parameters.of<msg::ReadParamsExt2>().acc_limiter3.roll.raw(), 2);
  parameters.save();
  EXPECT_EQ(parameters.variable(msg::VariableId::acc_limiter_roll), 10);
}

TEST(Variables, OneThatChangesTheSettingOfAnotherIsSeenThere) {
  Memory memory;
  Parameters parameters(memory);
  ASSERT_TRUE(parameters.set_variable(msg::VariableId::acc_limiter_roll, 12));
  ASSERT_TRUE(parameters.set_variable(msg::VariableId::acc_limiter, 100));
  EXPECT_EQ(parameters.variable(msg::VariableId::acc_limiter), 100);
  EXPECT_EQ(parameters.variable(msg::VariableId::acc_limiter_roll), 100);
}

TEST(Variables, AreForgottenUnlessSaved) {
  Memory memory;
  Parameters parameters(memory);
  const auto original = parameters.variable(msg::VariableId::p_pitch);
  const auto set = [&] { ASSERT_TRUE(parameters.set_variable(msg::VariableId::p_pitch, 201)); };
  set();
  parameters.reload();
  EXPECT_EQ(parameters.variable(msg::VariableId::p_pitch), original);
  set();
  parameters.select_profile(1);
  EXPECT_EQ(parameters.variable(msg::VariableId::p_pitch), original);
  parameters.select_profile(0);
  EXPECT_EQ(parameters.variable(msg::VariableId::p_pitch), original);
  set();
  ASSERT_TRUE(parameters.write(0, factory_parameters<msg::ReadParams3>(0)));
  EXPECT_EQ(parameters.variable(msg::VariableId::p_pitch), original);
  set();
  parameters.save();
  parameters.reload();
  EXPECT_EQ(parameters.variable(msg::VariableId::p_pitch), 201);
  EXPECT_EQ(Parameters(memory).variable(msg::VariableId::p_pitch), 201);
}

TEST(Variables, AChangeOfSettingsSavesNone) {
  Memory memory;
  Parameters parameters(memory);
  const auto change = [](msg::ReadParams3& main) { main.gyro_trust = 12; };
  const auto original = parameters.variable(msg::VariableId::p_pitch);
  ASSERT_TRUE(parameters.set_variable(msg::VariableId::p_pitch, 201));
  ASSERT_TRUE(parameters.set_variable(msg::VariableId::gyro_trust, 250));
  ASSERT_TRUE(parameters.change<msg::ReadParams3>(0, change));
  ASSERT_TRUE(parameters.change<msg::ReadParams3>(3, change));
  EXPECT_EQ(parameters.variable(msg::VariableId::p_pitch), 201);
  EXPECT_EQ(parameters.variable(msg::VariableId::gyro_trust), 12);
  EXPECT_EQ(parameters.read<msg::ReadParams3>(3).gyro_trust, 12);
  const Parameters restarted(memory);
  EXPECT_EQ(restarted.variable(msg::VariableId::p_pitch), original);
  EXPECT_EQ(restarted.variable(msg::VariableId::gyro_trust), 12);
  EXPECT_EQ(restarted.read<msg::ReadParams3>(3).gyro_trust, 12);
}

TEST(Variables, AreSavedInTheActiveProfileAlone) {
  Memory memory;
  Parameters parameters(memory);
  write_random(parameters, 8);
  parameters.select_profile(3);
  ASSERT_TRUE(parameters.set_variable(msg::VariableId::gyro_trust, 33));
  ASSERT_TRUE(parameters.set_variable(msg::VariableId::lpf_freq_yaw, 77));
  ASSERT_TRUE(parameters.set_variable(msg::VariableId::pid_gain_yaw, 55));
  parameters.save();
  const Parameters restarted(memory);
  for_each_random(8, [&]<class M>(std::uint8_t copy, M message) {
    if (copy == 3) {
      if constexpr (std::is_same_v<M, msg::ReadParams3>) message.gyro_trust = 33;
      if constexpr (std::is_same_v<M, msg::ReadParamsExt>)
        message.lpf_freq.yaw = msg::Frequency(77);
      if constexpr (std::is_same_v<M, msg::ReadParamsExt2>) message.pid_gain.yaw = msg::PidGain(55);
    }
    EXPECT_EQ(bytes_of(restarted.read<M>(copy)), bytes_of(message)) << Meta<M>::info.name;
  });
}

TEST(Variables, ThoseWithoutASettingAreKeptUntilTheRestart) {
  Memory memory;
  Parameters parameters(memory);
  const msg::VariableId heading = msg::VariableId::frame_heading_angle;
  EXPECT_EQ(parameters.variable(heading), 0);
  EXPECT_EQ(parameters.variable(msg::VariableId::gyro_heading_correction), 0);
  ASSERT_TRUE(parameters.set_variable(heading, -1234));
  ASSERT_TRUE(parameters.set_variable(msg::VariableId::gyro_heading_correction, 20000));
  parameters.save();
  parameters.select_profile(2);
  EXPECT_EQ(parameters.variable(heading), -1234);
  parameters.reload();
  EXPECT_EQ(parameters.variable(heading), 0);
  EXPECT_EQ(parameters.variable(msg::VariableId::gyro_heading_correction), 0);
}

}  // namespace
}  // namespace sbgc::test
