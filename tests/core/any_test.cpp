// Tests of messages whose type is known only at run time, apart from what round_trip_test.cpp and
// json_test.cpp do with every message.

#include <utility>
#include <variant>

#include <gtest/gtest.h>

#include <sbgc/json.hpp>
#include <sbgc/meta/all.hpp>
#include <sbgc/text.hpp>
#include <sbgc/value_text.hpp>

#include "messages.hpp"

namespace sbgc::test {
namespace {

TEST(AnyMessage, TypesAreFoundByName) {
  std::set<std::string> names;
  for (const MessageType* const type : message_types()) {
    EXPECT_TRUE(names.insert(type->info->name).second) << type->info->name;
    EXPECT_EQ(find_message(type->info->name), type);
  }
  EXPECT_EQ(find_message("Nothing"), nullptr);
  EXPECT_EQ(find_message(Direction::from_board, 0, 0), nullptr);
}

TEST(ParseValue, QuantitiesOf64BitsEndWhereTheWireDoes) {
  constexpr UnitInfo metres{.name = "m", .denominator = 1000};
  FieldType type{.shape = FieldShape::integer};
  type.size = 8;
  const auto raw_of = [&](std::string_view text) -> std::string {
    const ParsedValue parsed = parse_value(type, &metres, text);
    if (!parsed) return parsed.problem;
    const std::int64_t raw = std::get<std::int64_t>(parsed.value);
    return type.is_wide ? std::to_string(static_cast<std::uint64_t>(raw)) : std::to_string(raw);
  };
  const auto is_refused = [&](std::string_view text) {
    return raw_of(text).find("does not fit") != std::string::npos;
  };
  type.is_wide = true;
  EXPECT_EQ(raw_of("1.5 m"), "1500");
  EXPECT_EQ(raw_of("9223372036854775.808"), "9223372036854775808");
  EXPECT_EQ(raw_of("raw:18446744073709551615"), "18446744073709551615");
  EXPECT_TRUE(is_refused("18446744073709551.616 m"));
  EXPECT_TRUE(is_refused("-1 m"));
  EXPECT_TRUE(is_refused("raw:-1"));
  type.is_wide = false;
  type.lowest = std::numeric_limits<std::int64_t>::min();
  type.highest = std::numeric_limits<std::int64_t>::max();
  EXPECT_EQ(raw_of("-9223372036854775.808"), "-9223372036854775808");
  EXPECT_TRUE(is_refused("9223372036854775.808"));
}

TEST(AnyMessage, CopiesAreIndependent) {
  AnyMessage message = find_message("BoardInfo")->make();
  AnyMessage copy = message;
  EXPECT_TRUE(copy == message);
  message.get_if<msg::BoardInfo>()->board_ver = msg::BoardVersion(30);
  EXPECT_FALSE(copy == message);
  copy = message;
  EXPECT_TRUE(copy == message);
  const AnyMessage moved = std::move(message);
  EXPECT_TRUE(copy == moved);
  message = moved;  // assigned to after the move
  EXPECT_TRUE(message == moved);
  EXPECT_FALSE(message == find_message("Control")->make());
}

TEST(AnyMessage, JsonIsReadInPlaceOrNotAtAll) {
  AnyMessage any = find_message("GetAngles")->make();
  const auto* const message = any.get_if<msg::GetAngles>();
  msg::GetAngles other;
  other.axes.yaw.imu_angle = msg::Angle14(2048);
  ASSERT_TRUE(any.from_json(to_json(other)));
  EXPECT_EQ(any.get_if<msg::GetAngles>(), message);
  EXPECT_EQ(*message, other);
  std::string incomplete = to_json(msg::GetAngles{});
  incomplete.replace(incomplete.rfind("target_angle"), 1, "T");
  EXPECT_FALSE(any.from_json(incomplete));
  EXPECT_EQ(*message, other);
}

TEST(AnyMessage, IsTheMessageOfItsType) {
  AnyMessage message = find_message("GetAngles")->make();
  EXPECT_EQ(message.get_if<msg::Control>(), nullptr);
  message.get_if<msg::GetAngles>()->axes.yaw.imu_angle = msg::Angle14(2048);
  EXPECT_EQ(to_string(message), to_string(*message.get_if<msg::GetAngles>()));
  EXPECT_EQ(to_string(find_message("MotorsOn")->make()), "MotorsOn{}");
}

/// Returns the value at a path as text, or "-".
std::string value_at(const AnyMessage& message, std::string_view path) {
  std::string result = "-";
  message.with_leaf(path, [&](const Leaf& leaf) { result = value_text(leaf); });
  return result;
}

TEST(AnyMessage, ValuesAreAssignedFromText) {
  AnyMessage control = find_message("ControlExt")->make();
  EXPECT_EQ(control.assign("axes.pitch.angle", "-30deg"), "");
  EXPECT_EQ(value_at(control, "axes.pitch.angle"), "-29.9927 deg") << "the nearest";
  EXPECT_EQ(control.assign("axes.pitch.angle", "raw:16384"), "");
  EXPECT_EQ(value_at(control, "axes.pitch.angle"), "360 deg");

  AnyMessage variables = find_message("SetAdjVarsVal")->make();
  EXPECT_EQ(variables.assign("params[1].param_id", "lpf_freq_roll"), "");
  EXPECT_EQ(variables.assign("params[1].param_value", "30Hz"), "");
  EXPECT_EQ(value_at(variables, "params[1].param_value"), "30 Hz");
  EXPECT_EQ(variables.get_if<msg::SetAdjVarsVal>()->params.size(), 2U);

  AnyMessage sound = find_message("BeepSound")->make();
  EXPECT_EQ(sound.assign("note_freq_hz", "600, 700"), "");
  EXPECT_EQ(value_at(sound, "note_freq_hz[1]"), "700 Hz");
  EXPECT_EQ(sound.assign("note_freq_hz", "600"), "");
  EXPECT_EQ(value_at(sound, "note_freq_hz[1]"), "-");
  EXPECT_TRUE(sound.has("note_freq_hz") && sound.has("note_freq_hz[0]"));
  EXPECT_FALSE(sound.has("note_freq_hz[1]") || sound.has("note_freq") || sound.has("note"));
  EXPECT_TRUE(sound.add("note_freq_hz[2]") && sound.has("note_freq_hz[2]"));
  EXPECT_FALSE(sound.add("note"));
}

TEST(ParseValue, FlagsHaveTheSignOfTheirType) {
  FieldType type;
  type.shape = FieldShape::integer;
  type.size = 1;
  type.names = &EnumMeta<msg::ConnectionFlag>::info;
  const auto parsed = [&](const char* text, std::int64_t lowest) {
    type.lowest = lowest;
    type.highest = lowest + 255;
    return std::get<std::int64_t>(parse_value(type, nullptr, text).value);
  };
  EXPECT_EQ(parsed("CONNECTION_USB|126", -128), 127);
  EXPECT_EQ(parsed("CONNECTION_USB|128", -128), -127);
  EXPECT_EQ(parsed("CONNECTION_USB|254", 0), 255);
}

TEST(AnyMessage, APackedQuaternionTakesItsComponents) {
  AnyMessage message = find_message("ControlQuatAttitudePacked")->make();
  const auto after = [&](const char* text) {
    EXPECT_EQ(message.assign("target_attitude", text), "");
    return message.get_if<msg::ControlQuatAttitudePacked>()->target_attitude.raw();
  };
  // Sign and magnitude, in units of 1/741453.785976.
  constexpr std::uint64_t minus = 1U << 19U;
  EXPECT_EQ(after("a:-5"), minus + 5);
  EXPECT_EQ(after("a:5"), 5U);
  EXPECT_EQ(after("b:-7"), (minus + 7) * 0x100000U + 5);
  EXPECT_EQ(after("b:0, largest_sign:1"), (std::uint64_t{1} << 62U) + 5);
  EXPECT_EQ(after("a:0.5"), (std::uint64_t{1} << 62U) + 370727);
  for (const char* text : {"a:524288", "a:-524288", "a:1e30", "a:-1e30"}) {
    EXPECT_NE(message.assign("target_attitude", text).find("does not fit into 'a'"),
              std::string::npos);
  }
}

TEST(AnyMessage, ANumberHasTheTypeThatItsTextNames) {
  AnyMessage variables = find_message("DebugVars3")->make();
  const auto bytes_of = [&](const char* text) {
    EXPECT_EQ(variables.assign("var_value[0]", text), "");
    return encoded_body(variables);
  };
  EXPECT_EQ(bytes_of("u8:255"), ByteVector{255});
  EXPECT_EQ(bytes_of("i8:-5"), ByteVector{251});
  EXPECT_EQ(bytes_of("i16:-2"), (ByteVector{254, 255}));
  EXPECT_EQ(bytes_of("f32:1.5"), (ByteVector{0, 0, 0xC0, 0x3F}));
  for (const char* text : {"u8:256", "u8:-1", "i8:128", "i16:-32769", "u32:4294967296"}) {
    EXPECT_EQ(variables.assign("var_value[0]", text),
              std::string("var_value[0]: ") + text + " does not fit");
  }
}

TEST(AnyMessage, WhatAMessageCanLackIsAddedFoundAndRemoved) {
  AnyMessage motors = find_message("ExtMotorsControl")->make();
  EXPECT_FALSE(motors.has("setpoint16"));
  EXPECT_TRUE(motors.add("setpoint16"));
  EXPECT_TRUE(motors.has("setpoint16")) << "a list without elements";
  EXPECT_TRUE(motors.set("setpoint16", std::int64_t{2}));
  EXPECT_TRUE(motors.has("setpoint16[1]") && !motors.has("setpoint16[2]"));
  EXPECT_TRUE(motors.remove("setpoint16"));
  EXPECT_TRUE(motors == find_message("ExtMotorsControl")->make());

  AnyMessage control = find_message("Control")->make();
  EXPECT_TRUE(control.has("axes") && control.has("axes.roll") && control.has("axes.roll.angle"));
  EXPECT_FALSE(control.has("axes.roll.angles") || control.has("axes.tilt"));
  EXPECT_FALSE(control.remove("axes.roll.angle") || control.remove("axes.tilt"));
  EXPECT_TRUE(control.set("axes.roll.angle", std::int64_t{7}));
  EXPECT_EQ(control.get_if<msg::Control>()->axes.roll.angle.raw(), 7);
  EXPECT_FALSE(control.set("axes.roll.angle", 7.0) || control.set("axes.roll", std::int64_t{7}));
}

TEST(AnyMessage, EveryValueIsAssignedFromItsOwnText) {
  RandomBodies bodies(3);
  std::size_t assigned = 0;
  for (const MessageType* const type : message_types()) {
    for (std::size_t i = 0; i < 4; ++i) {
      AnyMessage message = type->make();
      const std::size_t more = is_of_fixed_size(*type) ? 0 : 7 * i;
      if (!message.decode(bodies.next(type->info->min_size + more), random_contexts(i))) continue;
      AnyMessage copy = message;
      message.for_each_leaf([&](const Leaf& leaf) {
        const bool is_exact = leaf.kind == LeafKind::integer || leaf.kind == LeafKind::bytes;
        if (!is_exact || leaf.announced != NumberType::none || leaf.is_u64) return;
        const std::string path = to_string(leaf.path);
        const std::string text = (leaf.kind == LeafKind::integer ? "raw:" : "") + raw_text(leaf);
        const std::string problem = copy.assign(path, text);
        // Random values need not be valid, but all others can be assigned.
        if (problem.empty()) ++assigned;
        EXPECT_TRUE(problem.empty() || !message.validate(newest, [](const Violation&) {}))
            << type->info->name << ' ' << problem;
      });
      EXPECT_EQ(encoded_body(copy), encoded_body(message)) << type->info->name;
    }
  }
  EXPECT_GT(assigned, 5000U);
}

TEST(AnyMessage, KnowsWhetherItHoldsASecret) {
  AnyMessage message = find_message("BoardInfoRequestExt")->make();
  EXPECT_FALSE(message.holds_secret());
  EXPECT_EQ(message.assign("password", "sesame"), "");
  EXPECT_TRUE(message.holds_secret());
  EXPECT_EQ(message.to_json().find("sesame"), std::string::npos);
  EXPECT_NE(message.to_json(Secrets::shown).find("sesame"), std::string::npos);
  EXPECT_EQ(to_string(message).find("sesame"), std::string::npos);

  const auto holds = [](std::uint8_t id, const ByteVector& body) {
    return holds_secret(Direction::to_board, id, body);
  };
  EXPECT_TRUE(holds(86, {0, 0, 3, 'a', 'b', 'c'}));
  // A request for the version may have any body: only a text that is all that is left is one.
  for (const ByteVector& other : {ByteVector{},
                                  {0, 0},
                                  {0, 0, 0},
                                  {0, 0, 4, 'a', 'b', 'c'},
                                  {0, 0, 2, 'a', 'b', 'c'},
                                  {0, 1, 2, 3, 4}}) {
    EXPECT_FALSE(holds(86, other));
  }
  EXPECT_TRUE(holds(137, {0, 0, 0, 0, 0, 0, 0, 0, 1, 'a'}));
  EXPECT_TRUE(holds(137, {0, 0, 0, 0, 0, 0, 0, 0, 9, 'a'})) << "it may be a part of one";
  EXPECT_FALSE(holds(137, {0, 0, 0, 0, 0, 0, 0, 0, 0}));
  EXPECT_FALSE(holds(73, {}));
}

}  // namespace
}  // namespace sbgc::test
