// Tests of the effects of requests.

#include <string_view>

#include <gtest/gtest.h>

#include <sbgc/messages.hpp>
#include <sbgc/meta/all.hpp>

namespace sbgc::test {
namespace {

template <class M>
constexpr Effects effects_of = Meta<M>::info.effects;

TEST(Effects, AreThoseOfTheRequest) {
  EXPECT_EQ(effects_of<msg::GetAnglesRequest>, Effects(Effect::reads));
  EXPECT_EQ(effects_of<msg::Control>, Effects(Effect::moves));
  EXPECT_EQ(effects_of<msg::WriteParams3>, Effects(Effect::stores) | Effect::moves);
  EXPECT_EQ(effects_of<msg::UseDefaults>, Effects(Effect::stores) | Effect::moves | Effect::erases);
  EXPECT_EQ(effects_of<msg::ResetRequest>, Effects(Effect::restarts));
  EXPECT_EQ(effects_of<msg::SystemStateRequest>, Effects(Effect::unknown));
}

TEST(Effects, OfAMessageInBothDirectionsAreThoseToTheBoard) {
  EXPECT_EQ(effects_of<msg::SetAdjVarsVal>, Effects(Effect::sets) | Effect::moves);
}

template <class M>
bool preparation_says(std::string_view words) {
  return std::string_view(Meta<M>::info.preparation).find(words) != std::string_view::npos;
}

TEST(Preparation, IsThatOfTheRequestOrOfItsForm) {
  EXPECT_TRUE(preparation_says<msg::CalibGyro>("completely still"));
  EXPECT_FALSE(preparation_says<msg::CalibGyro>("TEMPERATURE"));
  EXPECT_TRUE(preparation_says<msg::CalibGyroExt>("TEMPERATURE"));
  EXPECT_STREQ(Meta<msg::GetAnglesRequest>::info.preparation, "");
  EXPECT_STREQ(Meta<msg::CalibInfo>::info.preparation, "");
}

}  // namespace
}  // namespace sbgc::test
