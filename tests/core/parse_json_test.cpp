// Tests of the JSON reader: it reads the same values as nlohmann_json, rejects everything else with
// its position, and has a cost proportional to the length of the text.

#include <cstdlib>
#include <new>

#include <gtest/gtest.h>

#include <sbgc/json_dom.hpp>
#include <sbgc/parse_json.hpp>

#include "support.hpp"

namespace {

/// Bytes allocated since the program started.
std::size_t allocated = 0;  // NOLINT(*-avoid-non-const-global-variables): of operator new

}  // namespace

// Not inlined, because g++ would warn about mismatched allocation functions.
[[gnu::noinline]] void* operator new(std::size_t size) {
  allocated += size;
  if (void* const memory = std::malloc(size != 0 ? size : 1)) return memory;
  throw std::bad_alloc();
}
[[gnu::noinline]] void operator delete(void* memory) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }

namespace sbgc::test {
namespace {

std::string repeated(std::string_view text, std::size_t count) {
  std::string result;
  result.reserve(text.size() * count);
  for (std::size_t i = 0; i < count; ++i) result += text;
  return result;
}

/// Returns {"a":{"a": ... core ...,"b":1},"b":1}.
std::string nested(std::size_t depth, const std::string& core) {
  return repeated(R"({"a":)", depth) + core + repeated(R"(,"b":1})", depth);
}

std::string problem_of(std::string_view text, const JsonLimits& limits = {}) {
  const ParsedJson parsed = parse_json(text, limits);
  EXPECT_EQ(static_cast<bool>(parsed), !parsed.problem);
  if (!parsed.problem) return "";
  EXPECT_TRUE(parsed.value.is_null());
  return to_string(*parsed.problem);
}

TEST(ParseJson, NamesThePlaceOfWhatIsWrong) {
  EXPECT_EQ(problem_of(""), "this is not JSON, or only its beginning (line 1, column 1)");
  EXPECT_EQ(problem_of("{\n \"a\": "),
            "this is not JSON, or only its beginning (line 2, column 7)");
  EXPECT_EQ(problem_of("hello"), "this is not JSON (line 1, column 1)");
  EXPECT_EQ(problem_of("[1,\n2,\n 3 4]"), "this is not JSON (line 3, column 4)");
  EXPECT_EQ(problem_of("{} {}"), "this is not JSON (line 1, column 4)");
  EXPECT_EQ(problem_of("\"\xff\""), "this is not JSON (line 1, column 2)");
  EXPECT_EQ(problem_of("[1e999]"), "a number that is too large for JSON (line 1, column 2)");
}

TEST(ParseJson, NothingHidesAfterAZeroByte) {
  EXPECT_EQ(problem_of(std::string_view("{}\0{}", 5)), "this is not JSON (line 1, column 3)");
  EXPECT_EQ(problem_of(std::string_view("[\0]", 3)), "this is not JSON (line 1, column 2)");
}

TEST(ParseJson, RefusesAKeyThatIsThereTwice) {
  EXPECT_EQ(problem_of(R"({"a":1,"a":1})"), "the key 'a' occurs twice (line 1, column 8)");
  EXPECT_EQ(problem_of("{\"x\": [1,\n  {\"a\\\"\":1, \"b\":2,\n    \"a\\\"\" : 3}]}"),
            "the key 'a\"' occurs twice (line 3, column 5)");
  EXPECT_EQ(problem_of(R"({"\\":1,"\u005c":1})"), "the key '\\' occurs twice (line 1, column 9)");
  // The first of them, in the order of the text.
  EXPECT_EQ(problem_of(R"({"b":1,"a":1,"b":1,"a":1})"),
            "the key 'b' occurs twice (line 1, column 14)");
  EXPECT_EQ(problem_of(R"({"a":{"a":{}},"b":[{"a":1},{"a":1}]})"), "");
  const std::string key = "\"\\u001b[2J" + repeated("ä", 100) + "\"";
  EXPECT_EQ(problem_of("{" + key + ":1," + key + ":1}"),
            "the key '?[2J" + repeated("ä", 18) + "...' occurs twice (line 1, column 216)");
}

TEST(ParseJson, ReadsAsDeepAsTheLimit) {
  constexpr std::size_t depth = JsonLimits{}.depth;
  static_assert(depth == 64);
  for (const auto& [open, close] : {std::pair("[", "]"), std::pair("{\"a\":[", "]}")}) {
    const std::size_t most = depth / (std::string_view(open).size() == 1 ? 1 : 2);
    EXPECT_EQ(problem_of(repeated(open, most) + repeated(close, most)), "");
    EXPECT_NE(problem_of(repeated(open, most + 1) + repeated(close, most + 1)), "");
  }
  EXPECT_EQ(problem_of(repeated("[", depth + 1)),
            "nested deeper than 64 levels (line 1, column 65)");
  EXPECT_EQ(problem_of("[[]]", {.depth = 1}), "nested deeper than 1 levels (line 1, column 2)");
}

TEST(ParseJson, AnyDepthIsRefusedWithoutDescending) {
  constexpr std::size_t depth = 100'000;
  for (const std::string& text :
       {repeated("[", depth), repeated("[", depth) + repeated("]", depth),
        repeated(R"({"a":)", depth) + "1" + repeated("}", depth),
        R"({"message":)" + repeated("[", depth) + repeated("]", depth) + R"(,"fields":{}})",
        nested(depth, "1")}) {
    EXPECT_NE(problem_of(text), "");
  }
}

TEST(ParseJson, TakesTextUpToTheLimit) {
  constexpr std::size_t size = JsonLimits{}.size;
  static_assert(size == std::size_t{16} * 1024 * 1024);
  const std::string text = "\"" + std::string(size - 2, 'x') + "\"";
  EXPECT_EQ(problem_of(text), "");
  EXPECT_EQ(problem_of(text + " "), "longer than 16777216 bytes (line 1, column 1)");
  EXPECT_EQ(problem_of("[1]", {.size = 3}), "");
  EXPECT_EQ(problem_of("[1] ", {.size = 3}), "longer than 3 bytes (line 1, column 1)");
}

TEST(ParseJson, CopiesNoMemberWhenItsParentGrows) {
  // Otherwise the innermost value would be copied at each level and for each reallocation.
  const std::string core = "\"" + std::string(100'000, 'x') + "\"";
  const std::string text = nested(JsonLimits{}.depth, core);
  const std::size_t before = allocated;
  const ParsedJson parsed = parse_json(text);
  const std::size_t cost = allocated - before;
  ASSERT_TRUE(parsed);
  EXPECT_GE(cost, core.size());
  EXPECT_LE(cost, 2 * core.size());
}

TEST(ParseJson, ManyKeysTakeNoMoreThanTheirShare) {
  // Comparing each key with all previous ones would take 5 * 10^9 comparisons.
  constexpr std::size_t count = 100'000;
  std::string text = "{";
  for (std::size_t i = 0; i < count; ++i) text += "\"key " + std::to_string(i) + "\":0,";
  text.back() = '}';
  const ParsedJson parsed = parse_json(text);
  ASSERT_TRUE(parsed);
  EXPECT_EQ(parsed.value.size(), count);
}

TEST(ParseJson, WhatIsReadCanBeCopiedComparedAndPrinted) {
  const ParsedJson parsed = parse_json(nested(JsonLimits{}.depth - 1, "[]"));
  ASSERT_TRUE(parsed);
  const Json copy = parsed.value;
  EXPECT_EQ(copy, parsed.value);
  EXPECT_EQ(copy.dump(), nested(JsonLimits{}.depth - 1, "[]"));
}

}  // namespace
}  // namespace sbgc::test
