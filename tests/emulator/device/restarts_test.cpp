// Tests of restarts: their duration and what is lost.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sbgc/roles.hpp>

#include "host.hpp"

namespace sbgc::test {
namespace {

using ::testing::SizeIs;

bool answers(Host& host) { return host.ask(msg::BoardInfoRequest{}, milliseconds(2)).size() == 1; }

/// Returns how long the board does not respond from now on.
Duration silence(Host& host) {
  const Instant begin = host.now;
  while (!answers(host) && host.now - begin < seconds(60)) {
  }
  return host.now - begin;
}

TEST(Restart, ABoardThatStartsIsSilent) {
  emulator::BoardOptions options;
  options.start_time = milliseconds(300);
  emulator::Board board(options, {}, {});
  EXPECT_EQ(board.next(), Instant{} + options.start_time);
  Host host(options);
  host.ask(msg::ResetRequest{}, milliseconds(1));
  const Duration length = silence(host);
  EXPECT_GT(length, milliseconds(298));
  EXPECT_LT(length, milliseconds(304));
  EXPECT_EQ(host.board.counters().restarts, 1U);
}

TEST(Restart, TheBootloaderGivesUp) {
  emulator::BoardOptions options;
  options.bootloader_time = seconds(3);
  Host host(options);
  const msg::BootMode3Ext request{.confirm = msg::ResetOption::notify};
  EXPECT_THAT(all<msg::Reset>(host.ask(request, milliseconds(5))), SizeIs(1));
  EXPECT_GT(silence(host), seconds(3) + options.start_time - milliseconds(10));
  EXPECT_TRUE(answers(host));
}

TEST(Restart, OfTheBoardItselfIsAnnouncedToAll) {
  Host host;
  const auto other = host.board.open_port().value();
  const auto packets =
      host.ask(msg::ExecuteMenu{.cmd_id = msg::MenuCommand::reset}, milliseconds(10));
  EXPECT_THAT(all<msg::Reset>(packets), SizeIs(1));
  EXPECT_FALSE(host.board.output(other).empty());
  host.listen(milliseconds(roles::reset_delay_ms - 20));
  EXPECT_EQ(host.board.counters().restarts, 0U);
  host.listen(milliseconds(20));
  EXPECT_EQ(host.board.counters().restarts, 1U);
}

TEST(Restart, PowerOffLosesWhatWaitsToBeSent) {
  Host host;
  host.send(msg::BoardInfoRequest{});
  host.board.advance(host.now + milliseconds(10));
  host.board.restart(host.now + milliseconds(10));
  EXPECT_TRUE(host.board.output(host.port).empty());
  EXPECT_FALSE(answers(host));
}

/// The setting applies to all profiles, regardless of the profile it is written with.
std::uint8_t profile_after_restart(bool is_remembered, std::uint8_t written) {
  Host host;
  host.ask(msg::ExecuteMenu{.cmd_id = msg::MenuCommand::profile3});
  auto parameters = host.get<msg::ReadParams3>(msg::ReadParams3Request{.profile_id = written});
  parameters.general_flags1.set(msg::GeneralFlag::remember_last_used_profile, is_remembered);
  host.ask(msg::WriteParams3{parameters});
  host.ask(msg::ResetRequest{}, seconds(1));
  return host.get<msg::RealtimeData3>(msg::RealtimeData3Request{}).cur_profile;
}

TEST(Restart, TheLastProfileIsRememberedIfTheSettingsWantThat) {
  for (const std::uint8_t written : {std::uint8_t{0}, std::uint8_t{2}, std::uint8_t{4}}) {
    EXPECT_EQ(profile_after_restart(true, written), 2);
    EXPECT_EQ(profile_after_restart(false, written), 0);
  }
}

}  // namespace
}  // namespace sbgc::test
