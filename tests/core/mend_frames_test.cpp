#include "mend_frames.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

#include <sbgc/frame.hpp>
#include <sbgc/parser.hpp>

namespace sbgc::test {
namespace {

std::size_t intact_frames_in(const std::vector<std::uint8_t>& bytes) {
  std::size_t count = 0;
  ParserOfAll parser;
  parser.feed(bytes, [&](const Frame&) { ++count; });
  return count;
}

TEST(MendFrames, FramesOfBothFramingsGetTheirChecksums) {
  std::vector<std::uint8_t> input{7, 7};
  for (const Framing framing : framings) {
    const std::array<std::uint8_t, 3> body{1, 2, 3};
    std::array<std::uint8_t, max_frame_size> frame{};
    const auto written = write_frame(framing, 67, body, frame);
    ASSERT_TRUE(written);
    frame[3] ^= 0xFF;                 // the checksum of the header
    frame[written.size - 1] ^= 0xFF;  // the last byte of the trailer
    input.insert(input.end(), frame.begin(), frame.begin() + written.size);
    input.push_back(9);
  }
  ASSERT_EQ(intact_frames_in(input), 0U);
  EXPECT_EQ(fuzz::mend_frames(input), framings.size());
  EXPECT_EQ(intact_frames_in(input), framings.size());
  EXPECT_EQ(input[0], 7);
  EXPECT_EQ(input.back(), 9);
}

TEST(MendFrames, OtherBytesDoNotChange) {
  const std::vector<std::vector<std::uint8_t>> inputs{
      {},
      {0x3E},
      {0x24, 67, 0},
      {0x3E, 0, 0, 0, 0},     // no id
      {0x3E, 67, 5, 0, 1, 2}  // the body is not all there
  };
  for (const auto& input : inputs) {
    std::vector<std::uint8_t> mended = input;
    EXPECT_EQ(fuzz::mend_frames(mended), 0U);
    EXPECT_EQ(mended, input);
  }
}

}  // namespace
}  // namespace sbgc::test
