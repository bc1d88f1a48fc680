// Tests of dispatch: the message of a frame by id, direction and size.

#include <algorithm>
#include <array>
#include <cstddef>
#include <fstream>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include <sbgc/meta/enums.hpp>

#include "messages.hpp"

namespace sbgc::test {
namespace {

const Json& model() {
  static const Json json = [] {
    std::ifstream file(SBGC_GENERATED "/simplebgc.json");
    return Json::parse(file);
  }();
  return json;
}

std::string name_of(Direction direction) {
  return direction == Direction::to_board ? "to_board" : "from_board";
}

/// Returns the forms of a command in one direction from the exported model.
std::vector<Json> forms(Direction direction, int id) {
  std::vector<Json> result;
  for (const Json& message : model()["messages"]) {
    const auto its = message["direction"].get<std::string>();
    if (message["id"] == id && (its == name_of(direction) || its == "both")) {
      result.push_back(message);
    }
  }
  return result;
}

/// Returns the expected result of select(), computed from the exported model.
std::string expected(const std::vector<Json>& forms, std::size_t size) {
  if (forms.empty()) return name(Code::unknown_command);
  if (forms.size() == 1) return forms[0]["name"];
  for (const Json& form : forms) {
    if (size >= form["min_size"] && size <= form["max_size"]) return form["name"];
  }
  // Decoding limits a list only by the size of the body; other limits are up to validation. A
  // larger form is the limit of a smaller one.
  std::size_t largest = 0;
  for (const Json& form : forms) largest = std::max(largest, form["max_size"].get<std::size_t>());
  for (const Json& form : forms) {
    if (form["max_size"] < largest) continue;
    const Json& layout = form["layout"];
    const bool open =
        form["keeps_tail"].get<bool>() || (!layout.empty() && layout.back()["count"].is_null());
    if (open && size > form["max_size"]) return form["name"];
  }
  return name(Code::unknown_form);
}

class EveryDirection : public testing::TestWithParam<Direction> {};

TEST_P(EveryDirection, SelectKnowsEveryIdAndSize) {
  for (int id = 0; id < 256; ++id) {
    const std::vector<Json> its_forms = forms(GetParam(), id);
    for (std::size_t size = 0; size <= max_body_size; ++size) {
      const Selected result = selected(GetParam(), static_cast<std::uint8_t>(id), size);
      const std::string actual = result.info == nullptr ? name(result.code) : result.info->name;
      ASSERT_EQ(actual, expected(its_forms, size)) << "id " << id << ", " << size << " bytes";
      ASSERT_EQ(result.code == Code::ok, result.info != nullptr);
    }
  }
}

TEST_P(EveryDirection, VisitHandsOverEveryMessage) {
  for (const MessageType* const type : message_types()) {
    SCOPED_TRACE(type->info->name);
    if (type->info->direction != GetParam() && type->info->direction != Direction::both) continue;
    ByteVector body = encoded_body(type->make());
    body.resize(std::max(body.size(), type->info->min_size));  // a list may have a minimum length
    Contexts contexts;  // of two messages of one size, the request decides
    for (const MessageType* const request : message_types()) {
      const auto answers = request->info->answers;
      const bool asks = answers.size() == 1 && answers[0] == std::string_view(type->info->name);
      if (asks) request->make().teach(contexts);
    }
    const Visited result = visited(type->info->id, body, GetParam(), contexts);
    ASSERT_TRUE(result.status) << name(result.status.code);
    EXPECT_EQ(result.calls, 1);
    EXPECT_EQ(result.info, type->info);
  }
}

TEST_P(EveryDirection, VisitIsSilentWhenABodyDoesNotDecode) {
  for (const MessageType* const type : message_types()) {
    SCOPED_TRACE(type->info->name);
    if (type->info->direction != GetParam() && type->info->direction != Direction::both) continue;
    for (std::size_t size = 0; size <= max_body_size; ++size) {
      const ByteVector body(size, 0xFF);
      const Visited result = visited(type->info->id, body, GetParam());
      ASSERT_EQ(result.calls, result.status ? 1 : 0) << size << " bytes";
      if (size >= type->info->min_size || result.status.code == Code::unknown_form) continue;
      ASSERT_TRUE(result.calls == 1 || result.status.code == Code::too_short) << size;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Directions, EveryDirection,
                         testing::Values(Direction::to_board, Direction::from_board),
                         [](const auto& test) { return name_of(test.param); });

TEST(Dispatch, TheModelAndTheCodecHaveTheSameMessages) {
  std::set<std::string> in_model;
  for (const Json& message : model()["messages"]) in_model.insert(message["name"]);
  std::set<std::string> in_codec;
  for (const MessageType* const type : message_types()) in_codec.emplace(type->info->name);
  EXPECT_EQ(in_codec, in_model);
}

/// A switch over all commands of a direction compiles only with unique ids.
template <class Command>
constexpr bool ids_are_unique() {
  std::array<bool, 256> seen{};
  for (const ValueInfo& command : EnumMeta<Command>::values) {
    if (std::exchange(seen[static_cast<std::size_t>(command.value)], true)) return false;
  }
  return true;
}
static_assert(ids_are_unique<msg::CommandToBoard>());
static_assert(ids_are_unique<msg::CommandFromBoard>());
static_assert(msg::Control::command == msg::CommandToBoard::control);
static_assert(msg::Confirm::command == msg::CommandFromBoard::confirm);
static_assert(static_cast<int>(msg::Control::command) == static_cast<int>(msg::Confirm::command));

// Only the request determines which blocks the response contains.
TEST(Dispatch, LiveDataAreReadAsTheyWereAskedFor) {
  msg::RealtimeDataCustomRequest request;
  request.flags =
      msg::RealtimeDataCustomFlag::target_speed | msg::RealtimeDataCustomFlag::gyro_data;
  const ByteVector body = from_hex("1027 0100 0200 0300 0400 0500 0600");

  Contexts contexts;
  contexts.learn(msg::Control{});
  EXPECT_EQ(visited(88, body, Direction::from_board, contexts).fields.dump(),
            R"({"timestamp_ms":10000,"tail":"010002000300040005000600"})");

  contexts.learn(request);
  EXPECT_EQ(visited(88, body, Direction::from_board, contexts).fields.dump(),
            R"({"timestamp_ms":10000,"target_speed":{"roll":1,"pitch":2,"yaw":3},)"
            R"("gyro_data":{"roll":4,"pitch":5,"yaw":6}})");

  const std::span<const std::uint8_t> cut = std::span(body).first(13);
  const Visited result = visited(88, cut, Direction::from_board, contexts);
  EXPECT_EQ(result.status.code, Code::too_short);
  EXPECT_STREQ(result.status.field, "gyro_data");
}

// Earlier firmware ignores that its flags are asked for.
TEST(Dispatch, LiveDataWithoutTheFlagsThatWereAskedForAreRead) {
  Contexts contexts;
  contexts.learn(
      msg::RealtimeDataCustomRequest{.flags = msg::RealtimeDataCustomFlag::imu_angles |
                                              msg::RealtimeDataCustomFlag::include_flags});
  EXPECT_EQ(
      visited(88, from_hex("1027 0100 0200 0300"), Direction::from_board, contexts).fields.dump(),
      R"({"timestamp_ms":10000,"imu_angles":{"roll":1,"pitch":2,"yaw":3}})");
}

// A stream request provides the same context if it requests this message.
TEST(Dispatch, StreamsTeachToo) {
  msg::DataStreamInterval request;
  request.cmd_id = msg::CommandFromBoard::realtime_data_custom;
  request.config.flags = msg::RealtimeDataCustomFlags(msg::RealtimeDataCustomFlag::imu_angles);
  Contexts contexts;
  contexts.learn(request);
  EXPECT_TRUE(contexts.realtime_data_custom.flags.has(msg::RealtimeDataCustomFlag::imu_angles));

  msg::DataStreamInterval other;
  other.cmd_id = msg::CommandFromBoard::realtime_data_4;
  contexts.learn(other);
  EXPECT_TRUE(contexts.realtime_data_custom.flags.has(msg::RealtimeDataCustomFlag::imu_angles));
}

}  // namespace
}  // namespace sbgc::test
