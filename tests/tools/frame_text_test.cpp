// Tests of the text of a frame.

#include "frames/frame_text.hpp"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace sbgc::tools {
namespace {

/// Provides no more memory than it has to.
class TightOutput final : public TextOutput {
 public:
  TightOutput() { make_room(); }

  bool has_overflown() const { return has_overflown_; }
  std::string take() {
    make_room();
    return text_;
  }

 private:
  void make_room() override {
    if (const char* const end = end_of_text(); end != nullptr) {
      const auto size = static_cast<std::size_t>(end - buffer_.data());
      has_overflown_ = has_overflown_ || size > most_room;
      text_.append(buffer_.data(), size);
    }
    provide(buffer_.data(), buffer_.data() + most_room);
  }

  std::array<char, 4 * most_room> buffer_{};
  std::string text_{};
  bool has_overflown_ = false;
};

TEST(FrameText, LinesOfAnyLengthFitIntoTheMemoryOfTheOutput) {
  constexpr std::uint8_t read_file = 53;
  for (std::size_t size = 240; size <= max_body_size; ++size) {
    const std::vector<std::uint8_t> body(size, 0xA5);
    FrameDecoder decoder({.json = false, .rows = true});
    const DecodedFrame frame =
        decoder.decode({.id = read_file, .body = body}, Direction::from_board);
    ASSERT_TRUE(frame.status);
    TightOutput tight;
    put_text(tight, frame);
    std::string expected;
    StringOutput ample(expected);
    put_text(ample, frame);
    ample.finish();
    EXPECT_EQ(tight.take(), expected);
    EXPECT_FALSE(tight.has_overflown()) << size;
  }
}

}  // namespace
}  // namespace sbgc::tools
