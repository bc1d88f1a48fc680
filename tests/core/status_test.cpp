#include <cctype>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include <sbgc/status.hpp>

namespace sbgc::test {
namespace {

static_assert(Status{});
static_assert(!Status{Code::too_short, 3, "mode"});
static_assert(WriteResult{4, {}});
static_assert(!WriteResult{0, {Code::invalid_id}});
static_assert(std::string_view(name(Code::too_short)) == "too_short");

constexpr Code last_code = Code::invalid_id;

TEST(Code, HasANameAndASentenceEach) {
  std::set<std::string> names;
  std::set<std::string> texts;
  for (int i = 0; i <= static_cast<int>(last_code); ++i) {
    const auto code = static_cast<Code>(i);
    for (const char* c = name(code); *c != '\0'; ++c) {
      EXPECT_TRUE(std::islower(static_cast<unsigned char>(*c)) != 0 || *c == '_') << name(code);
    }
    EXPECT_EQ(std::string(text(code)).back(), '.');
    names.insert(name(code));
    texts.insert(text(code));
  }
  EXPECT_EQ(names.size(), static_cast<std::size_t>(last_code) + 1);
  EXPECT_EQ(texts.size(), names.size());
  EXPECT_FALSE(names.contains("unknown_code"));
}

TEST(Code, BeyondTheLastIsUnknown) {
  const auto beyond = static_cast<Code>(static_cast<int>(last_code) + 1);
  EXPECT_STREQ(name(beyond), "unknown_code");
  EXPECT_STREQ(text(beyond), "The status code is unknown.");
}

}  // namespace
}  // namespace sbgc::test
