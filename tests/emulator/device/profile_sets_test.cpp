// Tests of profile sets, and of series of requests that write parameters.

#include <cstdint>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sbgc/parameters.hpp>

#include "device/storage/eeprom_records.hpp"
#include "replies.hpp"

namespace sbgc::test {
namespace {

using SetAction = msg::ProfileSetAction;

std::uint8_t p_of_roll(Host& host, std::uint8_t profile) {
  return host.get<msg::ReadParams3>(msg::ReadParams3Request{.profile_id = profile}).axes.roll.p;
}

void set_p_of_roll(Host& host, std::uint8_t profile, std::uint8_t p) {
  auto parameters = host.get<msg::ReadParams3>(msg::ReadParams3Request{.profile_id = profile});
  parameters.axes.roll.p = p;
  EXPECT_TRUE(is_confirmed(host, msg::WriteParams3{parameters}));
}

TEST(ProfileSets, HoldAllProfiles) {
  Host host(newest_board());
  set_p_of_roll(host, 0, 33);
  set_p_of_roll(host, 4, 44);
  EXPECT_TRUE(is_confirmed(host, msg::ProfileSet{.slot = 2, .action = SetAction::save}));
  set_p_of_roll(host, 0, 1);
  set_p_of_roll(host, 4, 2);
  EXPECT_TRUE(is_confirmed(host, msg::ProfileSet{.slot = 6, .action = SetAction::save}));
  EXPECT_TRUE(is_confirmed(host, msg::ProfileSet{.slot = 2, .action = SetAction::load}));
  EXPECT_EQ(p_of_roll(host, 0), 33);
  EXPECT_EQ(p_of_roll(host, 4), 44);
  auto info = host.get<msg::BoardInfo3>(msg::BoardInfo3Request{});
  EXPECT_EQ(info.profile_set_cur, 2);
  EXPECT_EQ(info.profile_set_slots,
            msg::StoredProfileSet::set2 | msg::StoredProfileSet::set_backup);
  EXPECT_TRUE(is_confirmed(host, msg::ExecuteMenu{msg::MenuCommand::load_profile_set_backup}));
  EXPECT_EQ(p_of_roll(host, 4), 2);
  EXPECT_TRUE(is_confirmed(host, msg::ProfileSet{.slot = 2, .action = SetAction::clear}));
  info = host.get<msg::BoardInfo3>(msg::BoardInfo3Request{});
  EXPECT_EQ(info.profile_set_slots, msg::StoredProfileSet::set_backup);
  EXPECT_EQ(refusal(host, msg::ProfileSet{.slot = 2, .action = SetAction::load}),
            msg::BoardErrorCode::operation_failed);
}

TEST(ProfileSets, OnlyInTheirSlots) {
  Host host(newest_board());
  for (const std::uint8_t slot : {std::uint8_t{0}, std::uint8_t{7}}) {
    EXPECT_EQ(refusal(host, msg::ProfileSet{.slot = slot, .action = SetAction::save}),
              msg::BoardErrorCode::wrong_params);
  }
  EXPECT_EQ(refusal(host, msg::ProfileSet{.slot = 1, .action = SetAction{4}}),
            msg::BoardErrorCode::wrong_params);
}

TEST(WriteParameters, InASeriesApplyAtItsEnd) {
  Host host(newest_board());
  EXPECT_TRUE(is_confirmed(host, msg::WriteParamsSet{msg::WriteParamsAction::start}));
  auto parameters = host.get<msg::ReadParams3>(msg::ReadParams3Request{});
  parameters.output = {};  // no motor has power
  EXPECT_TRUE(is_confirmed(host, msg::WriteParams3{parameters}));
  const auto power = [&] { return host.board.gimbal().sample(host.now).power; };
  host.listen(seconds(1));
  EXPECT_GT(power().pitch, 0);
  EXPECT_EQ(host.get<msg::RealtimeData4>(msg::RealtimeData4Request{}).calib_mode,
            msg::CalibMode::write_params);
  EXPECT_TRUE(is_confirmed(host, msg::WriteParamsSet{msg::WriteParamsAction::finish}));
  host.listen(seconds(1));
  EXPECT_EQ(power().pitch, 0);
}

// A memory that an earlier emulator wrote: its records had no CMD_READ_PARAMS_EXT3.

TEST(EarlierMemory, KeepsAllItsParameters) {
  emulator::Memory memory;
  emulator::Eeprom eeprom(memory);
  std::size_t address = emulator::layout::parameters;
  const auto add = [&]<class M>(M message) {
    for (std::uint8_t copy = 0; copy < ParametersOf<M>::copies; ++copy) {
      if constexpr (requires { message.profile_id; }) message.profile_id = copy;
      std::array<std::uint8_t, max_body_size> body{};
      const auto size = encode(message, body).size;
      EXPECT_TRUE(
          emulator::write_record(eeprom, address, {M::command, copy}, std::span(body).first(size)));
      address += emulator::record_size();
    }
  };
  msg::ReadParams3 main;
  main.axes.roll.p = 77;
  msg::ReadAdjVarsCfg slots;
  slots.trigger_slots[3].action[2] = msg::MenuCommand::profile3;
  msg::ReadExternalData user;
  user.data[100] = 0xA5;
  add(main);
  add(msg::ReadParamsExt{});
  add(msg::ReadParamsExt2{});
  add(msg::ReadProfileNames{});
  add(slots);
  add(user);
  Host host(newest_board(), memory);
  EXPECT_EQ(p_of_roll(host, 3), 77);
  EXPECT_EQ(host.get<msg::ReadAdjVarsCfg>(msg::ReadAdjVarsCfgRequest{}), slots);
  EXPECT_EQ(host.get<msg::ReadExternalData>(msg::ReadExternalDataRequest{}), user);
  EXPECT_EQ(host.get<msg::ReadParamsExt3>(msg::ReadParamsExt3Request{.profile_id = 2}).profile_id,
            2);
}

}  // namespace
}  // namespace sbgc::test
