// Tests of pins, servos and sounds; debug variables report their state.

#include <array>
#include <cstdint>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "debug_values.hpp"
#include "replies.hpp"

namespace sbgc::test {
namespace {

using emulator::BoardOptions;
using ::testing::IsEmpty;

msg::TriggerPin pin(msg::OutputPin id, msg::PinState state = msg::PinState::high) {
  return {.pin_id = id, .state = state};
}

/// Modifies the parameters of the first profile.
template <class Change>
void change(Host& host, const Change& change) {
  msg::WriteParams3 parameters;
  static_cast<msg::ReadParams3&>(parameters) =
      host.get<msg::ReadParams3>(msg::ReadParams3Request{});
  change(parameters);
  ASSERT_TRUE(is_confirmed(host, parameters));
}

msg::ServoOut servos(std::int16_t first, std::int16_t others = msg::ServoOut::floating) {
  msg::ServoOut request;
  request.servo_time.fill(msg::ServoPulse(others));
  request.servo_time[0] = msg::ServoPulse(first);
  return request;
}

double sound(Host& host) { return debug_values(host).at("SOUND")[0]; }

TEST(Pins, AreSwitchedAndConfirmed) {
  Host host;
  EXPECT_EQ(debug_values(host).at("HIGH_PINS")[0], 0);
  EXPECT_TRUE(is_confirmed(host, pin(msg::OutputPin::pin_aux1)));
  const double one = debug_values(host).at("HIGH_PINS")[0];
  EXPECT_NE(one, 0);
  EXPECT_TRUE(is_confirmed(host, pin(msg::OutputPin::pin_buzzer)));
  EXPECT_GT(debug_values(host).at("HIGH_PINS")[0], one);
  EXPECT_TRUE(is_confirmed(host, pin(msg::OutputPin::pin_buzzer, msg::PinState::low)));
  EXPECT_EQ(debug_values(host).at("HIGH_PINS")[0], one);
}

TEST(Pins, InputsStayInputs) {
  Host host;
  change(host, [](msg::ReadParams3& parameters) {
    parameters.rc_map = {msg::RcInput::rc_input_roll, msg::RcInput::input_no,
                         msg::RcInput::input_no};
    parameters.rc_map_fc_pitch = msg::RcInput::ext_fc_input_pitch;
  });
  EXPECT_THAT(host.ask(pin(msg::OutputPin::rc_input_roll)), IsEmpty());
  EXPECT_THAT(host.ask(pin(msg::OutputPin::ext_fc_input_pitch)), IsEmpty());
  EXPECT_TRUE(is_confirmed(host, pin(msg::OutputPin::rc_input_pitch)));
  EXPECT_TRUE(is_confirmed(host, pin(msg::OutputPin::ext_fc_input_roll)));
}

TEST(Pins, AReceiverTakesTheFirst) {
  Host host;
  change(host, [](msg::ReadParams3& parameters) { parameters.rc_map = {}; });
  EXPECT_TRUE(is_confirmed(host, pin(msg::OutputPin::rc_input_roll)));
  change(host,
         [](msg::ReadParams3& parameters) { parameters.rc_virt_mode = msg::RcVirtualMode::sbus; });
  EXPECT_THAT(host.ask(pin(msg::OutputPin::rc_input_roll)), IsEmpty());
}

TEST(Pins, ASerialPortTakesTwo) {
  Host host;
  change(host, [](msg::ReadParams3& parameters) {
    parameters.rc_map = {};
    parameters.rc_virt_mode = msg::RcVirtualMode::api;
  });
  EXPECT_THAT(host.ask(pin(msg::OutputPin::rc_input_roll)), IsEmpty());
  EXPECT_THAT(host.ask(pin(msg::OutputPin::rc_input_yaw)), IsEmpty());
  EXPECT_TRUE(is_confirmed(host, pin(msg::OutputPin::rc_input_pitch)));
}

TEST(Pins, SlotsReadThemToo) {
  Host host;
  change(host, [](msg::ReadParams3& parameters) { parameters.rc_map = {}; });
  msg::WriteAdjVarsCfg config;
  config.trigger_slots[4].src_ch = msg::RcInput::rc_input_yaw;
  ASSERT_TRUE(is_confirmed(host, config));
  EXPECT_THAT(host.ask(pin(msg::OutputPin::rc_input_yaw)), IsEmpty());
}

TEST(Pins, WhatIsNoPinOrStateIsMetWithSilence) {
  Host host;
  EXPECT_THAT(host.ask(pin(msg::OutputPin{0})), IsEmpty());
  EXPECT_THAT(host.ask(pin(msg::OutputPin{19})), IsEmpty());
  EXPECT_THAT(host.ask(pin(msg::OutputPin::pin_aux1, msg::PinState{2})), IsEmpty());
}

TEST(Pins, AnInputThatDoesNotExistIsUnavailable) {
  BoardOptions options;
  options.board = msg::BoardVersion(36);
  for (const std::uint16_t firmware : {newest_firmware, std::uint16_t{2742}}) {
    options.firmware = msg::FirmwareVersion(firmware);
    Host host(options);
    for (const auto state : {msg::PinState::input_pull_up, msg::PinState::input_pull_down}) {
      const auto confirmed = all<msg::Confirm>(host.ask(pin(msg::OutputPin{19}, state)));
      ASSERT_EQ(confirmed.size(), firmware == newest_firmware ? 1U : 0U);
      if (confirmed.empty()) continue;
      EXPECT_EQ(confirmed[0].pin_id, msg::OutputPin{19});
      EXPECT_EQ(confirmed[0].pin_state, msg::Confirm::pin_unavailable);
    }
  }
}

TEST(Pins, OldBoardsHaveFewer) {
  BoardOptions options;
  options.board = msg::BoardVersion(12);
  Host host(options);
  EXPECT_THAT(host.ask(pin(msg::OutputPin::rc_input_yaw)), IsEmpty());
  EXPECT_TRUE(is_confirmed(host, pin(msg::OutputPin::pin_aux2)));
}

TEST(Pins, AServoIsNoPin) {
  Host host;
  EXPECT_TRUE(is_confirmed(host, servos(1500)));
  EXPECT_THAT(host.ask(pin(msg::OutputPin::ext_fc_input_roll)), IsEmpty());
  EXPECT_TRUE(is_confirmed(host, servos(msg::ServoOut::floating)));
  EXPECT_TRUE(is_confirmed(host, pin(msg::OutputPin::ext_fc_input_roll)));
  change(host, [](msg::ReadParams3& parameters) { parameters.servo_out[3] = 7; });
  EXPECT_THAT(host.ask(pin(msg::OutputPin::pin_aux1)), IsEmpty());
}

TEST(Pins, AreForgottenByARestart) {
  Host host;
  host.ask(pin(msg::OutputPin::pin_aux1));
  host.board.restart(host.now);
  host.listen(seconds(1));
  EXPECT_EQ(debug_values(host).at("HIGH_PINS")[0], 0);
}

TEST(Servos, PulsesMustFitIntoThePeriod) {
  Host host;
  change(host, [](msg::ReadParams3& parameters) { parameters.servo_rate = 400_Hz; });
  EXPECT_TRUE(is_confirmed(host, servos(2499)));
  EXPECT_EQ(refusal(host, servos(2500)), msg::BoardErrorCode::wrong_params);
  EXPECT_EQ(refusal(host, servos(0, 2500)), msg::BoardErrorCode::wrong_params);
  change(host, [](msg::ReadParams3& parameters) { parameters.servo_rate = 50_Hz; });
  EXPECT_TRUE(is_confirmed(host, servos(19999)));
  EXPECT_EQ(refusal(host, servos(20000)), msg::BoardErrorCode::wrong_params);
}

TEST(Servos, SpecialValues) {
  Host host;
  EXPECT_TRUE(is_confirmed(host, servos(msg::ServoOut::low, msg::ServoOut::low)));
  EXPECT_TRUE(is_confirmed(host, servos(msg::ServoOut::floating)));
  EXPECT_EQ(refusal(host, servos(-2, 20001)), msg::BoardErrorCode::wrong_params);
  EXPECT_TRUE(is_confirmed(host, servos(1500)));
  EXPECT_THAT(host.ask(pin(msg::OutputPin::ext_fc_input_roll)), IsEmpty());
  EXPECT_TRUE(is_confirmed(host, servos(-2, -32768))) << "all that is negative frees the pin";
  EXPECT_TRUE(is_confirmed(host, pin(msg::OutputPin::ext_fc_input_roll)));
}

TEST(Sounds, AStandardSoundIsShort) {
  Host host;
  EXPECT_TRUE(is_confirmed(host, msg::BeepSound{.mode = msg::BeepMode::complete}));
  EXPECT_EQ(sound(host), msg::BeepModes(msg::BeepMode::complete).raw());
  host.listen(seconds(1));
  EXPECT_EQ(sound(host), 0);
}

TEST(Sounds, AMelodyIsAsLongAsItsNotes) {
  Host host;
  msg::BeepSound melody{.mode = msg::BeepMode::custom_melody, .note_length = 400_ms};
  constexpr std::array<std::uint16_t, 5> notes{987, 987, msg::BeepSound::pause, 1174, 1567};
  for (const std::uint16_t note : notes) {
    melody.note_freq_hz.push_back(msg::NoteFrequency(note));
  }
  EXPECT_TRUE(is_confirmed(host, melody));
  host.listen(milliseconds(1500));
  EXPECT_EQ(sound(host), msg::BeepModes(msg::BeepMode::custom_melody).raw());
  host.listen(milliseconds(400));
  EXPECT_EQ(sound(host), 0);
}

TEST(Sounds, WhatIsNoSoundIsRefused) {
  Host host;
  EXPECT_EQ(refusal(host, msg::BeepSound{}), msg::BoardErrorCode::wrong_params);
  EXPECT_EQ(refusal(host, msg::BeepSound{.mode = msg::BeepModes(0x0100)}),
            msg::BoardErrorCode::wrong_params);
  EXPECT_EQ(refusal(host, msg::BeepSound{.mode = msg::BeepMode::click | msg::BeepMode::error}),
            msg::BoardErrorCode::wrong_params);
  EXPECT_EQ(refusal(host, msg::BeepSound{.mode = msg::BeepMode::custom_melody,
                                         .note_length = msg::NoteLength(5)}),
            msg::BoardErrorCode::wrong_params)
      << "no notes";
  msg::BeepSound melody{.mode = msg::BeepMode::custom_melody, .note_length = msg::NoteLength(5)};
  melody.note_freq_hz.push_back(msg::NoteFrequency(553));
  EXPECT_EQ(refusal(host, melody), msg::BoardErrorCode::wrong_params) << "too low";
  melody.note_freq_hz[0] = msg::NoteFrequency(554);
  melody.note_length = msg::NoteLength(0);
  EXPECT_EQ(refusal(host, melody), msg::BoardErrorCode::wrong_params) << "no length";
  melody.note_length = msg::NoteLength(5);
  EXPECT_TRUE(is_confirmed(host, melody));
  while (melody.note_freq_hz.size() < 51) melody.note_freq_hz.push_back(msg::NoteFrequency(554));
  EXPECT_EQ(refusal(host, melody), msg::BoardErrorCode::wrong_params) << "too many";
}

TEST(Sounds, CalibrationsAreHeardIfTheSettingsWantIt) {
  Host host;
  change(host, [](msg::ReadParams3& parameters) {
    parameters.beeper_modes = msg::BeeperMode::calibrate;
  });
  host.ask(msg::CalibGyro{});
  EXPECT_EQ(sound(host), msg::BeepModes(msg::BeepMode::calibrate).raw());
  host.listen(seconds(5));
  change(host, [](msg::ReadParams3& parameters) { parameters.beeper_modes = {}; });
  host.ask(msg::CalibGyro{});
  EXPECT_EQ(sound(host), 0);
}

}  // namespace
}  // namespace sbgc::test
