// Tests of output that does not wait for its reader.

#include "command/background_output.hpp"

#include <array>
#include <cstdio>
#include <string>

#include <gtest/gtest.h>
#include <unistd.h>

namespace sbgc::tools {
namespace {

class Output : public ::testing::Test {
 protected:
  void SetUp() override { ASSERT_EQ(::pipe(ends.data()), 0); }
  void TearDown() override {
    for (const int end : ends) ::close(end);
  }
  /// Reads so many bytes.
  std::string read(std::size_t size) const {
    std::string text(size, ' ');
    for (std::size_t at = 0; at < size;) {
      const ssize_t some = ::read(ends[0], text.data() + at, size - at);
      if (some <= 0) return text.substr(0, at);
      at += static_cast<std::size_t>(some);
    }
    return text;
  }

  std::array<int, 2> ends{};
};

TEST_F(Output, IsWrittenInOrder) {
  BackgroundOutput output(ends[1]);
  output.write("one\n");
  output.write("two\n");
  EXPECT_EQ(read(8), "one\ntwo\n");
}

TEST_F(Output, OneLongTextIsNotDropped) {
  const std::string text(200'000, 'x');
  BackgroundOutput output(ends[1]);
  output.write(text);
  EXPECT_EQ(read(text.size()), text);
  output.write("end\n");
  EXPECT_EQ(read(4), "end\n");
}

TEST_F(Output, WithoutAReaderTheNewestIsDroppedAndCounted) {
  const std::string line(999, 'x');
  BackgroundOutput output(ends[1]);
  for (int i = 0; i < 1000; ++i) output.write(line + "\n");
  int kept = 0;
  int dropped = 0;
  while (kept + dropped < 1000) {
    std::string text;
    while (!text.ends_with('\n')) text += read(1);
    if (text == line + "\n") {
      ++kept;
    } else {
      int lines = 0;
      ASSERT_EQ(std::sscanf(text.c_str(), "... %d lines dropped: no reader", &lines), 1) << text;
      dropped += lines;
    }
  }
  EXPECT_EQ(kept + dropped, 1000);
  EXPECT_LT(kept, 300);
}

}  // namespace
}  // namespace sbgc::tools
