// Tests of validation. rows.txt has every rule, with path, value and limit. The quick check of
// validate() never disagrees with the walk that reports violations, and both find each value
// outside the limits of the exported model.

#include <filesystem>

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

const std::filesystem::path generated = SBGC_GENERATED;

/// The oldest board, two in between, and the newest.
constexpr Availability boards[] = {{}, {2610, 30}, {2690, 36}, newest};

/// Counts how often both found a message valid, and invalid.
struct Verdicts {
  int valid{};
  int invalid{};
};

void expect_agreement(const AnyMessage& message, const char* name, Verdicts& verdicts) {
  for (const Availability& board : boards) {
    const bool is_valid = violations_of(message, board).empty();
    ASSERT_EQ(passes_quick_check(message, board), is_valid)
        << name << ", firmware " << board.firmware;
    ++(is_valid ? verdicts.valid : verdicts.invalid);
  }
}

/// The bodies with typical values by the name of their message.
const std::map<std::string, ByteVector>& typical_bodies() {
  static const auto bodies = [] {
    std::map<std::string, ByteVector> result;
    for (const auto& file : std::filesystem::directory_iterator(generated / "vectors")) {
      std::ifstream lines(file.path());
      for (std::string line; std::getline(lines, line);) {
        const Json json = Json::parse(line);
        if (json["why"] != "typical values" || json.contains("error")) continue;
        result[json["message"].get<std::string>()] = from_hex(json["hex"].get<std::string>());
      }
    }
    return result;
  }();
  return bodies;
}

TEST(PlainlyValid, AgreesWithTheWalkOnRandomMessages) {
  RandomBodies bodies(1);
  const Contexts& contexts = random_contexts(0);
  Verdicts verdicts;
  for (const MessageType* const type : message_types()) {
    auto message = type->make();
    expect_agreement(message, type->info->name, verdicts);
    for (int i = 0; i < 40; ++i) {
      const std::size_t more = is_of_fixed_size(*type) ? 0U : static_cast<std::size_t>(i);
      if (!message.decode(bodies.next(type->info->min_size + more), contexts)) continue;
      expect_agreement(message, type->info->name, verdicts);
    }
  }
  EXPECT_GT(verdicts.valid, 5000);
  EXPECT_GT(verdicts.invalid, 5000);
}

TEST(PlainlyValid, AgreesWithTheWalkOnOneChangedByte) {
  Verdicts verdicts;
  for (const auto& [name, typical] : typical_bodies()) {
    const MessageType& type = message_type(name);
    auto message = type.make();
    for (std::size_t i = 0; i < typical.size(); ++i) {
      for (const int value : {0, 1, 5, 0x7F, 0x80, 0xFF}) {
        ByteVector body = typical;
        body[i] = static_cast<std::uint8_t>(value);
        if (message.decode(body)) expect_agreement(message, type.info->name, verdicts);
      }
    }
  }
  EXPECT_GT(verdicts.valid, 20000);
  EXPECT_GT(verdicts.invalid, 5000);
}

/// An integer type of the wire.
struct IntegerType {
  std::size_t size{};
  std::int64_t lowest{};
  std::int64_t highest{};
};
const std::map<std::string, IntegerType> integer_types = {
    {"u8", {1, 0, 0xFF}},
    {"i8", {1, -0x80, 0x7F}},
    {"u16", {2, 0, 0xFFFF}},
    {"i16", {2, -0x8000, 0x7FFF}},
    {"u32", {4, 0, 0xFFFFFFFF}},
    {"i32",
     {4, std::numeric_limits<std::int32_t>::min(), std::numeric_limits<std::int32_t>::max()}},
};

bool reports(const AnyMessage& message, std::int64_t value, std::int64_t limit) {
  return std::ranges::any_of(violations_of(message), [&](const ViolationCopy& violation) {
    return violation.value == static_cast<double>(value) &&
           violation.limit == static_cast<double>(limit);
  });
}

// The limits come from the model, not from the tables in C++.
TEST(PlainlyValid, NoValueOutsideTheLimitsOfTheModelPasses) {
  int tried = 0;
  std::ifstream file(generated / "simplebgc.json");
  const Json model = Json::parse(file);
  for (const Json& entry : model["messages"]) {
    const auto name = entry["name"].get<std::string>();
    const auto typical = typical_bodies().find(name);
    if (typical == typical_bodies().end()) continue;
    auto message = message_type(name).make();
    for (const Json& leaf : entry["layout"]) {
      const auto type = integer_types.find(leaf["type"].get<std::string>());
      if (type == integer_types.end() || leaf["min"].is_null() || leaf["offset"].is_null())
        continue;
      if (leaf.contains("used_when")) continue;  // not by a board with the typical body
      const auto& [size, lowest, highest] = type->second;
      for (const int beyond : {-1, 1}) {
        const auto bound = leaf[beyond < 0 ? "min" : "max"].get<std::int64_t>();
        const std::int64_t value = bound + beyond;
        const bool is_special =
            leaf.contains("special") && leaf["special"].contains(std::to_string(value));
        if (value < lowest || value > highest || is_special) continue;
        ByteVector body = typical->second;
        const auto offset = leaf["offset"].get<std::size_t>();
        if (offset + size > body.size()) continue;
        for (std::size_t i = 0; i < size; ++i) {
          body[offset + i] =
              static_cast<std::uint8_t>(static_cast<std::uint64_t>(value) >> (8 * i));
        }
        if (!message.decode(body)) continue;  // a counter, for example
        ++tried;
        EXPECT_FALSE(passes_quick_check(message, newest)) << name << ", " << leaf["path"];
        EXPECT_TRUE(reports(message, value, bound)) << name << ", " << leaf["path"];
      }
    }
  }
  EXPECT_GT(tried, 400);
}

}  // namespace
}  // namespace sbgc::test
