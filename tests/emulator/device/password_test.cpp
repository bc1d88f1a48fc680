// Tests of a board that wants a password.

#include <cstddef>
#include <string_view>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "replies.hpp"

namespace sbgc::test {
namespace {

using ::testing::IsEmpty;
using ::testing::SizeIs;

emulator::BoardOptions protected_board() {
  emulator::BoardOptions options = newest_board();
  options.password = "sesame";
  return options;
}

msg::BoardInfoRequestExt opening(std::string_view password) {
  msg::BoardInfoRequestExt request;
  EXPECT_TRUE(request.password.emplace().assign(password));
  return request;
}

TEST(Password, NothingIsAnsweredBeforeIt) {
  Host host(protected_board());
  EXPECT_THAT(host.ask(msg::BoardInfoRequest{}), IsEmpty());
  EXPECT_THAT(host.ask(msg::GetAnglesRequest{}), IsEmpty());
  EXPECT_THAT(host.ask(opening("sesam")), IsEmpty());
  EXPECT_THAT(host.ask(opening("sesames")), IsEmpty());
  EXPECT_THAT(host.ask(msg::BoardInfoRequestExt{}), IsEmpty());
  EXPECT_EQ(host.board.counters().sent, 0U);

  host.get<msg::BoardInfo>(opening("sesame"));
  host.get<msg::GetAngles>(msg::GetAnglesRequest{});
  EXPECT_THAT(host.ask(opening("another one")), SizeIs(1)) << "an open port stays open";
}

TEST(Password, NothingIsExecutedBeforeIt) {
  Host host(protected_board());
  std::vector<emulator::Reaction> reactions;
  host.board.on_traffic = [&](const emulator::Board::Traffic& traffic) {
    if (traffic.reaction) reactions.push_back(*traffic.reaction);
  };
  const bool was_on = host.board.gimbal().motors_on();
  host.ask(msg::MotorsOff{});
  EXPECT_EQ(host.board.gimbal().motors_on(), was_on);
  EXPECT_THAT(reactions, ::testing::ElementsAre(emulator::Reaction::locked));
}

TEST(Password, IsWantedByEachPortAndAfterARestart) {
  Host host(protected_board());
  host.get<msg::BoardInfo>(opening("sesame"));
  std::size_t other = host.board.open_port().value();
  std::swap(host.port, other);
  EXPECT_THAT(host.ask(msg::GetAnglesRequest{}), IsEmpty());
  std::swap(host.port, other);
  host.get<msg::GetAngles>(msg::GetAnglesRequest{});
  host.board.restart(host.now);
  EXPECT_THAT(host.listen(seconds(2)), IsEmpty());
  EXPECT_THAT(host.ask(msg::GetAnglesRequest{}), IsEmpty());
  host.get<msg::BoardInfo>(opening("sesame"));
}

TEST(Password, ANewOneReplacesIt) {
  Host host(protected_board());
  host.get<msg::BoardInfo>(opening("sesame"));
  msg::PassProtectWrite request;
  EXPECT_THAT(all<msg::Confirm>(host.ask(request)), SizeIs(1)) << "an empty one keeps it";
  EXPECT_TRUE(request.new_password.assign(std::string_view("open")));
  EXPECT_THAT(all<msg::Confirm>(host.ask(request)), SizeIs(1));
  host.board.restart(host.now);
  host.listen(seconds(2));
  EXPECT_THAT(host.ask(opening("sesame")), IsEmpty());
  host.get<msg::BoardInfo>(opening("open"));
}

TEST(Password, ABoardWithoutOneAsksNobody) {
  Host host(newest_board());
  msg::PassProtectWrite request;
  EXPECT_TRUE(request.new_password.assign(std::string_view("open")));
  EXPECT_THAT(all<msg::Confirm>(host.ask(request)), SizeIs(1));
  host.board.restart(host.now);
  host.listen(seconds(2));
  host.get<msg::BoardInfo>(msg::BoardInfoRequest{});
  host.get<msg::BoardInfo>(opening("anything"));
}

}  // namespace
}  // namespace sbgc::test
