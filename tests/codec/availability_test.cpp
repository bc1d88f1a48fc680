// What a board understands, by the versions it has told.

#include <set>
#include <string>

#include <gtest/gtest.h>

#include <sbgc/availability.hpp>
#include <sbgc/messages.hpp>
#include <sbgc/meta/all.hpp>
#include <sbgc/validate.hpp>

namespace sbgc {
namespace {

BoardInfo board(std::uint8_t board_ver, std::uint16_t firmware_ver) {
  BoardInfo info;
  info.board_ver = BoardVersion(board_ver);
  info.firmware_ver = FirmwareVersion(firmware_ver);
  return info;
}

/// "rule path" of everything that a board with these versions does not know.
template <class M>
std::set<std::string> unknown(const M& message, const BoardInfo& info) {
  std::set<std::string> result;
  validate(message, versions_of(info), [&](const Violation& violation) {
    std::array<char, 100> path{};
    violation.path.write(path.data(), path.size());
    result.insert(std::string(name(violation.rule)) + " " + path.data());
  });
  return result;
}

// The specification says "ver. 2.59+" of these, and "firmware ver. 2.55b5" of the longer
// CMD_CONTROL.
TEST(Availability, OfMessages) {
  EXPECT_TRUE(is_supported<BeepSound>(board(31, 2590)));
  EXPECT_FALSE(is_supported<BeepSound>(board(31, 2589)));
  EXPECT_FALSE(is_supported<DataStreamInterval>(board(31, 2439)));
  EXPECT_TRUE(is_supported<ControlExt>(board(31, 2555)));
  EXPECT_FALSE(is_supported<ControlExt>(board(31, 2554)));
  EXPECT_TRUE(is_supported<Control>(board(10, 2200)));
  EXPECT_TRUE(is_supported<RealtimeData4>(board(30, 2400)));
  EXPECT_FALSE(is_supported<RealtimeData4>(board(10, 2400)));
}

static_assert(is_supported<BeepSound>(Availability{2590, 30}));
static_assert(!is_supported<BeepSound>(Availability{2580, 30}));

TEST(Availability, OfAFlagInsideAPackedByte) {
  Control control;
  control.control_mode.set_flags(ControlFlag::high_res_speed);
  EXPECT_EQ(unknown(control, board(31, 2550)), std::set<std::string>{"firmware control_mode"});
  EXPECT_TRUE(unknown(control, board(31, 2590)).empty());
}

TEST(Availability, OfEnumValuesAndFields) {
  RealtimeData3 data;
  for (auto* signal : {&data.rc.roll, &data.rc.pitch, &data.rc.yaw, &data.rc_cmd}) {
    *signal = RcSignal(1500);
  }
  data.cur_imu = SelectedImu::main;
  EXPECT_EQ(unknown(data, board(10, 2200)), std::set<std::string>{"board cur_imu"});
  EXPECT_TRUE(unknown(data, board(31, 2200)).empty());
}

}  // namespace
}  // namespace sbgc
