// Tests of dispatch: the message of a frame by id, direction and size; and of visit() with visitors
// that accept only some messages.

#include <utility>

#include <gtest/gtest.h>

#include <sbgc/meta/enums.hpp>
#include <sbgc/parser.hpp>
#include <sbgc/visit.hpp>

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
