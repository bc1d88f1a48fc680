// Tests of framing with byte sequences from the reference codec. Those of other sources are in
// outside_vectors_test.cpp.

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
