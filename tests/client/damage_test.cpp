// Tests of the client and the emulated board over faulty lines. Damage that passes the sums of the
// first framing must not lead to a wrong value on the board, in a backup, or in a report.

#include <sbgc/client/backup.hpp>
#include <sbgc/client/memory.hpp>
#include <sbgc/client/profiles.hpp>
#include <sbgc/client/statistics.hpp>
#include <sbgc/client/variables.hpp>
#include <sbgc/detector.hpp>
#include <sbgc/io/line.hpp>

#include "task_test.hpp"

namespace sbgc::test {
namespace {

class DamagedLine : public TaskTest {
 protected:
  DamagedLine() { connect(); }

  /// Changes two bytes so that their sum stays the same.
  static void damage(Packet& packet, std::size_t at, std::uint8_t by = 1) {
    packet.body[at] = static_cast<std::uint8_t>(packet.body[at] + by);
    packet.body[at + 1] = static_cast<std::uint8_t>(packet.body[at + 1] - by);
  }

  /// Damages the next answer that is an M, from byte `at` on.
  template <class M>
  void damage_next(std::size_t at) {
    board.tamper([this, at](Packets& answers) {
      for (Packet& one : answers) {
        if (!is<M>(one) || is_damaged) continue;
        is_damaged = true;
        damage(one, at);
      }
    });
  }

  /// Calls `action` after the next M that the board has executed, as if M had arrived damaged.
  template <class M, class Action>
  void once_after(Action action) {
    board.after([this, action](const Packet& request) {
      if (!is<M>(request) || is_damaged) return;
      is_damaged = true;
      action();
    });
  }

  ParameterSet changed(std::uint8_t profile, std::uint8_t gyro_trust) {
    msg::ReadParams3 params = board.settings<msg::ReadParams3>(profile);
    params.gyro_trust = gyro_trust;
    ParameterSet set;
    EXPECT_TRUE(set.set(params));
    return set;
  }

  void set_p_roll(std::int32_t value) {
    msg::SetAdjVarsVal request;
    request.params.push_back({msg::VariableId::p_roll, value});
    board.write(request);
  }

  bool is_damaged = false;
};

TEST_F(DamagedLine, NoWrongValueIsInABackup) {
  damage_next<msg::ReadParams3>(20);
  const auto backup = checked(client().make_backup());
  EXPECT_TRUE(is_damaged);
  for (std::uint8_t profile = 0; profile < 5; ++profile) {
    EXPECT_EQ(*backup->parameters.get<msg::ReadParams3>(profile),
              board.settings<msg::ReadParams3>(profile));
  }
}

TEST_F(DamagedLine, NoWrongValueOfTheBoardIsWrittenBack) {
  board.edit<msg::ReadParams3>(1, [](auto& params) {
    for (std::uint8_t i = 0; i < 4; ++i) params.tail.push_back(i);
  });
  const msg::ReadParams3 before = board.settings<msg::ReadParams3>(1);
  Parameters shorter = *changed(1, 77).find({"ReadParams3", 1});
  shorter.body.resize(msg::ReadParams3::min_size);
  ParameterSet wanted;
  ASSERT_TRUE(wanted.put(shorter));
  damage_next<msg::ReadParams3>(msg::ReadParams3::min_size);  // in the tail
  const WriteReport report = client().write_parameters(wanted);
  EXPECT_TRUE(report) << to_text(report);
  EXPECT_TRUE(is_damaged);
  msg::ReadParams3 expected = before;
  expected.gyro_trust = 77;
  EXPECT_EQ(board.settings<msg::ReadParams3>(1), expected);
}

TEST_F(DamagedLine, RenamingAProfileKeepsTheOtherNames) {
  damage_next<msg::ReadProfileNames>(100);
  ASSERT_TRUE(client().rename_profile(0, "Drone"));
  EXPECT_TRUE(is_damaged);
  const auto names = board.settings<msg::ReadProfileNames>();
  EXPECT_EQ(std::string_view(names.profile_name[2].data(), names.profile_name[2].size()),
            "Profile 3");
}

TEST_F(DamagedLine, APartlyWrittenPageKeepsItsOtherBytes) {
  const auto before = checked(client().download_eeprom(0, 128));
  damage_next<msg::EepromRead>(40);
  ASSERT_TRUE(client().upload_eeprom(8, {1, 2, 3}));
  EXPECT_TRUE(is_damaged);
  auto expected = *before;
  for (std::uint8_t i = 0; i < 3; ++i) expected[8U + i] = static_cast<std::uint8_t>(i + 1);
  const auto after = checked(client().download_eeprom(0, 128));
  EXPECT_EQ(*after, expected);
}

TEST_F(DamagedLine, UserDataKeepTheirOtherBytes) {
  const auto before = checked(client().download_user_data());
  damage_next<msg::ReadExternalData>(50);
  ASSERT_TRUE(client().upload_user_data(3, {9}));
  EXPECT_TRUE(is_damaged);
  auto expected = *before;
  expected[3] = 9;
  EXPECT_EQ(*client().download_user_data(), expected);
}

TEST_F(DamagedLine, AWriteThatArrivesDamagedIsRepeated) {
  once_after<msg::WriteParams3>(
      [this] { board.edit<msg::ReadParams3>(1, [](auto& params) { params.gyro_trust = 200; }); });
  const WriteReport report = client().write_parameters(changed(1, 5));
  EXPECT_TRUE(report) << to_text(report);
  EXPECT_TRUE(is_damaged);
  EXPECT_EQ(board.settings<msg::ReadParams3>(1).gyro_trust, 5);
}

TEST_F(DamagedLine, AReadingBackThatIsDamagedIsNoMismatch) {
  once_after<msg::WriteParams3>([this] {
    is_damaged = false;
    damage_next<msg::ReadParams3>(20);
  });
  const WriteReport report = client().write_parameters(changed(1, 5));
  EXPECT_TRUE(report) << to_text(report);
  EXPECT_TRUE(is_damaged);
  EXPECT_EQ(count<msg::WriteParams3>(), 1U);
}

TEST_F(DamagedLine, AVariableThatArrivesDamagedIsSetAgain) {
  once_after<msg::SetAdjVarsVal>([this] { set_p_roll(99); });
  const auto set = client().set_variable("P_ROLL", 12);
  EXPECT_TRUE(set) << set.error().message;
  EXPECT_TRUE(is_damaged);
  EXPECT_EQ(*client().get_variable("P_ROLL"), 12);
}

TEST_F(DamagedLine, AVariableThatIsNeverSetIsAMismatch) {
  board.after([this](const Packet& request) {
    if (is<msg::SetAdjVarsVal>(request)) set_p_roll(99);
  });
  EXPECT_THAT(client().set_variable("P_ROLL", 12), fails(ErrorCode::mismatch));
  EXPECT_EQ(count<msg::SetAdjVarsVal>(), 2U);
}

TEST_F(DamagedLine, ALineThatDamagesEveryAnswerIsReported) {
  board.tamper([by = std::uint8_t{0}](Packets& answers) mutable {
    for (Packet& one : answers) {
      if (is<msg::ReadParams3>(one)) damage(one, 20, ++by);
    }
  });
  EXPECT_THAT(client().read_parameters(),
              fails(ErrorCode::mismatch, "ReadParams3 of profile 1: 6 answers"));
}

TEST_F(DamagedLine, ParametersAreReadTwiceOnlyIfTheFramingHasOnlySums) {
  const auto reads = [this](std::uint16_t firmware) {
    become(msg::FirmwareVersion(firmware));
    ReadOptions options;
    options.wanted = [](const ParametersId& id) { return id == ParametersId{"ReadParams3", 2}; };
    EXPECT_TRUE(client().read_parameters(options));
    return count<msg::ReadParams3Request>();
  };
  EXPECT_EQ(reads(2590), 2U);
  EXPECT_EQ(reads(2740), 1U);
}

TEST(LineQuality, IsEstimatedFromTheCounters) {
  SessionStatistics statistics;
  EXPECT_EQ(line_quality(statistics).damaged, 0);
  statistics.parser.frames = 90;
  statistics.parser.body_errors = 7;
  statistics.parser.incomplete = 3;
  statistics.framing = Framing::v1;
  EXPECT_DOUBLE_EQ(line_quality(statistics).damaged, 0.1);
  EXPECT_DOUBLE_EQ(line_quality(statistics).undetected, 0.1 * 0.1 / 32);
  statistics.framing = Framing::v2;
  EXPECT_DOUBLE_EQ(line_quality(statistics).undetected, 0.1 / 65536);
}

ConnectOptions patient() {
  ConnectOptions options = quick();
  options.retries = 20;
  return options;
}

/// Expects that a backup is complete and correct although frames are lost.
void expect_backup(const emulator::Faults& faults) {
  EmulatedBoard original;
  original.edit<msg::ReadParams3>(3, [](auto& params) { params.gyro_trust = 99; });
  emulator::EmulatorOptions options = quick_board();
  options.line.faults = faults;
  EmulatedBoard board(options, original.memory(), false);
  auto client = checked(connect_over(board.line(), patient()));
  const auto backup = checked(client->make_backup());
  EXPECT_EQ(backup->parameters.all().size(), 18U);
  for (std::uint8_t profile = 0; profile < 5; ++profile) {
    EXPECT_EQ(*backup->parameters.get<msg::ReadParams3>(profile),
              original.settings<msg::ReadParams3>(profile));
    EXPECT_EQ(*backup->parameters.get<msg::ReadParamsExt2>(profile),
              original.settings<msg::ReadParamsExt2>(profile));
  }
  EXPECT_GT(client->statistics().session.retries, 0U) << "no fault occurred";
}

TEST(Faults, ABackupGetsThroughBitErrors) { expect_backup({.bit_errors = 1e-4}); }

TEST(Faults, ABackupGetsThroughLostBytes) { expect_backup({.lost = 1e-3}); }

TEST(Faults, ABackupGetsThroughDuplicatedBytes) { expect_backup({.duplicated = 1e-3}); }

TEST(Faults, ABackupGetsThroughSilence) {
  // From the beginning, while the client searches for the board.
  expect_backup({.silences = {{.from = {}, .length = milliseconds(2000)}}});
}

TEST(Faults, ABackupGetsThroughText) {
  emulator::EmulatorOptions options = quick_board();
  options.line.faults.text_every = milliseconds(2);
  EmulatedBoard board(options, {}, false);
  auto client = checked(connect_over(board.line(), patient()));
  const auto backup = checked(client->make_backup());
  EXPECT_EQ(*backup->parameters.get<msg::ReadParams3>(4), board.settings<msg::ReadParams3>(4));
  EXPECT_GT(client->statistics().session.parser.skipped_bytes, 0U) << "there was no text";
}

TEST(Faults, ABoardThatIsSwitchedOffAndOnAnswersAgain) {
  emulator::EmulatorOptions options = quick_board();
  options.board.start_time = seconds(60);  // longer than this machine may stall
  EmulatedBoard board(options);
  auto client = checked(connect_over(board.line(), patient()));
  // No request may be pending then, such as one repeated after a stall.
  ASSERT_TRUE(client->get_angles({}, {.timeout = std::chrono::seconds(60), .retries = 0}));
  board.restart();
  EXPECT_FALSE(client->get_angles({}, {.timeout = Ms(20), .retries = 0}));
  board.skip(std::chrono::seconds(61));
  EXPECT_TRUE(client->get_angles());
}

TEST(Faults, ABoardIsFoundAtEveryBaudRateAndParity) {
  // In parallel, because a search mostly waits.
  std::vector<std::future<void>> searches;
  for (const std::uint32_t rate : baud_rates) {
    for (const Parity parity : {Parity::none, Parity::even}) {
      searches.push_back(std::async(std::launch::async, [settings = LineSettings{rate, parity}] {
        EmulatedBoard board;
        ConnectOptions options = quick();
        options.timeout = std::chrono::seconds(60);
        auto client = connect_over(board.line_with(settings), options);
        ASSERT_TRUE(client) << io::to_string(settings) << ": " << client.error().message;
        EXPECT_THAT(client->description(), HasSubstr(io::to_string(settings)));
        EXPECT_TRUE(client->get_angles());
      }));
    }
  }
  EXPECT_EQ(searches.size(), Detector::lines);
  for (auto& search : searches) search.get();
}

}  // namespace
}  // namespace sbgc::test
