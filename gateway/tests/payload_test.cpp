// Topics and payloads of commands, and the queue for a slow broker.

#include "gateway/payload.hpp"

#include <initializer_list>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "gateway/admission.hpp"
#include "gateway/outbox.hpp"

namespace sbgc::tools {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

const Topics topics("studio");

std::string command_of(const std::string& topic) {
  const auto command = topics.command(topic);
  return command ? command->gimbal + ' ' + command->task : "";
}

TEST(Topics, commands) {
  EXPECT_EQ(command_of("sbgc/studio/front/cmd/move"), "front move");
  EXPECT_EQ(command_of("sbgc/studio/front/raw"), "front raw");
}

TEST(Topics, what_is_no_command) {
  for (const char* const topic :
       {"", "sbgc/studio/", "sbgc/studio/front", "sbgc/studio/front/", "sbgc/studio/front/cmd",
        "sbgc/studio/front/cmd/", "sbgc/studio/front/cmd/move/", "sbgc/studio/front/raw/",
        "sbgc/studio//cmd/move", "sbgc/other/front/cmd/move", "sbgc/studio/front/state",
        "xsbgc/studio/front/cmd/move"}) {
    EXPECT_EQ(command_of(topic), "") << topic;
  }
}

TEST(Topics, replies) {
  EXPECT_TRUE(topics.is_reply("sbgc/studio/reply/app"));
  EXPECT_TRUE(topics.is_reply("sbgc/studio/reply/app/7"));
  for (const char* const topic :
       {"", "sbgc/studio/reply/", "sbgc/studio/front/cmd/move", "sbgc/studio/reply/#",
        "sbgc/studio/reply/+", "sbgc/studio/reply/a\n", "sbgc/other/reply/app",
        // Brokers reject some Unicode characters, and disconnect clients that publish them.
        "sbgc/studio/reply/\xEF\xBF\xBF"}) {
    EXPECT_FALSE(topics.is_reply(topic)) << topic;
  }
  EXPECT_TRUE(topics.is_reply("sbgc/studio/reply" + std::string(29, '/') + 'a'));
  EXPECT_FALSE(topics.is_reply("sbgc/studio/reply" + std::string(200, '/') + 'a'));
  EXPECT_FALSE(topics.is_reply("sbgc/studio/reply/" + std::string(300, 'a')));
}

CommandPayload read(const std::string& text) {
  CommandPayload payload;
  read_payload(text, topics, payload);
  return payload;
}

TEST(Payload, everything) {
  const CommandPayload payload = read(
      R"({"version": 1, "key": "k", "reply": "sbgc/studio/reply/a", "correlation": "7ä",
          "deadline": 1700000000123, "parameters": {"angles": {"yaw": 1}}})");
  EXPECT_EQ(payload.key, "k");
  EXPECT_EQ(payload.reply, "sbgc/studio/reply/a");
  EXPECT_EQ(payload.correlation, "7ä");
  EXPECT_EQ(payload.deadline->time_since_epoch(), std::chrono::milliseconds(1700000000123));
  EXPECT_EQ(payload.parameters["angles"]["yaw"], 1);
}

TEST(Payload, the_least) {
  const CommandPayload payload = read(R"({"version": 1})");
  EXPECT_EQ(payload.key, "");
  EXPECT_FALSE(payload.deadline);
  EXPECT_TRUE(payload.parameters.empty());
}

TEST(Payload, what_is_refused) {
  for (const auto& [text, problem] : std::initializer_list<std::pair<std::string, const char*>>{
           {"", "no JSON"},
           {"[]", "must be a JSON object"},
           {"{}", "'version' must be 1"},
           {R"({"version": 2})", "'version' must be 1"},
           {R"({"version": "1"})", "'version' must be 1"},
           {R"({"version": 1, "key": ""})", "'key' must be 1 to 128 bytes"},
           {R"({"version": 1, "key": 5})", "'key' must be a string"},
           {R"({"version": 1, "key": "a\u0000b"})", "without control characters"},
           {R"({"version": 1, "reply": "sbgc/studio/front/cmd/move"})", "'reply' must be a topic"},
           {R"({"version": 1, "deadline": -1})", "'deadline' must be Unix time"},
           {R"({"version": 1, "deadline": 1.5})", "'deadline' must be Unix time"},
           {R"({"version": 1, "deadline": 18446744073709551615})", "'deadline' must be Unix time"},
           {R"({"version": 1, "sent": -1})", "'sent' must be Unix time"},
           {R"({"version": 1, "parameters": []})", "'parameters' must be an object"},
           {R"({"version": 1, "version": 1})", "occurs twice"},
           {R"({"version": 1, "dead_line": 1})", "unknown key 'dead_line'"},
           {std::string(longest_payload + 1, ' '), "longer than"},
           {std::string(40, '['), "nested deeper"}}) {
    const auto reading = [&text = text] { read(text); };
    EXPECT_THAT(reading, ThrowsMessage<Refusal>(HasSubstr(problem))) << text;
  }
}

TEST(Payload, a_refusal_knows_where_to_go) {
  CommandPayload payload;
  EXPECT_THROW(read_payload(R"({"version": 9, "x": 1, "key": "k", "reply": "sbgc/studio/reply/a"})",
                            topics, payload),
               Refusal);
  EXPECT_EQ(payload.key, "k");
  EXPECT_EQ(payload.reply, "sbgc/studio/reply/a");
}

TEST(Payload, a_stop_needs_nothing) {
  const std::string reply = R"("reply": "sbgc/studio/reply/a")";
  for (const auto& [text, ignored] :
       std::initializer_list<std::pair<std::string, std::vector<std::string>>>{
           {"", {}},
           {"{}", {}},
           {R"({"version": 1, "key": "k"})", {}},
           {"stop", {"the payload is no JSON: this is not JSON, at line 1, column 1"}},
           {"5", {"the payload must be a JSON object"}},
           {R"({"version": 2})", {"'version' must be 1"}},
           {R"({"parameters": {"x": 1}})", {"unknown parameter 'x'"}},
           {R"({"key": 5, "speed": 1, "parameters": 2})",
            {"'key' must be a string", "unknown key 'speed'", "'parameters' must be an object"}}}) {
    CommandPayload payload;
    EXPECT_EQ(read_stop_payload(text, topics, payload), ignored) << text;
  }
  CommandPayload payload;
  EXPECT_EQ(read_stop_payload(R"({"x": 0, "key": "", )" + reply + '}', topics, payload).size(), 2U);
  EXPECT_EQ(payload.reply, "sbgc/studio/reply/a");
  std::string many = "{";
  for (int i = 0; i < 1000; ++i) many += fmt::format(R"("{}": 0, )", i);
  EXPECT_LT(read_stop_payload(many + reply + '}', topics, payload).size(), 20U);
}

TEST(LatestByTopic, the_newest_of_each_topic_wins) {
  LatestByTopic newest;
  EXPECT_TRUE(newest.put("a", "1"));
  EXPECT_FALSE(newest.put("b", "2"));
  EXPECT_FALSE(newest.put("a", "3"));
  EXPECT_EQ(newest.thinned(), 1U);
  EXPECT_EQ(newest.take()->payload, "3");
  EXPECT_FALSE(newest.put("a", "4"));
  EXPECT_EQ(newest.take()->payload, "2");
  EXPECT_EQ(newest.take()->payload, "4");
  EXPECT_FALSE(newest.take());
  EXPECT_TRUE(newest.put("a", "5"));
}

TEST(Keys, what_is_one) {
  EXPECT_TRUE(is_key("desk-17"));
  EXPECT_FALSE(is_key(""));
  EXPECT_FALSE(is_key("\n"));
  EXPECT_FALSE(is_key("\xFF"));
  EXPECT_FALSE(is_key(std::string(129, 'a')));
}

TEST(RateLimiter, it_comes_back_with_time) {
  using std::chrono::milliseconds;
  const RateLimiter::Time start = RateLimiter::Time() + std::chrono::hours(1);
  RateLimiter allowance(2, 3);
  for (int i = 0; i < 3; ++i) EXPECT_TRUE(allowance.take(start));
  EXPECT_FALSE(allowance.take(start));
  EXPECT_FALSE(allowance.take(start + milliseconds(400)));
  EXPECT_TRUE(allowance.take(start + milliseconds(500)));
  EXPECT_FALSE(allowance.take(start + milliseconds(900)));
  EXPECT_TRUE(allowance.take(start + std::chrono::hours(1)));
}

}  // namespace
}  // namespace sbgc::tools
