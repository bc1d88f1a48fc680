// Tests of fields whose unit depends on a flag of the message; value and flag are read and set
// together.

#include <gtest/gtest.h>

#include <sbgc/messages/control.hpp>

namespace sbgc::test {
namespace {

constexpr msg::FineSpeed creeping = 0.5_deg_per_s;
constexpr msg::ControlSpeed turning = 20_deg_per_s;
constexpr std::size_t roll = 0;
constexpr std::size_t pitch = 1;
constexpr std::size_t yaw = 2;

bool is_fine(msg::ControlMode mode) { return mode.flags().has(msg::ControlFlag::high_res_speed); }

TEST(FlagUnit, IsSetTogetherWithTheValue) {
  msg::Control control{.control_mode = msg::ControlMode::speed};
  EXPECT_TRUE(control.set_speed(yaw, creeping));
  EXPECT_TRUE(is_fine(control.control_mode));
  EXPECT_EQ(control.control_mode.mode(), msg::ControlMode::speed);
  EXPECT_EQ(control.axes.yaw.speed.raw(), 500);
  EXPECT_DOUBLE_EQ(control.real_speed(yaw), 0.5);
  EXPECT_EQ(control.real_speed(pitch), 0);

  EXPECT_TRUE(control.set_speed(yaw, turning));
  EXPECT_FALSE(is_fine(control.control_mode));
  EXPECT_EQ(control.control_mode.mode(), msg::ControlMode::speed);
  EXPECT_EQ(control.axes.yaw.speed, turning);
  EXPECT_NEAR(control.real_speed(yaw), 20, 0.07);
}

TEST(FlagUnit, OneFlagForAllElementsTakesOneUnit) {
  msg::Control control;
  EXPECT_TRUE(control.set_speed(roll, turning));
  EXPECT_TRUE(control.set_speed(pitch, turning));
  const msg::Control before = control;
  EXPECT_FALSE(control.set_speed(yaw, creeping));
  EXPECT_FALSE(control.set_speed(pitch, creeping)) << "roll has the other unit";
  EXPECT_EQ(control, before);

  control = {};
  EXPECT_TRUE(control.set_speed(roll, creeping));
  EXPECT_TRUE(control.set_speed(pitch, creeping));
  EXPECT_FALSE(control.set_speed(yaw, turning));
  EXPECT_EQ(control.axes.yaw.speed.raw(), 0);
  EXPECT_TRUE(is_fine(control.control_mode));
}

TEST(FlagUnit, EachElementMayHaveItsOwnFlag) {
  msg::ControlExt control;
  control.set_speed(roll, turning);
  control.set_speed(yaw, creeping);
  EXPECT_FALSE(is_fine(control.control_mode.roll));
  EXPECT_TRUE(is_fine(control.control_mode.yaw));
  EXPECT_NEAR(control.real_speed(roll), 20, 0.07);
  EXPECT_DOUBLE_EQ(control.real_speed(yaw), 0.5);
  control.set_speed(yaw, turning);
  EXPECT_FALSE(is_fine(control.control_mode.yaw));
}

TEST(FlagUnit, IsReadFromTheWire) {
  msg::Control control{.control_mode = msg::ControlMode(0x81)};
  control.axes.pitch.speed = msg::ControlSpeed(-1000);
  EXPECT_DOUBLE_EQ(control.real_speed(pitch), -1);
  control.control_mode = msg::ControlMode::speed;
  EXPECT_DOUBLE_EQ(control.real_speed(pitch), -1000 * 4000.0 / 32767);
}

constexpr msg::Control constant = [] {
  msg::Control control;
  return control.set_speed(yaw, creeping) ? control : msg::Control{};
}();
static_assert(constant.control_mode.raw() == 0x80 && constant.real_speed(yaw) == 0.5);

}  // namespace
}  // namespace sbgc::test
