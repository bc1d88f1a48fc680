// Every menu action is known.

#include <sbgc/meta/enums.hpp>

#include "host.hpp"

namespace sbgc::test {
namespace {

TEST(Menu, HasAllActionsOfTheModelAndNoOther) {
  for (int action = 0; action < 256; ++action) {
    bool is_known = false;
    for (const ValueInfo& info : EnumMeta<msg::MenuCommand>::values)
      is_known |= info.value == action;
    Host host;
    const auto packets = host.ask(msg::ExecuteMenu{static_cast<msg::MenuCommand>(action)});
    EXPECT_EQ(all<msg::Confirm>(packets).size(), is_known ? 1U : 0U) << action;
    EXPECT_EQ(all<msg::ErrorExt>(packets).size(), is_known ? 0U : 1U) << action;
  }
}

}  // namespace
}  // namespace sbgc::test
