// Tests of the board's parameters: written values are read back, per profile, also after a restart;
// of adjustable variables and how long they last, and of their effect on the mechanics.

#include <sbgc/meta/variables.hpp>
#include <sbgc/validate.hpp>

#include "device/parameters/gimbal_tuning.hpp"
#include "device/storage/eeprom.hpp"
#include "host.hpp"
#include "random_input.hpp"

namespace sbgc::test {
namespace {

using emulator::factory_parameters;
using emulator::Memory;

constexpr std::uint8_t profiles = ParametersOf<msg::ReadParams3>::copies;

TEST(Parameters, EveryBodyComesBackBitForBit) {
  Memory memory;
  Parameters parameters(memory);
  for (unsigned seed = 0; seed < 50; ++seed) {
    write_random(parameters, seed);
    expect_random(parameters, seed);
  }
}

TEST(Parameters, AreThereAfterAPowerCycle) {
  Memory memory;
  {
    Parameters parameters(memory);
    write_random(parameters, 1);
    parameters.select_profile(3);
  }
  Memory kept = memory;
  const Parameters parameters(kept);
  EXPECT_EQ(parameters.profile(), 3);
  expect_random(parameters, 1);
}

void expect_speed(const Parameters& parameters, msg::SerialSpeed speed) {
  EXPECT_EQ(parameters.of<msg::ReadParams3>().serial_speed, speed);
  for (std::uint8_t profile = 0; profile < profiles; ++profile) {
    EXPECT_EQ(parameters.read<msg::ReadParams3>(profile).serial_speed, speed) << int{profile};
  }
}

TEST(Parameters, GeneralOnesAreChangedInAllProfiles) {
  Memory memory;
  Parameters parameters(memory);
  const auto change = [](msg::SerialSpeed speed) {
    return [speed](msg::ReadParams3& main) { main.serial_speed = speed; };
  };
  for (const std::uint8_t profile : {std::uint8_t{0}, std::uint8_t{2}}) {
    const auto speed = profile == 0 ? msg::SerialSpeed::baud_9600 : msg::SerialSpeed::baud_19200;
    ASSERT_TRUE(parameters.change<msg::ReadParams3>(profile, change(speed)));
    expect_speed(parameters, speed);
    expect_speed(Parameters(memory), speed);
  }
  parameters.select_profile(4);
  parameters.change_in_use<msg::ReadParams3>(change(msg::SerialSpeed::baud_57600));
  parameters.save();
  expect_speed(parameters, msg::SerialSpeed::baud_57600);
  expect_speed(Parameters(memory), msg::SerialSpeed::baud_57600);
}

TEST(Parameters, ADamagedRecordIsTheFactorySettings) {
  Memory memory;
  Parameters parameters(memory);
  write_random(parameters, 3);
  // The first record holds the first message of the first profile.
  memory.eeprom[emulator::layout::parameters + 50] ^= 0x40;
  EXPECT_EQ(parameters.read<msg::ReadParams3>(0).profile_id, 0);
  const Memory damaged = memory;
  parameters.reload();
  EXPECT_EQ(parameters.read<msg::ReadParams3>(0), factory_parameters<msg::ReadParams3>(0));
  EXPECT_EQ(memory, damaged) << "loading has changed something";
  for_each_random(3, [&]<class M>(std::uint8_t copy, const M& message) {
    const bool is_damaged = std::is_same_v<M, msg::ReadParams3> && copy == 0;
    if (is_damaged) return;
    // That record held the general parameters.
    const M expected = copy == 0 ? message : with_general_of(parameters.read<M>(0), message);
    EXPECT_EQ(parameters.read<M>(copy), expected);
  });
}

TEST(Parameters, AnUnknownActiveProfileIsTheFirst) {
  Memory memory;
  memory.profile = 200;
  Parameters parameters(memory);
  EXPECT_EQ(parameters.profile(), 0);
  EXPECT_EQ(parameters.of<msg::ReadParams3>().profile_id, 0);
}

TEST(Parameters, DefaultsAreOfOneProfile) {
  Memory memory;
  Parameters parameters(memory);
  write_random(parameters, 4);
  parameters.select_profile(2);
  parameters.use_defaults(2);
  EXPECT_EQ(parameters.of<msg::ReadParamsExt>(), factory_parameters<msg::ReadParamsExt>(2));
  EXPECT_EQ(Parameters(memory).of<msg::ReadParams3>(), parameters.of<msg::ReadParams3>());
  parameters.use_defaults(4);
  EXPECT_EQ(parameters.profile(), 2);
  for_each_random(4, [&]<class M>(std::uint8_t copy, const M& message) {
    const bool is_new = ParametersOf<M>::copies > 1 && (copy == 2 || copy == 4);
    const M factory = with_general_of(message, factory_parameters<M>(copy));
    EXPECT_EQ(parameters.read<M>(copy), is_new ? factory : message);
  });
}

TEST(Parameters, ErasingLeavesNothing) {
  Memory memory;
  Parameters parameters(memory);
  write_random(parameters, 5);
  parameters.select_profile(1);
  memory.eeprom.back() = 3;  // of a file
  const auto revision = memory.revision;
  parameters.erase();
  EXPECT_EQ(memory.eeprom, Memory().eeprom);
  EXPECT_NE(memory.revision, revision);
  EXPECT_EQ(parameters.profile(), 0);
  ParameterMessages::for_each([&]<class M>(Type<M>) {
    for (std::uint8_t copy = 0; copy < ParametersOf<M>::copies; ++copy) {
      EXPECT_EQ(parameters.read<M>(copy), factory_parameters<M>(copy));
    }
  });
}

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

TEST(FactorySettings, VariablesAreInsideOfTheirRanges) {
  Memory memory;
  const Parameters parameters(memory);
  for (const VariableInfo& variable : variables) {
    const auto value = parameters.variable(variable.id);
    ASSERT_TRUE(value) << variable.name;
    EXPECT_GE(*value, variable.range.lowest) << variable.name;
    EXPECT_LE(*value, variable.range.highest) << variable.name;
  }
}

// A memory that an earlier emulator wrote: its records had no CMD_READ_PARAMS_EXT3.
TEST(EarlierMemory, KeepsAllItsParameters) {
  emulator::Memory memory;
  emulator::Eeprom eeprom(memory);
  std::size_t address = emulator::layout::parameters;
  const auto add = [&]<class M>(M message) {
    for (std::uint8_t copy = 0; copy < ParametersOf<M>::copies; ++copy) {
      if constexpr (requires { message.profile_id; }) message.profile_id = copy;
      std::array<std::uint8_t, max_body_size> body{};
      const auto size = encode(message, body).size;
      EXPECT_TRUE(
          emulator::write_record(eeprom, address, {M::command, copy}, std::span(body).first(size)));
      address += emulator::record_size();
    }
  };
  msg::ReadParams3 main;
  main.axes.roll.p = 77;
  msg::ReadAdjVarsCfg slots;
  slots.trigger_slots[3].action[2] = msg::MenuCommand::profile3;
  msg::ReadExternalData user;
  user.data[100] = 0xA5;
  add(main);
  add(msg::ReadParamsExt{});
  add(msg::ReadParamsExt2{});
  add(msg::ReadProfileNames{});
  add(slots);
  add(user);
  Host host(newest_board(), memory);
  EXPECT_EQ(host.get<msg::ReadParams3>(msg::ReadParams3Request{.profile_id = 3}).axes.roll.p, 77);
  EXPECT_EQ(host.get<msg::ReadAdjVarsCfg>(msg::ReadAdjVarsCfgRequest{}), slots);
  EXPECT_EQ(host.get<msg::ReadExternalData>(msg::ReadExternalDataRequest{}), user);
  EXPECT_EQ(host.get<msg::ReadParamsExt3>(msg::ReadParamsExt3Request{.profile_id = 2}).profile_id,
            2);
}

}  // namespace
}  // namespace sbgc::test

namespace sbgc::emulator {
namespace {

Tuning tuning(const Parameters& parameters, double battery_factor = 1) {
  return tuning_of(parameters, newest, true, battery_factor);
}

TEST(Tuning, TheGainFactorIsForAllGains) {
  Memory memory;
  Parameters parameters(memory);
  const AxisTuning before = tuning(parameters).axes.pitch;
  auto more = parameters.of<msg::ReadParamsExt2>();
  more.pid_gain.pitch = *msg::PidGain::from_value(2);
  ASSERT_TRUE(parameters.write(0, more));
  const AxisTuning after = tuning(parameters).axes.pitch;
  EXPECT_NEAR(after.p, 2 * before.p, 1e-9);
  EXPECT_NEAR(after.i, 2 * before.i, 1e-9);
  EXPECT_NEAR(after.d, 2 * before.d, 1e-9);
  EXPECT_EQ(after.power, before.power);
}

TEST(Tuning, TheOffsetOfTheFollowModeIsOfEachAxis) {
  Memory memory;
  Parameters parameters(memory);
  auto main = parameters.of<msg::ReadParams3>();
  main.follow_offset = {1, -20, 127};
  ASSERT_TRUE(parameters.write(0, main));
  EXPECT_EQ(tuning(parameters).axes.pitch.follow_offset, -20);
  EXPECT_EQ(tuning(parameters).axes.yaw.follow_offset, 127);
}

TEST(Tuning, TheMotorsStopAtWhatTheSensorShows) {
  Memory memory;
  Parameters parameters(memory);
  const double threshold = parameters.of<msg::ReadParams3>().bat_threshold_motors.volts();
  EXPECT_NEAR(tuning(parameters, 0.5).battery_stop, 2 * threshold, 1e-9);
  EXPECT_LT(tuning(parameters, 0).battery_stop, 0) << "the motors never stop without a sensor";
}

}  // namespace
}  // namespace sbgc::emulator
