// Tests of texts: words of a line of commands, wording of messages, versions of firmware, frames,
// and files with bytes of an EEPROM.

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <random>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "care/memory/eeprom_image.hpp"
#include "command/command_error.hpp"
#include "command/wording.hpp"
#include "frames/frame_text.hpp"
#include "shell/line_editor.hpp"
#include "values/field_text.hpp"

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

TEST(FirmwareText, Versions) {
  EXPECT_EQ(parse_firmware("2.43b9"), msg::FirmwareVersion(2439));
  EXPECT_EQ(parse_firmware("2.59"), msg::FirmwareVersion(2590));
  EXPECT_EQ(parse_firmware("2.59")->minor(), 59);
  EXPECT_EQ(parse_firmware("2.59b0"), msg::FirmwareVersion(2590)) << "as decode prints it";
  EXPECT_EQ(parse_firmware("2.73.1"), msg::FirmwareVersion(2731));
  EXPECT_EQ(parse_firmware("2.74.5"), msg::FirmwareVersion(2745));
  for (const char* text : {"", "2", "2.5", "2.590", "2.59b", "2.59.", "2.59b10", "2.5.9", "x.59",
                           "2.59 ", "2.-9", "2..59", ".59", "2.59b1.", "2.59.1b"}) {
    EXPECT_EQ(parse_firmware(text), std::nullopt) << text;
  }
}

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

std::string text_of(FrameDecoder& decoder, std::span<const std::uint8_t> body) {
  constexpr std::uint8_t set_adj_vars_val = 31;
  std::string text;
  StringOutput out(text);
  put_text(out, decoder.decode({.id = set_adj_vars_val, .body = body}, Direction::to_board));
  out.finish();
  return text;
}

TEST(FrameText, DoesNotDependOnEarlierFrames) {
  FrameDecoder decoder({.json = false, .rows = true});
  std::minstd_rand random(1);
  for (int i = 0; i < 500; ++i) {
    // Few values of few variables, so that most of them stay.
    std::vector<std::uint8_t> body{static_cast<std::uint8_t>(1 + random() % 4)};
    for (unsigned n = 0; n < body[0]; ++n) {
      const auto value = static_cast<std::uint8_t>(random() % 3 == 0 ? random() : 7);
      const auto id = static_cast<std::uint8_t>(random() % 5 == 0 ? 201 : n);
      body.insert(body.end(), {id, value, 0, 0, 0});
    }
    FrameDecoder fresh({.json = false, .rows = true});
    EXPECT_EQ(text_of(decoder, body), text_of(fresh, body));
  }
}

std::string sample() { return to_text({"3.0", "2.59", 7, "0a0b", 4096, {'{', 0, '\n', 255, '"'}}); }

TEST(EepromImage, IsReadAsItWasWritten) {
  const std::optional<EepromImage> image = parse_image(sample());
  ASSERT_TRUE(image);
  EXPECT_EQ(image->model, "3.0");
  EXPECT_EQ(image->firmware, "2.59");
  EXPECT_EQ(image->extra_id, 7U);
  EXPECT_EQ(image->serial_number, "0a0b");
  EXPECT_EQ(image->address, 4096U);
  EXPECT_EQ(image->data, (std::vector<std::uint8_t>{'{', 0, '\n', 255, '"'}));
  EXPECT_FALSE(parse_image("bytes alone"));
}

TEST(EepromImage, NoChangeOfAnyBitAndNoCutPasses) {
  const std::string good = sample();
  const auto is_refused = [](const std::string& text) {
    try {
      return !parse_image(text).has_value();
    } catch (const CommandError&) {
      return true;
    }
  };
  for (std::size_t bit = 0; bit < good.size() * 8; ++bit) {
    std::string changed = good;
    changed[bit / 8] = static_cast<char>(changed[bit / 8] ^ 1 << bit % 8);
    EXPECT_TRUE(is_refused(changed)) << bit;
  }
  for (std::size_t size = 0; size < good.size(); ++size) {
    EXPECT_TRUE(is_refused(good.substr(0, size))) << size;
    EXPECT_TRUE(is_refused(good.substr(size + 1))) << size;
  }
  EXPECT_TRUE(is_refused(good + '\n'));
}

}  // namespace
}  // namespace sbgc::tools
