// Tests of the client and the emulated board over faulty lines.

#include <sbgc/client/backup.hpp>
#include <sbgc/client/memory.hpp>
#include <sbgc/detector.hpp>
#include <sbgc/io/line.hpp>

#include "testing.hpp"

namespace sbgc::test {
namespace {

ConnectOptions patient() {
  ConnectOptions options = quick();
  options.retries = 20;
  return options;
}

/// Expects that a backup is complete and correct although frames are lost.
void expect_backup(const emulator::Faults& faults) {
  EmulatedBoard original;
  original.edit<msg::ReadParams3>(3, [](auto& params) { params.gyro_trust = 99; });
  emulator::EmulatorOptions options = quick_board();
  options.line.faults = faults;
  EmulatedBoard board(options, original.memory(), false);
  auto client = checked(connect_over(board.line(), patient()));
  const auto backup = checked(client->make_backup());
  EXPECT_EQ(backup->parameters.all().size(), 18U);
  for (std::uint8_t profile = 0; profile < 5; ++profile) {
    EXPECT_EQ(*backup->parameters.get<msg::ReadParams3>(profile),
              original.settings<msg::ReadParams3>(profile));
    EXPECT_EQ(*backup->parameters.get<msg::ReadParamsExt2>(profile),
              original.settings<msg::ReadParamsExt2>(profile));
  }
  EXPECT_GT(client->statistics().session.retries, 0U) << "no fault occurred";
}

TEST(Faults, ABackupGetsThroughBitErrors) { expect_backup({.bit_errors = 1e-4}); }

TEST(Faults, ABackupGetsThroughLostBytes) { expect_backup({.lost = 1e-3}); }

TEST(Faults, ABackupGetsThroughDuplicatedBytes) { expect_backup({.duplicated = 1e-3}); }

TEST(Faults, ABackupGetsThroughSilence) {
  // From the beginning, while the client searches for the board.
  expect_backup({.silences = {{.from = {}, .length = milliseconds(2000)}}});
}

TEST(Faults, ABackupGetsThroughText) {
  emulator::EmulatorOptions options = quick_board();
  options.line.faults.text_every = milliseconds(2);
  EmulatedBoard board(options, {}, false);
  auto client = checked(connect_over(board.line(), patient()));
  const auto backup = checked(client->make_backup());
  EXPECT_EQ(*backup->parameters.get<msg::ReadParams3>(4), board.settings<msg::ReadParams3>(4));
  EXPECT_GT(client->statistics().session.parser.skipped_bytes, 0U) << "there was no text";
}

TEST(Faults, ABoardThatIsSwitchedOffAndOnAnswersAgain) {
  emulator::EmulatorOptions options = quick_board();
  options.board.start_time = seconds(60);  // longer than this machine may stall
  EmulatedBoard board(options);
  auto client = checked(connect_over(board.line(), patient()));
  // No request may be pending then, such as one repeated after a stall.
  ASSERT_TRUE(client->get_angles({}, {.timeout = std::chrono::seconds(60), .retries = 0}));
  board.restart();
  EXPECT_FALSE(client->get_angles({}, {.timeout = Ms(20), .retries = 0}));
  board.skip(std::chrono::seconds(61));
  EXPECT_TRUE(client->get_angles());
}

TEST(Faults, ABoardIsFoundAtEveryBaudRateAndParity) {
  // In parallel, because a search mostly waits.
  std::vector<std::future<void>> searches;
  for (const std::uint32_t rate : baud_rates) {
    for (const Parity parity : {Parity::none, Parity::even}) {
      searches.push_back(std::async(std::launch::async, [settings = LineSettings{rate, parity}] {
        EmulatedBoard board;
        ConnectOptions options = quick();
        options.timeout = std::chrono::seconds(60);
        auto client = connect_over(board.line_with(settings), options);
        ASSERT_TRUE(client) << io::to_string(settings) << ": " << client.error().message;
        EXPECT_THAT(client->description(), HasSubstr(io::to_string(settings)));
        EXPECT_TRUE(client->get_angles());
      }));
    }
  }
  EXPECT_EQ(searches.size(), Detector::lines);
  for (auto& search : searches) search.get();
}

}  // namespace
}  // namespace sbgc::test
