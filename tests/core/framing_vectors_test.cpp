// Tests of frames with byte sequences of the reference codec; tests/random_schemas runs them with
// random framings, too.

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <sbgc/json_dom.hpp>
#include <sbgc/parser.hpp>
#include <sbgc/small_parser.hpp>

#include "support.hpp"

namespace sbgc::test {
namespace {

using nlohmann::json;

template <class Parser>
json frames_in(const ByteVector& stream, const json& accepted) {
  Parser parser;
  if (accepted.size() != framings.size()) {
    for (const Framing framing : framings) {
      if (accepted[0] == to_string(framing)) parser.formats().accept_only(framing);
    }
  }
  json found = json::array();
  const auto sink = [&](const Frame& frame) {
    found.push_back({{"offset", frame.offset},
                     {"framing", to_string(frame.framing)},
                     {"id", frame.id},
                     {"body", detail::to_hex(frame.body)}});
  };
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
    const json vector = json::parse(line);
    const ByteVector stream = from_hex(vector["stream"].get<std::string>());
    const json& accepted = vector["framings"];
    EXPECT_EQ(frames_in<BasicParser<AnyFrameFormats>>(stream, accepted), vector["frames"]);
    EXPECT_EQ((frames_in<BasicParser<AnyFrameFormats, Optimize::size>>(stream, accepted)),
              vector["frames"]);
    if (!vector.contains("written")) continue;
    const json& frame = vector["frames"][0];
    for (const Framing framing : framings) {
      if (frame["framing"] != to_string(framing)) continue;
      ByteVector written(max_frame_size);
      const WriteResult result =
          write_frame(framing, frame["id"], from_hex(frame["body"].get<std::string>()), written);
      ASSERT_TRUE(result);
      EXPECT_EQ(detail::to_hex(std::span(written).first(result.size)), vector["stream"]);
    }
  }
  EXPECT_GT(count, 30U);
}

}  // namespace
}  // namespace sbgc::test
