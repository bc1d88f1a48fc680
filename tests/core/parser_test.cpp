#include <stdexcept>

#include <gtest/gtest.h>

#include <sbgc/parser.hpp>
#include <sbgc/small_parser.hpp>

#include "streams.hpp"

namespace sbgc::test {
namespace {

/// A parser that keeps a copy of the frames it delivers.
template <class P = Parser>
struct Collector {
  P parser;
  std::vector<ReferenceFrame> frames;

  void keep(const Frame& frame) {
    frames.push_back({frame.id,
                      {frame.body.begin(), frame.body.end()},
                      frame.offset,
                      frame.framing == Framing::v2});
  }
  void feed(std::span<const std::uint8_t> chunk) {
    parser.feed(chunk, [this](const Frame& frame) { keep(frame); });
  }
  void flush() {
    parser.flush([this](const Frame& frame) { keep(frame); });
  }
};

using ParserV2 = BasicParser<FrameFormats<CrcTable::nibbles, Framing::v2>>;
using SelectingParser = BasicParser<AnyFrameFormats>;
using SmallParserOfAll = BasicParser<AnyFrameFormats, Optimize::size>;

template <class P, class Test>
void for_each_selection(const Test& test) {
  Collector<P> selecting;
  test(selecting, Accepts::both);
  selecting.parser.formats().accept_only(Framing::v1);
  test(selecting, Accepts::v1);
  selecting.parser.formats().accept_only(Framing::v2);
  test(selecting, Accepts::v2);
}

/// Calls `test` for parsers of both kinds and all combinations of framings.
template <class Test>
void for_each_parser(const Test& test) {
  test(Collector<Parser>{}, Accepts::v1);
  test(Collector<SmallParser>{}, Accepts::v1);
  test(Collector<ParserV2>{}, Accepts::v2);
  test(Collector<ParserOfAll>{}, Accepts::both);
  for_each_selection<SelectingParser>(test);
  for_each_selection<SmallParserOfAll>(test);
}

template <class P>
void expect_same(const Collector<P>& collector, const ReferenceResult& reference) {
  ASSERT_EQ(collector.frames, reference.frames);
  const ParserCounters counters = collector.parser.counters();
  ASSERT_EQ(counters.frames, reference.frames.size());
  ASSERT_EQ(counters.skipped_bytes, reference.skipped_bytes);
  ASSERT_EQ(counters.header_errors, reference.header_errors);
  ASSERT_EQ(counters.body_errors, reference.body_errors);
  ASSERT_EQ(counters.incomplete, reference.incomplete);
  ASSERT_EQ(collector.parser.waiting_bytes(), reference.waiting_bytes);
}

/// Feeds `s` in chunks split at `cuts` (in ascending order); compares the results before and after
/// the flush. `collector` is new.
template <class P>
void check_cuts(Collector<P> collector, const Bytes& s, const std::vector<std::size_t>& cuts,
                const ReferenceResult& open, const ReferenceResult& final) {
  std::size_t begin = 0;
  for (const std::size_t cut : cuts) {
    collector.feed(std::span(s).subspan(begin, cut - begin));
    begin = cut;
  }
  collector.feed(std::span(s).subspan(begin));
  ASSERT_NO_FATAL_FAILURE(expect_same(collector, open));
  collector.flush();
  ASSERT_NO_FATAL_FAILURE(expect_same(collector, final));
}

/// Feeds `rest` to copies of `collector`, in every cutting, and compares the results. Cuttings that
/// begin the same share what that feeds.
template <class P>
void check_every_cutting(const Collector<P>& collector, std::span<const std::uint8_t> rest,
                         const ReferenceResult& open, const ReferenceResult& final) {
  if (rest.empty()) return check_cuts(collector, {}, {}, open, final);
  for (std::size_t size = 1; size <= rest.size(); ++size) {
    Collector<P> next = collector;
    next.feed(rest.first(size));
    check_every_cutting(next, rest.subspan(size), open, final);
    ASSERT_FALSE(testing::Test::HasFatalFailure()) << "after a chunk of " << size;
  }
}

template <class P>
void check_every_cutting(const Collector<P>& collector, Accepts accepts, const Bytes& s) {
  ASSERT_LE(s.size(), 18U);
  check_every_cutting(collector, s, reference_parse(s, End::open, 0, accepts),
                      reference_parse(s, End::final, 0, accepts));
}

void check_every_cutting(const Bytes& s) {
  check_every_cutting(Collector<>{}, Accepts::v1, s);
  check_every_cutting(Collector<ParserOfAll>{}, Accepts::both, s);
  check_every_cutting(Collector<SmallParserOfAll>{}, Accepts::both, s);
}

const Bytes read_params{0x3E, 0x52, 0x01, 0x53, 0x01, 0x01};  // the specification's example
const Bytes motors_on{0x3E, 0x4D, 0x00, 0x4D, 0x00};

TEST(Parser, DeliversTheLongestBody) {
  for_each_parser([](const auto& collector, Accepts accepts) {
    const Bytes frame = accepts == Accepts::v1 ? make_frame(1, Bytes(255, 0x3E))
                                               : make_v2_frame(1, Bytes(255, 0x24));
    const ReferenceResult open = reference_parse(frame, End::open, 0, accepts);
    ASSERT_EQ(open.frames.size(), 1U);
    for (std::size_t cut = 0; cut <= frame.size(); ++cut) {
      check_cuts(collector, frame, {cut}, open, open);
    }
  });
}

TEST(Parser, IsTheSameForEveryCuttingOfShortStreams) {
  check_every_cutting(concat({motors_on, read_params, motors_on}));
  check_every_cutting(concat({{0x3E, 0x3E}, read_params, {0x3E}, motors_on}));
  // A false candidate whose announced body contains a valid frame, and a start byte at the end.
  check_every_cutting(concat({{0x3E, 0x05, 0x08, 0x0D}, motors_on, read_params, {0x3E}}));
  // The body of the false candidate ends in the middle of a valid frame.
  check_every_cutting(concat({{0x3E, 0x05, 0x03, 0x08}, {9}, read_params, motors_on}));
  // Two nested false candidates.
  check_every_cutting(concat({{0x3E, 1, 8, 9}, {0x3E, 1, 2, 3}, motors_on, motors_on}));
  // A wrong header checksum; the id 0; a start byte and zeros.
  check_every_cutting(concat({{0x3E, 0x52, 0x01, 0x54, 0x01, 0x01}, motors_on}));
  check_every_cutting(concat({{0x3E, 0, 1, 1, 1, 1}, motors_on}));
  check_every_cutting(concat({{0x3E, 0, 0, 0, 0, 0, 0}, motors_on}));
  // A frame that is never completed hides two valid ones.
  check_every_cutting(concat({{0x3E, 0x05, 0xF0, 0xF5}, motors_on, read_params}));
  check_every_cutting(Bytes(16, 0x3E));
}

TEST(Parser, IsTheSameForEveryCuttingOfShortStreamsOfBothFramings) {
  const Bytes off = make_v2_frame(0x6D, {2});
  const Bytes on = make_v2_frame(0x4D, {});
  check_every_cutting(concat({on, motors_on, on}));
  check_every_cutting(concat({{0x24, 0x3E}, on, {0x3E, 0x24}, motors_on}));
  // A false candidate of each framing with a frame of the other in its body.
  check_every_cutting(concat({{0x3E, 0x05, 0x08, 0x0D}, on, off, {0x24}}));
  check_every_cutting(concat({{0x24, 0x05, 0x08, 0x0D}, motors_on, off, {0x3E}}));
  // The header and body of one framing after the start byte of the other.
  check_every_cutting(concat({{0x24}, {0x4D, 0, 0x4D, 0}, motors_on, on}));
  check_every_cutting(concat({{0x3E}, {0x6D, 1, 0x6E, 2, 0xB3, 0x07}, off}));
  check_every_cutting(concat({{0x24, 0, 0, 0, 0, 0}, on}));
}

TEST(Parser, IsTheSameForEveryCuttingOfShortRandomStreams) {
  for_each_parser([](const auto& collector, Accepts accepts) {
    for (std::uint32_t seed = 0; seed < 60; ++seed) {
      Bytes s = Random(seed, accepts).stream(6);
      s.resize(11);
      ASSERT_NO_FATAL_FAILURE(check_every_cutting(collector, accepts, s)) << "seed " << seed;
    }
  });
}

// Many streams, chunks of many sizes, flushes in between: after every step, the frames, the
// counters and the waiting bytes match the reference.
template <class P>
void follow_the_reference(const Collector<P>& fresh, Accepts accepts) {
  for (std::uint32_t seed = 0; seed < 500; ++seed) {
    Random random(seed, accepts);
    const std::size_t longest = std::size_t{1} << random.below(10);
    // The reference begins anew after each chunk.
    const Bytes s = random.stream(1 + random.below(longest < 16 ? 6 : 25));
    const bool flushes = random.below(2) == 0;

    Collector<P> collector = fresh;
    ReferenceResult settled;  // of the segments closed by a flush
    Bytes segment;
    std::uint64_t segment_offset = 0;
    const auto expect_reference = [&](End end) {
      ReferenceResult all = settled;
      const ReferenceResult now = reference_parse(segment, end, segment_offset, accepts);
      all.frames.insert(all.frames.end(), now.frames.begin(), now.frames.end());
      all.skipped_bytes += now.skipped_bytes;
      all.header_errors += now.header_errors;
      all.body_errors += now.body_errors;
      all.incomplete += now.incomplete;
      all.waiting_bytes = now.waiting_bytes;
      expect_same(collector, all);
      if (end == End::final) {
        settled = all;
        segment_offset += segment.size();
        segment.clear();
      }
    };
    for (std::size_t begin = 0; begin < s.size();) {
      const std::size_t size = std::min(s.size() - begin, random.below(longest + 1));
      const std::span chunk = std::span(s).subspan(begin, size);
      segment.insert(segment.end(), chunk.begin(), chunk.end());
      begin += size;
      collector.feed(chunk);
      ASSERT_NO_FATAL_FAILURE(expect_reference(End::open)) << "seed " << seed << " at " << begin;
      if (flushes && random.below(8) == 0) {
        collector.flush();
        ASSERT_NO_FATAL_FAILURE(expect_reference(End::final)) << "seed " << seed << " at " << begin;
      }
    }
    collector.flush();
    ASSERT_NO_FATAL_FAILURE(expect_reference(End::final)) << "seed " << seed;
  }
}

TEST(Parser, FollowsTheReferenceStepByStep) {
  for_each_parser([](const auto& collector, Accepts accepts) {
    ASSERT_NO_FATAL_FAILURE(follow_the_reference(collector, accepts));
  });
}

TEST(Parser, AcceptsAnotherFramingFromTheNextByteOn) {
  const Bytes v1 = make_frame(1, {});
  const Bytes v2 = make_v2_frame(2, {});
  Collector<SelectingParser> collector;
  auto& formats = collector.parser.formats();
  formats.accept_only(Framing::v1);
  collector.parser.feed(concat({v2, v1, v1, v2, v1}), [&](const Frame& frame) {
    collector.keep(frame);
    if (collector.frames.size() == 2) formats.accept_only(Framing::v2);
  });
  const std::vector<ReferenceFrame> expected{{1, {}, 6}, {1, {}, 11}, {2, {}, 16, true}};
  EXPECT_EQ(collector.frames, expected);
  // A candidate that waits is judged by the framing in use when its bytes are complete.
  collector.feed(std::span(v2).first(5));
  formats.accept_only(Framing::v1);
  collector.feed(concat({{v2[5]}, v1}));
  EXPECT_EQ(collector.frames.size(), 4U);
  EXPECT_EQ(collector.frames.back().id, 1);
}

TEST(Parser, FindsWhatADamagedLineLeavesIntact) {
  constexpr std::size_t frames = 2000;
  Random random(42);
  Bytes line;
  std::size_t intact = 0;
  for (std::size_t i = 0; i < frames; ++i) {
    Bytes body(124);
    for (std::uint8_t& b : body) b = random.byte();
    Bytes frame = make_frame(25, body);
    const std::size_t before = frame.size();
    std::erase_if(frame, [&](std::uint8_t) { return random.below(100) == 0; });
    if (frame.size() == before) ++intact;
    line.insert(line.end(), frame.begin(), frame.end());
  }
  Collector<> collector;
  for (std::size_t i = 0; i < line.size(); i += 50) {
    collector.feed(std::span(line).subspan(i, std::min<std::size_t>(50, line.size() - i)));
  }
  collector.flush();
  expect_same(collector, reference_parse(line, End::final));
  EXPECT_GE(static_cast<double>(collector.frames.size()), 0.995 * static_cast<double>(intact));
}

bool lies_in(std::span<const std::uint8_t> body, std::span<const std::uint8_t> chunk) {
  return body.data() >= chunk.data() && body.data() + body.size() <= chunk.data() + chunk.size();
}

TEST(Parser, ViewsFramesInsideTheChunk) {
  const Bytes chunk = concat({motors_on, {1, 2, 3}, read_params, {0x3E, 1, 1, 9}, read_params});
  Parser parser;
  int seen = 0;
  parser.feed(chunk, [&](const Frame& frame) {
    ++seen;
    EXPECT_TRUE(lies_in(frame.body, chunk));
    EXPECT_EQ(frame.body.data(), chunk.data() + frame.offset + 4);
  });
  EXPECT_EQ(seen, 3);
}

TEST(Parser, ViewsFramesInsideTheChunkAfterAFalseCandidateFromBefore) {
  // The candidate in the first chunk announces 5 + 20 bytes and is false. Of the frames in these
  // bytes, all but the first are contained in the second chunk.
  const Bytes first = concat({{0x3E, 1, 20, 21}, {0x3E, 0x52}});
  const Bytes second = concat({{0x01, 0x53, 0x01, 0x01}, read_params, motors_on, read_params});
  Parser parser;
  std::vector<std::uint64_t> copied;
  std::vector<std::uint64_t> viewed;
  const auto sink = [&](const Frame& frame) {
    (lies_in(frame.body, second) ? viewed : copied).push_back(frame.offset);
  };
  parser.feed(first, sink);
  parser.feed(second, sink);
  EXPECT_EQ(copied, (std::vector<std::uint64_t>{4}));
  EXPECT_EQ(viewed, (std::vector<std::uint64_t>{10, 16, 21}));
}

template <class P>
class ParserOfEachKind : public ::testing::Test {};
using ParserKinds = ::testing::Types<Parser, SmallParser>;
TYPED_TEST_SUITE(ParserOfEachKind, ParserKinds, );

TYPED_TEST(ParserOfEachKind, ForgetsEverythingOnReset) {
  Collector<TypeParam> collector;
  collector.feed(concat({{7}, motors_on, {0x3E, 1}}));
  collector.parser.reset();
  collector.frames.clear();
  EXPECT_EQ(collector.parser.counters(), ParserCounters{});
  EXPECT_EQ(collector.parser.waiting_bytes(), 0U);
  collector.feed(read_params);
  ASSERT_EQ(collector.frames.size(), 1U);
  EXPECT_EQ(collector.frames[0].offset, 0U);
}

TYPED_TEST(ParserOfEachKind, CanBeCopiedInTheMiddleOfAFrame) {
  Collector<TypeParam> first;
  first.feed(std::span(read_params).first(4));
  Collector<TypeParam> second = first;
  first.feed(Bytes{1, 2});
  second.feed(std::span(read_params).subspan(4));
  EXPECT_EQ(first.frames.size(), 0U);
  EXPECT_EQ(second.frames.size(), 1U);
}

TYPED_TEST(ParserOfEachKind, GoesOnAfterASinkThatThrows) {
  const auto throwing = [](const Frame&) { throw std::runtime_error("sink"); };
  const Bytes line = concat({motors_on, {1, 2}, motors_on, {0x3E, 1}});
  // In a chunk, in a frame completed by a chunk, in a flush.
  TypeParam parser;
  EXPECT_THROW(parser.feed(line, throwing), std::runtime_error);
  EXPECT_EQ(parser.counters(), (ParserCounters{.frames = 1, .skipped_bytes = line.size() - 5}));
  parser.reset();
  parser.feed(std::span(motors_on).first(2), throwing);
  EXPECT_THROW(parser.feed(concat({{0x00, 0x4D, 0x00}, line}), throwing), std::runtime_error);
  EXPECT_EQ(parser.counters(), (ParserCounters{.frames = 1, .skipped_bytes = line.size()}));
  parser.reset();
  parser.feed(concat({{0x3E, 1, 200, 201}, line}), throwing);
  EXPECT_THROW(parser.flush(throwing), std::runtime_error);
  EXPECT_EQ(parser.counters(),
            (ParserCounters{.frames = 1, .skipped_bytes = line.size() - 1, .incomplete = 1}));
  EXPECT_EQ(parser.waiting_bytes(), 0U);
  int seen = 0;
  std::uint64_t offset = 0;
  parser.feed(motors_on, [&](const Frame& frame) {
    ++seen;
    offset = frame.offset;
  });
  EXPECT_EQ(seen, 1);
  EXPECT_EQ(offset, 4 + line.size());
}

TYPED_TEST(ParserOfEachKind, ThrowsOnlyWhatItsSinkThrows) {
  const auto quiet = [](const Frame&) noexcept {};
  const auto loud = [](const Frame&) {};
  TypeParam parser;
  static_assert(noexcept(parser.feed({}, quiet))&& noexcept(parser.flush(quiet)));
  static_assert(!noexcept(parser.feed({}, loud)) && !noexcept(parser.flush(loud)));
  static_assert(noexcept(parser.counters())&& noexcept(parser.reset()));
}

/// All framings, counting the inspected bytes.
struct CountingFraming : AllFrameFormats {
  static inline std::uint64_t operations = 0;  // NOLINT(*-avoid-non-const-global-variables)

  static Candidate inspect(const std::uint8_t* bytes, std::size_t available) {
    const Candidate candidate = AllFrameFormats::inspect(bytes, available);
    const bool summed =
        candidate.verdict == Verdict::frame || candidate.verdict == Verdict::bad_body;
    operations += frame_header_size + (summed ? candidate.size : 0);
    return candidate;
  }
  static const std::uint8_t* find(const std::uint8_t* begin, const std::uint8_t* end,
                                  std::uint64_t& bad_headers) {
    const std::uint8_t* const found = AllFrameFormats::find(begin, end, bad_headers);
    operations += static_cast<std::uint64_t>(found - begin) + 1;
    return found;
  }
};

template <Optimize optimize>
std::uint64_t operations_for(const Bytes& s, std::size_t chunk_size) {
  CountingFraming::operations = 0;
  Collector<BasicParser<CountingFraming, optimize>> collector;
  for (std::size_t i = 0; i < s.size(); i += chunk_size) {
    collector.feed(std::span(s).subspan(i, std::min(chunk_size, s.size() - i)));
  }
  collector.flush();
  return CountingFraming::operations;
}

Bytes repeat(const Bytes& pattern, std::size_t size) {
  Bytes s(size);
  for (std::size_t i = 0; i < size; ++i) s[i] = pattern[i % pattern.size()];
  return s;
}

// For every stream and every chunk size, a byte costs at most about the length of a frame. (The
// parser copies no more than it inspects: one frame per verdict.)
template <Optimize optimize>
void expect_bounded_work() {
  const std::vector<Bytes> patterns{
      {0x3E},                    // every byte is a start byte
      {0x3E, 0x3F, 0xFF},        // every third byte starts a header, 255 bytes
      {0x3E, 0x01, 0xFF, 0x00},  // every fourth byte
      {0x3E, 0x00, 0x00, 0x00},  // id 0
      make_frame(1, repeat({0x3E, 0x3F, 0xFF}, 255)),         // the same in valid frames
      concat({{0x3E, 1, 255, 0}, Bytes(256, 0x3E)}),          // a false frame full of start bytes
      concat({{0x3E, 1, 254, 255}, repeat(motors_on, 255)}),  // or full of frames
      Random(1).noise(1000),
      {0x24},
      {0x24, 0x25, 0xFF, 0x3E, 0x3F, 0xFF},
      make_v2_frame(1, repeat({0x24, 0x25, 0xFF}, 255)),
      concat({{0x24, 1, 254, 255}, repeat(motors_on, 256)}),
      Random(2, Accepts::both).noise(1000),
  };
  for (const Bytes& pattern : patterns) {
    for (const std::size_t chunk_size : {1U, 2U, 3U, 64U, 259U, 260U, 261U, 100'000U}) {
      const std::size_t size = 20'000;
      const std::uint64_t once = operations_for<optimize>(repeat(pattern, size), chunk_size);
      const std::uint64_t twice = operations_for<optimize>(repeat(pattern, 2 * size), chunk_size);
      EXPECT_LE(once, size * (max_frame_size + 20));
      EXPECT_LE(twice, 2 * once + 300 * max_frame_size) << "more than linear";
    }
  }
}

TEST(Parser, DoesBoundedWorkPerByte) {
  expect_bounded_work<Optimize::speed>();
  expect_bounded_work<Optimize::size>();
}

}  // namespace
}  // namespace sbgc::test
