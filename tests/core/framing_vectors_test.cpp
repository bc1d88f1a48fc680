// Tests of framing with byte sequences from other sources (captures of real boards, worked
// examples, constants in other people's code) and from the reference codec.

#include <cstddef>
#include <cstdint>
#include <fstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <sbgc/frame.hpp>
#include <sbgc/parser.hpp>
#include <sbgc/small_parser.hpp>

#include "reference_parser.hpp"

namespace sbgc::test {
namespace {

Bytes from_hex(const std::string& hex) {
  Bytes bytes;
  for (std::size_t i = 0; i < hex.size(); i += 2) {
    bytes.push_back(static_cast<std::uint8_t>(std::stoul(hex.substr(i, 2), nullptr, 16)));
  }
  return bytes;
}

/// Returns the sizes of the frames in `bytes`, which are the complete input.
std::vector<std::size_t> frames_in(const Bytes& bytes) {
  std::vector<std::size_t> sizes;
  const auto sink = [&](const Frame& frame) { sizes.push_back(frame.body.size() + 5); };
  Parser parser;
  parser.feed(bytes, sink);
  parser.flush(sink);
  return sizes;
}

TEST(FramingVectors, YieldTheFramesTheyShould) {
  std::ifstream file(SBGC_TEST_DATA "/vectors.json");
  const nlohmann::json vectors = nlohmann::json::parse(file);
  ASSERT_GE(vectors.size(), 29U);
  for (const nlohmann::json& vector : vectors) {
    SCOPED_TRACE(vector.dump());
    const Bytes bytes = from_hex(vector.at("hex"));
    const std::string kind = vector.at("kind");
    if (kind == "payload") {
      Bytes frame(bytes.size() + 5);
      EXPECT_TRUE(write_frame(vector.at("command_id").get<std::uint8_t>(), bytes, frame));
      EXPECT_EQ(frames_in(frame), std::vector{frame.size()});
    } else if (vector.at("expect") == "valid") {
      EXPECT_EQ(frames_in(bytes), std::vector{bytes.size()});
      // Writing the decoded frame yields the same bytes.
      Bytes again(bytes.size());
      EXPECT_TRUE(write_frame(bytes[1], Bytes(bytes.begin() + 4, bytes.end() - 1), again));
      EXPECT_EQ(again, bytes);
    } else {
      EXPECT_TRUE(frames_in(bytes).empty());
    }
  }
}

TEST(FramingVectors, SurviveOnOneLine) {
  std::ifstream file(SBGC_TEST_DATA "/vectors.json");
  Bytes line;
  for (const nlohmann::json& vector : nlohmann::json::parse(file)) {
    const Bytes bytes = from_hex(vector.at("hex"));
    line.insert(line.end(), bytes.begin(), bytes.end());
  }
  std::vector<std::size_t> sizes;
  for (const ReferenceFrame& frame : reference_parse(line, End::final).frames) {
    sizes.push_back(frame.body.size() + 5);
  }
  EXPECT_EQ(frames_in(line), sizes);
}

Framing framing_named(const std::string& name) { return name == "v2" ? Framing::v2 : Framing::v1; }

template <Optimize optimize>
std::vector<ReferenceFrame> found_in(const Bytes& stream, const std::vector<Framing>& accepted) {
  std::vector<ReferenceFrame> found;
  const auto sink = [&](const Frame& frame) {
    found.push_back({frame.id,
                     {frame.body.begin(), frame.body.end()},
                     frame.offset,
                     frame.framing == Framing::v2});
  };
  BasicParser<AnyFrameFormats, optimize> parser;
  if (accepted.size() == 1) parser.formats().accept_only(accepted[0]);
  parser.feed(stream, sink);
  parser.flush(sink);
  return found;
}

/// generated/frames.jsonl; generator/sbgcgen/oracle/streams.py describes it.
TEST(FramingVectors, AgreeWithTheReferenceCodec) {
  std::ifstream file(SBGC_GENERATED "/frames.jsonl");
  std::size_t count = 0;
  for (std::string line; std::getline(file, line); ++count) {
    SCOPED_TRACE(line);
    const auto vector = nlohmann::json::parse(line);
    const Bytes stream = from_hex(vector.at("stream"));
    std::vector<ReferenceFrame> expected;
    for (const nlohmann::json& frame : vector.at("frames")) {
      expected.push_back({frame.at("id"), from_hex(frame.at("body")), frame.at("offset"),
                          frame.at("framing") == "v2"});
    }
    std::vector<Framing> accepted;
    for (const nlohmann::json& name : vector.at("framings")) {
      accepted.push_back(framing_named(name));
    }
    EXPECT_EQ(found_in<Optimize::speed>(stream, accepted), expected);
    EXPECT_EQ(found_in<Optimize::size>(stream, accepted), expected);
    if (!vector.contains("written")) continue;
    Bytes written(stream.size());
    EXPECT_TRUE(write_frame(accepted[0], expected.at(0).id, expected.at(0).body, written));
    EXPECT_EQ(written, stream);
  }
  EXPECT_GT(count, 100U);
}

}  // namespace
}  // namespace sbgc::test
