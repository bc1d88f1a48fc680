// Parameters of the board: what a host writes is read again, per profile, after a restart as well.

#include "device/parts/parameters.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <random>
#include <set>
#include <vector>

#include <gtest/gtest.h>

#include <sbgc/meta/all.hpp>
#include <sbgc/validate.hpp>

namespace {

using sbgc::Meta;
namespace msg = sbgc::msg;
using sbgc::SettingsOf;
using sbgc::StoredMessages;
using sbgc::Type;
using sbgc::emulator::Memory;
using sbgc::emulator::Parameters;
using ByteVector = std::vector<std::uint8_t>;

constexpr std::uint8_t profiles = SettingsOf<msg::ReadParams3>::copies;

template <class M>
ByteVector bytes_of(const M& message) {
  ByteVector bytes(sbgc::max_body_size);
  bytes.resize(encode(message, bytes).size);
  return bytes;
}

template <class M>
void set_copy(M& message, std::uint8_t copy) {
  if constexpr (SettingsOf<M>::copies > 1) SettingsOf<M>::copy(message) = copy;
}

/// A body of any bytes with a tail: reserved bytes, values without a meaning, all of it.
template <class M>
M random_message(std::mt19937& random, std::uint8_t copy) {
  ByteVector body(M::min_size + random() % (sbgc::max_body_size - M::min_size + 1));
  for (auto& byte : body) byte = static_cast<std::uint8_t>(random());
  M message{};
  EXPECT_TRUE(decode(std::span(body), message));
  EXPECT_EQ(bytes_of(message), body);
  set_copy(message, copy);
  return message;
}

/// The message with the general parameters of another.
template <class M>
M with_general_of(const M& from, M message) {
  if constexpr (SettingsOf<M>::copies > 1) SettingsOf<M>::share(from, message);
  return message;
}

/// Hands out random bodies for everything, always in the same order.
template <class Use>
void for_each_random(unsigned seed, Use&& use) {
  std::mt19937 random(seed);
  StoredMessages::for_each([&]<class M>(Type<M>) {
    const M first = random_message<M>(random, 0);
    use(std::uint8_t{0}, first);
    for (std::uint8_t copy = 1; copy < SettingsOf<M>::copies; ++copy) {
      use(copy, with_general_of(first, random_message<M>(random, copy)));
    }
  });
}

void write_random(Parameters& parameters, unsigned seed) {
  for_each_random(seed, [&](std::uint8_t copy, const auto& message) {
    EXPECT_TRUE(parameters.write(copy, message));
  });
}

void expect_random(const Parameters& parameters, unsigned seed) {
  for_each_random(seed, [&]<class M>(std::uint8_t copy, const M& message) {
    EXPECT_EQ(bytes_of(parameters.read<M>(copy)), bytes_of(message))
        << Meta<M>::info.name << ' ' << int{copy};
  });
}

template <class M>
M with_gain(std::uint8_t gain) {
  M result = sbgc::emulator::factory_parameters<M>(0);
  result.axes.roll.p = gain;
  return result;
}

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

TEST(Parameters, SayTheNumberOfTheirProfile) {
  Memory memory;
  Parameters parameters(memory);
  for (std::uint8_t profile = 0; profile < profiles; ++profile) {
    auto sent = with_gain<msg::ReadParams3>(1);
    sent.profile_id = 255;  // "the active one"
    ASSERT_TRUE(parameters.write(profile, sent));
    EXPECT_EQ(parameters.read<msg::ReadParams3>(profile).profile_id, profile);
    parameters.select_profile(profile);
    EXPECT_EQ(parameters.of<msg::ReadParams3>().profile_id, profile);
  }
}

TEST(Parameters, OneProfileLeavesTheOthersAlone) {
  Memory memory;
  Parameters parameters(memory);
  for (std::uint8_t profile = 0; profile < profiles; ++profile) {
    ASSERT_TRUE(parameters.write(profile, with_gain<msg::ReadParams3>(100 + profile)));
  }
  ASSERT_TRUE(parameters.write(2, with_gain<msg::ReadParams3>(7)));
  for (std::uint8_t profile = 0; profile < profiles; ++profile) {
    const std::uint8_t expected = profile == 2 ? 7 : 100 + profile;
    EXPECT_EQ(parameters.read<msg::ReadParams3>(profile).axes.roll.p, expected);
    parameters.select_profile(profile);
    EXPECT_EQ(parameters.of<msg::ReadParams3>().axes.roll.p, expected);
  }
}

void expect_speed(const Parameters& parameters, sbgc::msg::SerialSpeed speed) {
  EXPECT_EQ(parameters.of<msg::ReadParams3>().serial_speed, speed);
  for (std::uint8_t profile = 0; profile < profiles; ++profile) {
    EXPECT_EQ(parameters.read<msg::ReadParams3>(profile).serial_speed, speed) << int{profile};
  }
}

TEST(Parameters, GeneralOnesAreThoseOfAllProfiles) {
  Memory memory;
  Parameters parameters(memory);
  parameters.select_profile(1);
  const auto gain = parameters.of<msg::ReadParams3>().axes.roll.p;
  ASSERT_TRUE(parameters.set_variable(msg::VariableId::p_roll, 99));
  auto sent = with_gain<msg::ReadParams3>(7);
  sent.serial_speed = sbgc::msg::SerialSpeed::baud_9600;
  ASSERT_TRUE(parameters.write(3, sent));
  expect_speed(parameters, sbgc::msg::SerialSpeed::baud_9600);
  EXPECT_EQ(parameters.variable(msg::VariableId::p_roll), 99) << "it is not of the profile written";
  Parameters restarted(memory);
  expect_speed(restarted, sbgc::msg::SerialSpeed::baud_9600);
  for (std::uint8_t profile = 0; profile < profiles; ++profile) {
    EXPECT_EQ(restarted.read<msg::ReadParams3>(profile).axes.roll.p, profile == 3 ? 7 : gain);
    restarted.select_profile(profile);
    expect_speed(restarted, sbgc::msg::SerialSpeed::baud_9600);
  }
}

TEST(Parameters, GeneralOnesAreChangedInAllProfiles) {
  Memory memory;
  Parameters parameters(memory);
  const auto change = [](sbgc::msg::SerialSpeed speed) {
    return [speed](msg::ReadParams3& main) { main.serial_speed = speed; };
  };
  for (const std::uint8_t profile : {std::uint8_t{0}, std::uint8_t{2}}) {
    const auto speed =
        profile == 0 ? sbgc::msg::SerialSpeed::baud_9600 : sbgc::msg::SerialSpeed::baud_19200;
    ASSERT_TRUE(parameters.change<msg::ReadParams3>(profile, change(speed)));
    expect_speed(parameters, speed);
    expect_speed(Parameters(memory), speed);
  }
  parameters.select_profile(4);
  parameters.change_in_use<msg::ReadParams3>(change(sbgc::msg::SerialSpeed::baud_57600));
  parameters.save();
  expect_speed(parameters, sbgc::msg::SerialSpeed::baud_57600);
  expect_speed(Parameters(memory), sbgc::msg::SerialSpeed::baud_57600);
}

TEST(Parameters, WritingTheActiveProfileTakesEffectAtOnce) {
  Memory memory;
  Parameters parameters(memory);
  ASSERT_TRUE(parameters.write(1, with_gain<msg::ReadParams3>(77)));
  EXPECT_NE(parameters.of<msg::ReadParams3>().axes.roll.p, 77);
  ASSERT_TRUE(parameters.write(0, with_gain<msg::ReadParams3>(78)));
  EXPECT_EQ(parameters.of<msg::ReadParams3>().axes.roll.p, 78);
}

TEST(Parameters, StateOfTheBoardIsKeptButNotObeyed) {
  Memory memory;
  Parameters parameters(memory);
  msg::ReadParams3 sent = parameters.of<msg::ReadParams3>();
  sent.cur_imu = sbgc::msg::SelectedImu::frame;
  sent.cur_profile_id = 4;
  ASSERT_TRUE(parameters.write(0, sent));
  EXPECT_EQ(parameters.profile(), 0);
  EXPECT_EQ(Parameters(memory).read<msg::ReadParams3>(0), sent);
}

TEST(Parameters, ADamagedRecordIsTheFactorySettings) {
  Memory memory;
  Parameters parameters(memory);
  write_random(parameters, 3);
  // The first record is that of the first message and profile.
  memory.eeprom[sbgc::emulator::layout::parameters + 50] ^= 0x40;
  EXPECT_EQ(parameters.read<msg::ReadParams3>(0).profile_id, 0);
  const Memory damaged = memory;
  parameters.reload();
  EXPECT_EQ(parameters.read<msg::ReadParams3>(0),
            sbgc::emulator::factory_parameters<msg::ReadParams3>(0));
  EXPECT_EQ(memory, damaged) << "loading has changed something";
  for_each_random(3, [&]<class M>(std::uint8_t copy, const M& message) {
    const bool is_damaged = std::is_same_v<M, msg::ReadParams3> && copy == 0;
    if (is_damaged) return;
    // The general ones were in that record.
    const M expected = copy == 0 ? message : with_general_of(parameters.read<M>(0), message);
    EXPECT_EQ(parameters.read<M>(copy), expected);
  });
}

TEST(Parameters, ARawWriteToTheEepromCountsAtTheNextStart) {
  Memory other;
  Parameters(other).write(0, with_gain<msg::ReadParams3>(42));
  Memory memory;
  Parameters parameters(memory);
  ASSERT_TRUE(parameters.write(0, with_gain<msg::ReadParams3>(41)));
  memory.eeprom = other.eeprom;
  EXPECT_EQ(parameters.of<msg::ReadParams3>().axes.roll.p, 41);
  EXPECT_EQ(parameters.read<msg::ReadParams3>(0).axes.roll.p, 41);
  parameters.reload();
  EXPECT_EQ(parameters.of<msg::ReadParams3>().axes.roll.p, 42);
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
  EXPECT_EQ(parameters.of<msg::ReadParamsExt>(),
            sbgc::emulator::factory_parameters<msg::ReadParamsExt>(2));
  EXPECT_EQ(Parameters(memory).of<msg::ReadParams3>(), parameters.of<msg::ReadParams3>());
  parameters.use_defaults(4);
  EXPECT_EQ(parameters.profile(), 2);
  for_each_random(4, [&]<class M>(std::uint8_t copy, const M& message) {
    const bool is_new = SettingsOf<M>::copies > 1 && (copy == 2 || copy == 4);
    const M factory = with_general_of(message, sbgc::emulator::factory_parameters<M>(copy));
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
  StoredMessages::for_each([&]<class M>(Type<M>) {
    for (std::uint8_t copy = 0; copy < SettingsOf<M>::copies; ++copy) {
      EXPECT_EQ(parameters.read<M>(copy), sbgc::emulator::factory_parameters<M>(copy));
    }
  });
}

TEST(FactorySettings, AreAllowedOnOldBoardsToo) {
  StoredMessages::for_each([]<class M>(Type<M>) {
    for (std::uint8_t copy = 0; copy < SettingsOf<M>::copies; ++copy) {
      const M message = sbgc::emulator::factory_parameters<M>(copy);
      for (const sbgc::Availability versions : {sbgc::newest, sbgc::Availability{2400, 30}}) {
        sbgc::validate(message, versions, [&](const sbgc::Violation& violation) {
          std::array<char, 128> path{};
          violation.path.write(path.data(), path.size());
          ADD_FAILURE() << Meta<M>::info.name << ' ' << int{copy} << ' ' << path.data() << ": "
                        << violation.value << " against " << violation.limit;
        });
      }
      if constexpr (SettingsOf<M>::copies > 1) {
        EXPECT_EQ(SettingsOf<M>::copy(message), copy);
      }
    }
  });
}

TEST(FactorySettings, NameTheProfiles) {
  const auto names = sbgc::emulator::factory_parameters<msg::ReadProfileNames>(0).profile_name;
  EXPECT_EQ(std::string_view(names[0].data(), names[0].size()), "Profile 1");
  EXPECT_EQ(std::string_view(names[4].data(), names[4].size()), "Profile 5");
}

TEST(FactorySettings, SlotsAreEmpty) {
  EXPECT_EQ(sbgc::emulator::factory_parameters<msg::ReadAdjVarsCfg>(0), msg::ReadAdjVarsCfg{});
}

TEST(FactorySettings, VariablesAreInsideOfTheirRanges) {
  Memory memory;
  const Parameters parameters(memory);
  for (const sbgc::VariableInfo& variable : sbgc::variables) {
    const auto value = parameters.variable(variable.id);
    ASSERT_TRUE(value) << variable.name;
    EXPECT_GE(*value, variable.range.lowest) << variable.name;
    EXPECT_LE(*value, variable.range.highest) << variable.name;
  }
}

TEST(Variables, AreWhatWasSet) {
  Memory memory;
  Parameters parameters(memory);
  const Memory before = memory;
  std::mt19937 random(7);
  for (const sbgc::VariableInfo& variable : sbgc::variables) {
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
  for (const sbgc::VariableInfo& variable : sbgc::variables) known.insert(variable.id);
  for (int id = 0; id <= 255; ++id) {
    const auto variable = static_cast<msg::VariableId>(id);
    EXPECT_EQ(parameters.variable(variable).has_value(), known.contains(variable)) << id;
    if (known.contains(variable)) continue;
    EXPECT_FALSE(parameters.set_variable(variable, 0)) << id;
  }
}

TEST(Variables, ChangeTheSettingsInUse) {
  Memory memory;
  Parameters parameters(memory);
  ASSERT_TRUE(parameters.set_variable(msg::VariableId::p_roll, 99));
  EXPECT_EQ(parameters.of<msg::ReadParams3>().axes.roll.p, 99);
  EXPECT_EQ(parameters.read<msg::ReadParams3>(0).axes.roll.p, 99);
}

TEST(Variables, ASmallLimitDoesNotSwitchTheLimiterOff) {
  Memory memory;
  Parameters parameters(memory);
  ASSERT_TRUE(parameters.set_variable(msg::VariableId::acc_limiter_roll, 2));
  EXPECT_EQ(parameters.of<msg::ReadParamsExt2>().acc_limiter3.roll.raw(), 1);
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
  ASSERT_TRUE(parameters.write(0, sbgc::emulator::factory_parameters<msg::ReadParams3>(0)));
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
        message.lpf_freq.yaw = sbgc::msg::Frequency(77);
      if constexpr (std::is_same_v<M, msg::ReadParamsExt2>)
        message.pid_gain.yaw = sbgc::msg::PidGain(55);
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
