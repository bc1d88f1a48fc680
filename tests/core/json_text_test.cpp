// Tests of JSON text without a DOM: the reader accepts the same text as parse_json() and
// from_dom(), and names the place of what is wrong; the writer writes what nlohmann_json reads.

#include <unordered_set>

#include <gtest/gtest.h>

#include <sbgc/json.hpp>
#include <sbgc/meta/all.hpp>
#include <sbgc/parse_json.hpp>

#include "messages.hpp"

namespace sbgc::test {
namespace {

bool read_by_dom(AnyMessage& message, std::string_view text) {
  const ParsedJson parsed = parse_json(text);
  if (!parsed) {
    // nlohmann_json accepts two equal keys, and anything after a NUL byte.
    EXPECT_TRUE(!Json::accept(text) || parsed.problem->reason.ends_with("occurs twice") ||
                text.find('\0') != std::string_view::npos)
        << text;
    return false;
  }
  EXPECT_EQ(parsed.value.dump(), Json::parse(text).dump());
  try {
    read_dom(parsed.value, message);
  } catch (const JsonError&) {
    return false;
  }
  return true;
}

/// Reads text in both ways, which must agree. Returns true if it is accepted.
bool read_in_both_ways(const MessageType& type, std::string_view text) {
  auto message = type.make();
  auto by_dom = type.make();
  const bool accepted = read_by_dom(by_dom, text);
  const JsonResult result = message.from_json(text);
  EXPECT_EQ(static_cast<bool>(result), accepted)
      << text << '\n'
      << (result.problem ? to_string(*result.problem) : "");
  EXPECT_EQ(encoded_body(message), encoded_body(by_dom)) << text;
  return accepted;
}

class Mutations {
 public:
  explicit Mutations(unsigned seed) : random_(seed) {}

  std::string of(std::string text) {
    constexpr std::string_view characters =
        "{}[]\",:\\/u0123456789abcdefE+-. \n\t\x01\x7F\xC3\xEF\x9E";
    const std::size_t at = below(text.size());
    switch (below(7)) {
      case 0: return text.erase(at, 1 + below(3));
      case 1: return text.insert(at, 1, characters[below(characters.size())]);
      case 2: text[at] = characters[below(characters.size())]; return text;
      case 3: return text.substr(0, at);
      case 4: return text.insert(at, text.substr(below(text.size()), below(40)));
      case 5: return text.replace(at, below(20), text.substr(below(text.size()), below(20)));
      default: return text.insert(at, values[below(values.size())]);
    }
  }

 private:
  static constexpr std::array values = std::to_array<const char*>(
      {"null", "-1", "1e3", "99999999999999999999", "\"\\u0061\"", "[]", "{}", "0.5", "-0", "1e999",
       "\"\\ud83d\\ude00\"", "\"\xEF\x9E\x80\"", " \r\n\t", "\"nan:7fc00000\""});

  std::size_t below(std::size_t limit) {
    return std::uniform_int_distribution<std::size_t>(0, limit - 1)(random_);
  }

  std::mt19937 random_;
};

class JsonText : public testing::TestWithParam<const MessageType*> {};

TEST_P(JsonText, AcceptsWhatTheDomAccepts) {
  RandomBodies bodies(23);
  Mutations mutations(5);
  const std::size_t min_size = GetParam()->info->min_size;
  for (std::size_t i = 0; i < 12; ++i) {
    auto message = GetParam()->make();
    const std::size_t more = is_of_fixed_size(*GetParam()) ? 0 : 5 * i;
    if (!message.decode(bodies.next(std::min(min_size + more, max_body_size)),
                        random_contexts(i))) {
      continue;
    }
    const std::string text = message.to_json(Secrets::shown);
    EXPECT_TRUE(read_in_both_ways(*GetParam(), text)) << text;
    for (int k = 0; k < 12; ++k) read_in_both_ways(*GetParam(), mutations.of(text));
  }
}

TEST_P(JsonText, MembersMayHaveAnyOrder) {
  auto message = GetParam()->make();
  Json reversed = Json::object();
  const Json json = dom_of(message);
  for (auto item = json.rbegin(); item != json.rend(); ++item) reversed[item.key()] = item.value();
  auto copy = GetParam()->make();
  EXPECT_TRUE(copy.from_json(reversed.dump(3))) << reversed.dump();
  EXPECT_TRUE((copy == message));
}

INSTANTIATE_TEST_SUITE_P(Messages, JsonText, testing::ValuesIn(message_types()),
                         [](const auto& test) { return test.param->info->name; });

/// Returns the parts of a text with semicolons between them.
std::vector<std::string> parts_of(std::string_view text) {
  std::vector<std::string> result(1);
  for (const char c : text) {
    if (c == ';') {
      result.emplace_back();
    } else {
      result.back() += c;
    }
  }
  return result;
}

const MessageType& sounds() { return message_type("BeepSound"); }

TEST(JsonTextValues, AreReadAsTheDomReadsThem) {
  int accepted = 0;
  for (const std::string& value :
       parts_of("0;-0;00;01;-01;+1;1.;.5;1.0;1e0;1E+0;1e;1e+;0x1;255;256;-1;- 1;4294967296;"
                "9223372036854775807;9223372036854775808;18446744073709551615;18446744073709551616;"
                "-9223372036854775808;-9223372036854775809;1e5;true;false;null;nul;NaN;Infinity;"
                "\"1\";'1';[1];{};;1 2;1,;/**/1;1//")) {
    const std::string text = R"({"mode":)" + value +
                             R"(,"note_length":1,"decay_factor":0,"reserved":"0000000000000000",)" +
                             R"("note_freq_hz":[]})";
    accepted += read_in_both_ways(sounds(), text) ? 1 : 0;
  }
  EXPECT_EQ(accepted, 4);
}

TEST(JsonTextValues, StringsAreReadAsTheDomReadsThem) {
  int accepted = 0;
  std::vector<std::string> names = parts_of(
      ";a;\\n\\t\\r\\b\\f\\/\\\\\\\";\\u00e4;\\u00E4;\\uABCD\\uEF00;\\uabcd\\uef00;"
      "\\u00G0;\\u20ac;\\ud83d\\ude00;\\u0000;\\uf780;\xEF\x9E\x80;\xEF\x9F\xBF;"
      "\xC3\xA4\xE2\x82\xAC\xF0\x9F\x98\x80;\\u0080\\ud7ff\\ue000\\uf77f\\uf800;"
      "\\udbff\\udfff\\ud800\\udc00;\\ud83d;\\ud800\\ue000;\\ud800\\udbff;\\udc00;"
      "\\udfff;\\ude00;\\ud83d\\u0041;\\ud83dx;\\u12;\\u123g;\\x41;\\;\\a;\n;\x7F;\x1F;"
      "\xFF;\xC3;\xC0\x80;\xED\xA0\x80;\xF4\x90\x80\x80;\xE2\x82");
  for (const auto& name : {std::string(1, '\0'), std::string(48, 'x'), std::string(49, 'x'),
                           std::string(3 * 48, '\xEF')}) {
    names.push_back(name);
  }
  for (const std::string& name : names) {
    const std::string text = R"({"profile_name":[")" + name + R"(","\u0062","c","d","e"]})";
    accepted += read_in_both_ways(message_type("ReadProfileNames"), text) ? 1 : 0;
  }
  EXPECT_EQ(accepted, 18);
}

/// Returns the UTF-8 encoding of a code point.
std::string utf8_of(std::uint32_t c) {
  std::string result;
  const auto add = [&](std::uint32_t byte) { result += static_cast<char>(byte); };
  const auto follow = [&](int shift) { add(0x80 | (c >> shift & 0x3F)); };
  if (c < 0x80) return add(c), result;
  if (c < 0x800) return add(0xC0 | c >> 6), follow(0), result;
  if (c < 0x10000) return add(0xE0 | c >> 12), follow(6), follow(0), result;
  return add(0xF0 | c >> 18), follow(12), follow(6), follow(0), result;
}

TEST(Utf8, EveryCharacterAndNothingElseIsWellFormed) {
  // All that have their bytes at a limit, and many others.
  std::unordered_set<std::string> characters;
  for (std::uint32_t c = 0; c <= 0x10FFFF; ++c) {
    if (c >= 0xD800 && c < 0xE000) continue;
    const std::string character = utf8_of(c);
    ASSERT_EQ(detail::utf8_length(character + "x"), character.size()) << c;
    if (c % 64 == 0 || c % 64 == 63) characters.insert(character);
  }
  constexpr std::array<char, 4> limits{'\x7F', '\x80', '\xBF', '\xC0'};
  for (int first = 0; first < 256; ++first) {
    for (int second = 0; second < 256; ++second) {
      for (const char third : limits) {
        for (const char last : limits) {
          const std::string bytes{static_cast<char>(first), static_cast<char>(second), third, last};
          const std::size_t length = detail::utf8_length(bytes);
          if (first < 0x80 || (first < 0xE0 && length == 2)) continue;  // as seen above
          ASSERT_EQ(length != 0,
                    characters.contains(bytes.substr(0, 3)) || characters.contains(bytes))
              << first << ' ' << second << ' ' << int{third} << ' ' << int{last};
        }
      }
    }
  }
}

TEST(JsonTextValues, FloatsAreReadAsTheDomReadsThem) {
  const std::string zeros(400, '0');
  int accepted = 0;
  std::vector<std::string> values = parts_of(
      "0;-0.0;1e38;1e39;-1e39;1e308;1e309;-1e309;1e-45;1e-400;-1e-400;0e999;"
      "1e99999999999999999999;1e-99999999999999999999;16777217;3.4028235677973366e38;"
      "123456789012345678901234567890;\"inf\";\"-inf\";\"+inf\";\"nan:7fc00000\";"
      "\"nan:7FC00001\";\"nan:7f800000\";\"nan:7fc000000\";\"\\u0069nf\"");
  for (const std::string& value : {"0." + zeros + "1e401", "0." + zeros + "1e10",
                                   "1" + zeros + "e-400", "1" + zeros, "1" + zeros + "e-10"}) {
    values.push_back(value);
  }
  for (const std::string& value : values) {
    const std::string text =
        R"({"timestamp_ms":0,"z1_vector":{"x":)" + value + R"(,"y":0,"z":-1.5e0}})";
    accepted += read_in_both_ways(message_type("RealtimeDataCustom"), text) ? 1 : 0;
  }
  EXPECT_EQ(accepted, 18);
}

TEST(JsonTextValues, NumbersOfAnnouncedTypesAreReadAsTheDomReadsThem) {
  int accepted = 0;
  for (const char* const value :
       {R"({"i16":-5})", R"({"f32":1e5})", R"({"f32":"inf"})", R"({"u8":256})", R"({"u8":-1})",
        R"({})", R"([])", R"(5)", R"({"i16":1,"i16":1})", R"({"i16":1,"u8":1})", R"({"x":1})",
        R"({"i16":})", R"({"i16":1)", R"({"\u0069\u00316":1})"}) {
    const auto& type = message_type("DebugVars3");
    const std::string key = dom_of(type.make()).begin().key();
    accepted += read_in_both_ways(type, R"({")" + key + R"(":[)" + value + "]}") ? 1 : 0;
  }
  EXPECT_EQ(accepted, 4);
}

TEST(JsonTextValues, TextAroundTheObject) {
  int accepted = 0;
  using namespace std::string_literals;
  for (const std::string& text : parts_of(
           "{}; \n\t\r{ } \n;\xEF\xBB\xBF{};\xEF\xBB{};{}\0;{}{};{},;[;{;};; ;{}\f;{,};null;[];"
           "{\"a\":1};{\"\":1};{1:1};{\"a\" 1};{\"a\":"s)) {
    accepted += read_in_both_ways(message_type("MotorsOn"), text) ? 1 : 0;
  }
  EXPECT_EQ(accepted, 3);
}

template <class M>
std::string problem_of(std::string_view text) {
  M message{};
  const JsonResult result = from_json(text, message);
  EXPECT_EQ(message, M{});
  return result.problem ? to_string(*result.problem) : "";
}

TEST(JsonTextProblems, NoDepthIsTooDeep) {
  for (const char* const open : {"[", R"({"axes":)", R"({"x":)"}) {
    std::string text;
    for (int i = 0; i < 100'000; ++i) text += open;
    EXPECT_NE(problem_of<msg::Control>(text), "");
  }
}

TEST(JsonTextOutput, NoTextControlsATerminal) {
  for (std::uint32_t c = 1; c <= 0x10FFFF; c += c < 0x10000 ? 1 : 0x1001) {
    if (c >= 0xD800 && c < 0xE000) continue;
    const std::string character = utf8_of(c);
    msg::ReadProfileNames message;
    ASSERT_TRUE(message.profile_name[0].assign(character));
    const std::string text = to_json(message);
    const bool is_raw = text.find('"' + character + '"') != std::string::npos;
    const bool is_private = c >= 0xF780 && c < 0xF800;  // stands for a byte that is not UTF-8
    const bool is_control = c < 0x20 || (c >= 0x7F && c < 0xA0) || c == 0x061C || c == 0x200E ||
                            c == 0x200F || (c >= 0x2028 && c <= 0x202E) ||
                            (c >= 0x2066 && c <= 0x2069) || c == 0xFFFE || c == 0xFFFF;
    const bool is_syntax = c == '"' || c == '\\';
    ASSERT_EQ(is_raw, !is_control && !is_syntax && !is_private) << c;
    if (is_raw && c % 64 != 0) continue;
    ASSERT_EQ(detail::json_text(to_dom(message)), text) << "the DOM writes the same";
    msg::ReadProfileNames copy;
    ASSERT_TRUE(from_json(text, copy)) << c;
    ASSERT_EQ(copy, message) << c;
  }
}

TEST(JsonTextOutput, GoesAnywhere) {
  const msg::Control message;
  const std::string expected = to_dom(message).dump();
  EXPECT_EQ(to_json(message), expected);

  std::string text = "before ";
  write_json(message, [&](std::string_view piece) { text += piece; });
  EXPECT_EQ(text, "before " + expected);

  std::array<char, 300> buffer{};
  EXPECT_EQ(to_json(message, buffer), expected.size());
  EXPECT_EQ(std::string_view(buffer.data(), expected.size()), expected);
  for (const std::size_t size : {std::size_t{0}, std::size_t{1}, expected.size() - 1}) {
    std::array<char, 300> small{};
    EXPECT_EQ(to_json(message, std::span(small).first(size)), expected.size());
    EXPECT_EQ(std::string_view(small.data(), size), expected.substr(0, size));
    EXPECT_EQ(small[size], '\0') << "nothing is written after the buffer";
  }
}

TEST(JsonTextOutput, LongTextArrivesInPieces) {
  msg::BeepSound message;
  using Note = decltype(message.note_freq_hz)::value_type;
  for (int i = 0; i < 121; ++i) message.note_freq_hz.push_back(Note(60000));
  std::string text;
  std::size_t pieces = 0;
  write_json(message, [&](std::string_view piece) {
    text += piece;
    ++pieces;
  });
  EXPECT_EQ(text, to_dom(message).dump());
  EXPECT_GT(pieces, 1U);
}

std::string real(double value) {
  std::string result;
  StringOutput out(result);
  detail::put_real(out, value);
  out.finish();
  return result;
}

TEST(JsonTextOutput, RealNumbersLookLikeThoseOfNlohmann) {
  for (const double value : {0.0,
                             -0.0,
                             1.0,
                             -1.5,
                             0.1,
                             1e-4,
                             1e-5,
                             12345.678,
                             1e14,
                             123456789012345.0,
                             1e15,
                             1e16,
                             1.5e16,
                             1e22,
                             1e-30,
                             5e-324,
                             2.2250738585072014e-308,
                             1.7976931348623157e308,
                             100.0,
                             static_cast<double>(0.1F),
                             static_cast<double>(3.4028235e38F)}) {
    EXPECT_EQ(real(value), Json(value).dump());
  }
  std::mt19937 random(1);
  for (int i = 0; i < 20'000; ++i) {
    const auto value =
        static_cast<double>(std::bit_cast<float>(static_cast<std::uint32_t>(random())));
    if (!detail::is_finite(value)) continue;
    const std::string text = real(value);
    EXPECT_EQ(Json::parse(text).get<double>(), value) << text;
    EXPECT_TRUE(Json::parse(text).is_number_float()) << text;
    // nlohmann_json rarely prints one digit more than necessary.
    EXPECT_LE(text.size(), Json(value).dump().size());
  }
}

}  // namespace
}  // namespace sbgc::test
