// Tests of scripts: starting, watching and stopping them.

#include <string>
#include <string_view>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "replies.hpp"

namespace sbgc::test {
namespace {

using ::testing::IsEmpty;

constexpr std::string_view five_commands =
    "# prepare\n"
    "MOTORS ON\n"
    "\n"
    "  DELAY 100\r\n"
    "// turn\n"
    "ANGLE 10\n"
    "ANGLE 0\n"
    "   \n"
    "END";

void store(Host& host, std::uint16_t file, std::string_view text) {
  msg::WriteFile request{.file_id = file,
                         .file_size = msg::ByteCount(static_cast<std::uint16_t>(text.size()))};
  for (const char c : text) ASSERT_TRUE(request.data.push_back(static_cast<std::uint8_t>(c)));
  EXPECT_EQ(confirmations<msg::WriteFile>(host.ask(request)), 1);
}

msg::RunScript run(msg::ScriptMode mode, std::uint8_t slot) { return {.mode = mode, .slot = slot}; }

TEST(Scripts, TheirSizesAreBoardInformation) {
  Host host;
  store(host, 3, five_commands);
  const auto sizes = host.get<msg::BoardInfo3>(msg::BoardInfo3Request{}).script_slot_size;
  for (std::size_t slot = 0; slot < sizes.size(); ++slot) {
    EXPECT_EQ(sizes[slot].raw(), slot == 3 ? five_commands.size() : 0) << slot;
  }
}

TEST(Scripts, DebuggingCountsTheCommands) {
  Host host;
  store(host, 3, five_commands);
  const Packets first = host.ask(run(msg::ScriptMode::start_debug, 3), milliseconds(20));
  ASSERT_EQ(first.size(), 2U);
  EXPECT_TRUE(is<msg::Confirm>(first[0])) << "the confirmation comes first";
  EXPECT_EQ(message<msg::ScriptDebug>(first[1]).cmd_count, 1);
  const auto rest = all<msg::ScriptDebug>(host.listen(seconds(2)));
  ASSERT_EQ(rest.size(), 5U);
  for (std::size_t i = 0; i < rest.size(); ++i) {
    EXPECT_EQ(rest[i].cmd_count, std::min<std::size_t>(i + 2, 5))
        << "and the last at the end again";
    EXPECT_EQ(rest[i].err_code, msg::FileError::no_error);
  }
}

TEST(Scripts, EachCommandTakesItsTime) {
  Host host;
  store(host, 0, five_commands);
  host.ask(run(msg::ScriptMode::start_debug, 0), milliseconds(20));
  EXPECT_EQ(host.listen(milliseconds(100)).size(), 1U);
  EXPECT_EQ(host.listen(milliseconds(200)).size(), 2U);
}

TEST(Scripts, NothingIsReportedWithoutDebugging) {
  Host host;
  store(host, 0, five_commands);
  EXPECT_TRUE(is_confirmed(host, run(msg::ScriptMode::start, 0)));
  EXPECT_THAT(host.listen(seconds(2)), IsEmpty());
}

TEST(Scripts, NotEveryBoardRunsThem) {
  emulator::BoardOptions options;
  options.features = msg::BoardFeature::three_axis;
  Host host(options);
  store(host, 0, five_commands);
  for (const auto mode :
       {msg::ScriptMode::start, msg::ScriptMode::start_debug, msg::ScriptMode::stop}) {
    EXPECT_EQ(refusal(host, run(mode, 0)), msg::BoardErrorCode::not_supported);
  }
}

TEST(Scripts, AnEmptySlotIsRefused) {
  Host host;
  EXPECT_EQ(refusal(host, run(msg::ScriptMode::start, 1)), msg::BoardErrorCode::operation_failed);
  EXPECT_EQ(refusal(host, run(msg::ScriptMode::start_debug, 4)),
            msg::BoardErrorCode::operation_failed);
}

TEST(Scripts, WhatIsNoSlotOrModeIsRefused) {
  Host host;
  store(host, 5, five_commands);
  EXPECT_EQ(refusal(host, run(msg::ScriptMode::start, 5)), msg::BoardErrorCode::wrong_params);
  EXPECT_EQ(refusal(host, run(msg::ScriptMode{3}, 0)), msg::BoardErrorCode::wrong_params);
  EXPECT_EQ(refusal(host, run(msg::ScriptMode::stop, 5)), msg::BoardErrorCode::wrong_params);
}

TEST(Scripts, Stop) {
  Host host;
  store(host, 0, five_commands);
  host.ask(run(msg::ScriptMode::start_debug, 0));
  EXPECT_EQ(confirmations<msg::RunScript>(host.ask(run(msg::ScriptMode::stop, 1))), 1);
  EXPECT_FALSE(host.listen(milliseconds(100)).empty()) << "that was another slot";
  EXPECT_EQ(confirmations<msg::RunScript>(host.ask(run(msg::ScriptMode::stop, 0))), 1);
  EXPECT_THAT(host.listen(seconds(2)), IsEmpty());
}

TEST(Scripts, AScriptThatVanishesEndsWithAnError) {
  Host host;
  store(host, 0, five_commands);
  host.ask(run(msg::ScriptMode::start_debug, 0));
  host.ask(msg::WriteFile{.file_id = 0});
  const auto reports = all<msg::ScriptDebug>(host.listen(seconds(2)));
  ASSERT_FALSE(reports.empty());
  EXPECT_EQ(reports.back().err_code, msg::FileError::file_not_found);
}

TEST(Scripts, OfCommentsAloneEndsAtOnce) {
  Host host;
  store(host, 0, "# nothing\n\n");
  host.send(run(msg::ScriptMode::start_debug, 0));
  const auto reports = all<msg::ScriptDebug>(host.listen(milliseconds(20)));
  ASSERT_EQ(reports.size(), 1U);
  EXPECT_EQ(reports[0].cmd_count, 0);
}

TEST(Scripts, TheMenuRunsThem) {
  Host host;
  store(host, 1, five_commands);
  host.ask(msg::ExecuteMenu{.cmd_id = msg::MenuCommand::run_script2});
  host.ask(run(msg::ScriptMode::start_debug, 1));
  EXPECT_EQ(all<msg::ScriptDebug>(host.listen(seconds(2))).back().cmd_count, 5) << "it began again";
}

TEST(Scripts, AHostThatHasLeftGetsNothing) {
  Host host;
  store(host, 0, five_commands);
  host.ask(run(msg::ScriptMode::start_debug, 0));
  host.board.close_port(host.port);
  ASSERT_EQ(host.board.open_port(), host.port);
  EXPECT_THAT(host.listen(seconds(2)), IsEmpty());
}

}  // namespace
}  // namespace sbgc::test
