// The generated headers of a random protocol: the frames of random framings are those that the
// reference codec finds in streams; settings, including share(), are those of random_messages.py,
// which shares the model with the generated code but none of the templates; a conversation
// compiles.

#include <cstddef>
#include <cstdint>
#include <fstream>
#include <set>
#include <span>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <sbgc/detector.hpp>
#include <sbgc/dispatch.hpp>
#include <sbgc/json_dom.hpp>
#include <sbgc/meta/all.hpp>
#include <sbgc/parameters.hpp>
#include <sbgc/parser.hpp>
#include <sbgc/responses/all.hpp>
#include <sbgc/session.hpp>
#include <sbgc/small_parser.hpp>

#include "support.hpp"

namespace sbgc::test {
namespace {

template <class... Messages>
Json names(TypeList<Messages...>) {
  return Json::array({Meta<Messages>::info.name...});
}

template <class M>
void check(const Json& line) {
  using Settings = ParametersOf<M>;
  EXPECT_EQ(Settings::copies, line["copies"]);
  EXPECT_EQ(names(typename Settings::Readers{}), line["readers"]);
  EXPECT_EQ(names(typename Settings::Writers{}), line["writers"]);
  M from{}, to{};
  from_dom(line["from"], from);
  from_dom(line["to"], to);
  if constexpr (Settings::copies > 1) {
    EXPECT_EQ(Settings::copy(to), line["copy"]);
    Settings::share(from, to);
  }
  EXPECT_EQ(to_dom(to), line["shared"])
      << "differences: " << Json::diff(line["shared"], to_dom(to));
  EXPECT_EQ(detail::to_hex(body_of(to)), line["hex"].get<std::string>());
}

TEST(Settings, AreSharedAsTheModelSays) {
  std::ifstream file(SBGC_GENERATED "/settings.jsonl");
  std::set<std::string> seen;
  std::string text;
  int number = 0;
  while (std::getline(file, text)) {
    SCOPED_TRACE("line " + std::to_string(++number) + " of settings.jsonl");
    const Json line = Json::parse(text);
    seen.insert(line["settings"].get<std::string>());
    ParameterMessages::for_each([&]<class M>(Type<M>) {
      if (line["settings"] != ParametersOf<M>::name) return;
      ASSERT_NO_THROW(check<M>(line));
    });
  }
  ParameterMessages::for_each([&]<class M>(Type<M>) {
    EXPECT_TRUE(seen.contains(ParametersOf<M>::name)) << ParametersOf<M>::name;
  });
}

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

TEST(Frames, AreThoseOfTheReferenceCodec) {
  std::ifstream file("frames.jsonl");
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

// A conversation in the protocol is compiled, not run.
void talk(Session& session, Instant now);

void talk(Session& session, Instant now) {
  AllMessages::for_each([&]<class M>(Type<M>) {
    if constexpr (M::direction != Direction::from_board) session.send(M{});
  });
  static_cast<void>(session.poll(now, [](const Event&) {}));
  if constexpr (Detector::lines != 0) {
    static Detector detector;
    static_cast<void>(detector.next(now));
  }
}

}  // namespace sbgc::test
