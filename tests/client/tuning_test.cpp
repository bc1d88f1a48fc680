// The automatic tuning of the controllers, in virtual time.

#include <optional>

#include <gtest/gtest.h>

#include <sbgc/client/tuning.hpp>

#include "virtual_client.hpp"

namespace sbgc::test {
namespace {

TEST(Tuning, ReportsItsProgressUntilItsEnd) {
  VirtualClient client;
  std::optional<msg::AutoPid> last;
  const auto tuned = client.run(tasks::run_tuning(tuning_request({.axes = {.pitch = true}}),
                                                  {.progress = [&](const auto& report) {
                                                    last = report;
                                                    return true;
                                                  }}));
  ASSERT_TRUE(tuned) << tuned.error().message;
  ASSERT_TRUE(last);
  EXPECT_GT(last->iter_num, 1);
  EXPECT_FALSE(*client.run(tasks::is_tuning()));
}

TEST(Tuning, IsEndedAfterACancellation) {
  VirtualClient client;
  const auto tuned = client.run(tasks::run_tuning(
      tuning_request({}), {.progress = [&](const auto& report) { return !report; }}));
  ASSERT_FALSE(tuned);
  EXPECT_EQ(tuned.error().code, ErrorCode::cancelled);
  EXPECT_TRUE(client.run(tasks::end_tuning()));
  EXPECT_FALSE(*client.run(tasks::is_tuning()));
}

}  // namespace
}  // namespace sbgc::test
