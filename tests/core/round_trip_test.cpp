// Tests every message with bodies of every size: a decoded body encodes to the same bytes, any
// other body is an error with a position, and no byte outside the buffers is touched.

#include <gtest/gtest.h>

#include <sbgc/frame.hpp>

#include "messages.hpp"

namespace sbgc::test {
namespace {

constexpr int bodies_per_size = 40;
constexpr std::uint8_t untouched = 0xA5;

bool all_untouched(std::span<const std::uint8_t> bytes) {
  return std::ranges::all_of(bytes, [](std::uint8_t byte) { return byte == untouched; });
}

/// Returns true if validation reports a list as too long, by its size or by its counter.
bool has_tail(const AnyMessage& message) {
  bool result = false;
  message.for_each_leaf([&](const Leaf& leaf) { result = result || &leaf.field == &tail_field; });
  return result;
}

bool has_too_many_elements(const AnyMessage& message) {
  return std::ranges::any_of(violations_of(message), [](const ViolationCopy& violation) {
    return violation.rule == Rule::count || violation.rule == Rule::maximum;
  });
}

/// Calls `encode` with buffers of exactly the right size and of every smaller size.
template <class Encode>
void check_buffers(const ByteVector& expected, const Encode& encode) {
  constexpr std::size_t margin = 8;
  ByteVector out(expected.size() + margin, untouched);
  const WriteResult exact = encode(std::span(out).first(expected.size()));
  ASSERT_TRUE(exact) << name(exact.status.code);
  ASSERT_EQ(exact.size, expected.size());
  EXPECT_TRUE(std::equal(expected.begin(), expected.end(), out.begin()));
  EXPECT_TRUE(all_untouched(std::span(out).last(margin))) << "written past the buffer";

  for (std::size_t size = 0; size < expected.size(); ++size) {
    std::ranges::fill(out, untouched);
    const WriteResult small = encode(std::span(out).first(size));
    EXPECT_EQ(small.status.code, Code::buffer_too_small) << "buffer of " << size;
    EXPECT_EQ(small.size, 0U);
    EXPECT_TRUE(all_untouched(std::span(out).subspan(size))) << "past a buffer of " << size;
  }
}

class RoundTrip : public testing::TestWithParam<const MessageType*> {
 protected:
  const MessageInfo& info() const { return *GetParam()->info; }

  void check_decoded(const AnyMessage& message, const ByteVector& body) const {
    ByteVector out(max_body_size);
    const WriteResult written = message.encode(out);
    ASSERT_TRUE(written) << name(written.status.code) << " at " << written.status.field;
    out.resize(written.size);
    ASSERT_EQ(out, body);
    EXPECT_GE(body.size(), info().min_size);
    // The protocol limits a confirmation as a whole; the limits of its parts add up to more.
    if (body.size() > info().max_size && info().name != std::string("Confirm")) {
      EXPECT_TRUE(has_tail(message) || has_too_many_elements(message))
          << "longer than max_size without a reason";
    }
  }

  void check_refused(const Status& status, std::size_t size) const {
    const bool expected = status.code == Code::too_short || status.code == Code::too_long ||
                          status.code == Code::text_too_long;
    EXPECT_TRUE(expected) << name(status.code);
    EXPECT_LE(status.offset, size);
    ASSERT_NE(status.field, nullptr);
    if (size < info().min_size) {
      EXPECT_EQ(status.code, Code::too_short);
    }
    if (is_of_fixed_size(*GetParam())) {
      EXPECT_NE(size, info().min_size) << "the right size is rejected";
    }
  }
};

TEST_P(RoundTrip, EveryBodyThatDecodesEncodesToTheSameBytes) {
  RandomBodies bodies(info().id);
  int decoded = 0;
  auto used = GetParam()->make();  // reused: no value may leak into the next decoding
  for (std::size_t size = 0; size <= max_body_size; ++size) {
    for (int i = 0; i < bodies_per_size; ++i) {
      const ByteVector body = bodies.next(size);
      const ExactCopy copy(body);
      const Contexts& contexts = random_contexts(size + static_cast<unsigned>(i));
      auto message = GetParam()->make();
      const Status status = message.decode(copy.get(), contexts);
      ASSERT_EQ(used.decode(copy.get(), contexts).code, status.code);
      if (status) {
        ++decoded;
        check_decoded(message, body);
        check_decoded(used, body);
      } else {
        check_refused(status, size);
      }
      if (HasFailure()) FAIL() << "with " << size << " bytes, body " << i;
    }
  }
  EXPECT_GE(decoded, bodies_per_size / 2) << "too few bodies decode";
}

/// Returns whether a leaf says what its bytes in the body say.
bool says(const LeafCopy& leaf, std::span<const std::uint8_t> bytes) {
  std::uint64_t bits = 0;
  for (std::size_t i = std::min<std::size_t>(bytes.size(), 8); i > 0; --i) {
    bits = bits << 8 | bytes[i - 1];
  }
  switch (leaf.kind) {
    case LeafKind::integer:
    case LeafKind::counter: {
      const std::uint64_t mask = ~std::uint64_t{0} >> (64 - 8 * bytes.size());
      return (static_cast<std::uint64_t>(leaf.integer) & mask) == bits;
    }
    case LeafKind::real: {
      const auto low_bits = static_cast<std::uint32_t>(bits);
      const double real = bytes.size() == 8 ? std::bit_cast<double>(bits)
                                            : static_cast<double>(std::bit_cast<float>(low_bits));
      return leaf.real == real || (std::isnan(leaf.real) && std::isnan(real));
    }
    case LeafKind::bytes: return std::ranges::equal(leaf.bytes, bytes);
    case LeafKind::text: break;
  }
  // A text is padded with NUL, or preceded by its length.
  const auto length = static_cast<std::ptrdiff_t>(leaf.bytes.size());
  ByteVector padded = leaf.bytes;
  padded.resize(bytes.size());
  ByteVector preceded{static_cast<std::uint8_t>(length)};
  preceded.insert(preceded.end(), leaf.bytes.begin(), leaf.bytes.end());
  return std::ranges::equal(padded, bytes) || std::ranges::equal(preceded, bytes);
}

TEST_P(RoundTrip, LeavesAreTheBytesOfTheBodyOneAfterTheOther) {
  RandomBodies bodies(13);
  for (std::size_t i = 0; i < 300; ++i) {
    const std::size_t more = is_of_fixed_size(*GetParam()) ? 0 : i % 40;
    auto message = GetParam()->make();
    const ByteVector body = bodies.next(std::min(info().min_size + more, max_body_size));
    if (!message.decode(body, random_contexts(i))) continue;
    std::size_t end = 0;
    for (const LeafCopy& leaf : leaves_of(message)) {
      ASSERT_EQ(leaf.offset, end);
      end += leaf.size;
      ASSERT_LE(end, body.size());
      EXPECT_TRUE(says(leaf, std::span(body).subspan(leaf.offset, leaf.size)))
          << leaf.offset << ": " << leaf.integer << ", " << leaf.real;
    }
    ASSERT_EQ(end, body.size());
  }
}

TEST_P(RoundTrip, EqualMessagesAreThoseWithEqualBytes) {
  const std::size_t min_size = info().min_size;
  RandomBodies bodies(7);
  auto previous = GetParam()->make();
  for (std::size_t i = 0; i < 2000; ++i) {
    const std::size_t more = is_of_fixed_size(*GetParam()) ? 0 : i % (max_body_size - min_size + 1);
    auto message = GetParam()->make();
    if (!message.decode(bodies.next(min_size + more))) continue;
    const ByteVector body = encoded_body(message);
    auto copy = GetParam()->make();
    ASSERT_TRUE(copy.decode(body));
    const bool has_nan = !(message == message);
    EXPECT_TRUE(has_nan || (copy == message));
    EXPECT_TRUE(body == encoded_body(previous) || !(previous == message));
    previous = std::move(message);
  }
}

TEST_P(RoundTrip, BuffersMayBeExactButNotSmaller) {
  RandomBodies bodies(11);
  int checked = 0;
  for (std::size_t i = 0; i < 5000 && checked < 10; ++i) {
    const std::size_t more = i % 2 == 0 ? 0 : i % 24;
    const ByteVector body = bodies.next(std::min(info().min_size + more, max_body_size));
    auto message = GetParam()->make();
    if (!message.decode(body)) continue;
    ++checked;
    check_buffers(body, [&](std::span<std::uint8_t> out) { return message.encode(out); });
    ByteVector frame(frame_size(body.size()));
    ASSERT_TRUE(write_frame(info().id, body, frame));
    check_buffers(frame, [&](std::span<std::uint8_t> out) { return typed_frame(message, out); });
    check_buffers(frame, [&](std::span<std::uint8_t> out) {
      return message.encode_frame(basic_framing, out);
    });
  }
  EXPECT_EQ(checked, 10);
}

TEST_P(RoundTrip, TheDefaultMessageEncodesAndDecodes) {
  auto message = GetParam()->make();
  ByteVector buffer(max_body_size);
  const Code code = message.encode(buffer).status.code;
  if (code == Code::presence_mismatch) return;  // other fields require a field without a default
  if (code == Code::count_mismatch) {
    // A list with a minimum length is empty. This is reported, and no element is made up.
    const auto violations = violations_of(message);
    ASSERT_FALSE(violations.empty());
    EXPECT_EQ(violations[0].rule, Rule::count);
    return;
  }
  const ByteVector body = encoded_body(message);
  EXPECT_GE(body.size(), info().min_size);
  EXPECT_LE(body.size(), info().max_size);
  auto copy = GetParam()->make();
  ASSERT_TRUE(copy.decode(body));
  EXPECT_EQ(encoded_body(copy), body);
}

INSTANTIATE_TEST_SUITE_P(Messages, RoundTrip, testing::ValuesIn(message_types()),
                         [](const auto& test) { return test.param->info->name; });

TEST(EncodeBody, TellsASmallBufferFromABodyThatNoFrameCarries) {
  msg::DebugVars3 message;
  for (int i = 0; i < 64; ++i) message.var_value.push_back({NumberType::u32, 0});
  ByteVector out(300);
  const auto code = [&](std::size_t space) {
    return encode_body(message, std::span(out).first(space)).status.code;
  };
  EXPECT_EQ(code(254), Code::buffer_too_small);
  EXPECT_EQ(code(255), Code::too_long) << "the body has 256 bytes";
  EXPECT_EQ(code(256), Code::too_long);
}

TEST(EncodeBody, RefusesANumberWithoutAType) {
  msg::DebugVars3 message;
  message.var_value.push_back({NumberType::i16, 5});
  ByteVector out(10);
  EXPECT_EQ(encode_body(message, out).size, 2U);
  message.var_value.push_back({NumberType::none, 5});
  EXPECT_EQ(encode_body(message, out).status.code, Code::value_out_of_range);
}

/// A list after its counter, which counts as in no message of the specification so far.
template <Counting counting>
struct Counted {
  BoundedArray<std::uint16_t, 4> list{};

  static constexpr void varying_members(auto& self, auto& cursor) noexcept {
    std::uint8_t count{};
    cursor.template count_as<counting>(count, self.list, "count");
    cursor.template counted_as<counting>(self.list, count, "list");
  }
};

template <Counting counting>
void expect_counted(std::uint8_t count) {
  Counted<counting> counted;
  counted.list.push_back(0x0102);
  counted.list.push_back(0x0304);
  ByteVector body(5);
  detail::Writer writer(body, 0);
  Counted<counting>::varying_members(counted, writer);
  ASSERT_EQ(writer.end().size, 5U);
  EXPECT_EQ(body, (ByteVector{count, 0x02, 0x01, 0x04, 0x03}));
  Counted<counting> copy;
  detail::Reader reader(body, 0);
  Counted<counting>::varying_members(copy, reader);
  EXPECT_TRUE(reader.end());
  EXPECT_EQ(copy.list, counted.list);
}

TEST(Counter, CanCountBytes) {
  expect_counted<Counting::bytes>(4);
  const ByteVector body{3, 1, 2, 3, 4};
  Counted<Counting::bytes> counted;
  detail::Reader reader(body, 0);
  Counted<Counting::bytes>::varying_members(counted, reader);
  EXPECT_EQ(reader.end().code, Code::count_mismatch) << "3 bytes are no numbers of 2";
}

TEST(Counter, CanCountAllElementsButOne) {
  expect_counted<Counting::minus_1>(1);
  const Counted<Counting::minus_1> none;
  ByteVector body(5);
  detail::Writer writer(body, 0);
  Counted<Counting::minus_1>::varying_members(none, writer);
  EXPECT_EQ(writer.end().status.code, Code::count_mismatch);
}

/// A member whose size varies, as no axis of a message of the specification has so far.
struct Named {
  BoundedText<3> name{};

  bool operator==(const Named&) const = default;
  static constexpr void varying_members(auto& self, auto& cursor) noexcept {
    cursor.value(self.name, "name");
  }
};

template <class T>
void expect_three_names() {
  T names;
  ASSERT_TRUE(names[0].name.assign(std::string_view("a")));
  ASSERT_TRUE(names[2].name.assign(std::string_view("xyz")));
  const ByteVector expected{1, 'a', 0, 3, 'x', 'y', 'z'};
  ByteVector body(expected.size());
  detail::Writer writer(body, 0);
  writer.value(names, "names");
  EXPECT_TRUE(writer.end());
  EXPECT_EQ(body, expected);
  T copy;
  detail::Reader reader(body, 0);
  reader.value(copy, "names");
  EXPECT_TRUE(reader.end());
  EXPECT_TRUE(copy == names);
}

TEST(VaryingSize, OfEachAxis) { expect_three_names<Axes<Named>>(); }

TEST(VaryingSize, OfEachCoordinate) { expect_three_names<Xyz<Named>>(); }

TEST(VaryingSize, OfEachElement) { expect_three_names<std::array<Named, 3>>(); }

}  // namespace
}  // namespace sbgc::test
