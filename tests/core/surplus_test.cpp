// Tests of requests with surplus: bytes after the largest form.

#include <gtest/gtest.h>

#include <sbgc/meta/all.hpp>
#include <sbgc/surplus.hpp>

#include "messages.hpp"

namespace sbgc::test {
namespace {

// Requests themselves have no tail.
static_assert(sizeof(msg::ServoOut) == msg::ServoOut::max_size);
static_assert(!takes_surplus<msg::Control>, "a longer body is another form");
static_assert(takes_surplus<msg::ControlExt>);
static_assert(!takes_surplus<msg::GetAngles>, "it keeps a tail itself");
static_assert(!takes_surplus<msg::WriteParams3>, "it keeps a tail itself");
static_assert(!takes_surplus<msg::BeepSound>, "it ends in a list");

static_assert([] {
  constexpr std::array<std::uint8_t, 3> body{2, 7, 8};
  WithSurplus<msg::MotorsOffExt> request;
  std::array<std::uint8_t, 3> out{};
  return decode(body, request) && request.mode == msg::MotorsOffMode::safe_stop &&
         request.tail.size() == 2 && encode(request, out).size == 3 && out == body;
}());

TEST(Surplus, IsAnErrorOfARequestAlone) {
  AllMessages::for_each([]<class M>(Type<M>) {
    if constexpr (takes_surplus<M>) {
      SCOPED_TRACE(Meta<M>::info.name);
      const std::array<std::uint8_t, max_body_size> body{};
      for (const std::size_t size : {M::max_size + 1, max_body_size}) {
        M request;
        const Status status = decode(std::span(body).first(size), request);
        EXPECT_EQ(status.code, Code::too_long);
        WithSurplus<M> whole;
        EXPECT_TRUE(decode(std::span(body).first(size), whole));
        EXPECT_EQ(whole.tail.size(), size - status.offset);
        EXPECT_EQ(body_of(whole).size(), size);
      }
    }
  });
}

TEST(Surplus, BeginsAfterTheLargestFormOfTheFirmware) {
  constexpr std::uint8_t motors_off = 109, field_offset = 27, control = 67, beep = 89, unknown = 1;
  EXPECT_EQ(largest_request(motors_off, {2686, 30}), 0U);
  EXPECT_EQ(largest_request(motors_off, {2687, 30}), 1U);
  EXPECT_EQ(largest_request(field_offset, {2625, 30}), 0U);
  EXPECT_EQ(largest_request(field_offset, {2626, 30}), 6U);
  EXPECT_EQ(largest_request(field_offset, newest), 14U);
  EXPECT_EQ(largest_request(control, {2430, 30}), 13U);
  EXPECT_EQ(largest_request(control, newest), 15U);
  EXPECT_EQ(largest_request(beep, newest), max_body_size);
  EXPECT_EQ(largest_request(unknown, newest), max_body_size);
}

TEST(Surplus, IsNotWrittenWhereItWouldBeReadOtherwise) {
  std::array<std::uint8_t, max_body_size> out{};
  WithSurplus<msg::ControlExtCommand> none_controlled;
  ASSERT_TRUE(none_controlled.tail.resize(30));
  EXPECT_EQ(encode(none_controlled, out).status.code, Code::presence_mismatch);
  ASSERT_TRUE(none_controlled.tail.resize(31));
  EXPECT_EQ(encode(none_controlled, out).size, msg::ControlExtCommand::max_size + 1);

  WithSurplus<msg::EncodersCalibOffset4> without_motor;
  ASSERT_TRUE(without_motor.tail.resize(9));
  const Status status = encode(without_motor, out).status;
  EXPECT_EQ(status.code, Code::presence_mismatch);
  EXPECT_STREQ(status.field, "tail");
}

TEST(Surplus, NeedsRoom) {
  WithSurplus<msg::MotorsOn> request;
  ASSERT_TRUE(request.tail.resize(3));
  std::array<std::uint8_t, max_frame_size> out{};
  EXPECT_EQ(encode(request, std::span(out).first(2)).status.code, Code::buffer_too_small);
  EXPECT_EQ(encode(request, std::span(out).first(3)).size, 3U);
  EXPECT_EQ(encode_frame(request, out).size, frame_size<basic_framing>(3));
}

TEST(Surplus, KeepsTheContextOfItsRequest) {
  constexpr std::uint8_t custom = 88;
  std::array<std::uint8_t, 12> body{0x10};
  Contexts contexts;
  const auto learn = [&](const auto& message) { contexts.learn(without_surplus(message)); };
  EXPECT_TRUE(visit_received(custom, body, Direction::to_board, learn));
  EXPECT_EQ(contexts.realtime_data_custom.flags.raw(), 0x10U);
}

}  // namespace
}  // namespace sbgc::test
