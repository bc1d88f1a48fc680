// Tests of the text that says what came instead of a message.

#include <cstdint>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <sbgc/explain.hpp>
#include <sbgc/visit.hpp>

namespace sbgc {
namespace {

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
