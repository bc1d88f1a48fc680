// Tests of what the library says about itself and about each message: the version, from which
// versions of a board a message is there, and the effects of requests.

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <sbgc/availability.hpp>
#include <sbgc/explain.hpp>
#include <sbgc/messages.hpp>
#include <sbgc/meta/all.hpp>
#include <sbgc/text.hpp>
#include <sbgc/validate.hpp>
#include <sbgc/version.hpp>

#include "support.hpp"

namespace sbgc {
namespace {

msg::BoardInfo board(std::uint8_t board_ver, std::uint16_t firmware_ver) {
  msg::BoardInfo info;
  info.board_ver = msg::BoardVersion(board_ver);
  info.firmware_ver = msg::FirmwareVersion(firmware_ver);
  return info;
}

// The specification documents these as "ver. 2.59+", and the longer CMD_CONTROL as "firmware ver.
// 2.55b5".
TEST(Availability, OfMessages) {
  EXPECT_TRUE(is_supported<msg::BeepSound>(board(31, 2590)));
  EXPECT_FALSE(is_supported<msg::BeepSound>(board(31, 2589)));
  EXPECT_FALSE(is_supported<msg::DataStreamInterval>(board(31, 2439)));
  EXPECT_TRUE(is_supported<msg::ControlExt>(board(31, 2555)));
  EXPECT_FALSE(is_supported<msg::ControlExt>(board(31, 2554)));
  EXPECT_TRUE(is_supported<msg::Control>(board(10, 2200)));
  EXPECT_TRUE(is_supported<msg::RealtimeData4>(board(30, 2400)));
  EXPECT_FALSE(is_supported<msg::RealtimeData4>(board(10, 2400)));
}

TEST(Availability, OfBoardsWithAFeature) {
  msg::BoardInfo info = board(36, 2745);
  EXPECT_FALSE(is_supported<msg::BodeTestStartStopRequest>(info));
  info.board_features = msg::BoardFeature::bode_test;
  EXPECT_TRUE(is_supported<msg::BodeTestStartStopRequest>(info));
  EXPECT_FALSE(is_supported<msg::ReadStateVarsRequest>(info));
  info.board_features_ext = msg::BoardFeaturesExtBit::state_vars;
  EXPECT_TRUE(is_supported<msg::ReadStateVarsRequest>(info));

  // CMD_BOARD_INFO_3 has this one.
  EXPECT_TRUE(is_supported<msg::ExtMotorsAction>(info));
  msg::BoardInfo3 details;
  Availability versions = versions_of(info);
  versions.features |= lacking_features(details);
  EXPECT_FALSE(is_supported<msg::ExtMotorsAction>(versions));
  details.board_features_ext2 = msg::BoardFeaturesExt2Bit::ext_motors;
  versions.features = lacking_features(details);
  EXPECT_TRUE(is_supported<msg::ExtMotorsAction>(versions));
  EXPECT_EQ(objection_to(Meta<msg::ControlQuatConfig>::info, versions), "needs QUAT_CONTROL");
}

TEST(Availability, OfAFieldThatNeedsAFeature) {
  Availability versions{.firmware = 2745, .board = 36};
  versions.features = lacking_features(msg::BoardInfo3{});
  msg::SetDebugPortRequest message;
  std::string said;
  const auto report = [&](const Violation& violation) { said += to_string(violation); };
  EXPECT_TRUE(validate(message, versions, report));
  message.cmd_filter = decltype(message.cmd_filter)(1);
  EXPECT_TRUE(validate(message, report));
  EXPECT_FALSE(validate(message, versions, report));
  EXPECT_NE(said.find("cmd_filter: "), std::string::npos) << said;
  EXPECT_NE(said.find("needs PLUS_VER"), std::string::npos) << said;
}

static_assert(is_supported<msg::BeepSound>(Availability{2590, 30}));
static_assert(!is_supported<msg::BeepSound>(Availability{2580, 30}));

// The version that introduces the new form is the end of the old one.
TEST(Availability, OfFormsThatTakeEachOthersPlace) {
  EXPECT_TRUE(is_supported<msg::MotorsOff>(board(31, 2687)));
  EXPECT_FALSE(is_supported<msg::MotorsOffExt>(board(31, 2686)));
  EXPECT_TRUE(is_supported<msg::MotorsOffExt>(board(31, 2687)));
  for (const int firmware : {2590, 2694, 2695, 2700}) {
    const auto info = board(31, static_cast<std::uint16_t>(firmware));
    EXPECT_EQ(is_supported<msg::AhrsHelperRequest>(info), firmware < 2695);
    EXPECT_EQ(is_supported<msg::AhrsHelperRequestExt>(info), firmware < 2695);
    EXPECT_EQ(is_supported<msg::AhrsHelperRequestWide>(info), firmware >= 2695);
    EXPECT_EQ(is_supported<msg::AhrsHelperRequestExtWide>(info), firmware >= 2695);
  }
  EXPECT_EQ(Meta<msg::AhrsHelperRequest>::info.until.firmware, 2695);
  EXPECT_EQ(newest_firmware, 2745);
}

TEST(Availability, ALaterFormSaysTheSame) {
  msg::AhrsHelperRequestExt request;
  request.mode = msg::AhrsHelperMode(0xA7);  // with unnamed bits set
  request.z1_vector = {0, 0, 1};
  request.h1_vector = {1, 0, 0};
  const msg::AhrsHelperRequestExtWide later = later_form(request);
  EXPECT_EQ(later.mode.raw(), 0xA7);
  EXPECT_EQ(later.z1_vector, request.z1_vector);
  EXPECT_EQ(later.h1_vector, request.h1_vector);
  EXPECT_EQ(later_form(msg::AhrsHelperRequest{msg::AhrsHelperModeBit::frame_imu}).mode.raw(), 2);
}

TEST(Version, AsANumberOrdersReleases) {
  static_assert(SBGC_VERSION ==
                SBGC_VERSION_MAJOR * 10000 + SBGC_VERSION_MINOR * 100 + SBGC_VERSION_PATCH);
  static_assert(SBGC_VERSION_MINOR < 100 && SBGC_VERSION_PATCH < 100, "they have two digits");
#if SBGC_VERSION < 100
  FAIL() << "0.1.0 is the first release";
#endif
}

TEST(Version, OfTheProtocolIsThatOfTheModel) {
  std::ifstream file(SBGC_GENERATED "/simplebgc.json");
  const auto model = nlohmann::json::parse(file);
  const auto& protocol = model["protocol"];
  EXPECT_EQ(protocol["name"], protocol_name);
  EXPECT_EQ(protocol["revision"], protocol_revision);
  EXPECT_EQ(protocol["date"], protocol_date);
  EXPECT_EQ(std::stoull(model["fingerprint"].get<std::string>(), nullptr, 16), model_fingerprint);
}

template <class M>
constexpr Effects effects_of = Meta<M>::info.effects;

TEST(Effects, AreThoseOfTheRequest) {
  EXPECT_EQ(effects_of<msg::GetAnglesRequest>, Effects(Effect::reads));
  EXPECT_EQ(effects_of<msg::Control>, Effects(Effect::moves));
  EXPECT_EQ(effects_of<msg::WriteParams3>, Effects(Effect::stores) | Effect::moves);
  EXPECT_EQ(effects_of<msg::UseDefaults>, Effects(Effect::stores) | Effect::moves | Effect::erases);
  EXPECT_EQ(effects_of<msg::ResetRequest>, Effects(Effect::restarts));
  EXPECT_EQ(effects_of<msg::SystemStateRequest>, Effects(Effect::unknown));
}

TEST(Effects, OfAMessageInBothDirectionsAreThoseToTheBoard) {
  EXPECT_EQ(effects_of<msg::SetAdjVarsVal>, Effects(Effect::sets) | Effect::moves);
}

template <class M>
bool preparation_says(std::string_view words) {
  return std::string_view(Meta<M>::info.preparation).find(words) != std::string_view::npos;
}

TEST(Preparation, IsThatOfTheRequestOrOfItsForm) {
  EXPECT_TRUE(preparation_says<msg::CalibGyro>("completely still"));
  EXPECT_FALSE(preparation_says<msg::CalibGyro>("TEMPERATURE"));
  EXPECT_TRUE(preparation_says<msg::CalibGyroExt>("TEMPERATURE"));
  EXPECT_STREQ(Meta<msg::GetAnglesRequest>::info.preparation, "");
  EXPECT_STREQ(Meta<msg::CalibInfo>::info.preparation, "");
}

}  // namespace
}  // namespace sbgc
