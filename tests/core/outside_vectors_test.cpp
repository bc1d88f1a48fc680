// Tests with byte sequences from public sources: captures of real boards, constants in other
// people's code and worked examples. tests/data/vectors.json holds them unchanged.

#include <gtest/gtest.h>

#include <sbgc/parser.hpp>

#include "messages.hpp"

namespace sbgc::test {
namespace {

Json read_json(const std::string& path) {
  std::ifstream file(path);
  return Json::parse(file);
}

const Json& vectors() {
  static const Json json = read_json(SBGC_TEST_DATA "/vectors.json");
  return json;
}

/// Returns the ids of the exported model's messages in one direction.
std::set<int> ids_of_model(const std::string& direction) {
  static const Json model = read_json(SBGC_GENERATED "/simplebgc.json");
  std::set<int> result;
  for (const Json& message : model["messages"]) {
    const auto its = message["direction"].get<std::string>();
    if (its == direction || its == "both") result.insert(message["id"].get<int>());
  }
  return result;
}

class OutsideVectors : public testing::TestWithParam<std::size_t> {
 protected:
  const Json& vector() const { return vectors()[GetParam()]; }
  std::string text(const char* key) const { return vector()[key].get<std::string>(); }
  ByteVector bytes() const { return from_hex(text("hex")); }
  Direction direction() const {
    return text("direction") == "to_board" ? Direction::to_board : Direction::from_board;
  }

  /// Decodes a body, encodes it again, and compares the fields named by the entry.
  void check(std::uint8_t id, const ByteVector& body) const {
    const MessageType* const type = find_message(direction(), id, body.size());
    if (!ids_of_model(text("direction")).contains(id)) {
      // The project's specification lacks this command. As soon as it has it, this fails.
      EXPECT_EQ(type, nullptr) << "missing in the exported model";
      return;
    }
    ASSERT_NE(type, nullptr) << "the exported model has it, the codec does not";
    auto message = type->make();
    const Status status = message.decode(body);
    ASSERT_TRUE(status) << name(status.code) << " at " << status.offset << " " << status.field;
    EXPECT_EQ(encoded_body(message), body);
    check_command_name(type->info->command);
    if (!vector().contains("fields")) return;
    FieldValues values = spec_fields(message);
    for (const auto& [name, expected] : vector()["fields"].items()) {
      const auto list = expected.is_array() ? expected.get<std::vector<double>>()
                                            : std::vector{expected.get<double>()};
      EXPECT_EQ(values[name], list) << name;
    }
  }

  /// Most meanings start with the command's name.
  void check_command_name(const std::string& command) const {
    const std::string meaning = text("meaning");
    if (!meaning.starts_with("CMD_")) return;
    EXPECT_EQ(meaning.substr(0, meaning.find_first_of(" (:")), command);
  }
};

TEST_P(OutsideVectors, MeansWhatItsSourceSays) {
  SCOPED_TRACE(text("source") + ": " + text("meaning"));
  const std::string expect = text("expect");
  if (text("kind") == "payload") {
    ASSERT_EQ(expect, "valid");
    check(vector()["command_id"].get<std::uint8_t>(), bytes());
    return;
  }
  int frames = 0;
  const ByteVector stream = bytes();
  Parser parser;
  const auto sink = [&](const Frame& frame) {
    ++frames;
    EXPECT_EQ(frame_size(frame.body.size()), stream.size());
    check(frame.id, {frame.body.begin(), frame.body.end()});
    ByteVector again(stream.size());
    EXPECT_TRUE(write_frame(frame.id, frame.body, again));
    EXPECT_EQ(again, stream);
  };
  parser.feed(stream, sink);
  parser.flush(sink);
  ASSERT_TRUE(expect == "valid" || expect == "invalid" || expect == "foreign") << expect;
  EXPECT_EQ(frames, expect == "valid" ? 1 : 0);
}

INSTANTIATE_TEST_SUITE_P(Entries, OutsideVectors, testing::Range<std::size_t>(0, vectors().size()));

TEST(OutsideVectorsFile, HasNotShrunk) { EXPECT_GE(vectors().size(), 31U); }

// The reference codec reads the same frames: tests/generator/oracle/test_outside_vectors.py.
TEST(OutsideVectorsFile, FramesOfTheVendorsCodeDecodeAndComeBack) {
  for (const Json& entry : read_json(SBGC_TEST_DATA "/vendor_2026.json")) {
    SCOPED_TRACE(entry["meaning"].get<std::string>());
    const ByteVector frame = from_hex(entry["hex"].get<std::string>());
    const auto trailer = entry["framing"] == "v2" ? 2 : 1;
    const ByteVector body(frame.begin() + 4, frame.end() - trailer);
    const auto direction =
        entry["direction"] == "to_board" ? Direction::to_board : Direction::from_board;
    const MessageType* const type = find_message(direction, frame[1], body.size());
    ASSERT_NE(type, nullptr);
    auto message = type->make();
    ASSERT_TRUE(message.decode(body));
    EXPECT_EQ(encoded_body(message), body);
    EXPECT_EQ(dom_of(message).value("tail", ""), "");
    FieldValues values = spec_fields(message);
    for (const auto& [name, expected] : entry["fields"].items()) {
      const std::vector<double>& value = values[name];
      if (expected.is_number() && value.size() == 1) EXPECT_EQ(value[0], expected.get<double>());
    }
  }
}

}  // namespace
}  // namespace sbgc::test
