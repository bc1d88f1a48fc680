// Lines of commands as words.

#include <string>
#include <string_view>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "shell/line_editor.hpp"

namespace sbgc::tools {

namespace {

using testing::ElementsAre;
using testing::IsEmpty;

std::vector<std::string> words(std::string_view line) { return split_words(line).words; }

TEST(Words, AreQuotedAsInAShell) {
  EXPECT_THAT(words(""), IsEmpty());
  EXPECT_THAT(words("  info   -p\tx "), ElementsAre("info", "-p", "x"));
  EXPECT_THAT(words(R"('a b' "c d" e\ f)"), ElementsAre("a b", "c d", "e f"));
  EXPECT_THAT(words(R"(a'b'"c" '' "")"), ElementsAre("abc", "", ""));
  EXPECT_THAT(words(R"('\' "\"\\\n" \')"), ElementsAre("\\", "\"\\\\n", "'"));
  EXPECT_THAT(words("a #b c"), ElementsAre("a"));
  EXPECT_THAT(words("a#b '#c'"), ElementsAre("a#b", "#c"));
}

TEST(Words, LackTheEndOfAQuote) {
  EXPECT_TRUE(split_words("a 'b'").is_complete);
  EXPECT_FALSE(split_words("a 'b").is_complete);
  EXPECT_FALSE(split_words("a \"b\\\"").is_complete);
}

TEST(Words, OfATypedLineEndAtTheCursor) {
  EXPECT_THAT(split_typed("params ge").words, ElementsAre("params", "ge"));
  EXPECT_EQ(split_typed("params ge").last_begin, 7U);
  EXPECT_THAT(split_typed("params ").words, ElementsAre("params", ""));
  EXPECT_EQ(split_typed("params ").last_begin, 7U);
  EXPECT_THAT(split_typed("").words, ElementsAre(""));
  EXPECT_THAT(split_typed("a 'b ").words, ElementsAre("a", "b "));
  EXPECT_THAT(split_typed("a b\\ ").words, ElementsAre("a", "b "));
}

TEST(Words, ReturnAfterQuoting) {
  for (const std::string_view word : {"a", "a b", "x'y\"z", "\\", "#", "\t", "a#b"}) {
    EXPECT_THAT(words("before " + quoted_word(word)), ElementsAre("before", word));
  }
}

}  // namespace
}  // namespace sbgc::tools
