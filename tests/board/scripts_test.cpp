// Scripts: started, watched, stopped.

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
  WriteFile request{.file_id = file,
                    .file_size = ByteCount(static_cast<std::uint16_t>(text.size()))};
  for (const char c : text) ASSERT_TRUE(request.data.push_back(static_cast<std::uint8_t>(c)));
  EXPECT_EQ(confirmations<WriteFile>(host.ask(request)), 1);
}

RunScript run(ScriptMode mode, std::uint8_t slot) { return {.mode = mode, .slot = slot}; }

TEST(Scripts, TheirSizesAreBoardInformation) {
  Host host;
  store(host, 3, five_commands);
  const auto sizes = host.get<BoardInfo3>(BoardInfo3Request{}).script_slot_size;
  for (std::size_t slot = 0; slot < sizes.size(); ++slot) {
    EXPECT_EQ(sizes[slot].raw(), slot == 3 ? five_commands.size() : 0) << slot;
  }
}

TEST(Scripts, DebuggingCountsTheCommands) {
  Host host;
  store(host, 3, five_commands);
  const Packets first = host.ask(run(ScriptMode::start_debug, 3), milliseconds(20));
  ASSERT_EQ(first.size(), 2U);
  EXPECT_TRUE(is<Confirm>(first[0])) << "the confirmation comes first";
  EXPECT_EQ(message<ScriptDebug>(first[1]).cmd_count, 1);
  const auto rest = all<ScriptDebug>(host.listen(seconds(2)));
  ASSERT_EQ(rest.size(), 5U);
  for (std::size_t i = 0; i < rest.size(); ++i) {
    EXPECT_EQ(rest[i].cmd_count, std::min<std::size_t>(i + 2, 5))
        << "and the last at the end again";
    EXPECT_EQ(rest[i].err_code, FileError::no_error);
  }
}

TEST(Scripts, EachCommandTakesItsTime) {
  Host host;
  store(host, 0, five_commands);
  host.ask(run(ScriptMode::start_debug, 0), milliseconds(20));
  EXPECT_EQ(host.listen(milliseconds(100)).size(), 1U);
  EXPECT_EQ(host.listen(milliseconds(200)).size(), 2U);
}

TEST(Scripts, NothingIsReportedWithoutDebugging) {
  Host host;
  store(host, 0, five_commands);
  EXPECT_TRUE(is_confirmed(host, run(ScriptMode::start, 0)));
  EXPECT_THAT(host.listen(seconds(2)), IsEmpty());
}

TEST(Scripts, NotEveryBoardRunsThem) {
  board::Options options;
  options.features = BoardFeature::three_axis;
  Host host(options);
  store(host, 0, five_commands);
  for (const auto mode : {ScriptMode::start, ScriptMode::start_debug, ScriptMode::stop}) {
    EXPECT_EQ(refusal(host, run(mode, 0)), BoardErrorCode::not_supported);
  }
}

TEST(Scripts, AnEmptySlotIsRefused) {
  Host host;
  EXPECT_EQ(refusal(host, run(ScriptMode::start, 1)), BoardErrorCode::operation_failed);
  EXPECT_EQ(refusal(host, run(ScriptMode::start_debug, 4)), BoardErrorCode::operation_failed);
}

TEST(Scripts, WhatIsNoSlotOrModeIsRefused) {
  Host host;
  store(host, 5, five_commands);
  EXPECT_EQ(refusal(host, run(ScriptMode::start, 5)), BoardErrorCode::wrong_params);
  EXPECT_EQ(refusal(host, run(ScriptMode{3}, 0)), BoardErrorCode::wrong_params);
  EXPECT_EQ(refusal(host, run(ScriptMode::stop, 5)), BoardErrorCode::wrong_params);
}

TEST(Scripts, Stop) {
  Host host;
  store(host, 0, five_commands);
  host.ask(run(ScriptMode::start_debug, 0));
  EXPECT_EQ(confirmations<RunScript>(host.ask(run(ScriptMode::stop, 1))), 1);
  EXPECT_FALSE(host.listen(milliseconds(100)).empty()) << "that was another slot";
  EXPECT_EQ(confirmations<RunScript>(host.ask(run(ScriptMode::stop, 0))), 1);
  EXPECT_THAT(host.listen(seconds(2)), IsEmpty());
}

TEST(Scripts, AScriptThatVanishesEndsWithAnError) {
  Host host;
  store(host, 0, five_commands);
  host.ask(run(ScriptMode::start_debug, 0));
  host.ask(WriteFile{.file_id = 0});
  const auto reports = all<ScriptDebug>(host.listen(seconds(2)));
  ASSERT_FALSE(reports.empty());
  EXPECT_EQ(reports.back().err_code, FileError::file_not_found);
}

TEST(Scripts, OfCommentsAloneEndsAtOnce) {
  Host host;
  store(host, 0, "# nothing\n\n");
  host.send(run(ScriptMode::start_debug, 0));
  const auto reports = all<ScriptDebug>(host.listen(milliseconds(20)));
  ASSERT_EQ(reports.size(), 1U);
  EXPECT_EQ(reports[0].cmd_count, 0);
}

TEST(Scripts, TheMenuRunsThem) {
  Host host;
  store(host, 1, five_commands);
  host.ask(ExecuteMenu{.cmd_id = MenuCommand::run_script2});
  host.ask(run(ScriptMode::start_debug, 1));
  EXPECT_EQ(all<ScriptDebug>(host.listen(seconds(2))).back().cmd_count, 5) << "it began again";
}

TEST(Scripts, AHostThatHasLeftGetsNothing) {
  Host host;
  store(host, 0, five_commands);
  host.ask(run(ScriptMode::start_debug, 0));
  host.board.close_port(host.port);
  ASSERT_EQ(host.board.open_port(), host.port);
  EXPECT_THAT(host.listen(seconds(2)), IsEmpty());
}

}  // namespace
}  // namespace sbgc::test
