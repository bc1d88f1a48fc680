// Before its memory is saved, a board confirms no change to it.

#include <cstdint>
#include <vector>

#include "host.hpp"
#include "random_input.hpp"

namespace sbgc::test {
namespace {

emulator::BoardOptions options() {
  emulator::BoardOptions result;
  result.waits_for_saving = true;
  return result;
}

msg::WriteExternalData data(std::uint8_t first) {
  msg::WriteExternalData request;
  request.data[0] = first;
  return request;
}

/// A board whose memory has been saved.
struct Rig {
  Host host{options()};

  Rig() { save(); }

  std::uint32_t revision() const { return host.board.memory().revision; }
  void save() { host.board.memory_saved(revision(), host.now); }
  void fail() { host.board.memory_not_saved(revision(), host.now); }
  /// Returns the packets that arrive now.
  Packets heard() { return host.listen(milliseconds(50)); }
};

TEST(Saving, AChangeIsConfirmedWhenItIsSafe) {
  Rig rig;
  EXPECT_TRUE(rig.host.ask(data(1), seconds(10)).empty());
  EXPECT_FALSE(rig.host.board.is_quiet(rig.host.port)) << "a confirmation is pending";
  rig.save();
  EXPECT_EQ(confirmations<msg::WriteExternalData>(rig.heard()), 1);
  EXPECT_TRUE(rig.host.board.is_quiet(rig.host.port));
}

TEST(Saving, WithoutAPlaceToSaveNothingWaits) {
  Host host;
  EXPECT_TRUE(is_confirmed(host, data(1)));
  EXPECT_FALSE(host.board.memory().is_unsaved);
}

TEST(Saving, WhatChangesNothingDoesNotWait) {
  Rig rig;
  rig.host.get<msg::BoardInfo>(msg::BoardInfoRequest{});
  EXPECT_TRUE(is_confirmed(rig.host, msg::MotorsOff{}));
  rig.host.send(data(1));
  rig.heard();
  rig.save();
  rig.heard();
  EXPECT_TRUE(is_confirmed(rig.host, data(1))) << "it is already written and saved";
}

TEST(Saving, AnswersKeepTheirOrder) {
  Rig rig;
  rig.host.get<msg::BoardInfo>(msg::BoardInfoRequest{});
  rig.host.send(data(1));
  EXPECT_TRUE(rig.host.ask(msg::ReadExternalDataRequest{}).empty());
  rig.save();
  const Packets heard = rig.heard();
  ASSERT_EQ(heard.size(), 2U);
  EXPECT_TRUE(is<msg::Confirm>(heard[0]));
  EXPECT_EQ(message<msg::ReadExternalData>(heard[1]).data[0], 1);
}

TEST(Saving, OtherHostsOfTheBoardAreAnswered) {
  Rig rig;
  rig.host.ask(data(1));
  const std::size_t first = rig.host.port;
  rig.host.port = rig.host.board.open_port().value();
  rig.host.get<msg::BoardInfo>(msg::BoardInfoRequest{});
  EXPECT_TRUE(rig.host.ask(data(1)).empty()) << "it is already written but not saved";
  rig.save();
  EXPECT_EQ(confirmations<msg::WriteExternalData>(rig.heard()), 1);
  rig.host.port = first;
  EXPECT_EQ(confirmations<msg::WriteExternalData>(rig.heard()), 1);
}

TEST(Saving, EachChangeWaitsForItsOwn) {
  Rig rig;
  rig.host.ask(data(1));
  const std::uint32_t first = rig.revision();
  rig.host.ask(data(2));
  rig.host.board.memory_saved(first, rig.host.now);
  EXPECT_EQ(confirmations<msg::WriteExternalData>(rig.heard()), 1);
  EXPECT_TRUE(rig.heard().empty());
  EXPECT_TRUE(rig.host.board.memory().is_unsaved);
  rig.save();
  EXPECT_EQ(confirmations<msg::WriteExternalData>(rig.heard()), 1);
  EXPECT_FALSE(rig.host.board.memory().is_unsaved);
}

TEST(Saving, AChangeThatCannotBeSavedIsRefused) {
  Rig rig;
  rig.host.ask(data(1));
  rig.host.send(msg::BoardInfoRequest{});
  rig.host.ask(data(2));
  rig.fail();
  const Packets heard = rig.heard();
  ASSERT_EQ(heard.size(), 3U);
  EXPECT_EQ(refusal<msg::WriteExternalData>({heard[0]}), msg::BoardErrorCode::operation_failed);
  EXPECT_TRUE(is<msg::BoardInfo>(heard[1]));
  EXPECT_EQ(refusal<msg::WriteExternalData>({heard[2]}), msg::BoardErrorCode::operation_failed);
  // Repeating the request does not confirm it either.
  EXPECT_TRUE(rig.host.ask(data(2)).empty());
  rig.fail();
  EXPECT_EQ(refusal<msg::WriteExternalData>(rig.heard()), msg::BoardErrorCode::operation_failed);
  EXPECT_TRUE(rig.host.ask(data(2)).empty());
  rig.save();
  EXPECT_EQ(confirmations<msg::WriteExternalData>(rig.heard()), 1);
}

TEST(Saving, TheEndOfACalibrationWaits) {
  Rig rig;
  const auto begun = rig.host.ask(msg::CalibGyro{});
  EXPECT_EQ(confirmations<msg::CalibGyro>(begun), 1) << "it has begun";
  EXPECT_TRUE(rig.host.listen(seconds(60)).empty());
  rig.save();
  EXPECT_EQ(confirmations<msg::CalibGyro>(rig.heard()), 1) << "it has ended";
}

TEST(Saving, AProfileThatIsSelectedWaits) {
  Rig rig;
  msg::ExecuteMenu request;
  request.cmd_id = msg::MenuCommand::profile2;
  EXPECT_TRUE(rig.host.ask(request).empty());
  EXPECT_TRUE(rig.host.ask(request).empty()) << "already selected but not saved";
  rig.save();
  EXPECT_EQ(confirmations<msg::ExecuteMenu>(rig.heard()), 2);
}

TEST(Saving, SamplesOfAStreamComeAfterTheConfirmation) {
  Rig rig;
  msg::DataStreamInterval stream;
  stream.cmd_id = msg::CommandFromBoard::realtime_data_3;
  stream.interval_ms = msg::Milliseconds(10);
  EXPECT_GT(rig.host.ask(stream, milliseconds(200)).size(), 10U);
  rig.host.ask(data(1));
  EXPECT_TRUE(rig.host.listen(seconds(5)).empty());
  rig.save();
  const Packets heard = rig.heard();
  ASSERT_GT(heard.size(), 2U);
  EXPECT_EQ(confirmations<msg::WriteExternalData>(heard), 1);
}

TEST(Saving, PowerOffLosesWhatWaits) {
  Rig rig;
  rig.host.ask(data(1));
  rig.host.board.restart(rig.host.now);
  rig.host.listen(seconds(1));
  rig.save();
  EXPECT_TRUE(rig.heard().empty());
  EXPECT_EQ(rig.host.get<msg::ReadExternalData>(msg::ReadExternalDataRequest{}).data[0], 1);
}

/// A host receives the same responses in the same order, whenever the memory is saved.
TEST(Saving, ChangesNothingButWhen) {
  int waited = 0;
  for (std::uint32_t seed = 0; seed < 30; ++seed) {
    std::vector<Bytes> heard[2];
    for (const bool waits : {false, true}) {
      RandomRequests requests(seed);
      emulator::BoardOptions options = seed % 2 == 0 ? emulator::BoardOptions{} : newest_board();
      options.waits_for_saving = waits;
      options.output_buffer = 0;
      emulator::Board board(options, {}, Instant{});
      const std::vector<std::size_t> ports{board.open_port().value(), board.open_port().value()};
      heard[waits].resize(ports.size());
      Instant now = Instant{} + seconds(1);
      const auto collect = [&] {
        for (const std::size_t port : ports) {
          const auto bytes = board.output(port);
          heard[waits][port].insert(heard[waits][port].end(), bytes.begin(), bytes.end());
          board.sent(port, bytes.size(), now);
        }
      };
      for (int i = 0; i < 400; ++i) {
        const std::size_t port = requests.up_to(1);
        const Bytes bytes = requests.next();
        const std::uint32_t pause = requests.up_to(20);
        const bool is_saved = requests.up_to(3) == 0;
        board.receive(port, bytes, now);
        now = now + milliseconds(pause);
        board.advance(now);
        waited += board.memory().is_unsaved ? 1 : 0;
        if (is_saved) board.memory_saved(board.memory().revision, now);
        collect();
      }
      board.memory_saved(board.memory().revision, now);
      collect();
    }
    EXPECT_EQ(heard[0], heard[1]) << seed;
  }
  EXPECT_GT(waited, 100);
}

}  // namespace
}  // namespace sbgc::test
