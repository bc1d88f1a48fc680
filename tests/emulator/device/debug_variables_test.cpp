// Tests of debug variables: their announcement, and that their values change.

#include "device/debug/debug_variables.hpp"

#include <array>
#include <set>

#include <gtest/gtest.h>

#include <sbgc/meta/enums.hpp>

#include "debug_values.hpp"
#include "replies.hpp"

namespace sbgc::test {
namespace {

TEST(DebugVariables, EveryKindOfVariableIsThere) {
  const msg::DebugVarsInfo3 info = emulator::debug_variables_info();
  std::set<msg::DebugVarKind> kinds;
  std::set<msg::DebugVarAxis> axes;
  std::set<std::string> names;
  bool has_angle = false;
  for (const msg::DebugVarInfo& one : info.vars) {
    kinds.insert(one.var_type.kind());
    axes.insert(one.var_type.axis());
    names.insert(std::string(one.var_name.data(), one.var_name.size()));
    EXPECT_EQ(one.arr_size, 0) << "existing readers treat these bytes as reserved";
    has_angle = has_angle || one.var_type.flags().has(msg::DebugVarFlag::angle14);
  }
  EXPECT_EQ(kinds.size(), EnumMeta<msg::DebugVarKind>::info.values.size());
  EXPECT_EQ(axes.size(), EnumMeta<msg::DebugVarAxis>::info.values.size());
  EXPECT_EQ(names.size(), info.vars.size()) << "names are different";
  EXPECT_EQ(names.count(""), 0U);
  EXPECT_TRUE(has_angle);
}

TEST(DebugVariables, ValuesAreLive) {
  Host host;
  const auto before = debug_values(host);
  host.board.gimbal().place({10, -20, 30}, host.now);
  host.listen(seconds(2));
  const auto after = debug_values(host);
  EXPECT_NEAR(after.at("UPTIME_MS")[0] - before.at("UPTIME_MS")[0], 2100, 100);
  EXPECT_NEAR(after.at("ROLL")[0] * msg::Angle14(1).degrees(), 10, 1);
  EXPECT_NEAR(after.at("PITCH")[0] * msg::Angle14(1).degrees(), -20, 1);
  EXPECT_NEAR(after.at("YAW")[0] * msg::Angle14(1).degrees(), 30, 1);
  EXPECT_NEAR(after.at("BATTERY")[0], 16, 2);
  const auto gyro = [](const auto& values) {
    return std::array{values.at("GYRO_X")[0], values.at("GYRO_Y")[0], values.at("GYRO_Z")[0]};
  };
  EXPECT_NE(gyro(after), gyro(before)) << "it has noise";
}

TEST(DebugVariables, AgreeWithTheLiveData) {
  Host host;
  ASSERT_TRUE(is_confirmed(host, msg::CalibBat{20_V}));
  const auto data = host.get<msg::RealtimeData3>(msg::RealtimeData3Request{});
  EXPECT_NEAR(debug_values(host).at("BATTERY")[0], data.bat_level.volts(), 0.05);
}

TEST(DebugVariables, TellNoVoltageThatIsNotMeasured) {
  Host host({.features = msg::BoardFeature::three_axis});
  EXPECT_EQ(debug_values(host).at("BATTERY")[0], 0);
}

TEST(DebugVariables, FollowTheProfile) {
  Host host;
  EXPECT_EQ(debug_values(host).at("PROFILE")[0], 0);
  host.ask(msg::ExecuteMenu{.cmd_id = msg::MenuCommand::profile4});
  EXPECT_EQ(debug_values(host).at("PROFILE")[0], 3);
}

TEST(DebugVariables, UptimeBeginsWithTheRestart) {
  Host host;
  host.listen(seconds(100));
  host.board.restart(host.now);
  host.listen(seconds(2));
  EXPECT_LT(debug_values(host).at("UPTIME_MS")[0], 3000);
}

}  // namespace
}  // namespace sbgc::test
