// Tests of validation: every rule, with path, value and limit.

#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <sbgc/meta/all.hpp>

#include "messages.hpp"

namespace sbgc::test {
namespace {

using Violations = std::vector<ViolationCopy>;

msg::BeepSound good_beep() {
  msg::BeepSound message;
  message.note_length = msg::NoteLength(1);
  message.note_freq_hz.push_back(msg::NoteFrequency(554));
  message.note_freq_hz.push_back(msg::NoteFrequency(20999));
  return message;
}

TEST(Validate, LimitsAreAllowed) {
  EXPECT_EQ(violations_of(good_beep()), Violations{});
  EXPECT_TRUE(is_valid(good_beep()));
}

TEST(Validate, FieldsThatOlderFirmwareDoesNotHave) {
  msg::EncodersCalibFldOffset4 message;
  const auto valid_for = [&](std::uint16_t firmware) {
    return validate(message, {firmware, 31}, [](const Violation&) {});
  };
  EXPECT_TRUE(valid_for(2590));
  message.calib_angle.emplace();
  EXPECT_FALSE(valid_for(2625)) << "present, although 0";
  EXPECT_TRUE(valid_for(2626));
  message.calib_speed.emplace();
  EXPECT_FALSE(valid_for(2710));
  EXPECT_TRUE(valid_for(2711));
}

TEST(Validate, WhatTheBoardDoesNotUseMayHaveAnyValue) {
  msg::CalibCogging message{.action = msg::CoggingAction::erase,
                            .axes = msg::CoggingAxis::roll | msg::CoggingAxis::pitch};
  EXPECT_EQ(violations_of(message), Violations{});
  EXPECT_TRUE(is_valid(message));
  message.action = msg::CoggingAction::calibrate;
  message.motors.roll = {.angle = msg::WideDegrees(20), .smooth = msg::Percent(100)};
  message.motors.yaw.smooth = msg::Percent(101);
  EXPECT_EQ(violations_of(message), (Violations{{"motors.pitch.angle", 0, 20, Rule::minimum},
                                                {"iterations_num", 0, 2, Rule::minimum}}));
  EXPECT_FALSE(is_valid(message));
  message.iterations_num = 2;
  message.axes = msg::CoggingAxis::roll;
  EXPECT_EQ(violations_of(message), Violations{});
}

TEST(Validate, RulesAcrossFields) {
  msg::ReadParamsExt2 params;
  const auto orders = [&] {
    Violations found;
    for (const ViolationCopy& violation : violations_of(params)) {
      if (violation.rule == Rule::order) found.push_back(violation);
    }
    return found;
  };
  params.frame_cam_angle_min.pitch = msg::Degrees(-30);
  params.frame_cam_angle_max.pitch = msg::Degrees(-30);
  EXPECT_EQ(orders(), Violations{});
  params.frame_cam_angle_max.pitch = msg::Degrees(-31);
  EXPECT_EQ(orders(), (Violations{{"frame_cam_angle_min.pitch", -30, -31, Rule::order}}));
}

TEST(Validate, Minimum) {
  msg::BeepSound message = good_beep();
  message.note_freq_hz[1] = msg::NoteFrequency(553);
  EXPECT_EQ(violations_of(message), (Violations{{"note_freq_hz[1]", 553, 554, Rule::minimum}}));
  EXPECT_FALSE(is_valid(message));
}

TEST(Validate, MaximumAndSpecialValues) {
  msg::BeepSound message = good_beep();
  message.note_freq_hz[0] = msg::NoteFrequency(msg::BeepSound::pause);
  message.note_length = msg::NoteLength(0);
  EXPECT_EQ(violations_of(message), Violations{}) << "these have another meaning";
  message.note_freq_hz[0] = msg::NoteFrequency(21001);
  message.decay_factor = 16;
  EXPECT_EQ(violations_of(message), (Violations{{"decay_factor", 16, 15, Rule::maximum},
                                                {"note_freq_hz[0]", 21001, 20999, Rule::maximum}}));
}

TEST(Validate, Count) {
  msg::BeepSound message = good_beep();
  while (message.note_freq_hz.size() < 50) message.note_freq_hz.push_back(msg::NoteFrequency(1000));
  EXPECT_EQ(violations_of(message), Violations{});
  message.note_freq_hz.push_back(msg::NoteFrequency(1000));
  EXPECT_EQ(violations_of(message), (Violations{{"note_freq_hz", 51, 50, Rule::count}}));
}

TEST(Validate, FewestElements) {
  msg::ApiVirtChControl message;
  EXPECT_EQ(violations_of(message), (Violations{{"val_ch", 0, 1, Rule::count}}));
  message.val_ch.push_back({});
  EXPECT_EQ(violations_of(message), Violations{});
}

TEST(Validate, Counters) {
  msg::SetAdjVarsVal message;
  EXPECT_EQ(violations_of(message), (Violations{{"num_vars", 0, 1, Rule::minimum}}));
  while (message.params.size() < 41) message.params.push_back({msg::VariableId(19), 1});
  EXPECT_EQ(violations_of(message), (Violations{{"num_vars", 41, 40, Rule::maximum}}));
}

TEST(Validate, Alignment) {
  msg::EepromWrite message;
  message.addr = 128;
  message.data.resize(64);
  EXPECT_EQ(violations_of(message), Violations{});
  message.addr = 130;
  message.data.resize(65);
  EXPECT_EQ(violations_of(message),
            (Violations{{"addr", 130, 64, Rule::alignment}, {"data", 65, 64, Rule::alignment}}));
}

TEST(Validate, PathsThroughAxesAndLists) {
  msg::ReadParams3 params;
  params.axis_top = msg::SensorAxis::z;
  const auto before = violations_of(params);
  params.axes.pitch.invert = 2;
  params.rc.yaw.rc_follow = -128;
  params.servo_out[3] = 33;
  Violations added;
  for (const ViolationCopy& violation : violations_of(params)) {
    if (std::find(before.begin(), before.end(), violation) == before.end()) {
      added.push_back(violation);
    }
  }
  EXPECT_EQ(added, (Violations{{"axes.pitch.invert", 2, 1, Rule::maximum},
                               {"rc.yaw.rc_follow", -128, -127, Rule::minimum},
                               {"servo_out[3]", 33, 32, Rule::maximum}}));
}

// The limits of an adjustable variable depend on its id.
TEST(Validate, PathsIntoRecords) {
  msg::SetAdjVarsVal message;
  for (int i = 0; i < 3; ++i) message.params.push_back({msg::VariableId(0), 255});
  message.params.push_back({msg::VariableId(0), 256});
  EXPECT_EQ(violations_of(message),
            (Violations{{"params[3].param_value", 256, 255, Rule::maximum}}));
}

TEST(Validate, OptionalMembersOnlyWhenTheyAreThere) {
  msg::RealtimeDataCustom message;
  EXPECT_EQ(violations_of(message), Violations{});
  message.z1_vector = Xyz<float>{0, -1.5F, 1};
  EXPECT_EQ(violations_of(message), (Violations{{"z1_vector.y", -1.5, -1, Rule::minimum}}));
}

TEST(Validate, NotANumberAndInfinity) {
  msg::RealtimeDataCustom message;
  constexpr float infinity = std::numeric_limits<float>::infinity();
  message.z1_vector = Xyz<float>{std::nanf(""), infinity, -infinity};
  const Violations violations = violations_of(message);
  ASSERT_EQ(violations.size(), 3U);
  EXPECT_EQ(violations[0].path, "z1_vector.x");
  EXPECT_TRUE(std::isnan(violations[0].value));
  EXPECT_EQ(violations[1].rule, Rule::maximum);
  EXPECT_EQ(violations[2].rule, Rule::minimum);
}

// Reserved bytes, unknown flags and unknown enum values are reserved for later firmware.
TEST(Validate, TheUnknownIsNotRejected) {
  msg::BeepSound message = good_beep();
  message.reserved.fill(0xFF);
  message.mode = msg::BeepModes(0x4000);
  EXPECT_TRUE(is_valid(message));
  msg::BoardInfo info;
  info.tail.resize(9);
  EXPECT_TRUE(is_valid(info));
  msg::Confirm confirm;
  confirm.cmd = static_cast<msg::CommandToBoard>(200);
  EXPECT_TRUE(is_valid(confirm));
}

TEST(Validate, WhatAnOlderBoardDoesNotKnow) {
  msg::ReadParams3 params;
  params.pwm_freq = msg::PwmFrequency::ultra_high;
  const auto reported = [&](const Availability& versions) {
    bool result = false;
    validate(params, versions, [&](const Violation& violation) {
      result |= std::string("pwm_freq") == violation.field.name && violation.rule == Rule::board &&
                violation.limit == 30;
    });
    return result;
  };
  EXPECT_TRUE(reported({2400, 10}));
  EXPECT_FALSE(reported({2400, 30}));
  EXPECT_FALSE(reported(newest));
}

TEST(Validate, FlagsThatOlderFirmwareDoesNotKnow) {
  msg::RealtimeDataCustomRequest request;
  const auto valid_for = [&](std::uint16_t firmware) {
    return validate(request, {firmware, 31}, [](const Violation&) {});
  };
  request.flags.set(msg::RealtimeDataCustomFlag::imu_angles);
  EXPECT_TRUE(valid_for(2679));
  request.flags.set(msg::RealtimeDataCustomFlag::encoder_raw24);
  EXPECT_FALSE(valid_for(2679));
  EXPECT_TRUE(valid_for(2680));
}

TEST(Validate, EveryDefaultMessageGivesTheSameReportTwice) {
  for (const MessageType* const type : message_types()) {
    auto message = type->make();
    EXPECT_EQ(violations_of(message), violations_of(message)) << type->info->name;
    for (const ViolationCopy& violation : violations_of(message)) {
      EXPECT_FALSE(violation.path.empty());
      EXPECT_STRNE(name(violation.rule), "unknown_rule");
    }
  }
}

TEST(FieldPath, IsCutOffSafely) {
  const FieldPath params{nullptr, "params"};
  const FieldPath element{&params, "", 120};
  const FieldPath id{&element, "param_id"};
  const std::string full = "params[120].param_id";
  for (std::size_t space = 0; space <= full.size() + 3; ++space) {
    char out[64];
    std::memset(out, '#', sizeof out);
    const std::size_t length = id.write(out, space);
    if (space == 0) {
      EXPECT_EQ(out[0], '#');
      continue;
    }
    EXPECT_EQ(length, std::min(space - 1, full.size()));
    EXPECT_EQ(std::string(out), full.substr(0, space - 1));
    EXPECT_EQ(out[space], '#') << "written past the end";
  }
}

TEST(FieldPath, Indices) {
  for (const std::size_t index : {0U, 9U, 10U, 99U, 100U, 254U, 1000000007U}) {
    const FieldPath list{nullptr, "x"};
    const FieldPath element{&list, "", index};
    char out[32];
    element.write(out, sizeof out);
    EXPECT_EQ(std::string(out), "x[" + std::to_string(index) + "]");
  }
}

}  // namespace
}  // namespace sbgc::test
