// The worked examples of the specification, with every field written by hand.

#include <array>
#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

#include <sbgc/message.hpp>
#include <sbgc/messages.hpp>
#include <sbgc/parser.hpp>

#include "support.hpp"

namespace sbgc::test {
namespace {

std::vector<unsigned> notes(const msg::BeepSound& message) {
  std::vector<unsigned> result;
  for (const msg::NoteFrequency note : message.note_freq_hz) result.push_back(note.raw());
  return result;
}

// "Message format": the command that reads profile 2.
TEST(WorkedExamples, ReadProfile2) {
  const ByteVector bytes = from_hex("3E 52 01 53 01 01");
  int frames = 0;
  Parser parser;
  parser.feed(bytes, [&](const Frame& frame) {
    ++frames;
    EXPECT_EQ(frame.id, 82);
    EXPECT_EQ(frame.offset, 0U);
    EXPECT_EQ(ByteVector(frame.body.begin(), frame.body.end()), ByteVector{1});
  });
  EXPECT_EQ(frames, 1);

  ByteVector written(max_frame_size);
  const std::array<std::uint8_t, 1> body{1};
  const WriteResult result = write_frame(82, body, written);
  ASSERT_TRUE(result);
  written.resize(result.size);
  EXPECT_EQ(written, bytes);
}

// L160-L161: "10 means 1.0", "2305 means 2.30b5".
TEST(WorkedExamples, Versions) {
  EXPECT_EQ(msg::BoardVersion(10).major(), 1);
  EXPECT_EQ(msg::BoardVersion(10).minor(), 0);
  EXPECT_EQ(msg::FirmwareVersion(2305).major(), 2);
  EXPECT_EQ(msg::FirmwareVersion(2305).minor(), 30);
  EXPECT_EQ(msg::FirmwareVersion(2305).beta(), 5);
}

// L1227, example 1: "simple melody with short B5, D6, G6 notes and envelope".
TEST(WorkedExamples, BeepSoundMelody) {
  const ByteVector body = from_hex(
      "00 80 05 03 00 00 00 00 00 00 00 00 DB 03 DB 03 08 52 DB 03 DB 03 08 52 96 04 96 04 08 52 "
      "1F 06 1F 06 1F 06 1F 06 1F 06");
  msg::BeepSound message;
  ASSERT_TRUE(decode(body, message));
  EXPECT_EQ(message.mode, msg::BeepModes(msg::BeepMode::custom_melody));
  EXPECT_EQ(message.note_length.raw(), 5);
  EXPECT_EQ(message.note_length.milliseconds(), 40);
  EXPECT_EQ(message.decay_factor, 3);
  EXPECT_EQ(message.reserved, sbgc::Bytes<8>{});
  constexpr unsigned b5 = 987;
  constexpr unsigned d6 = 1174;
  constexpr unsigned g6 = 1567;
  constexpr unsigned pause = 21000;
  EXPECT_EQ(notes(message),
            (std::vector{b5, b5, pause, b5, b5, pause, d6, d6, pause, g6, g6, g6, g6, g6}));
  EXPECT_EQ(message.note_freq_hz[0].hertz(), 987);
  EXPECT_EQ(body_of(message), body);
}

// L1227, example 2: "standard "calibration" sound". Its fourth byte is DECAY_FACTOR 3.
TEST(WorkedExamples, BeepSoundCalibration) {
  const ByteVector body = from_hex("01 00 00 03 00 00 00 00 00 00 00 00");
  msg::BeepSound message;
  ASSERT_TRUE(decode(body, message));
  EXPECT_EQ(message.mode, msg::BeepModes(msg::BeepMode::calibrate));
  EXPECT_EQ(message.note_length.raw(), 0);
  EXPECT_EQ(message.decay_factor, 3);
  EXPECT_TRUE(message.note_freq_hz.empty());

  msg::BeepSound built;
  built.mode = msg::BeepMode::calibrate;
  built.decay_factor = 3;
  EXPECT_EQ(body_of(built), body);
  EXPECT_EQ(built, message);
}

// L1227, example 3: "single beep 1 second at 3kHz".
TEST(WorkedExamples, BeepSoundOneSecond) {
  const ByteVector body = from_hex("00 80 7D 00 00 00 00 00 00 00 00 00 B8 0B");
  msg::BeepSound message;
  ASSERT_TRUE(decode(body, message));
  EXPECT_EQ(message.note_length.milliseconds(), 1000);
  EXPECT_EQ(message.decay_factor, 0);
  EXPECT_EQ(notes(message), std::vector{3000U});

  msg::BeepSound built;
  built.mode = msg::BeepMode::custom_melody;
  built.note_length = 1000_ms;
  ASSERT_TRUE(built.note_freq_hz.push_back(3000_Hz));
  EXPECT_EQ(body_of(built), body);
}

}  // namespace
}  // namespace sbgc::test
