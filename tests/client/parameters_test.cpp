
#include <sbgc/client/parameters.hpp>

#include "task_test.hpp"

namespace sbgc::test {
namespace {

class ParametersTest : public TaskTest {
 protected:
  ParameterSet read() {
    Result<ParameterSet> set = client().read_parameters();
    EXPECT_TRUE(set) << set.error().message;
    return set ? *set : ParameterSet{};
  }
  static std::vector<ParametersState> states(const WriteReport& report) {
    std::vector<ParametersState> result;
    for (const ParametersReport& block : report.parameters) result.push_back(block.state);
    return result;
  }
  static ParametersState state(const WriteReport& report, const ParametersId& id) {
    for (const ParametersReport& block : report.parameters) {
      if (block.id == id) return block.state;
    }
    ADD_FAILURE() << to_text(id) << " is not in the report";
    return {};
  }
  static msg::ReadParams3 get(const ParameterSet& set, std::uint8_t profile) {
    const Result<msg::ReadParams3> result = set.get<msg::ReadParams3>(profile);
    EXPECT_TRUE(result);
    return result ? *result : msg::ReadParams3{};
  }
  /// Changes the settings of one profile in a set.
  template <class Change>
  static void edit(ParameterSet& set, int profile, Change change) {
    msg::ReadParams3 params = get(set, static_cast<std::uint8_t>(profile));
    change(params);
    EXPECT_TRUE(set.set(params));
  }
  /// Makes every block of every profile different from all others.
  void fill() {
    for (std::uint8_t profile = 0; profile < 5; ++profile) {
      board.edit<msg::ReadParams3>(profile, [&](msg::ReadParams3& params) {
        params.gyro_trust = static_cast<std::uint8_t>(50 + profile);
        params.general_flags1 = {};
        params.cur_imu = {};
        // Later firmware sends more than is documented.
        for (std::uint8_t i = 0; i < 5; ++i) {
          params.tail.push_back(static_cast<std::uint8_t>(profile * 40 + i));
        }
      });
      board.edit<msg::ReadParamsExt>(
          profile, [&](msg::ReadParamsExt& params) { params.reserved[0] = profile; });
      board.edit<msg::ReadParamsExt2>(
          profile, [&](msg::ReadParamsExt2& params) { params.auto_pid_momentum = profile; });
    }
  }
  std::size_t writes() {
    return count<msg::WriteParams3>() + count<msg::WriteParamsExt>() +
           count<msg::WriteParamsExt2>() + count<msg::WriteProfileNames>() +
           count<msg::WriteAdjVarsCfg>() + count<msg::WriteExternalData>();
  }
};

TEST_F(ParametersTest, ReadsEveryBlockOfEveryProfileToTheLastByte) {
  fill();
  const ParameterSet set = read();
  ASSERT_THAT(set.all(), SizeIs(3 * 5 + 3));
  BackedUp::for_each([&]<class M>(Type<M>) {
    for (std::uint8_t copy = 0; copy < ParametersOf<M>::copies; ++copy) {
      EXPECT_EQ(set.find({ParametersOf<M>::name, copy})->body,
                packet(board.settings<M>(copy)).body);
    }
  });
  EXPECT_EQ(get(set, 3).tail.size(), 5U);
  EXPECT_EQ(get(set, 3).gyro_trust, 53);
}

TEST_F(ParametersTest, ReadingTellsItsProgressAndCanBeCancelled) {
  std::vector<std::string> seen;
  ReadOptions options;
  options.progress = [&](const Progress& progress) {
    EXPECT_EQ(progress.done, seen.size());
    EXPECT_EQ(progress.total, 18U);
    seen.emplace_back(progress.what);
    return seen.size() < 3;
  };
  EXPECT_THAT(client().read_parameters(options), fails(ErrorCode::cancelled));
  EXPECT_THAT(seen, ElementsAre("ReadParams3 of profile 1", "ReadParams3 of profile 2",
                                "ReadParams3 of profile 3"));
}

TEST_F(ParametersTest, AnAnswerAboutAnotherProfileIsNotTaken) {
  connect(few_retries);
  board.tamper([](Packets& answers) {
    for (Packet& one : answers) {
      if (is<msg::ReadParams3>(one) && one.body[0] == 1) one.body[0] = 3;
    }
  });
  const Result<ParameterSet> set = client().read_parameters();
  ASSERT_FALSE(set);
  EXPECT_THAT(set.error().message, HasSubstr("ReadParams3 of profile 2"));
}

TEST_F(ParametersTest, BoardsWithoutTheNewerCommandsAreAskedWithTheOlderOne) {
  become(msg::BoardVersion(10));
  const Result<ParameterSet> set = client().read_parameters();
  EXPECT_TRUE(set) << set.error().message;
  EXPECT_GE(count<msg::ReadParams>(), 1U);
  EXPECT_EQ(count<msg::ReadParams3Request>(), 0U);
}

TEST_F(ParametersTest, ReadsOnlyWhatIsWanted) {
  ReadOptions options;
  options.wanted = [](const ParametersId& id) {
    return id.message == "ReadParams3" && id.copy == 2;
  };
  std::size_t total = 0;
  options.progress = [&](const Progress& progress) {
    total = progress.total;
    return true;
  };
  const auto set = checked(client().read_parameters(options));
  ASSERT_THAT(set->all(), SizeIs(1));
  EXPECT_EQ(set->all()[0].id, (ParametersId{"ReadParams3", 2}));
  EXPECT_EQ(count<msg::ReadParams3Request>(), 2U);
  EXPECT_EQ(total, 1U);
}

TEST_F(ParametersTest, AMinimumAboveAMaximumIsRejectedWhicheverOfThemChanges) {
  for (const bool is_minimum : {true, false}) {
    ParameterSet set = read();
    msg::ReadParams3 wanted = get(set, 0);
    const int lowest = wanted.rc.pitch.rc_min_angle.raw();
    const int highest = wanted.rc.pitch.rc_max_angle.raw();
    if (is_minimum) {
      wanted.rc.pitch.rc_min_angle = msg::Degrees(static_cast<std::int16_t>(highest + 1));
    } else {
      wanted.rc.pitch.rc_max_angle = msg::Degrees(static_cast<std::int16_t>(lowest - 1));
    }
    ASSERT_TRUE(set.set(wanted));
    EXPECT_THAT(client().write_parameters(set),
                fails(ErrorCode::invalid,
                      AllOf(HasSubstr("rc.pitch.rc_min_angle"), HasSubstr("rc_max_angle"))));
  }
  EXPECT_EQ(writes(), 0U);
}

TEST_F(ParametersTest, WritingWhatIsThereWritesNothing) {
  const ParameterSet set = read();
  const WriteReport report = client().write_parameters(set);
  EXPECT_TRUE(report) << to_text(report);
  EXPECT_EQ(writes(), 0U);
  EXPECT_THAT(states(report), AllOf(SizeIs(18), Each(ParametersState::equal)));
}

TEST_F(ParametersTest, OnlyBlocksThatDifferAreWrittenAndNothingElseChanges) {
  fill();
  ParameterSet set = read();
  edit(set, 2, [](auto& params) { params.axes.pitch.p = 1; });
  const auto before = board.all_settings<msg::ReadParams3>();

  const WriteReport report = client().write_parameters(set);
  EXPECT_TRUE(report) << to_text(report);
  EXPECT_EQ(writes(), 1U);
  EXPECT_EQ(state(report, {"ReadParams3", 2}), ParametersState::written);
  EXPECT_EQ(state(report, {"ReadParams3", 1}), ParametersState::equal);
  auto expected = before;
  expected[2].axes.pitch.p = 1;
  EXPECT_EQ(board.all_settings<msg::ReadParams3>(), expected);  // including reserved bytes and tail
}

TEST_F(ParametersTest, StateOfTheBoardIsNoDifferenceAndIsWrittenAsItIs) {
  ParameterSet set = read();
  board.write(msg::ExecuteMenu{msg::MenuCommand::profile4});
  board.write(msg::SelectImu3{msg::SelectedImu::frame});
  ASSERT_EQ(board.settings<msg::ReadParams3>(0).cur_profile_id, 3);  // no bit as before
  ASSERT_EQ(board.settings<msg::ReadParams3>(0).cur_imu, msg::SelectedImu::frame);
  EXPECT_THAT(diff(set, read()), IsEmpty());
  EXPECT_TRUE(client().write_parameters(set));
  EXPECT_EQ(writes(), 0U);

  edit(set, 0, [](auto& params) { params.gyro_trust = 17; });
  EXPECT_TRUE(client().write_parameters(set));
  for (const auto& request : board.requests<msg::WriteParams3>()) {
    EXPECT_EQ(request.cur_profile_id, 3);
    EXPECT_EQ(request.cur_imu, msg::SelectedImu::frame);
  }
  EXPECT_EQ(writes(), 1U);
  EXPECT_EQ(board.settings<msg::ReadParams3>(0).gyro_trust, 17);
}

TEST_F(ParametersTest, AShorterBodyLeavesWhatTheBoardHasAfterIt) {
  fill();
  ParameterSet set = read();
  Parameters shorter = *set.find({"ReadParams3", 1});
  shorter.body.resize(msg::ReadParams3::min_size);
  shorter.body[1] = 77;  // axes.roll.p
  ASSERT_TRUE(set.put(shorter));
  const auto tail = board.settings<msg::ReadParams3>(1).tail;
  ASSERT_EQ(tail.size(), 5U);
  EXPECT_TRUE(client().write_parameters(set));
  EXPECT_EQ(board.settings<msg::ReadParams3>(1).axes.roll.p, 77);
  EXPECT_EQ(board.settings<msg::ReadParams3>(1).tail, tail);
}

TEST_F(ParametersTest, ALongerBodyIsRefusedBeforeAnythingIsWritten) {
  ParameterSet set = read();
  Parameters longer = *set.find({"ReadParamsExt", 4});
  longer.body.push_back(1);
  ASSERT_TRUE(set.put(longer));
  edit(set, 0, [](auto& params) { params.gyro_trust = 1; });
  EXPECT_THAT(client().write_parameters(set), fails(ErrorCode::incompatible));
  EXPECT_EQ(writes(), 0U);
}

TEST_F(ParametersTest, ADryRunTellsAndWritesNothing) {
  ParameterSet set = read();
  msg::ReadParams3 wanted = get(set, 0);
  ASSERT_NE(wanted.follow_mode, msg::FollowMode::pitch);
  wanted.follow_mode = msg::FollowMode::pitch;
  wanted.rc_memory.yaw = 45_deg;
  ASSERT_TRUE(set.set(wanted));
  const WriteReport report = client().write_parameters(set, {.dry_run = true});
  EXPECT_TRUE(report);
  EXPECT_EQ(writes(), 0U);
  EXPECT_EQ(state(report, {"ReadParams3", 0}), ParametersState::unwritten);
  const auto& fields = report.parameters.front().wanted;
  ASSERT_THAT(fields, SizeIs(2));
  EXPECT_EQ(fields[0].path, "follow_mode");
  EXPECT_EQ(fields[0].after_meaning, "FOLLOW_MODE_PITCH");
  EXPECT_EQ(fields[1].path, "rc_memory.yaw");
  EXPECT_EQ(fields[1].after, "2048");
  EXPECT_EQ(fields[1].after_meaning, "45 deg");
}

TEST_F(ParametersTest, ValuesThatTheProtocolDoesNotAllowAreRefusedOnlyWhereTheyChange) {
  board.edit<msg::ReadParams3>(0, [](auto& params) { params.rc_expo_rate = 200; });  // out of range
  ParameterSet set = read();
  msg::ReadParams3 wanted = get(set, 0);
  ASSERT_EQ(wanted.rc_expo_rate, 200);
  wanted.gyro_trust = 3;
  ASSERT_TRUE(set.set(wanted));
  EXPECT_TRUE(client().write_parameters(set));

  wanted.follow_expo_rate = 101;
  ASSERT_TRUE(set.set(wanted));
  EXPECT_THAT(client().write_parameters(set),
              fails(ErrorCode::invalid, AllOf(HasSubstr("follow_expo_rate"), HasSubstr("100"))));
  EXPECT_EQ(board.settings<msg::ReadParams3>(0).gyro_trust, 3);
  EXPECT_TRUE(client().write_parameters(set, {.validate = false}));
}

TEST_F(ParametersTest, WritingTellsItsProgressUpToTheEnd) {
  ParameterSet set = read();
  edit(set, 2, [](auto& params) { params.gyro_trust = 7; });
  std::vector<std::size_t> seen;
  WriteOptions options;
  options.progress = [&](const Progress& progress) {
    EXPECT_EQ(progress.total, 3 * set.all().size());
    seen.push_back(progress.done);
    return true;
  };
  ASSERT_TRUE(client().write_parameters(set, options));
  EXPECT_TRUE(std::ranges::is_sorted(seen));
  EXPECT_EQ(seen.back(), 3 * set.all().size());
}

TEST_F(ParametersTest, AWriteThatIsLostIsReportedAsUnwritten) {
  ParameterSet set = read();
  for (const int profile : {1, 3}) edit(set, profile, [](auto& params) { params.gyro_trust = 5; });
  connect(few_retries);
  board.on_lost(
      [](const Packet& request) { return is<msg::WriteParams3>(request) && request.body[0] == 3; });
  const WriteReport report = client().write_parameters(set);
  ASSERT_THAT(report, fails(ErrorCode::timeout));
  EXPECT_EQ(state(report, {"ReadParams3", 1}), ParametersState::written);
  EXPECT_EQ(state(report, {"ReadParams3", 3}), ParametersState::unwritten);
  EXPECT_EQ(state(report, {"ReadParams3", 2}), ParametersState::equal);
}

TEST_F(ParametersTest, WhatCannotBeReadBackIsUnknown) {
  for (const bool is_dead_then : {false, true}) {  // or only the confirmation is lost
    ParameterSet set = read();
    edit(set, 1, [](auto& params) { ++params.gyro_trust; });
    connect(few_retries);
    if (is_dead_then) {
      board.on_lost([is_dead = false](const Packet& request) mutable {
        return is_dead || (is_dead = is<msg::WriteParams3>(request));
      });
    } else {
      board.on_answer_lost(is<msg::WriteParams3>);
    }
    const WriteReport report = client().write_parameters(set);
    ASSERT_FALSE(report);
    EXPECT_EQ(state(report, {"ReadParams3", 1}),
              is_dead_then ? ParametersState::unknown : ParametersState::written);
    board.on_answer_lost({});
  }
}

TEST_F(ParametersTest, WhatIsReadBackDifferentlyIsAMismatch) {
  ParameterSet set = read();
  edit(set, 1, [](auto& params) { params.gyro_trust = 5; });
  board.after([&](const Packet& request) {
    if (!is<msg::WriteParams3>(request)) return;
    board.edit<msg::ReadParams3>(1, [](auto& params) { params.gyro_trust = 6; });
  });
  const WriteReport report = client().write_parameters(set);
  ASSERT_THAT(report, fails(ErrorCode::mismatch));
  EXPECT_EQ(state(report, {"ReadParams3", 1}), ParametersState::different);
  EXPECT_THAT(to_text(report), HasSubstr("gyro_trust: 5 -> 6"));
}

TEST_F(ParametersTest, WritingOneProfileThatChangesAnotherIsNoticed) {
  fill();
  // A board with more general settings than the specification documents.
  board.after([&](const Packet& request) {
    if (!is<msg::WriteParams3>(request)) return;
    for (std::uint8_t profile = 0; profile < 5; ++profile) {
      board.edit<msg::ReadParams3>(
          profile, [](auto& params) { params.gyro_deadband = msg::GyroDeadband(9); });
    }
  });
  ParameterSet set = read();
  edit(set, 4, [](auto& params) { params.gyro_deadband = msg::GyroDeadband(9); });
  const WriteReport report = client().write_parameters(set);
  ASSERT_THAT(report, fails(ErrorCode::mismatch, "ReadParams3 of profile 1"));
  EXPECT_EQ(state(report, {"ReadParams3", 0}), ParametersState::different);
  EXPECT_EQ(state(report, {"ReadParams3", 4}), ParametersState::written);
}

TEST_F(ParametersTest, AGeneralSettingIsChangedInAllProfiles) {
  fill();
  ParameterSet set = read();
  for (int profile = 0; profile < 5; ++profile) {
    edit(set, profile,
         [](auto& params) { params.general_flags1 = msg::GeneralFlag::blink_profile; });
  }
  const WriteReport report = client().write_parameters(set);
  EXPECT_TRUE(report) << to_text(report);
  EXPECT_EQ(board.settings<msg::ReadParams3>(3).general_flags1, msg::GeneralFlag::blink_profile);
}

TEST_F(ParametersTest, AFailureTellsWhatWritingHasChangedInOtherProfiles) {
  fill();
  ParameterSet set = read();
  for (int profile = 0; profile < 5; ++profile) {
    edit(set, profile, [](auto& params) {
      params.general_flags1 = msg::GeneralFlag::blink_profile;
      params.gyro_trust = 99;
    });
  }
  connect(few_retries);
  board.on_lost(
      [](const Packet& request) { return is<msg::WriteParams3>(request) && request.body[0] == 1; });
  const WriteReport report = client().write_parameters(set);
  ASSERT_THAT(report, fails(ErrorCode::timeout));
  EXPECT_EQ(state(report, {"ReadParams3", 0}), ParametersState::written);
  EXPECT_EQ(state(report, {"ReadParams3", 4}), ParametersState::different);
  EXPECT_EQ(state(report, {"ReadParamsExt", 4}), ParametersState::equal);
}

TEST_F(ParametersTest, ProfilesThatWantDifferentGeneralSettingsAreRefused) {
  fill();
  ParameterSet set = read();
  msg::ReadParams3 wanted = get(set, 4);
  wanted.general_flags1 = msg::GeneralFlag::blink_profile;
  wanted.gyro_trust = 1;
  ASSERT_TRUE(set.set(wanted));
  WriteReport report = client().write_parameters(set);
  ASSERT_THAT(
      report,
      fails(ErrorCode::invalid,
            Eq("ReadParams3 of profile 5, general_flags1: 8 is wanted, but 0 in ReadParams3 of "
               "profile 1; the board has only one value")));
  EXPECT_EQ(writes(), 0U);

  // Without validation, the result is reported afterwards.
  report = client().write_parameters(set, {.validate = false});
  ASSERT_THAT(report, fails(ErrorCode::mismatch));
  EXPECT_EQ(state(report, {"ReadParams3", 0}), ParametersState::different);
  EXPECT_EQ(state(report, {"ReadParams3", 4}), ParametersState::written);
}

TEST_F(ParametersTest, AGeneralSettingDiffersInItsLowestBit) {
  become(msg::FirmwareVersion(2740));
  ParameterSet set = read();
  msg::ReadParamsExt2 wanted = *set.get<msg::ReadParamsExt2>(4);
  wanted.outer_mot_tilt_angle = msg::SignedDegrees(1);
  ASSERT_TRUE(set.set(wanted));
  EXPECT_EQ(client().write_parameters(set).outcome.error().message,
            "ReadParamsExt2 of profile 5, outer_mot_tilt_angle: 1 is wanted, but 0 in "
            "ReadParamsExt2 of profile 1; the board has only one value");
}

TEST_F(ParametersTest, OneProfileAloneMayChangeAGeneralSetting) {
  fill();
  ParameterSet set;
  msg::ReadParams3 wanted = get(read(), 4);
  const auto flag = msg::GeneralFlag::remember_last_used_profile;
  wanted.general_flags1 = flag;
  ASSERT_TRUE(set.set(wanted));
  const WriteReport report = client().write_parameters(set);
  EXPECT_TRUE(report) << to_text(report);
  EXPECT_EQ(board.settings<msg::ReadParams3>(0).general_flags1, flag);
}

TEST_F(ParametersTest, ABoardThatKeepsAGeneralSettingInEachProfileCanBeWritten) {
  const auto kept = std::make_shared<std::array<msg::GeneralFlags, 5>>();
  kept->at(2) = msg::GeneralFlag::emergency_stop;
  board.after([kept](const Packet& request) {
    if (!is<msg::WriteParams3>(request)) return;
    const auto written = message<msg::WriteParams3>(request);
    kept->at(written.profile_id) = written.general_flags1;
  });
  board.tamper([kept](Packets& answers) {
    for (Packet& one : answers) {
      if (!is<msg::ReadParams3>(one)) continue;
      auto changed = message<msg::ReadParams3>(one);
      changed.general_flags1 = kept->at(changed.profile_id);
      one = packet(changed);
    }
  });
  ParameterSet set = read();
  ASSERT_EQ(get(set, 2).general_flags1, msg::GeneralFlag::emergency_stop);
  edit(set, 4, [](auto& params) { params.general_flags1 = msg::GeneralFlag::blink_profile; });
  const WriteReport report = client().write_parameters(set);
  EXPECT_TRUE(report) << to_text(report);
  EXPECT_EQ(get(read(), 1).general_flags1, msg::GeneralFlags{});
  EXPECT_EQ(get(read(), 4).general_flags1, msg::GeneralFlag::blink_profile);
}

TEST_F(ParametersTest, SettingsThatTheBoardDoesNotHaveAreRefused) {
  ParameterSet set = read();
  become(msg::BoardVersion(10));
  const WriteReport report = client().write_parameters(set);
  ASSERT_FALSE(report);
  EXPECT_EQ(writes(), 0U);
}

TEST_F(ParametersTest, DifferencesAreFoundFieldByField) {
  const ParameterSet before = read();
  ParameterSet after = before;
  msg::ReadParamsExt2 changed = *before.get<msg::ReadParamsExt2>(3);
  changed.pid_gain.yaw = msg::PidGain(95);
  ++changed.auto_pid_momentum;
  ASSERT_TRUE(after.set(changed));
  msg::ReadProfileNames names = *before.get<msg::ReadProfileNames>();
  ASSERT_TRUE(names.profile_name[4].assign(std::string_view("Drone")));
  ASSERT_TRUE(after.set(names));
  const auto changes = diff(before, after);
  ASSERT_THAT(changes, SizeIs(2));
  ASSERT_THAT(changes[0].fields, SizeIs(2));
  EXPECT_EQ(changes[0].fields[0].path, "pid_gain.yaw");
  EXPECT_EQ(changes[0].fields[0].after_meaning, "2 (before firmware 2.73.1)");
  EXPECT_EQ(changes[0].fields[1].path, "auto_pid_momentum");
  EXPECT_THAT(to_text(changes), HasSubstr("ReadParamsExt2 of profile 4:\n"));
  EXPECT_THAT(to_text(changes), HasSubstr("  profile_name[4]: \"Profile 5\" -> \"Drone\"\n"));
}

TEST_F(ParametersTest, BlocksOfOneSideOnlyAreDifferences) {
  ParameterSet some;
  ASSERT_TRUE(some.set(msg::ReadProfileNames{}));
  ParameterSet others;
  ASSERT_TRUE(others.set(msg::ReadExternalData{}));
  const auto changes = diff(some, others);
  ASSERT_THAT(changes, SizeIs(2));
  EXPECT_EQ(changes[0].kind, ParametersChange::Kind::only_before);
  EXPECT_EQ(changes[1].kind, ParametersChange::Kind::only_after);
}

TEST_F(ParametersTest, ASetTakesNothingThatIsNoSettings) {
  ParameterSet set;
  EXPECT_FALSE(set.put({{"GetAngles", 0}, std::vector<std::uint8_t>(18)}));
  EXPECT_FALSE(set.put({{"ReadParams3", 5}, std::vector<std::uint8_t>(134, 5)}));
  EXPECT_FALSE(set.put({{"ReadParams3", 1}, std::vector<std::uint8_t>(134)}));
  EXPECT_FALSE(set.put({{"ReadParams3", 0}, std::vector<std::uint8_t>(133)}));
  const auto other = set.put({{"ReadParams3", 1}, std::vector<std::uint8_t>(134, 2)});
  ASSERT_FALSE(other);
  EXPECT_THAT(other.error().message, HasSubstr("of profile 3"));
  EXPECT_TRUE(set.put({{"ReadParams3", 0}, std::vector<std::uint8_t>(134)}));
  EXPECT_EQ(set.get<msg::ReadParams3>(1).error().code, ErrorCode::not_found);
}

}  // namespace
}  // namespace sbgc::test
