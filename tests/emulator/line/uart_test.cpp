// What a UART makes of bytes that were sent with other settings.

#include <cstdint>
#include <numeric>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sbgc/emulator/uart.hpp>

namespace sbgc::emulator {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

using Bytes = std::vector<std::uint8_t>;

Bytes every_byte() {
  Bytes bytes(256);
  std::iota(bytes.begin(), bytes.end(), std::uint8_t{0});
  return bytes;
}
TEST(ReceivedAs, SameSettingsChangeNothing) {
  const Bytes bytes = every_byte();
  for (const LineSettings line : {LineSettings{9600}, LineSettings{115200, Parity::even}}) {
    EXPECT_EQ(received_as(bytes, line, line), bytes);
  }
}

TEST(ReceivedAs, AlmostTheSameRateChangesNothing) {
  const Bytes bytes = every_byte();
  EXPECT_EQ(received_as(bytes, {115200}, {117000}), bytes);
  EXPECT_EQ(received_as(bytes, {115200, Parity::even}, {113500, Parity::even}), bytes);
}

TEST(ReceivedAs, HalfTheRate) {
  // 0xE0 is six bits of 0, then ones: for the receiver a start bit and two bits of 0.
  EXPECT_THAT(received_as(Bytes{0xE0}, {19200}, {9600}), ElementsAre(0xFC));
}

TEST(ReceivedAs, TwiceTheRate) {
  // Bits seen at twice the rate: 0xFF has a start bit of two bits, then ones.
  EXPECT_THAT(received_as(Bytes{0xFF}, {9600}, {19200}), ElementsAre(0xFE));
  // 0x00 is a break: no stop bit where one should be.
  EXPECT_THAT(received_as(Bytes{0x00}, {9600}, {19200}), IsEmpty());
}

TEST(ReceivedAs, ParityThatIsNotThere) {
  // The stop bit is taken for parity: right for an odd number of ones, if the line is idle then.
  EXPECT_THAT(received_as(Bytes{0x01}, {9600}, {9600, Parity::even}), ElementsAre(0x01));
  EXPECT_THAT(received_as(Bytes{0x03}, {9600}, {9600, Parity::even}), IsEmpty());
}

TEST(ReceivedAs, ParityThatIsNotExpected) {
  // The parity bit is taken for the stop bit: it must be 1.
  EXPECT_THAT(received_as(Bytes{0x01, 0x03, 0x07}, {9600, Parity::even}, {9600}),
              ElementsAre(0x01, 0x07));
}

}  // namespace
}  // namespace sbgc::emulator
