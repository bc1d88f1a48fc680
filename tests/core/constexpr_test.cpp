// Every message is read and written in two ways: member by member in constant evaluation (and on
// hosts whose memory layout differs from the wire), in blocks at run time. Both must agree, and a
// wrong byte is a compile error.

#include <gtest/gtest.h>

#include <sbgc/messages.hpp>
#include <sbgc/meta/all.hpp>
#include <sbgc/validate.hpp>
#include <sbgc/visit.hpp>

#include "support.hpp"

namespace sbgc::test {
namespace {

/// Returns true if `message` encodes to exactly these bytes, and these bytes decode to an equal
/// message.
template <class M, std::size_t n, class... Context>
constexpr bool round_trips(const M& message, const std::array<std::uint8_t, n>& body,
                           const Context&... context) {
  std::array<std::uint8_t, max_body_size> out{};
  const WriteResult written = encode(message, out);
  if (!written || written.size != n || !std::equal(body.begin(), body.end(), out.begin())) {
    return false;
  }
  M copy{};
  return decode(body, copy, context...) && copy == message;
}

// Packed bytes, groups per axis, quantities.
constexpr msg::Control control = [] {
  msg::Control message;
  message.control_mode.set_mode(msg::ControlModeKind::angle);
  message.control_mode.set_flags(msg::ControlFlag::high_res_speed);
  message.axes.roll.speed = -0.25_deg_per_s;
  message.axes.pitch.angle = -30_deg;
  message.axes.yaw.angle = msg::Angle14(0x1234);
  return message;
}();
static_assert(round_trips(control, std::to_array<std::uint8_t>({0x82, 0xFE, 0xFF, 0, 0, 0, 0, 0xAB,
                                                                0xFA, 0, 0, 0x34, 0x12})));

// A list that fills the remaining body, flags, reserved bytes.
constexpr msg::BeepSound melody = [] {
  msg::BeepSound message;
  message.mode = msg::BeepMode::custom_melody;
  message.note_length = 40_ms;
  message.reserved[7] = 9;
  message.note_freq_hz.push_back(987_Hz);
  message.note_freq_hz.push_back(msg::NoteFrequency(21000));
  return message;
}();
static_assert(round_trips(melody, std::to_array<std::uint8_t>({0, 0x80, 5, 0, 0, 0, 0, 0, 0, 0, 0,
                                                               9, 0xDB, 0x03, 0x08, 0x52})));

// Fields whose presence depends on the request; floats.
constexpr msg::RealtimeDataCustom custom = [] {
  msg::RealtimeDataCustom message;
  message.timestamp_ms = msg::MillisecondClock(0x0102);
  message.target_angles = Axes<msg::Angle14>{msg::Angle14(1), msg::Angle14(2), msg::Angle14(-3)};
  message.z1_vector = Xyz<float>{0, 1, -2};
  message.h1_vector = Xyz<float>{};
  return message;
}();
constexpr msg::RealtimeDataCustom::Context custom_context{
    msg::RealtimeDataCustomFlag::target_angles | msg::RealtimeDataCustomFlag::z1_h1_vectors};
static_assert(round_trips(custom,
                          std::to_array<std::uint8_t>({2, 1, 1, 0, 2, 0, 0xFD, 0xFF,  //
                                                       0, 0, 0, 0, 0, 0, 0x80, 0x3F, 0, 0, 0, 0xC0,
                                                       0, 0, 0, 0, 0, 0, 0,    0,    0, 0, 0, 0}),
                          custom_context));

// A complete frame, dispatched by its id.
constexpr auto control_frame = [] {
  std::array<std::uint8_t, 18> frame{};
  const WriteResult written = encode_frame(control, frame);
  return written.size == frame.size() ? frame : std::array<std::uint8_t, 18>{};
}();
static_assert(control_frame[0] == '>' && control_frame[1] == 67 && control_frame[2] == 13 &&
              control_frame[3] == 80);
static_assert(control_frame[17] == (0x82 + 0xFE + 0xFF + 0xAB + 0xFA + 0x34 + 0x12) % 256);
static_assert(visit(67, std::span(control_frame).subspan(4, 13), Direction::to_board,
                    []<class M>(const M& message) {
                      if constexpr (std::is_same_v<M, msg::Control>) {
                        if (message == control) return;
                      }
                      throw "another message";
                    }));

// Validation and errors.
static_assert(is_valid(melody));
static_assert(!is_valid([] {
  msg::BeepSound message = melody;
  message.note_freq_hz[0] = msg::NoteFrequency(553);
  return message;
}()));
static_assert([] {
  msg::Control message;
  const Status status = decode(std::span(control_frame).subspan(4, 12), message);
  return status.code == Code::too_short && status.offset == 12;
}());

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
