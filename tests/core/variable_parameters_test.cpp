// Tests of the adjustable variables and the settings they represent.

#include <cstdlib>
#include <tuple>

#include <gtest/gtest.h>

#include <sbgc/messages.hpp>
#include <sbgc/meta/variables.hpp>
#include <sbgc/parameters.hpp>
#include <sbgc/variable_parameters.hpp>

#include "messages.hpp"

namespace sbgc::test {
namespace {

/// One setting of each kind that a variable can represent.
struct Settings {
  template <class M>
  constexpr M& of() {
    return std::get<M>(messages);
  }
  template <class M>
  constexpr const M& of() const {
    return std::get<M>(messages);
  }

  std::tuple<msg::ReadParams3, msg::ReadParamsExt, msg::ReadParamsExt2, msg::ReadParamsExt3>
      messages;
};

std::vector<std::uint8_t> bytes_of(const Settings& settings) {
  std::vector<std::uint8_t> all;
  std::apply(
      [&](const auto&... message) {
        const auto add = [&](const auto& one) {
          std::vector<std::uint8_t> bytes(max_body_size);
          bytes.resize(encode(one, bytes).size);
          all.insert(all.end(), bytes.begin(), bytes.end());
        };
        (add(message), ...);
      },
      settings.messages);
  return all;
}

std::vector<std::size_t> differences(const Settings& a, const Settings& b) {
  const auto first = bytes_of(a);
  const auto second = bytes_of(b);
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < first.size(); ++i) {
    if (first[i] != second[i]) places.push_back(i);
  }
  return places;
}

/// Variables without a setting that any source names.
bool has_no_setting(msg::VariableId id) {
  using enum msg::VariableId;
  constexpr std::array without{
      frame_heading_angle, gyro_heading_correction, h_corr_factor, auto_pid_target,
      rc_mode_roll,        rc_mode_pitch,           rc_mode_yaw,   euler_order,
      shake_master_gain};
  return std::ranges::find(without, id) != without.end();
}

/// Returns the change of the variable for one step of the setting.
std::int32_t step_of(msg::VariableId id) {
  switch (id) {
    case msg::VariableId::acc_limiter:
    case msg::VariableId::acc_limiter_roll:
    case msg::VariableId::acc_limiter_pitch:
    case msg::VariableId::acc_limiter_yaw: return 5;
    case msg::VariableId::shake_pause_period: return 20;
    default: return 1;
  }
}

TEST(VariableSettings, EveryValueComesBackWithinAStep) {
  for (const VariableInfo& info : variables) {
    SCOPED_TRACE(info.name);
    const auto low = static_cast<std::int32_t>(info.range.lowest);
    const auto high = static_cast<std::int32_t>(info.range.highest);
    for (const std::int32_t value : {low, high, low + (high - low) / 2, low + (high - low) / 3}) {
      Settings settings;
      EXPECT_EQ(set_variable(settings, info.id, value), !has_no_setting(info.id));
      const auto told = variable_value(settings, info.id);
      ASSERT_EQ(told.has_value(), !has_no_setting(info.id));
      if (!told) continue;
      EXPECT_LE(2 * std::abs(*told - value), step_of(info.id)) << value;
      EXPECT_TRUE(*told == value || (value != low && value != high)) << value;
    }
  }
}

TEST(VariableSettings, NothingBesideTheSettingChanges) {
  std::vector<std::size_t> seen;
  for (const VariableInfo& info : variables) {
    SCOPED_TRACE(info.name);
    Settings settings;
    Settings changed;
    const bool is_set =
        set_variable(settings, info.id, static_cast<std::int32_t>(info.range.lowest)) &&
        set_variable(changed, info.id, static_cast<std::int32_t>(info.range.highest));
    const auto places = differences(settings, changed);
    if (!is_set) {
      EXPECT_EQ(places.size(), 0U);
    } else if (info.id == msg::VariableId::acc_limiter) {
      EXPECT_EQ(places.size(), 4U) << "the older limit and one for each axis";
    } else {
      const std::size_t most = info.range.highest > 255 && step_of(info.id) == 1 ? 2 : 1;
      ASSERT_GE(places.size(), 1U);
      ASSERT_LE(places.size(), most);
      EXPECT_EQ(places.back() - places.front() + 1, places.size());
      seen.push_back(places.front());
    }
  }
  std::sort(seen.begin(), seen.end());
  EXPECT_EQ(std::unique(seen.begin(), seen.end()), seen.end()) << "each has its own location";
}

TEST(VariableSettings, PlacesOfSome) {
  Settings settings;
  settings.of<msg::ReadParams3>().axes.pitch.i = msg::Hundredths(7);
  settings.of<msg::ReadParams3>().follow_mode = msg::FollowMode::pitch;
  settings.of<msg::ReadParamsExt>().lpf_freq.yaw = msg::Frequency(300);
  settings.of<msg::ReadParamsExt2>().pid_gain.roll = msg::PidGain(45);
  EXPECT_EQ(*variable_value(settings, msg::VariableId::i_pitch), 7);
  EXPECT_EQ(*variable_value(settings, msg::VariableId::follow_mode), 2);
  EXPECT_EQ(*variable_value(settings, msg::VariableId::lpf_freq_yaw), 300);
  EXPECT_EQ(*variable_value(settings, msg::VariableId::pid_gain_roll), 45);
}

TEST(VariableSettings, LimitOfTheAccelerationCountsInOtherSteps) {
  Settings settings;
  ASSERT_TRUE(set_variable(settings, msg::VariableId::acc_limiter, 502));
  EXPECT_EQ(settings.of<msg::ReadParams3>().acc_limiter_all.raw(), 100);
  EXPECT_EQ(settings.of<msg::ReadParamsExt2>().acc_limiter3.yaw.raw(), 100);
  ASSERT_TRUE(set_variable(settings, msg::VariableId::acc_limiter_yaw, 503));
  EXPECT_EQ(settings.of<msg::ReadParamsExt2>().acc_limiter3.yaw.raw(), 101);
  EXPECT_EQ(settings.of<msg::ReadParamsExt2>().acc_limiter3.roll.raw(), 100);
  EXPECT_EQ(*variable_value(settings, msg::VariableId::acc_limiter), 500)
      << "the first one is reported";
  EXPECT_EQ(*variable_value(settings, msg::VariableId::acc_limiter_yaw), 505);
}

TEST(VariableSettings, ASmallLimitOfTheAccelerationIsNotNone) {
  for (const std::int32_t value : {0, 1, 2, 3, 7}) {
    Settings settings;
    ASSERT_TRUE(set_variable(settings, msg::VariableId::acc_limiter, value));
    const std::uint8_t steps = value == 0 ? msg::ReadParams3::acc_limiter_disabled : 1;
    EXPECT_EQ(settings.of<msg::ReadParams3>().acc_limiter_all.raw(), steps) << value;
    EXPECT_EQ(settings.of<msg::ReadParamsExt2>().acc_limiter3.pitch.raw(), steps) << value;
  }
}

TEST(VariableSettings, AreTheNearest) {
  for (std::int64_t denominator = 1; denominator <= 6; ++denominator) {
    for (std::int64_t numerator = -20; numerator <= 20; ++numerator) {
      // std::lround() rounds halves away from 0, too; halves are exact.
      EXPECT_EQ(sbgc::detail::nearest(numerator, denominator),
                std::lround(static_cast<double>(numerator) / static_cast<double>(denominator)))
          << numerator << " / " << denominator;
    }
  }
}

TEST(VariableSettings, OnlyAnExactValueIsASpecialOne) {
  constexpr auto count = [](std::int32_t value) {
    std::int16_t setting = 0;
    sbgc::detail::set_variable({1, 0, 10}, setting, value, {0, 100});
    return setting;
  };
  static_assert(count(0) == 0 && count(1) == 1 && count(4) == 1 && count(-1) == -1);
  static_assert(count(15) == 2 && count(-15) == -2 && count(14) == 1);
  static_assert(count(1000) == 100 && count(999) == 99 && count(996) == 99 && count(1001) == 101);
}

TEST(VariableSettings, SwitchKeepsWhatIsOn) {
  Settings settings;
  auto& follow = settings.of<msg::ReadParams3>().rc.yaw.rc_follow;
  follow = -100;
  EXPECT_EQ(*variable_value(settings, msg::VariableId::rc_follow_yaw), 1);
  ASSERT_TRUE(set_variable(settings, msg::VariableId::rc_follow_yaw, 1));
  EXPECT_EQ(follow, -100);
  ASSERT_TRUE(set_variable(settings, msg::VariableId::rc_follow_yaw, 0));
  EXPECT_EQ(follow, 0);
  ASSERT_TRUE(set_variable(settings, msg::VariableId::rc_follow_yaw, 1));
  EXPECT_EQ(follow, 1);
}

TEST(VariableSettings, ValuesOutOfTheRangeAreRefused) {
  for (const VariableInfo& info : variables) {
    SCOPED_TRACE(info.name);
    Settings settings;
    for (const std::int32_t value :
         {static_cast<std::int32_t>(info.range.lowest) - 1,
          static_cast<std::int32_t>(info.range.highest) + 1, std::int32_t{INT32_MAX}, INT32_MIN}) {
      EXPECT_FALSE(set_variable(settings, info.id, value)) << value;
    }
    EXPECT_EQ(settings.messages, Settings{}.messages);
  }
  Settings settings;
  EXPECT_FALSE(set_variable(settings, static_cast<msg::VariableId>(200), 1));
  EXPECT_FALSE(variable_value(settings, static_cast<msg::VariableId>(200)));
}

}  // namespace
}  // namespace sbgc::test
