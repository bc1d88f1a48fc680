// Tests of text output: to_string(), {fmt}, streams, and the text that says what came instead of a
// message.

#include <cstdio>
#include <sstream>

#include <gtest/gtest.h>

#include <sbgc/explain.hpp>
#include <sbgc/fmt.hpp>
#include <sbgc/messages.hpp>
#include <sbgc/ostream.hpp>
#include <sbgc/text/values.hpp>
#include <sbgc/visit.hpp>

#include "messages.hpp"

namespace sbgc {
namespace {

TEST(Text, QuantitiesHaveTheirUnit) {
  EXPECT_EQ(to_string(msg::Angle14(2048)), "45 deg");
  EXPECT_EQ(to_string(msg::Angle14(-1)), "-0.0219727 deg");
  EXPECT_EQ(to_string(msg::Milliseconds(513)), "513 ms");
  EXPECT_EQ(to_string(msg::ControlSpeed(32767)), "4000 deg/s");
}

TEST(Text, EnumsAreTheirNamesOrNumbers) {
  EXPECT_EQ(to_string(msg::ControlModeKind::angle), "MODE_ANGLE");
  EXPECT_EQ(to_string(static_cast<msg::RcModeKind>(7)), "7");
}

TEST(Text, FlagsAreTheirNamesAndTheRest) {
  using Features = decltype(msg::BoardInfo::connection_flags);
  EXPECT_EQ(to_string(Features(1)), "CONNECTION_USB");
  EXPECT_EQ(to_string(Features(0x41)), "CONNECTION_USB | 0x40");
  EXPECT_EQ(to_string(Features(0)), "0");
}

TEST(Text, PackedValuesAreTheirParts) {
  EXPECT_EQ(to_string(msg::ControlMode(130)), "MODE_ANGLE, CONTROL_FLAG_HIGH_RES_SPEED");
  EXPECT_EQ(to_string(msg::RcMode(0)), "RC_MODE_ANGLE, inverted 0");
  EXPECT_EQ(to_string(msg::RcMode(0x0F)), "mode 7, inverted 1") << "7 has no name";
}

TEST(Text, VersionsAreWrittenAsPeopleDo) {
  EXPECT_EQ(to_string(msg::FirmwareVersion(2439)), "2.43b9");
  EXPECT_EQ(to_string(msg::FirmwareVersion(2590)), "2.59");
  EXPECT_EQ(to_string(msg::FirmwareVersion(2305)), "2.30b5");
  EXPECT_EQ(to_string(msg::FirmwareVersion(2729)), "2.72b9");
  EXPECT_EQ(to_string(msg::FirmwareVersion(2730)), "2.73");
  EXPECT_EQ(to_string(msg::FirmwareVersion(2745)), "2.74.5");
  EXPECT_EQ(to_string(msg::FirmwareVersion(0)), "0.00");
  EXPECT_EQ(to_string(msg::BoardVersion(30)), "3.0");
}

TEST(Text, APartOfAMessageHasNoName) {
  msg::ControlAxis axis;
  axis.angle = msg::Angle14(2048);
  EXPECT_EQ(to_string(axis), "{speed = 0 deg/s, angle = 45 deg}");
  EXPECT_EQ(to_string(Axes<msg::Angle14>{axis.angle}),
            "{roll = 45 deg, pitch = 0 deg, yaw = 0 deg}");
}

TEST(Text, TextsAreQuotedAndHarmless) {
  EXPECT_EQ(detail::quoted("Fußgänger \"1\""), "\"Fußgänger \\\"1\\\"\"");
  EXPECT_EQ(detail::quoted("a\x1b[2J\n\t\r\x1f\x7f\xc2\x9f\\"),
            "\"a\\u001b[2J\\n\\t\\r\\u001f\\u007f\\u009f\\\\\"");
  EXPECT_EQ(detail::quoted("\u202Eabc\u2066\u2028\u061C"), R"("\u202eabc\u2066\u2028\u061c")");
  EXPECT_EQ(detail::quoted(" ~\xc2\xa0"), "\" ~\xc2\xa0\"") << "no control characters";
}

/// Compares the text of a number with what printf("%.6g") writes.
void expect_as_printed(double value) {
  const std::string text =
      detail::text_of([&](TextOutput& out) { detail::put_general(out, value); });
  char printed[32];
  std::snprintf(printed, sizeof printed, "%.6g", value);
  ASSERT_EQ(text, printed);
}

TEST(Text, NumbersAreAsPrintfWritesThem) {
  std::mt19937 random(1);
  for (const double scale :
       {1e-6, 1e-4, 1e-3, 1e-2, 0.1, 1.0, 10.0, 360.0 / 16384, 4000.0 / 32767}) {
    for (int i = 0; i < 20'000; ++i) {
      expect_as_printed((static_cast<double>(random()) - 0x8000'0000) * scale);
      expect_as_printed(static_cast<std::int16_t>(random()) * scale);
    }
  }
  // Halves between two results, and numbers that round up to another digit.
  for (int i = 0; i < 100'000; ++i) expect_as_printed(100'000 + i * 0.5);
  for (const double value : {0.0, -0.0, 999999.5, 99999.95, 9.999995, 0.000099999949, 1e-5, 1e6}) {
    expect_as_printed(value);
  }
}

TEST(Text, NumbersWithoutAFractionAreInFull) {
  const auto text = [](double value) {
    return detail::text_of([&](TextOutput& out) { detail::put_number(out, value); });
  };
  EXPECT_EQ(text(123456789), "123456789");
  EXPECT_EQ(text(-999999999999999), "-999999999999999");
  EXPECT_EQ(text(1e15), "1e+15");
  EXPECT_EQ(text(-1e16), "-1e+16");
  EXPECT_EQ(text(1e300), "1e+300");
  EXPECT_EQ(text(1234567.5), "1.23457e+06");
}

TEST(Text, IntegersHaveAllTheirDigits) {
  const auto expect = [](auto number) {
    EXPECT_EQ(detail::text_of([&](TextOutput& out) { out.put(number); }), std::to_string(number));
  };
  for (std::uint32_t number = 0; number < 20'000; ++number) expect(number);
  for (std::uint64_t power = 1;; power *= 10) {
    for (const std::uint64_t number : {power - 1, power, power + 1, 2 * power, 9 * power}) {
      expect(number);
      expect(static_cast<std::int64_t>(number));
      expect(-static_cast<std::int64_t>(number));
    }
    if (power > std::numeric_limits<std::uint64_t>::max() / 10) break;
  }
  for (int bits = 0; bits < 64; ++bits) expect(std::uint64_t{1} << bits);
  expect(std::numeric_limits<std::int64_t>::min());
  expect(std::numeric_limits<std::int8_t>::min());
  expect(std::numeric_limits<std::uint64_t>::max());
}

TEST(Text, FloatsHaveAllTheirDigits) {
  const auto text = [](float value) {
    return detail::real_text(static_cast<double>(value), sizeof value);
  };
  EXPECT_EQ(text(0.1F), "0.1");
  EXPECT_EQ(text(-1.0F), "-1");
  EXPECT_EQ(text(1e-30F), "1e-30");
  EXPECT_EQ(text(0.1F + 1e-8F), "0.10000001");
  EXPECT_EQ(text(std::numeric_limits<float>::infinity()), "inf");
  EXPECT_EQ(text(std::numeric_limits<float>::quiet_NaN()), "nan");
  EXPECT_EQ(detail::real_text(0.1, sizeof(double)), "0.1");
  EXPECT_EQ(detail::real_text(0.1 + 1e-16, sizeof(double)), "0.1000000000000001");
}

TEST(Text, NumbersWithAnAnnouncedTypeAreInThatType) {
  msg::DebugVars3 variables;
  variables.var_value.push_back({NumberType::i8, 0xFB});
  variables.var_value.push_back({NumberType::u8, 0xFB});
  variables.var_value.push_back({NumberType::f32, 0xBFC00000});
  std::vector<std::string> raw;
  for_each_leaf(variables, [&](const Leaf& leaf) { raw.push_back(raw_text(leaf)); });
  EXPECT_EQ(raw, (std::vector<std::string>{"-5", "251", "-1.5"}));
}

TEST(Text, StatusesSayWhichField) {
  EXPECT_EQ(to_string(Status{}), "No error");
  EXPECT_EQ(to_string(Status{Code::too_short, 1, "params"}),
            "params: The body ends before this field does");
  EXPECT_EQ(to_string(Code::too_short), "too_short");
}

template <class M>
std::vector<std::string> violations_in(const M& message, const Availability& versions = newest) {
  std::vector<std::string> result;
  validate(message, versions,
           [&](const Violation& violation) { result.push_back(to_string(violation)); });
  return result;
}
using Sentences = std::vector<std::string>;

TEST(Violations, NaNIsNoNumber) {
  msg::AhrsHelper vectors;
  vectors.z1_vector.x = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(violations_in(vectors).at(0), "z1_vector.x: nan is not a number");
}

TEST(Printing, FmtAndStreamsPrintTheSame) {
  const msg::Angle14 angle(2048);
  const msg::ControlMode mode(2);
  const Status status{Code::too_long};
  std::ostringstream stream;
  stream << angle << '|' << mode << '|' << status << '|' << msg::ControlModeKind::speed << '|'
         << msg::MotorsOn{};
  EXPECT_EQ(fmt::format("{}|{}|{}|{}|{}", angle, mode, status, msg::ControlModeKind::speed,
                        msg::MotorsOn{}),
            stream.str());
  EXPECT_EQ(fmt::format("{:>8}|{:-<8}", angle, Code::ok), "  45 deg|ok------");
  validate(msg::EepromRead{decltype(msg::EepromRead::addr)(7)}, [&](const Violation& violation) {
    EXPECT_EQ(fmt::format("{}", violation), "addr: 7 is not a multiple of 64");
  });
}

TEST(Printing, EveryMessagePrintsItself) {
  AllMessages::for_each([]<class M>(Type<M>) {
    const std::string text = fmt::format("{}", M{});
    EXPECT_EQ(text.substr(0, text.find('{')), Meta<M>::info.name);
    EXPECT_EQ(text.back(), '}');
  });
}

using Body = std::vector<std::uint8_t>;

Body body_of(std::size_t size, Body begin = {}) {
  begin.resize(size);
  return begin;
}

/// Explains why a body from the board does not decode.
std::string explanation(std::uint8_t id, const Body& body, const Contexts& contexts = {}) {
  const Status status = visit(
      id, body, Direction::from_board, [](const auto&) {}, contexts);
  EXPECT_FALSE(status) << static_cast<int>(id);
  return explain(status, Direction::from_board, id, body, contexts);
}

TEST(Explain, SaysWhatAMessageNeeds) {
  EXPECT_EQ(explanation(86, body_of(17)), "17 bytes, the message needs 18");
  EXPECT_EQ(explanation(86, body_of(1)), "1 byte, the message needs 18");
  EXPECT_EQ(explanation(23, body_of(0)), "0 bytes, the message needs 63");
}

TEST(Explain, NamesAFlagOnlyIfNoOtherExplainsTheSize) {
  using Flag = msg::RealtimeDataCustomFlag;
  Contexts contexts;
  const auto custom = [&](msg::RealtimeDataCustomFlags flags, std::size_t size) {
    contexts.learn(msg::RealtimeDataCustomRequest{.flags = flags});
    return explanation(88, body_of(size), contexts);
  };
  const auto encoders = Flag::imu_angles | Flag::rc_data | Flag::encoder_raw24;
  EXPECT_EQ(custom(encoders, 20), "20 bytes, the flags need 29, and 20 without ENCODER_RAW24");
  EXPECT_EQ(custom(encoders, 23), "23 bytes, the flags need 29, and 23 without IMU_ANGLES");
  EXPECT_EQ(custom(encoders, 8), "8 bytes, the flags need 29") << "two are missing";
  EXPECT_EQ(custom(encoders | Flag::acc_data, 29), "29 bytes, the flags need 35")
      << "one of two blocks of the same size";
  // One flag announces two vectors of 12 bytes.
  EXPECT_EQ(custom(Flag::imu_angles | Flag::z1_h1_vectors, 8),
            "8 bytes, the flags need 32, and 8 without Z1_H1_VECTORS");
  EXPECT_EQ(custom(Flag::imu_angles | Flag::z1_h1_vectors, 20), "20 bytes, the flags need 32");
  // More than a body can hold.
  msg::RealtimeDataCustomFlags all;
  for (const ValueInfo& value : EnumMeta<Flag>::info.values) {
    all.set(static_cast<Flag>(value.value));
  }
  EXPECT_EQ(custom(all, 255), "255 bytes, the flags need 418");
}

TEST(Explain, KnowsFlagsOfTheMessageItself) {
  msg::ExtMotorsState state;
  state.data_set = msg::ExtMotorsStateField::torque | msg::ExtMotorsStateField::angle32;
  state.torque.emplace();
  state.angle32.emplace();
  Body body(max_body_size);
  body.resize(encode(state, body).size);
  ASSERT_EQ(body.size(), 11U);
  body.resize(7);
  EXPECT_EQ(explanation(131, body), "7 bytes, the flags need 11, and 7 without ANGLE32");
  body.resize(6);
  EXPECT_EQ(explanation(131, body), "6 bytes, the flags need 11");
}

TEST(Explain, GuessesNoSizeOfLists) {
  EXPECT_EQ(explanation(31, body_of(8, {2})), "8 bytes, the message needs 11")
      << "two are announced";
  EXPECT_EQ(explanation(100, body_of(3)), "3 bytes: rc_val: The body ends before this field does");
}

TEST(Explain, SaysThatABodyIsTooLongOrBetweenForms) {
  EXPECT_EQ(explain({Code::too_long}, Direction::to_board, 21, body_of(3)),
            "3 bytes, the message has 1");
  EXPECT_EQ(explanation(53, body_of(2)),
            "2 bytes: The command has no form with a body of this size");
}

TEST(Explain, ABoardWithoutTheMessageIsNamed) {
  EXPECT_EQ(objection_to(Meta<msg::BeepSound>::info, newest), "");
  EXPECT_EQ(objection_to(Meta<msg::BeepSound>::info, {2430, 36}), "needs firmware 2.59");
  EXPECT_EQ(objection_to(Meta<msg::AutoPidRequest>::info, {2729, 36}), "");
  EXPECT_EQ(objection_to(Meta<msg::AutoPidRequest>::info, {2730, 36}),
            "needs firmware before 2.73");
}

}  // namespace
}  // namespace sbgc
