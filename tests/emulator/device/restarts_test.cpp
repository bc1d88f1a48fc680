// Tests of restarts: their duration and what is lost.

#include "host.hpp"

namespace sbgc::test {
namespace {

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

TEST(Restart, PowerOffLosesWhatWaitsToBeSent) {
  Host host;
  host.send(msg::BoardInfoRequest{});
  host.board.advance(host.now + milliseconds(10));
  host.board.restart(host.now + milliseconds(10));
  EXPECT_TRUE(host.board.output(host.port).empty());
  EXPECT_FALSE(answers(host));
}

}  // namespace
}  // namespace sbgc::test
