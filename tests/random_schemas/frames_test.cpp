// The frames of random framings: streams, and the frames that the reference codec finds in them.

#include <cstddef>
#include <cstdint>
#include <fstream>
#include <span>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <sbgc/parser.hpp>
#include <sbgc/small_parser.hpp>

namespace {

using Bytes = std::vector<std::uint8_t>;
using nlohmann::json;

Bytes from_hex(const std::string& hex) {
  Bytes bytes;
  for (std::size_t i = 0; i < hex.size(); i += 2) {
    bytes.push_back(static_cast<std::uint8_t>(std::stoul(hex.substr(i, 2), nullptr, 16)));
  }
  return bytes;
}

std::string to_hex(std::span<const std::uint8_t> bytes) {
  std::string hex;
  for (const std::uint8_t byte : bytes) {
    hex += "0123456789abcdef"[byte >> 4];
    hex += "0123456789abcdef"[byte & 15];
  }
  return hex;
}

template <class Parser>
json frames_in(const Bytes& stream, const json& accepted) {
  Parser parser;
  if (accepted.size() != sbgc::framings.size()) {
    for (const sbgc::Framing framing : sbgc::framings) {
      if (accepted[0] == to_string(framing)) parser.formats().accept_only(framing);
    }
  }
  json found = json::array();
  const auto sink = [&](const sbgc::Frame& frame) {
    found.push_back({{"offset", frame.offset},
                     {"framing", to_string(frame.framing)},
                     {"id", frame.id},
                     {"body", to_hex(frame.body)}});
  };
  parser.feed(stream, sink);
  parser.flush(sink);
  return found;
}

TEST(Frames, AreThoseOfTheReferenceCodec) {
  using sbgc::AnyFrameFormats, sbgc::BasicParser, sbgc::Optimize;
  std::ifstream file("frames.jsonl");
  std::size_t count = 0;
  for (std::string line; std::getline(file, line); ++count) {
    SCOPED_TRACE(line);
    const json vector = json::parse(line);
    const Bytes stream = from_hex(vector["stream"]);
    const json& accepted = vector["framings"];
    EXPECT_EQ(frames_in<BasicParser<AnyFrameFormats>>(stream, accepted), vector["frames"]);
    EXPECT_EQ((frames_in<BasicParser<AnyFrameFormats, Optimize::size>>(stream, accepted)),
              vector["frames"]);
    if (!vector.contains("written")) continue;
    const json& frame = vector["frames"][0];
    for (const sbgc::Framing framing : sbgc::framings) {
      if (frame["framing"] != to_string(framing)) continue;
      Bytes written(sbgc::max_frame_size);
      const sbgc::WriteResult result =
          write_frame(framing, frame["id"], from_hex(frame["body"]), written);
      ASSERT_TRUE(result);
      EXPECT_EQ(to_hex(std::span(written).first(result.size)), vector["stream"]);
    }
  }
  EXPECT_GT(count, 30U);
}

}  // namespace
