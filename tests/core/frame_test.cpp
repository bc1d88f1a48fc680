// Tests of frames: written and recognized; and of the fuzzers' mutator, which mends them.

#include <gtest/gtest.h>

#include <sbgc/frame.hpp>
#include <sbgc/parser.hpp>
#include <sbgc/small_parser.hpp>

#include "mend_frames.hpp"
#include "streams.hpp"

namespace sbgc::test {
namespace {

template <std::size_t size>
using Array = std::array<std::uint8_t, size>;

constexpr Array<6> whole_frame{0x3E, 0x52, 0x01, 0x53, 0x01, 0x01};

// The specification's example, written and read at compile time.
static_assert([] {
  Array<6> out{};
  const WriteResult result = write_frame(0x52, Array<1>{0x01}, out);
  return result && result.size == 6 && out == whole_frame;
}());
static_assert([] {
  Array<6> out{};
  *frame_body(out.data()) = 0x01;
  return finish_frame(out.data(), 0x52, 1) == 6 && out == whole_frame;
}());
static_assert(FrameFormat<Framing::v1>::inspect(whole_frame.data(), 6).verdict == Verdict::frame);
static_assert(FrameFormat<Framing::v1>::inspect(whole_frame.data(), 6).size == 6);
static_assert(FrameFormat<Framing::v1>::inspect(whole_frame.data(), 5).verdict ==
              Verdict::incomplete);
static_assert(FrameFormat<Framing::v1>::inspect(whole_frame.data(), 5).size == 6);
static_assert(FrameFormat<Framing::v1>::inspect(whole_frame.data(), 3).size == 4);
static_assert(FrameFormat<Framing::v1>::inspect(whole_frame.data() + 1, 5).verdict ==
              Verdict::no_start);

static_assert(noexcept(write_frame(1, {}, {})));
static_assert(write_frame(0, {}, {}).status.code == Code::invalid_id);
static_assert(write_frame(1, {}, {}).status.code == Code::buffer_too_small);
static_assert(check_frame(1, 255, 260).code == Code::ok);
static_assert(check_frame(1, 256, 1000).code == Code::too_long);

TEST(WriteFrame, FramesEverySizeOfBody) {
  Random random(1);
  for (std::size_t size = 0; size <= 255; ++size) {
    const Bytes body = random.noise(size);
    Bytes out(size + 5 + 3, 0xAA);
    const WriteResult result = write_frame(0xFE, body, out);
    ASSERT_TRUE(result);
    ASSERT_EQ(result.size, size + 5);
    Bytes expected = make_frame(0xFE, body);
    expected.resize(out.size(), 0xAA);  // bytes after the frame remain unchanged
    ASSERT_EQ(out, expected);
  }
}

TEST(WriteFrame, LeavesTheOutputAloneOnFailure) {
  Bytes out(600, 0xAA);
  const Bytes untouched = out;
  const auto refuses = [&](std::uint8_t id, std::size_t body_size, std::size_t space, Code code) {
    const WriteResult result = write_frame(id, Bytes(body_size), std::span(out).first(space));
    EXPECT_FALSE(result);
    EXPECT_EQ(result.size, 0U);
    EXPECT_EQ(result.status.code, code);
    EXPECT_STREQ(result.status.field, "");
    EXPECT_EQ(out, untouched);
  };
  refuses(0, 1, 600, Code::invalid_id);
  refuses(1, 256, 600, Code::too_long);
  refuses(1, 300, 600, Code::too_long);
  for (std::size_t space = 0; space < 15; ++space) refuses(1, 10, space, Code::buffer_too_small);
  refuses(1, 255, 259, Code::buffer_too_small);
}

TEST(WriteFrame, AcceptsABodyThatIsInPlace) {
  Bytes out(9);
  const Bytes body{1, 2, 3, 4};
  std::copy(body.begin(), body.end(), frame_body(out.data()));
  ASSERT_TRUE(write_frame(9, std::span(out).subspan(4, 4), out));
  EXPECT_EQ(out, make_frame(9, body));
}

// A frame of the second framing, written at compile time.
constexpr Array<6> v2_frame{0x24, 0x4D, 0x00, 0x4D, 0x44, 0x0A};
static_assert([] {
  Array<6> out{};
  return write_frame<Framing::v2>(0x4D, {}, out) && out == v2_frame;
}());
static_assert(frame_at(v2_frame.data()).framing == Framing::v2);
static_assert(check_frame<Framing::v2>(1, 255, 260).code == Code::buffer_too_small);
static_assert(check_frame<Framing::v2>(1, 255, 261).code == Code::ok);

TEST(WriteFrame, WritesEitherFraming) {
  Random random(4);
  for (std::size_t size = 0; size <= 255; ++size) {
    const Bytes body = random.noise(size);
    Bytes out(size + 6);
    ASSERT_TRUE(write_frame<Framing::v2>(0xFE, body, out));
    ASSERT_EQ(out, make_v2_frame(0xFE, body));
    Bytes selected(max_frame_size);
    for (const Framing framing : framings) {
      const WriteResult written = write_frame(framing, 0xFE, body, selected);
      ASSERT_TRUE(written);
      const Bytes expected =
          framing == Framing::v1 ? make_frame(0xFE, body) : make_v2_frame(0xFE, body);
      ASSERT_EQ(Bytes(selected.data(), selected.data() + written.size), expected);
    }
  }
}

template <class Formats>
void expect_the_plain_search(const Formats& formats, Accepts accepts) {
  for (std::uint32_t seed = 0; seed < 3000; ++seed) {
    Random random(seed, accepts);
    Bytes s = random.noise(random.below(120));
    if (random.below(2) == 0 && s.size() >= 8) {
      const Bytes header{random.start(), 5, 1, 6};
      std::copy(header.begin(), header.end(),
                s.begin() + static_cast<std::ptrdiff_t>(random.below(s.size() - 3)));
    }
    std::uint64_t expected_headers = 7;
    std::size_t expected = 0;
    for (; expected < s.size(); ++expected) {
      const Verdict verdict = formats.inspect(&s[expected], s.size() - expected).verdict;
      if (verdict == Verdict::bad_header) ++expected_headers;
      if (verdict != Verdict::bad_header && verdict != Verdict::no_start) break;
    }
    std::uint64_t bad_headers = 7;
    const std::uint8_t* const found = formats.find(s.data(), s.data() + s.size(), bad_headers);
    ASSERT_EQ(static_cast<std::size_t>(found - s.data()), expected) << "seed " << seed;
    ASSERT_EQ(bad_headers, expected_headers) << "seed " << seed;
  }
}

// The search examines 16 positions at a time; every remainder and every position must count alike.
TEST(Framing, FindsWhatAPlainSearchFinds) {
  expect_the_plain_search(FrameFormats<CrcTable::slices, Framing::v1>{}, Accepts::v1);
  expect_the_plain_search(FrameFormats<CrcTable::bytes, Framing::v2>{}, Accepts::v2);
  expect_the_plain_search(AllFrameFormats{}, Accepts::both);
  AnyFrameFormats selected;
  expect_the_plain_search(selected, Accepts::both);
  selected.accept_only(Framing::v2);
  expect_the_plain_search(selected, Accepts::v2);
  expect_the_plain_search(selected, Accepts::both);  // with starts that it must ignore
}

TEST(Framing, WhatHasNoHeaderHasNoSize) {
  const auto expect = [](Candidate candidate, Verdict verdict) {
    EXPECT_EQ(candidate.verdict, verdict);
    EXPECT_EQ(candidate.size, 0U);
  };
  const Bytes zeros(8);
  expect(FrameFormat<Framing::v1>::inspect(zeros.data(), zeros.size()), Verdict::no_start);
  expect(FrameFormat<Framing::v2>::inspect(zeros.data(), zeros.size()), Verdict::no_start);
  expect(AllFrameFormats::inspect(zeros.data(), zeros.size()), Verdict::no_start);
  Bytes start = zeros;
  start[0] = 0x3E;
  expect(FrameFormat<Framing::v1>::inspect(start.data(), start.size()), Verdict::bad_header);
}

TEST(Framing, CountsManyStartsInOneSearch) {
  const Bytes starts(100'000, 0x3E);
  std::uint64_t bad_headers = 0;
  const std::uint8_t* const found =
      AllFrameFormats::find(starts.data(), starts.data() + starts.size(), bad_headers);
  EXPECT_EQ(found, starts.data() + starts.size() - 3);  // too few remaining bytes for a header
  EXPECT_EQ(bad_headers, starts.size() - 3);
}

std::size_t intact_frames_in(const std::vector<std::uint8_t>& bytes) {
  std::size_t count = 0;
  ParserOfAll parser;
  parser.feed(bytes, [&](const Frame&) { ++count; });
  return count;
}

TEST(MendFrames, FramesOfBothFramingsGetTheirChecksums) {
  std::vector<std::uint8_t> input{7, 7};
  for (const Framing framing : framings) {
    const std::array<std::uint8_t, 3> body{1, 2, 3};
    std::array<std::uint8_t, max_frame_size> frame{};
    const auto written = write_frame(framing, 67, body, frame);
    ASSERT_TRUE(written);
    frame[3] ^= 0xFF;                 // the checksum of the header
    frame[written.size - 1] ^= 0xFF;  // the last byte of the trailer
    input.insert(input.end(), frame.begin(), frame.begin() + written.size);
    input.push_back(9);
  }
  ASSERT_EQ(intact_frames_in(input), 0U);
  EXPECT_EQ(fuzz::mend_frames(input), framings.size());
  EXPECT_EQ(intact_frames_in(input), framings.size());
  EXPECT_EQ(input[0], 7);
  EXPECT_EQ(input.back(), 9);
}

TEST(MendFrames, OtherBytesDoNotChange) {
  const std::vector<std::vector<std::uint8_t>> inputs{
      {},
      {0x3E},
      {0x24, 67, 0},
      {0x3E, 0, 0, 0, 0},     // no id
      {0x3E, 67, 5, 0, 1, 2}  // the body is not all there
  };
  for (const auto& input : inputs) {
    std::vector<std::uint8_t> mended = input;
    EXPECT_EQ(fuzz::mend_frames(mended), 0U);
    EXPECT_EQ(mended, input);
  }
}

}  // namespace
}  // namespace sbgc::test
