// Tests of messages as JSON: the round trip is lossless, and invalid JSON is rejected. The same
// with text and with values of nlohmann_json.

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>

#include <gtest/gtest.h>

#include <sbgc/json.hpp>
#include <sbgc/meta/all.hpp>

#include "messages.hpp"

namespace sbgc::test {
namespace {

class JsonOfMessage : public testing::TestWithParam<const MessageType*> {};

TEST_P(JsonOfMessage, ComesBackAsTheSameBytes) {
  RandomBodies bodies(17);
  const std::size_t min_size = GetParam()->info->min_size;
  int checked = 0;
  for (std::size_t i = 0; i < 6000 && checked < 60; ++i) {
    const std::size_t more = is_of_fixed_size(*GetParam()) && i % 4 != 0 ? 0 : i % 200;
    const ByteVector body = bodies.next(std::min(min_size + more, max_body_size));
    auto message = GetParam()->make();
    if (!message.decode(body, random_contexts(i))) continue;
    ++checked;
    const std::string text = message.to_json(Secrets::shown);
    ASSERT_EQ(Json::parse(text), dom_of(message)) << text;
    auto copy = GetParam()->make();
    read_dom(Json::parse(text), copy);
    ASSERT_EQ(encoded_body(copy), body) << text;
    auto by_text = GetParam()->make();
    ASSERT_TRUE(by_text.from_json(text)) << text;
    ASSERT_EQ(encoded_body(by_text), body) << text;
  }
  EXPECT_GE(checked, 8);
}

TEST_P(JsonOfMessage, HasEveryMemberOrIsRefused) {
  auto message = GetParam()->make();
  const Json full = dom_of(message);
  ASSERT_TRUE(full.is_object());
  read_dom(full, message);

  Json extra = full;
  extra["nonsense"] = 1;
  EXPECT_THROW(read_dom(extra, message), JsonError);
  EXPECT_THROW(read_dom(Json::array(), message), JsonError);
  EXPECT_THROW(read_dom(Json(), message), JsonError);

  for (const auto& item : full.items()) {
    Json missing = full;
    missing.erase(item.key());
    Json wrong = full;
    wrong[item.key()] = true;
    EXPECT_THROW(read_dom(wrong, message), JsonError) << item.key();
    try {
      read_dom(missing, message);
      // Only a counter can be derived from another field.
      EXPECT_TRUE(item.value().is_number_unsigned()) << item.key();
    } catch (const JsonError& error) {
      EXPECT_EQ(error.field(), item.key());
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Messages, JsonOfMessage, testing::ValuesIn(message_types()),
                         [](const auto& test) { return test.param->info->name; });

Json control_json() {
  return Json::parse(R"({"control_mode": 2, "axes": {
      "roll": {"speed": 1, "angle": -2}, "pitch": {"speed": 3, "angle": -4},
      "yaw": {"speed": 5, "angle": -6}}})");
}

/// Returns the message and the field of the error for which `json` is rejected.
template <class M>
std::string refusal(const Json& json) {
  M message{};
  const M before = message;
  const JsonResult by_text = from_json(json.dump(), message);
  try {
    from_dom(json, message);
  } catch (const JsonError& error) {
    EXPECT_EQ(message, before) << "the message was modified";
    EXPECT_TRUE(by_text.problem);
    EXPECT_EQ(by_text.problem.value_or(JsonProblem{}).field, error.field());
    EXPECT_TRUE(
        std::string(error.what()).ends_with(by_text.problem.value_or(JsonProblem{}).reason));
    EXPECT_EQ(std::string(error.what()).find(error.field()), 0U);
    return error.field() + "|" + error.what();
  }
  EXPECT_TRUE(by_text);
  return "accepted";
}

std::string refused_control(const std::string& pointer, const Json& value) {
  Json json = control_json();
  json[Json::json_pointer(pointer)] = value;
  return refusal<msg::Control>(json);
}

bool is_about(const std::string& refusal, const std::string& field, const std::string& words) {
  return refusal.starts_with(field + "|") && refusal.find(words) != std::string::npos;
}

TEST(Json, NestsAsTheStructDoes) {
  msg::Control message;
  from_dom(control_json(), message);
  EXPECT_EQ(message.control_mode.raw(), 2);
  EXPECT_EQ(message.axes.roll.speed.raw(), 1);
  EXPECT_EQ(message.axes.yaw.angle.raw(), -6);
  EXPECT_EQ(to_dom(message), control_json());
}

TEST(Json, NamesTheFieldAndTheReason) {
  EXPECT_PRED3(is_about, refused_control("/axes/pitch/angle", 32768), "axes.pitch.angle",
               "32768 does not fit: -32768 to 32767");
  EXPECT_PRED3(is_about, refused_control("/axes/pitch/angle", -32769), "axes.pitch.angle",
               "does not fit");
  EXPECT_PRED3(is_about, refused_control("/control_mode", -1), "control_mode", "does not fit");
  EXPECT_PRED3(is_about, refused_control("/control_mode", 256), "control_mode", "does not fit");
  EXPECT_PRED3(is_about, refused_control("/control_mode", ~std::uint64_t{0}), "control_mode",
               "18446744073709551615 does not fit");
  EXPECT_PRED3(is_about, refused_control("/control_mode", 1.0), "control_mode", "integer");
  EXPECT_PRED3(is_about, refused_control("/control_mode", "2"), "control_mode", "integer");
  EXPECT_PRED3(is_about, refused_control("/axes/roll", 1), "axes.roll", "object");
  EXPECT_PRED3(is_about, refused_control("/axes/rol", 1), "axes.rol", "unknown");
  Json json = control_json();
  json["axes"]["yaw"].erase("speed");
  EXPECT_PRED3(is_about, refusal<msg::Control>(json), "axes.yaw.speed", "missing");
}

TEST(Json, Bytes) {
  Json json = to_dom(msg::BeepSound{});
  EXPECT_EQ(json["reserved"], "0000000000000000");
  json["reserved"] = "0123456789ABCDEF";
  msg::BeepSound message;
  from_dom(json, message);
  EXPECT_EQ(message.reserved[7], 0xEF);
  EXPECT_EQ(to_dom(message)["reserved"], "0123456789abcdef");
  for (const char* const wrong :
       {"", "0", "00", "0123456789abcde", "0123456789abcdefab", "0123456789abcdeg",
        " 123456789abcdef", "-123456789abcdef", "0x23456789abcdef"}) {
    json["reserved"] = wrong;
    EXPECT_PRED3(is_about, refusal<msg::BeepSound>(json), "reserved", "hex") << wrong;
  }
  Json tail = to_dom(msg::BoardInfo{});
  EXPECT_FALSE(tail.contains("tail"));
  tail["tail"] = std::string(474, 'f');
  msg::BoardInfo info;
  from_dom(tail, info);
  EXPECT_EQ(info.tail.size(), 237U);
  tail["tail"] = std::string(476, 'f');
  EXPECT_PRED3(is_about, refusal<msg::BoardInfo>(tail), "tail", "at most 237");
}

TEST(Json, Lists) {
  Json json = to_dom(msg::BeepSound{});
  json["note_freq_hz"] = std::vector<int>(121, 1000);
  msg::BeepSound message;
  from_dom(json, message);
  EXPECT_EQ(message.note_freq_hz.size(), 121U);
  json["note_freq_hz"] = std::vector<int>(122, 1000);
  EXPECT_PRED3(is_about, refusal<msg::BeepSound>(json), "note_freq_hz", "at most 121");
  json["note_freq_hz"] = {1, "2"};
  EXPECT_PRED3(is_about, refusal<msg::BeepSound>(json), "note_freq_hz[1]", "integer");
  json["note_freq_hz"] = Json::object();
  EXPECT_PRED3(is_about, refusal<msg::BeepSound>(json), "note_freq_hz", "list");
}

TEST(Json, CountersAgreeWithTheirLists) {
  const Json params = Json::parse(R"([{"param_id": 1, "param_value": -5}])");
  msg::SetAdjVarsVal message;
  from_dom(Json{{"num_vars", 1}, {"params", params}}, message);
  EXPECT_EQ(message.params.size(), 1U);
  EXPECT_EQ(to_dom(message), (Json{{"num_vars", 1}, {"params", params}}));
  from_dom(Json{{"params", params}}, message);
  const Json wrong{{"num_vars", 2}, {"params", params}};
  EXPECT_PRED3(is_about, refusal<msg::SetAdjVarsVal>(wrong), "num_vars", "2 is announced");
}

TEST(Json, OptionalMembersAreLeftOut) {
  msg::Confirm message;
  message.cmd = msg::CommandToBoard::eeprom_write;
  EXPECT_EQ(to_dom(message).dump(), R"({"cmd":47,"data":""})");
  message.addr = 64;
  EXPECT_EQ(to_dom(message).dump(), R"({"cmd":47,"addr":64,"data":""})");
  msg::Confirm copy;
  from_dom(to_dom(message), copy);
  EXPECT_EQ(copy, message);
}

TEST(Json, FloatsKeepEveryBit) {
  for (const std::uint32_t bits :
       {0x00000000U, 0x80000000U, 0x00000001U, 0x807FFFFFU, 0x7F7FFFFFU, 0x3DCCCCCDU, 0x7F800000U,
        0xFF800000U, 0x7FC00000U, 0xFFC00001U, 0x7F800001U, 0xFFFFFFFFU}) {
    msg::RealtimeDataCustom message;
    message.z1_vector = Xyz<float>{std::bit_cast<float>(bits), 0, 0};
    message.h1_vector = Xyz<float>{};
    msg::RealtimeDataCustom copy;
    from_dom(Json::parse(to_dom(message).dump()), copy);
    ASSERT_TRUE(copy.z1_vector);
    EXPECT_EQ(std::bit_cast<std::uint32_t>(copy.z1_vector->x), bits) << to_dom(message).dump();
    msg::RealtimeDataCustom by_text;
    ASSERT_TRUE(from_json(to_json(message), by_text));
    EXPECT_EQ(std::bit_cast<std::uint32_t>(by_text.z1_vector->x), bits) << to_json(message);
  }
}

TEST(Json, FloatsThatAreNone) {
  Json json = Json::parse(R"({"timestamp_ms": 0, "z1_vector": {"x": 0, "y": 0, "z": 0}})");
  EXPECT_EQ(refusal<msg::RealtimeDataCustom>(json), "accepted") << "an integer is a number";
  for (const Json& wrong :
       {Json(1e39), Json(-1e39), Json("NaN"), Json("nan"), Json("nan:7f800000"),
        Json("nan:7fc0000"), Json("nan:7fc0000g"), Json(""), Json(), Json(true)}) {
    json["z1_vector"]["x"] = wrong;
    EXPECT_PRED3(is_about, refusal<msg::RealtimeDataCustom>(json), "z1_vector.x", "number")
        << wrong;
  }
}

std::string text_after_round_trip(const std::string& bytes) {
  msg::ReadProfileNames message;
  EXPECT_TRUE(message.profile_name[0].assign(bytes));
  const std::string printed = to_dom(message).dump();  // throws if it is not UTF-8
  msg::ReadProfileNames copy;
  from_dom(Json::parse(printed), copy);
  msg::ReadProfileNames by_text;
  EXPECT_TRUE(from_json(printed, by_text));
  EXPECT_EQ(by_text, copy);
  EXPECT_EQ(to_json(message), detail::json_text(Json::parse(printed)));
  return {copy.profile_name[0].data(), copy.profile_name[0].size()};
}

TEST(Json, TextsKeepEveryByte) {
  for (const std::string& bytes :
       {std::string("plain"), std::string("\xC3\xA4\xE2\x82\xAC\xF0\x9F\x98\x80"),  //
        std::string("\xFF\xFE"), std::string("\x80"), std::string("\xC3"), std::string("\xC0\x80"),
        std::string("\xED\xA0\x80"), std::string("\xF4\x90\x80\x80"), std::string("\xE2\x82"),
        std::string("\xEF\x9E\x80"), std::string("\xEF\x9F\xBF"), std::string("\xEF\x9E"),
        std::string("a\0b", 3), std::string("\"\\\n\x01")}) {
    EXPECT_EQ(text_after_round_trip(bytes), bytes);
  }
  std::string all;
  for (int byte = 255; byte > 0; --byte) all += static_cast<char>(byte);
  for (std::size_t at = 0; at < all.size(); at += 48) {
    EXPECT_EQ(text_after_round_trip(all.substr(at, 48)), all.substr(at, 48));
  }
}

TEST(Json, HidesSecretsUnlessTheyAreToBeShown) {
  msg::BoardInfoRequestExt message;
  EXPECT_EQ(to_json(message), R"({"cfg":0,"reserved":""})");
  ASSERT_TRUE(message.password.emplace().assign(std::string_view("sesame")));
  EXPECT_EQ(to_json(message), R"--({"cfg":0,"password":"(hidden)","reserved":""})--");
  EXPECT_EQ(to_dom(message).dump(), to_json(message));
  EXPECT_EQ(to_string(message), "BoardInfoRequestExt{cfg = 0 ms, password = (hidden)}");
  const std::string shown = to_json(message, Secrets::shown);
  EXPECT_EQ(shown, R"({"cfg":0,"password":"sesame","reserved":""})");

  msg::BoardInfoRequestExt copy;
  ASSERT_TRUE(from_json(shown, copy));
  EXPECT_EQ(copy, message);
  const JsonResult hidden = from_json(to_json(message), copy);
  ASSERT_FALSE(hidden);
  EXPECT_EQ(hidden.problem->field, "password");
  EXPECT_EQ(hidden.problem->reason, "it is hidden; the secret itself is needed");

  const msg::PassProtectWrite kept;  // an empty password is none
  EXPECT_EQ(to_json(kept), R"({"flags":0,"reserved":"00000000","new_password":""})");
}

TEST(Json, TextsThatDoNotFit) {
  Json json = to_dom(msg::ReadProfileNames{});
  json["profile_name"][2] = std::string(48, 'x');
  EXPECT_EQ(refusal<msg::ReadProfileNames>(json), "accepted");
  json["profile_name"][2] = std::string(49, 'x');
  EXPECT_PRED3(is_about, refusal<msg::ReadProfileNames>(json), "profile_name[2]", "at most 48");
  json["profile_name"][2] = 7;
  EXPECT_PRED3(is_about, refusal<msg::ReadProfileNames>(json), "profile_name[2]", "string");
  json["profile_name"][2] = "x";
  json["profile_name"].erase(4);
  EXPECT_PRED3(is_about, refusal<msg::ReadProfileNames>(json), "profile_name", "list of 5");
}

}  // namespace
}  // namespace sbgc::test
