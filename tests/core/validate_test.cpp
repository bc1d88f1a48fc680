// Tests of validation. rows.txt has every rule, with path, value and limit.

#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <sbgc/meta/all.hpp>

#include "messages.hpp"

namespace sbgc::test {
namespace {

using Violations = std::vector<ViolationCopy>;

TEST(Validate, NotANumberAndInfinity) {
  msg::RealtimeDataCustom message;
  constexpr float infinity = std::numeric_limits<float>::infinity();
  message.z1_vector = Xyz<float>{std::nanf(""), infinity, -infinity};
  const Violations violations = violations_of(message);
  ASSERT_EQ(violations.size(), 3U);
  EXPECT_EQ(violations[0].path, "z1_vector.x");
  EXPECT_TRUE(std::isnan(violations[0].value));
  EXPECT_EQ(violations[1].rule, Rule::maximum);
  EXPECT_EQ(violations[2].rule, Rule::minimum);
}

TEST(Validate, EveryDefaultMessageGivesTheSameReportTwice) {
  for (const MessageType* const type : message_types()) {
    auto message = type->make();
    EXPECT_EQ(violations_of(message), violations_of(message)) << type->info->name;
    for (const ViolationCopy& violation : violations_of(message)) {
      EXPECT_FALSE(violation.path.empty());
      EXPECT_STRNE(name(violation.rule), "unknown_rule");
    }
  }
}

TEST(FieldPath, IsCutOffSafely) {
  const FieldPath params{nullptr, "params"};
  const FieldPath element{&params, "", 120};
  const FieldPath id{&element, "param_id"};
  const std::string full = "params[120].param_id";
  for (std::size_t space = 0; space <= full.size() + 3; ++space) {
    char out[64];
    std::memset(out, '#', sizeof out);
    const std::size_t length = id.write(out, space);
    if (space == 0) {
      EXPECT_EQ(out[0], '#');
      continue;
    }
    EXPECT_EQ(length, std::min(space - 1, full.size()));
    EXPECT_EQ(std::string(out), full.substr(0, space - 1));
    EXPECT_EQ(out[space], '#') << "written past the end";
  }
}

TEST(FieldPath, Indices) {
  for (const std::size_t index : {0U, 9U, 10U, 99U, 100U, 254U, 1000000007U}) {
    const FieldPath list{nullptr, "x"};
    const FieldPath element{&list, "", index};
    char out[32];
    element.write(out, sizeof out);
    EXPECT_EQ(std::string(out), "x[" + std::to_string(index) + "]");
  }
}

}  // namespace
}  // namespace sbgc::test
