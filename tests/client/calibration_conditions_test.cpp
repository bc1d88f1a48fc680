// Preconditions of calibrations, and automatic tuning of the controllers, in virtual time.

#include <sbgc/client/readiness.hpp>
#include <sbgc/client/tuning.hpp>

#include "testing.hpp"
#include "virtual_client.hpp"

namespace sbgc::test {
namespace {

class ReadinessTest : public testing::Test {
 public:
  ReadinessTest() {
    client.pass(seconds(4));  // the camera comes to rest
  }

 protected:
  bool are_motors_on() {
    const auto ask = []() -> Task<Result<msg::RealtimeData3>> {
      co_return co_await tasks::call(msg::RealtimeData3Request{});
    };
    return client.run(ask())->other_flags.has(msg::OtherFlag::motors_on);
  }

  VirtualClient client;
};

TEST_F(ReadinessTest, AnAnswerMayComeLater) {
  std::string reason;
  std::function<void(bool)> answer;
  ReadinessOptions options{.conditions = {.motors_off = true, .one_side_up = true}};
  options.ask = [&](const Question& question, std::function<void(bool)> given) {
    EXPECT_EQ(question.kind, Question::Kind::turn_motors_off);
    reason = question.reason;
    answer = std::move(given);
  };
  std::optional<Result<Readiness>> found;
  client.start(tasks::check_readiness(options),
               [&](Result<Readiness> one) { found = std::move(one); });
  client.pass(seconds(60));
  EXPECT_EQ(reason, "the motors are on");
  ASSERT_FALSE(found);
  EXPECT_TRUE(are_motors_on());
  answer(true);
  client.pass(seconds(6));
  ASSERT_TRUE(found && *found);
  EXPECT_EQ((*found)->problem, "");
  EXPECT_EQ((*found)->side, 2U);
  EXPECT_FALSE(are_motors_on());
}

TEST_F(ReadinessTest, NoIsAProblem) {
  ReadinessOptions options{.conditions = {.motors_off = true}};
  EXPECT_EQ(client.run(tasks::check_readiness(options))->problem, "the motors are on");
  options.ask = [](const Question&, const std::function<void(bool)>& answer) { answer(false); };
  EXPECT_EQ(client.run(tasks::check_readiness(options))->problem, "the motors are on");
  EXPECT_TRUE(are_motors_on());
}

TEST_F(ReadinessTest, EachSideOnce) {
  const ReadinessOptions options{.conditions = {.one_side_up = true}, .sides = {2}};
  EXPECT_THAT(client.run(tasks::check_readiness(options))->problem, HasSubstr("was up before"));
}

TEST_F(ReadinessTest, AVoltageThatIsFarFromTheMeasuredOne) {
  const ReadinessOptions options{.conditions = {.near_voltage = true}, .voltage = 126};
  EXPECT_THAT(client.run(tasks::check_readiness(options))->problem, HasSubstr("from 126.00 V"));
}

TEST(Tuning, ReportsItsProgressUntilItsEnd) {
  VirtualClient client;
  std::optional<msg::AutoPid> last;
  require(client.run(tasks::run_tuning(tuning_request({.axes = {.pitch = true}}),
                                       {.progress = [&](const auto& report) {
                                         last = report;
                                         return true;
                                       }})));
  ASSERT_TRUE(last);
  EXPECT_GT(last->iter_num, 1);
  EXPECT_FALSE(*client.run(tasks::is_tuning()));
}

TEST(Tuning, IsEndedAfterACancellation) {
  VirtualClient client;
  EXPECT_THAT(client.run(tasks::run_tuning(
                  tuning_request({}), {.progress = [&](const auto& report) { return !report; }})),
              fails(ErrorCode::cancelled));
  EXPECT_TRUE(client.run(tasks::end_tuning()));
  EXPECT_FALSE(*client.run(tasks::is_tuning()));
}

}  // namespace
}  // namespace sbgc::test
