// Every message is read and written in two ways: member by member in constant evaluation (and on
// hosts whose memory layout differs from the wire), in blocks at run time. Both must agree.

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>

#include <gtest/gtest.h>

#include <sbgc/dispatch.hpp>
#include <sbgc/message.hpp>
#include <sbgc/meta/all.hpp>

namespace sbgc::test {
namespace {

/// A body in which neighboring bytes differ, and no float is NaN.
struct Body {
  std::array<std::uint8_t, max_body_size> bytes{};
  std::size_t size{};

  constexpr std::span<const std::uint8_t> view() const { return std::span(bytes).first(size); }
};

constexpr Body pattern(std::size_t size, std::uint8_t first) {
  Body body;
  body.size = size;
  for (std::size_t i = 0; i < size; ++i) {
    body.bytes[i] = static_cast<std::uint8_t>(1 + i * 37 % 101);
  }
  if (size != 0) body.bytes[0] = first;
  return body;
}

/// Returns the longest such body that decodes; its first byte may be a counter.
template <class M>
constexpr Body body_for() {
  for (std::size_t size = M::max_size; size + 1 > M::min_size; --size) {
    for (const std::uint8_t first : {std::uint8_t{71}, std::uint8_t{2}, std::uint8_t{0}}) {
      const Body body = pattern(size, first);
      M message{};
      if (decode(body.view(), message)) return body;
    }
  }
  // Counters further inside are 0 at least.
  Body zeros;
  zeros.size = M::min_size;
  return zeros;
}

template <class M>
constexpr Body body_of_type = body_for<M>();

template <class M>
constexpr M read_member_by_member = [] {
  M message{};
  static_cast<void>(decode(body_of_type<M>.view(), message));
  return message;
}();

template <class M>
constexpr Body written_member_by_member = [] {
  Body body;
  body.size = encode(read_member_by_member<M>, body.bytes).size;
  return body;
}();

template <class M>
void check() {
  SCOPED_TRACE(Meta<M>::info.name);
  const Body& body = body_of_type<M>;
  ASSERT_GE(body.size, M::min_size);
  M message{};
  ASSERT_TRUE(decode(body.view(), message));
  EXPECT_TRUE(message == read_member_by_member<M>);
  EXPECT_TRUE(std::ranges::equal(written_member_by_member<M>.view(), body.view()));
  Body written;
  written.size = encode(read_member_by_member<M>, written.bytes).size;
  EXPECT_TRUE(std::ranges::equal(written.view(), body.view()));

  // The checksum of a frame is computed from the message in memory if possible, otherwise from the
  // bytes written.
  const auto id = static_cast<std::uint8_t>(M::command);
  std::array<std::uint8_t, max_frame_size> framed{};
  std::array<std::uint8_t, max_frame_size> expected{};
  const auto size = encode_frame(message, framed).size;
  ASSERT_EQ(size, write_frame(id, body.view(), expected).size);
  EXPECT_TRUE(framed == expected);
}

TEST(TwoWays, AtCompileTimeAndAtRunTime) {
  AllMessages::for_each([]<class M>(Type<M>) { check<M>(); });
}

}  // namespace
}  // namespace sbgc::test
