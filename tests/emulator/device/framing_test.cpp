// Tests of the framings that an emulated board understands.

#include "host.hpp"

namespace sbgc::test {
namespace {

TEST(BoardFraming, AnswersEachRequestInItsFraming) {
  Host host({.firmware = msg::FirmwareVersion(2680)});
  for (const Framing framing : {Framing::v1, Framing::v2, Framing::v2, Framing::v1}) {
    host.framing = framing;
    const Packets answer = host.ask(msg::BoardInfoRequest{});
    ASSERT_THAT(answer, SizeIs(1));
    EXPECT_EQ(answer[0].framing, framing);
  }
}

TEST(BoardFraming, StreamsInTheFramingOfTheLastRequest) {
  Host host({.firmware = msg::FirmwareVersion(2680)});
  host.framing = Framing::v2;
  host.ask(msg::DataStreamInterval{.cmd_id = msg::CommandFromBoard::realtime_data_3,
                                   .interval_ms = msg::Milliseconds(10)});
  for (const Packet& sample : host.listen(milliseconds(100))) {
    EXPECT_EQ(sample.framing, Framing::v2);
  }
  host.framing = Framing::v1;
  host.ask(msg::BoardInfoRequest{});
  const Packets samples = host.listen(milliseconds(100));
  EXPECT_THAT(samples, SizeIs(testing::Ge(5U)));
  for (const Packet& sample : samples) EXPECT_EQ(sample.framing, Framing::v1);
}

TEST(BoardFraming, OldFirmwareKnowsOnlyTheFirst) {
  Host host({.firmware = msg::FirmwareVersion(2679)});
  host.framing = Framing::v2;
  EXPECT_THAT(host.ask(msg::BoardInfoRequest{}), IsEmpty());
  host.framing = Framing::v1;
  EXPECT_THAT(host.ask(msg::BoardInfoRequest{}), SizeIs(1));
}

TEST(BoardFraming, BeginsWithTheFirstAfterARestart) {
  Host host({.firmware = msg::FirmwareVersion(2680)});
  host.framing = Framing::v2;
  host.ask(msg::ResetRequest{});
  host.listen(seconds(2));
  host.framing = Framing::v1;
  EXPECT_THAT(host.ask(msg::BoardInfoRequest{}), SizeIs(1));
}

TEST(BoardFraming, AFullOutputBufferCountsTheBytesOfTheFraming) {
  // The answer has 18 bytes: 23 in the first framing, 24 in the second.
  Host host({.firmware = msg::FirmwareVersion(2680), .output_buffer = 24});
  host.framing = Framing::v2;
  EXPECT_THAT(host.ask(msg::BoardInfoRequest{}), SizeIs(1));
}

}  // namespace
}  // namespace sbgc::test
