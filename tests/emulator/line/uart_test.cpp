// Tests of the bytes that a UART receives if they were sent with other settings.

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

using ByteVector = std::vector<std::uint8_t>;

ByteVector every_byte() {
  ByteVector bytes(256);
  std::iota(bytes.begin(), bytes.end(), std::uint8_t{0});
  return bytes;
}
TEST(ReceivedAs, SameSettingsChangeNothing) {
  const ByteVector bytes = every_byte();
  for (const LineSettings line : {LineSettings{9600}, LineSettings{115200, Parity::even}}) {
    EXPECT_EQ(received_as(bytes, line, line), bytes);
  }
}

TEST(ReceivedAs, AlmostTheSameRateChangesNothing) {
  const ByteVector bytes = every_byte();
  EXPECT_EQ(received_as(bytes, {115200}, {117000}), bytes);
  EXPECT_EQ(received_as(bytes, {115200, Parity::even}, {113500, Parity::even}), bytes);
}

TEST(ReceivedAs, HalfTheRate) {
  // 0xE0 is six 0 bits, then ones: for the receiver, a start bit and two 0 bits.
  EXPECT_THAT(received_as(ByteVector{0xE0}, {19200}, {9600}), ElementsAre(0xFC));
}

TEST(ReceivedAs, TwiceTheRate) {
  // Sampled at twice the rate, 0xFF has a start bit of two bits, followed by ones.
  EXPECT_THAT(received_as(ByteVector{0xFF}, {9600}, {19200}), ElementsAre(0xFE));
  // 0x00 is a break: the stop bit is missing.
  EXPECT_THAT(received_as(ByteVector{0x00}, {9600}, {19200}), IsEmpty());
}

TEST(ReceivedAs, ParityThatIsNotThere) {
  // The stop bit is read as the parity bit: correct for an odd number of ones, if the line is idle
  // afterwards.
  EXPECT_THAT(received_as(ByteVector{0x01}, {9600}, {9600, Parity::even}), ElementsAre(0x01));
  EXPECT_THAT(received_as(ByteVector{0x03}, {9600}, {9600, Parity::even}), IsEmpty());
}

TEST(ReceivedAs, ParityThatIsNotExpected) {
  // The parity bit is read as the stop bit, so it must be 1.
  EXPECT_THAT(received_as(ByteVector{0x01, 0x03, 0x07}, {9600, Parity::even}, {9600}),
              ElementsAre(0x01, 0x07));
}

}  // namespace
}  // namespace sbgc::emulator
