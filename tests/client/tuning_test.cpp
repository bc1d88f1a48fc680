// The automatic tuning of the controllers, in virtual time.

#include <sbgc/client/tuning.hpp>

#include "testing.hpp"
#include "virtual_client.hpp"

namespace sbgc::test {
namespace {

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
