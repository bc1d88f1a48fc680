// Tests of messages whose type is known only at run time, apart from what round_trip_test.cpp and
// json_test.cpp do with every message.

#include <array>
#include <cstdint>
#include <set>
#include <string>
#include <utility>

#include <gtest/gtest.h>

#include <sbgc/any.hpp>
#include <sbgc/message.hpp>
#include <sbgc/meta/all.hpp>
#include <sbgc/text.hpp>

#include "messages.hpp"

namespace sbgc::test {
namespace {

TEST(AnyMessage, TypesAreFoundByNameAndByBody) {
  std::set<std::string> names;
  for (const MessageType* const type : message_types()) {
    EXPECT_TRUE(names.insert(type->info->name).second) << type->info->name;
    EXPECT_EQ(find_message(type->info->name), type);
  }
  EXPECT_EQ(find_message("Nothing"), nullptr);
  EXPECT_EQ(find_message(Direction::to_board, 67, 13), find_message("Control"));
  EXPECT_EQ(find_message(Direction::to_board, 67, 15), find_message("ControlExt"));
  EXPECT_EQ(find_message(Direction::to_board, 67, 20), find_message("ControlExt"))
      << "with surplus";
  EXPECT_EQ(find_message(Direction::to_board, 67, 14), nullptr);
  EXPECT_EQ(find_message(Direction::from_board, 0, 0), nullptr);
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

TEST(AnyMessage, IsTheMessageOfItsType) {
  AnyMessage message = find_message("GetAngles")->make();
  EXPECT_EQ(message.get_if<msg::Control>(), nullptr);
  message.get_if<msg::GetAngles>()->axes.yaw.imu_angle = msg::Angle14(2048);
  EXPECT_EQ(to_string(message), to_string(*message.get_if<msg::GetAngles>()));
  EXPECT_EQ(to_string(find_message("MotorsOn")->make()), "MotorsOn{}");
}

TEST(AnyMessage, WhatNoFrameCanCarryIsAnError) {
  AnyMessage message = find_message("WriteFile")->make();
  auto& file = *message.get_if<msg::WriteFile>();
  ASSERT_TRUE(file.data.resize(file.data.capacity()));
  std::array<std::uint8_t, max_frame_size> frame{};
  const WriteResult whole = message.encode_frame(basic_framing, frame);
  ASSERT_TRUE(whole);
  for (std::size_t size = 0; size < whole.size; ++size) {
    const auto out = std::span(frame).first(size);
    EXPECT_EQ(message.encode_frame(basic_framing, out).status.code, Code::buffer_too_small);
  }
}

}  // namespace
}  // namespace sbgc::test
