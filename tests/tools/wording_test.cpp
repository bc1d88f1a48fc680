// Tests of the wording of messages.

#include "command/wording.hpp"

#include <string>

#include <gtest/gtest.h>

namespace sbgc::tools {
namespace {

TEST(Wording, NoControlCharacterReachesTheTerminal) {
  EXPECT_EQ(printable("\x1B[31m\a\t\x7F"), "?[31m???");
  EXPECT_EQ(printable("\xC2\x9B"
                      "31m\xC2\x80"),
            "?31m?");
}

TEST(Wording, NoCharacterThatChangesTheDirectionOrEndsALineReachesTheTerminal) {
  for (const char* const text :
       {"\u061C", "\u200E", "\u200F", "\u2028", "\u2029", "\u202A", "\u202E", "\u2066", "\u2069"}) {
    EXPECT_EQ(printable(text), "?");
    EXPECT_EQ(clipped(text), "?");
  }
}

TEST(Wording, NoByteThatIsNotUtf8ReachesTheTerminal) {
  // Terminals of other encodings obey 80 to 9F.
  EXPECT_EQ(printable("\x9B"
                      "31m\xC3(\xE2\x82"),
            "?31m?(??");
}

TEST(Wording, AQuotedInputStaysOnOneLine) {
  EXPECT_EQ(clipped("two\nlines\xC2\x9B"), "two?lines?");
  EXPECT_EQ(clipped(std::string(2000, 'a')), std::string(1000, 'a') + "...");
}

TEST(Wording, OtherCharactersStay) {
  for (const std::string text : {"", "two\nlines", "45\xC2\xB0", "\xC3\x84\xE2\x82\xAC",
                                 "\u00A0\u200D\u2027\u202F\u2065\u206A"}) {
    EXPECT_EQ(printable(text), text);
  }
}

}  // namespace
}  // namespace sbgc::tools
