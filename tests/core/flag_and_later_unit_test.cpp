// Tests of fields whose unit depends on a flag of the message, which are read and set together, and
// of those that later firmware has in another unit: P, I, D and PID_GAIN.

#include <gtest/gtest.h>

#include <sbgc/any.hpp>
#include <sbgc/messages/control.hpp>
#include <sbgc/messages/parameters.hpp>
#include <sbgc/meta/all.hpp>
#include <sbgc/text.hpp>

#include "support.hpp"

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

constexpr Availability unknown{};
constexpr Availability earlier{.firmware = 2730, .board = 36};
constexpr Availability later{.firmware = 2731, .board = 36};

/// The vendor's formula.
double gain(int raw) { return 5 * std::exp(raw * std::log(260.0 / 5) / 255) - 5; }

TEST(LaterUnits, AreThoseOfTheFirmware) {
  msg::ReadParams3 params;
  auto& pitch = params.axes.pitch;
  for (int raw = 0; raw <= 255; ++raw) {
    pitch.p = static_cast<std::uint8_t>(raw);
    pitch.i = msg::Hundredths(pitch.p);
    EXPECT_EQ(pitch.real_p(), raw);
    EXPECT_EQ(pitch.real_p(earlier), raw);
    EXPECT_NEAR(pitch.real_p(later), gain(raw), 1e-9);
    EXPECT_DOUBLE_EQ(pitch.real_i(earlier), raw / 100.0);
    EXPECT_NEAR(pitch.real_i(later), gain(raw), 1e-9);
    pitch.p = 1;
    ASSERT_TRUE(pitch.set_p(gain(raw) * 1.001, later));
    EXPECT_EQ(pitch.p, raw);
  }
  msg::ReadParamsExt2 more;
  more.pid_gain.yaw = msg::PidGain(70);
  EXPECT_NEAR(more.real_pid_gain(2), 1.5, 1e-9);
  EXPECT_NEAR(more.real_pid_gain(2, later), gain(70), 1e-9);
}

TEST(LaterUnits, WhatDoesNotFitIsNotSet) {
  msg::ReadParams3 params;
  params.axes.roll.p = 7;
  params.axes.roll.i = msg::Hundredths(7);
  for (const double value : {-1.0, 258.0, -1e300, 1e300, std::nan("")}) {
    EXPECT_FALSE(params.axes.roll.set_p(value, later)) << value;
    EXPECT_FALSE(params.axes.roll.set_p(value)) << value;
  }
  EXPECT_FALSE(params.axes.roll.set_i(2.56));
  EXPECT_EQ(params.axes.roll.p, 7);
  EXPECT_EQ(params.axes.roll.i.raw(), 7);
  EXPECT_TRUE(params.axes.roll.set_i(2.56, later));
}

constexpr bool is_constexpr() {
  msg::ReadParams3 params;
  return params.axes.yaw.set_d(255, later) && params.axes.yaw.d == 255 &&
         (*msg::LogarithmicGain::from_value(0)).raw() == 0;
}
static_assert(is_constexpr());

std::string text_of(const AnyMessage& message, std::string_view path,
                    const Availability& versions) {
  std::string result;
  message.with_leaf(
      path, [&](const Leaf& leaf) { result = value_text(leaf); }, versions);
  return result;
}

TEST(LaterUnits, TextSaysWhatItAssumes) {
  AnyMessage message = find_message("ReadParams3")->make();
  message.get_if<msg::ReadParams3>()->axes.roll.p = 70;
  EXPECT_EQ(text_of(message, "axes.roll.p", unknown), "70 (before firmware 2.73.1)");
  EXPECT_EQ(text_of(message, "axes.roll.p", earlier), "70");
  EXPECT_EQ(text_of(message, "axes.roll.p", later), "9.7921");
  EXPECT_EQ(text_of(message, "axes.roll.i", unknown), "0 (before firmware 2.73.1)");
  EXPECT_EQ(text_of(message, "axes.roll.power", unknown), "0");
}

TEST(LaterUnits, TextIsReadAsItIsShown) {
  AnyMessage message = find_message("ReadParams3")->make();
  const auto roll = [&] { return message.get_if<msg::ReadParams3>()->axes.roll; };
  EXPECT_EQ(message.assign("axes.roll.p", "9.7921", true, later), "");
  EXPECT_EQ(roll().p, 70);
  EXPECT_EQ(message.assign("axes.roll.i", "0.7", true, earlier), "");
  EXPECT_EQ(roll().i.raw(), 70);
  EXPECT_EQ(message.assign("axes.roll.p", "300", true, later),
            "axes.roll.p: 300 does not fit: 0 to 255");
  EXPECT_EQ(message.assign("axes.roll.p", "9.5"), "axes.roll.p: '9.5' is not an integer");
}

TEST(LaterUnits, OfAVariableAreThoseOfItsSetting) {
  const VariableInfo& p = *find_variable(msg::VariableId::p_roll);
  EXPECT_EQ(p.unit_in(earlier).real(70), 70);
  EXPECT_NEAR(p.unit_in(later).real(70), gain(70), 1e-9);
  AnyMessage message = find_message("SetAdjVarsVal")->make();
  EXPECT_EQ(message.assign("params[0].param_id", "P_ROLL"), "");
  EXPECT_EQ(message.assign("params[0].param_value", "9.7921", true, later), "");
  EXPECT_EQ(text_of(message, "params[0].param_value", earlier), "70");
  EXPECT_EQ(text_of(message, "params[0].param_value", unknown), "70 (before firmware 2.73.1)");
}

}  // namespace
}  // namespace sbgc::test
