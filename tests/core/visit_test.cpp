// Tests of visit() with visitors that accept only some messages.

#include <array>
#include <cstdint>
#include <span>

#include <gtest/gtest.h>

#include <sbgc/message.hpp>
#include <sbgc/parser.hpp>
#include <sbgc/visit.hpp>

namespace sbgc::test {
namespace {

/// A message as a frame.
class Framed {
 public:
  template <class M>
  explicit Framed(const M& message) : written_(encode_frame(message, bytes_)) {
    Parser parser;
    parser.feed({bytes_.data(), written_.size}, [this](const Frame& found) {
      frame_ = found;
      frame_.body = std::span(bytes_).subspan(frame_header_size, found.body.size());
    });
  }
  Framed(const Framed&) = delete;
  Framed& operator=(const Framed&) = delete;
  Framed(Framed&&) = delete;
  Framed& operator=(Framed&&) = delete;
  ~Framed() = default;

  const Frame& operator*() const { return frame_; }

 private:
  std::array<std::uint8_t, max_frame_size> bytes_{};
  WriteResult written_;
  Frame frame_;
};

const msg::Control moved{.control_mode = msg::ControlMode::angle,
                         .axes = {.yaw = {.angle = 45_deg}}};

TEST(Visit, APlainLambdaGetsItsMessage) {
  const Framed frame(moved);
  int calls = 0;
  const Status status = visit(*frame, Direction::to_board, [&](const msg::Control& control) {
    EXPECT_EQ(control, moved);
    ++calls;
  });
  EXPECT_TRUE(status);
  EXPECT_EQ(calls, 1);
}

int& calls_of_function() {
  static int calls = 0;
  return calls;
}
void count_read_params(const msg::ReadParams3&) { ++calls_of_function(); }

TEST(Visit, AFunctionGetsExactlyItsMessage) {
  EXPECT_TRUE(visit(*Framed(msg::ReadParams3{}), Direction::from_board, count_read_params));
  EXPECT_EQ(calls_of_function(), 1);
  // WriteParams3 derives from ReadParams3.
  EXPECT_TRUE(visit(*Framed(msg::WriteParams3{}), Direction::to_board, count_read_params));
  EXPECT_TRUE(visit(*Framed(msg::WriteParams3{}), Direction::to_board, &count_read_params));
  EXPECT_EQ(calls_of_function(), 1);
}

TEST(Visit, WhatNobodyAcceptsIsNotDecoded) {
  const std::array<std::uint8_t, 3> cut{};
  const auto never = [](const msg::GetAngles&) { FAIL(); };
  EXPECT_EQ(visit(73, cut, Direction::from_board, never).code, Code::too_short);
  EXPECT_TRUE(visit(73, cut, Direction::from_board, [](const msg::Confirm&) { FAIL(); }));
  EXPECT_EQ(visit(67, cut, Direction::to_board, never).code, Code::unknown_form);
  EXPECT_EQ(visit(0, cut, Direction::to_board, never).code, Code::unknown_command);
}

TEST(Visit, SeveralLambdas) {
  int controls = 0;
  int angles = 0;
  int others = 0;
  const auto on_control = [&](const msg::Control&) { ++controls; };
  const auto on_angles = [&](const msg::GetAngles&) { ++angles; };
  const auto on_other = [&](const auto&) { ++others; };
  const Framed control(moved);
  const Framed motors(msg::MotorsOn{});

  EXPECT_TRUE(visit(*control, Direction::to_board, on_control, on_angles));
  EXPECT_TRUE(visit(*motors, Direction::to_board, on_control, on_angles));
  EXPECT_TRUE(visit(*Framed(msg::GetAngles{}), Direction::from_board, on_control, on_angles));
  EXPECT_EQ(controls, 1);
  EXPECT_EQ(angles, 1);

  EXPECT_TRUE(visit(*control, Direction::to_board, on_control, on_angles, on_other));
  EXPECT_TRUE(visit(*motors, Direction::to_board, on_control, on_angles, on_other));
  EXPECT_EQ(controls, 2);
  EXPECT_EQ(others, 1);

  const auto all = overloaded{on_control, on_angles, on_other};
  EXPECT_TRUE(visit(*control, Direction::to_board, all));
  EXPECT_TRUE(visit(*motors, Direction::to_board, overloaded{on_control, on_other}));
  EXPECT_EQ(controls, 3);
  EXPECT_EQ(others, 2);
}

// WriteParams3 is derived from ReadParams3: they share a body.
TEST(Visit, AMessageDerivedFromAnotherIsAnotherOne) {
  const Framed write(msg::WriteParams3{});
  int reads = 0;
  int writes = 0;
  int others = 0;
  const auto on_read = [&](const msg::ReadParams3&) { ++reads; };
  const auto on_write = [&](msg::WriteParams3) noexcept { ++writes; };
  const auto on_other = [&](const auto&) { ++others; };
  EXPECT_TRUE(visit(*write, Direction::to_board, on_read));
  EXPECT_TRUE(visit(*write, Direction::to_board, on_read, on_other));
  EXPECT_TRUE(visit(*write, Direction::to_board, on_read, on_write));
  EXPECT_EQ(reads, 0);
  EXPECT_EQ(writes, 1);
  EXPECT_EQ(others, 1);
}

TEST(Visit, AVisitorMayHaveAStateOfItsOwn) {
  struct Counter {
    int controls = 0;
    int motors = 0;
    void operator()(const msg::Control&) { ++controls; }
    void operator()(const msg::MotorsOn&) { ++motors; }
  };
  Counter counter;
  EXPECT_TRUE(visit(*Framed(moved), Direction::to_board, counter));
  EXPECT_TRUE(visit(*Framed(msg::MotorsOn{}), Direction::to_board, counter));
  EXPECT_TRUE(visit(*Framed(msg::MotorsOff{}), Direction::to_board, counter));
  EXPECT_EQ(counter.controls, 1);
  EXPECT_EQ(counter.motors, 1);

  auto mutable_lambda = [calls = 0](const msg::Control&) mutable { EXPECT_EQ(++calls, 1); };
  EXPECT_TRUE(visit(*Framed(moved), Direction::to_board, mutable_lambda));
}

TEST(Visit, AVisitorMayOverwriteTheBody) {
  std::array<std::uint8_t, max_body_size> body{};
  const std::size_t size = encode(moved, body).size;
  msg::Control seen{};
  const Status status =
      visit(static_cast<std::uint8_t>(msg::Control::command), std::span(body).first(size),
            Direction::to_board, [&](const msg::Control& control) {
              body.fill(0xFF);
              seen = control;
            });
  EXPECT_TRUE(status);
  EXPECT_EQ(seen, moved);
}

TEST(Visit, ContextsReachALambda) {
  msg::RealtimeDataCustomRequest request;
  request.flags = msg::RealtimeDataCustomFlag::imu_angles;
  Contexts contexts;
  contexts.learn(request);
  const std::array<std::uint8_t, 8> body{0x10, 0x27, 1, 0, 2, 0, 3, 0};
  int calls = 0;
  const auto look = [&](const msg::RealtimeDataCustom& data) {
    ++calls;
    ASSERT_TRUE(data.imu_angles);
    EXPECT_EQ(data.imu_angles->yaw.raw(), 3);
  };
  EXPECT_TRUE(visit(88, body, Direction::from_board, look, contexts));
  EXPECT_EQ(calls, 1);
}

}  // namespace
}  // namespace sbgc::test
