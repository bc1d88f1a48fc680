// Tests of messages as JSON: the round trip is lossless, and invalid JSON is rejected. The same
// with text and with values of nlohmann_json.

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

bool is_about(const std::string& refusal, const std::string& field, const std::string& words) {
  return refusal.starts_with(field + "|") && refusal.find(words) != std::string::npos;
}

TEST(Json, BytesAreHexDigitsOfEitherCase) {
  Json json = to_dom(msg::BeepSound{});
  EXPECT_EQ(json["reserved"], "0000000000000000");
  json["reserved"] = "0123456789ABCDEF";
  msg::BeepSound message;
  from_dom(json, message);
  EXPECT_EQ(message.reserved[7], 0xEF);
  EXPECT_EQ(to_dom(message)["reserved"], "0123456789abcdef");
}

TEST(Json, TailsAndListsHaveLimits) {
  Json info = to_dom(msg::BoardInfo{});
  EXPECT_FALSE(info.contains("tail"));
  info["tail"] = std::string(474, 'f');
  EXPECT_EQ(refusal<msg::BoardInfo>(info), "accepted");
  info["tail"] = std::string(476, 'f');
  EXPECT_PRED3(is_about, refusal<msg::BoardInfo>(info), "tail", "at most 237");
  Json sound = to_dom(msg::BeepSound{});
  sound["note_freq_hz"] = std::vector<int>(121, 1000);
  EXPECT_EQ(refusal<msg::BeepSound>(sound), "accepted");
  sound["note_freq_hz"] = std::vector<int>(122, 1000);
  EXPECT_PRED3(is_about, refusal<msg::BeepSound>(sound), "note_freq_hz", "at most 121");
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

}  // namespace
}  // namespace sbgc::test
