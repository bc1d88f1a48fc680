// Tests of debug variables: their announcement.

#include <set>
#include <string>

#include <gtest/gtest.h>

#include <sbgc/meta/enums.hpp>

#include "device/debug/debugging.hpp"

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

}  // namespace
}  // namespace sbgc::test
