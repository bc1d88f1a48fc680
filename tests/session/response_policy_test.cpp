// Tests of response policies against tables compiled manually from the specification.

#include <concepts>
#include <type_traits>

#include <sbgc/dispatch.hpp>
#include <sbgc/line_facts.hpp>

#include "simulation.hpp"

namespace sbgc::test {
namespace {

/// Calls `use(message)` with a default message of each type that is sent to the board.
template <class Use>
void for_each_request(Use&& use) {
  AllMessages::for_each([&]<class M>(Type<M>) {
    if constexpr (M::direction != Direction::from_board) use(M{});
  });
}

// Requests and the responding message, by id (lines 615-660, 753-774, 793-802, 837-905, 946-953),
// then those of later firmware.
const std::map<int, int> answers = {
    {86, 86},   {20, 20},   {68, 23},   {23, 23},   {25, 25},   {88, 88},   {82, 82},   {21, 21},
    {33, 33},   {37, 37},   {62, 62},   {73, 73},   {61, 61},   {28, 28},   {64, 31},   {40, 40},
    {253, 253}, {42, 42},   {43, 43},   {254, 254}, {48, 48},   {49, 49},   {53, 53},   {46, 46},
    {56, 56},   {50, 50},   {76, 76},   {96, 96},   {100, 100}, {104, 104}, {106, 106}, {111, 111},
    {131, 131}, {132, 132}, {135, 134}, {136, 136}, {139, 139}, {141, 141}, {144, 96},
};

// Commands that are confirmed according to the specification: "A, G, P, W, etc." in line 417, and
// lines 640, 668, 726, 730, 791, 835, 875, 882, 916, 932, 972; then those of later firmware.
const std::set<int> confirmed = {'A', 'G', 'P', 'W', 'g', 22,  34,  63, 'M', 'm', 31,  39,
                                 44,  47,  54,  55,  85,  90,  91,  93, 94,  95,  105, 108,
                                 112, 119, 123, 134, 137, 142, 249, 78, 81,  83};

// Commands that may be confirmed, but neither document says so.
const std::set<int> possibly_confirmed = {24,  26,  27,  29,  30,  32,  35,  36,  41,  52,  57,
                                          59,  60,  66,  67,  69,  70,  74,  75,  79,  84,  89,
                                          92,  97,  98,  99,  101, 107, 110, 113, 115, 117, 118,
                                          120, 121, 122, 124, 125, 126, 150, 250, 251};

// Commands that may be confirmed before the response (the vendor's code of 2026).
const std::set<int> possibly_confirmed_first = {37};

// Hosts send these whenever they have new data, so no confirmation is expected.
const std::set<int> hardly_confirmed = {72, 45, 129};

// No response is expected, unless the request asks for notice or confirmation.
const std::set<int> silent = {114, 51, 116, 128, 130, 133, 140, 143, 151};

TEST(ResponsePolicy, AreThoseOfTheSpecification) {
  std::set<int> seen;
  for_each_request([&]<class M>(const M& message) {
    const ResponsePolicy policy = response_policy(message);
    const int id = static_cast<int>(M::command);
    seen.insert(id);
    const auto answer = answers.find(id);
    // Facts from elsewhere, such as release notes, are not compared.
    if (answer == answers.end() && !confirmed.contains(id) && !possibly_confirmed.contains(id) &&
        !hardly_confirmed.contains(id) && !silent.contains(id)) {
      return;
    }
    EXPECT_EQ(policy.responses.command, id);
    // Its answer cannot be distinguished from samples of a stream.
    if (std::same_as<M, msg::DebugVars3RequestSelected>) return;
    EXPECT_EQ(policy.response_required, answer != answers.end()) << id;
    EXPECT_EQ(policy.responses.form_count != 0, answer != answers.end()) << id;
    for (std::size_t i = 0; i < policy.responses.form_count; ++i) {
      EXPECT_EQ(policy.responses.forms[i].id, answer->second) << id;
    }
    const bool is_certain = policy.responses.confirmed == Confirmed::always;
    EXPECT_EQ(is_certain, confirmed.contains(id)) << id;
    if (possibly_confirmed_first.contains(id)) {
      EXPECT_EQ(policy.responses.confirmed, Confirmed::possible) << id;
    } else if (silent.contains(id) || answer != answers.end()) {
      EXPECT_EQ(policy.responses.confirmed, Confirmed::never) << id;
    } else if (!is_certain) {
      EXPECT_EQ(policy.responses.confirmed == Confirmed::unlikely, hardly_confirmed.contains(id))
          << id;
      EXPECT_NE(policy.responses.confirmed, Confirmed::never) << id;
    }
    EXPECT_EQ(policy.confirmations == 0, policy.responses.confirmed == Confirmed::never) << id;
    EXPECT_GT(policy.timeout_ms, 0U);
  });
  for (const auto& [id, answer] : answers) EXPECT_TRUE(seen.contains(id)) << id;
  for (const auto* const ids : {&confirmed, &possibly_confirmed, &hardly_confirmed, &silent}) {
    for (const int id : *ids) EXPECT_TRUE(seen.contains(id)) << id;
  }
}

TEST(ResponsePolicy, OnlyReadsAndRequestsThatCanBeRepeatedAreSafe) {
  // Commands that step, count, start, restart or toggle something each time they are executed, and
  // commands with unknown effect.
  const std::set<int> unsafe = {
      69,  72,  65,  103, 59,  71,  80,  79,  66,  26,  27,  35,  75,  89,  39,  40,  114, 51,  30,
      52,  74,  250, 251, 37,  60,  91,  92,  93,  94,  95,  97,  98,  99,  101, 107, 108, 110, 113,
      115, 117, 118, 120, 122, 123, 124, 125, 126, 128, 130, 140, 143, 144, 150, 151, 78,  81,  83};
  for_each_request([&]<class M>(const M& message) {
    const int id = static_cast<int>(M::command);
    const bool calibrates =
        std::same_as<M, msg::SelectImu3Calibrate> || std::same_as<M, msg::SelectImu3CalibrateShort>;
    const bool does_nothing = std::same_as<M, msg::ExecuteMenu>;  // unless it names an action
    EXPECT_EQ(response_policy(message).retry_is_safe,
              (!unsafe.contains(id) && !calibrates) || does_nothing)
        << id
        << ": `unsafe` above lists the commands of which a second one does more than the first";
  });
}

TEST(ResponsePolicy, CalibrationsConfirmTwice) {
  for_each_request([&]<class M>(const M& message) {
    const bool twice = M::command == msg::CommandToBoard::calib_acc ||
                       M::command == msg::CommandToBoard::calib_gyro ||
                       std::same_as<M, msg::SelectImu3Calibrate> ||
                       std::same_as<M, msg::SelectImu3CalibrateShort>;
    const ResponsePolicy policy = response_policy(message);
    EXPECT_EQ(policy.confirmations == 2, twice);
    EXPECT_EQ(policy.finish_ms > policy.timeout_ms, twice || policy.series != 0);
  });
  msg::CalibAccExt request;
  for (const auto action : {msg::CalibAction::reset, msg::CalibAction::enable_temperature,
                            msg::CalibAction::disable_temperature}) {
    request.action = action;
    EXPECT_EQ(response_policy(request).confirmations, 1);
    EXPECT_TRUE(response_policy(request).restarts_board);
  }
  request.action = msg::CalibAction::temperature;
  EXPECT_EQ(response_policy(request).confirmations, 2);
  EXPECT_GT(response_policy(request).finish_ms, 600'000U);
}

TEST(ResponsePolicy, WhatTogglesOrStartsIsNotRepeated) {
  using msg::MenuCommand;
  const auto is_safe = [](MenuCommand action) {
    msg::ExecuteMenuExt with_confirmation{.cmd_id = action, .param = msg::ExecuteMenuFlag::confirm};
    const bool safe = response_policy(with_confirmation).retry_is_safe;
    EXPECT_EQ(response_policy(msg::ExecuteMenu{action}).retry_is_safe, safe);
    return safe;
  };
  EXPECT_TRUE(is_safe(MenuCommand::profile5) && is_safe(MenuCommand::motor_off));
  for (const auto action : {MenuCommand::motor_toggle, MenuCommand::run_script1,
                            MenuCommand::calib_gyro, MenuCommand::button_press}) {
    EXPECT_FALSE(is_safe(action));
  }
  EXPECT_FALSE(response_policy(msg::RunScript{msg::ScriptMode::start}).retry_is_safe);
}

TEST(ResponsePolicy, DependOnTheRequest) {
  msg::ResetRequestExt reset;
  EXPECT_FALSE(response_policy(reset).response_required);
  reset.confirm.set(msg::ResetOption::notify);
  EXPECT_TRUE(response_policy(reset).response_required);
  EXPECT_EQ(response_policy(reset).responses.forms[0].id, 114);
  msg::BootMode3Ext boot;
  boot.confirm.set(msg::ResetOption::notify);
  EXPECT_EQ(response_policy(boot).responses.forms[0].id, 114) << "CMD_RESET, not CMD_BOOT_MODE_3";
  msg::AhrsHelperRequestExt attitude;
  EXPECT_TRUE(response_policy(attitude).response_required);
  attitude.mode.set(msg::AhrsHelperModeBit::set);
  EXPECT_FALSE(response_policy(attitude).response_required);
  EXPECT_EQ(response_policy(attitude).responses.confirmed, Confirmed::unlikely);
  for_each_request([&]<class M>(const M& message) {
    if (M::command == msg::CommandToBoard::reset ||
        M::command == msg::CommandToBoard::boot_mode_3) {
      EXPECT_TRUE(response_policy(message).restarts_board);
    }
  });
}

// A value of the request that the response repeats: its offset, size and value.
struct Repeated {
  std::uint8_t offset;
  std::uint8_t size;
  std::uint32_t value;
};

void expect_field(const CorrelationField& field, const Repeated& repeated) {
  EXPECT_EQ(field.offset, repeated.offset);
  EXPECT_EQ(field.size, repeated.size);
  EXPECT_EQ(field.value, repeated.value);
}

TEST(ResponsePolicy, AnswersRepeatPartsOfTheRequest) {
  msg::ReadParamsExt2Request params{.profile_id = 3};
  expect_field(response_policy(params).responses.forms[0].correlation[0], {0, 1, 3});
  params.profile_id = 255;
  EXPECT_EQ(response_policy(params).responses.forms[0].correlation[0].size, 0);
  msg::EepromReadRequest memory{.addr = 0x12345640};
  expect_field(response_policy(memory).responses.forms[0].correlation[0], {0, 4, 0x12345640});
  msg::ReadFileRequest file{.page_offset = msg::Pages(0x0102)};
  expect_field(response_policy(file).responses.forms[0].correlation[0], {2, 2, 0x0102});
  EXPECT_TRUE(response_policy(file).responses.forms[1].is_error);
  EXPECT_EQ(response_policy(file).responses.forms[1].max_size, 1);
  msg::CalibInfoRequest calibration{.imu_type = msg::SelectedImu::frame};
  expect_field(response_policy(calibration).responses.forms[0].correlation[0], {1, 1, 2});
  msg::EepromWrite write{.addr = 64};
  expect_field(response_policy(write).responses.confirmation, {1, 4, 64});
  EXPECT_EQ(response_policy(msg::WriteFile{}).result.offset, 1);
  EXPECT_EQ(response_policy(msg::WriteFile{}).result.size, 1);
  EXPECT_EQ(response_policy(msg::FsClearAll{}).result.size, 1);
  EXPECT_EQ(response_policy(write).result.size, 0);
}

/// A response with the requested values matches; a response with any other value in a correlation
/// field does not.
TEST(ResponsePolicy, CorrelationFieldsDecideWhatFits) {
  msg::EepromReadRequest request{.addr = 0xA0B0C0};
  const Responses responses = response_policy(request).responses;
  std::vector<std::uint8_t> body = {0xC0, 0xB0, 0xA0, 0x00, 1, 2, 3};
  EXPECT_NE(responses.form_of({48, body, 0}), nullptr);
  EXPECT_EQ(responses.form_of({47, body, 0}), nullptr);
  for (std::size_t i = 0; i < 4; ++i) {
    body[i] ^= 0x40;
    EXPECT_EQ(responses.form_of({48, body, 0}), nullptr) << i;
    body[i] ^= 0x40;
  }
  EXPECT_EQ(responses.form_of({48, std::span(body).first(3), 0}), nullptr);
}

TEST(ResponsePolicy, FormsBeyondTheirNumberDoNotCount) {
  Responses responses = response_policy(msg::ReadFileRequest{}).responses;
  const std::vector<std::uint8_t> failure = {3};
  EXPECT_NE(responses.form_of({53, failure, 0}), nullptr);
  responses.form_count = 1;
  EXPECT_EQ(responses.form_of({53, failure, 0}), nullptr);
}

TEST(ResponsePolicy, ThoseThatOneFrameFitsCanBeConfused) {
  const auto confused = [](const auto& one, const auto& two) {
    const Responses first = response_policy(one).responses;
    const Responses second = response_policy(two).responses;
    EXPECT_EQ(first.can_be_confused_with(second), second.can_be_confused_with(first));
    return first.can_be_confused_with(second);
  };
  msg::ReadParams3Request one;
  msg::ReadParams3Request two{.profile_id = 1};
  EXPECT_TRUE(confused(one, one));
  EXPECT_FALSE(confused(one, two));
  two.profile_id = 255;
  EXPECT_TRUE(confused(one, two));
  EXPECT_FALSE(confused(one, msg::ReadParams{})) << "each has an answer of its own";
  EXPECT_TRUE(confused(msg::RealtimeData{}, msg::RealtimeData3Request{}));
  EXPECT_FALSE(confused(msg::RealtimeData4Request{}, msg::RealtimeData3Request{}));
  EXPECT_TRUE(confused(msg::Control{}, msg::ControlExt{}));
  EXPECT_FALSE(confused(msg::MotorsOn{}, msg::MotorsOff{}));
  msg::EepromWrite write;
  msg::EepromWrite elsewhere{.addr = 64};
  EXPECT_TRUE(confused(write, elsewhere)) << "the address may be missing";
}

TEST(ResponsePolicy, SizeOfTheAnswer) {
  msg::RealtimeDataCustomRequest request;
  EXPECT_EQ(response_policy(request).responses.forms[0].size, 2);
  request.flags.set(msg::RealtimeDataCustomFlag::rc_data);
  request.flags.set(msg::RealtimeDataCustomFlag::z1_h1_vectors);
  EXPECT_EQ(response_policy(request).responses.forms[0].size, 2 + 12 + 24);
  EXPECT_EQ(response_policy(msg::ReadParams3Request{}).responses.forms[0].size, 134);
  EXPECT_EQ(response_policy(msg::ReadParams3Request{}).responses.forms[0].max_size, 255);
}

template <class M>
concept HasResponse = requires {
  typename M::Response;
};

static_assert(std::same_as<msg::ReadParams::Response, msg::ReadParamsAnswer>);
static_assert(std::same_as<msg::GetAdjVarsVal::Response, msg::SetAdjVarsVal>);
static_assert(std::same_as<msg::BootMode3Ext::Response, Maybe<msg::Reset>>);
static_assert(std::same_as<msg::AhrsHelperRequestExt::Response, Maybe<msg::AhrsHelper>>);
static_assert(
    std::same_as<msg::ReadFileRequest::Response, TypeList<msg::ReadFile, msg::ReadFileError>>);
static_assert(std::is_void_v<msg::ResetRequest::Response>);
static_assert(std::is_void_v<msg::SetAdjVarsVal::Response>, "a request in both directions");
static_assert(!HasResponse<msg::BoardInfo>);
static_assert(std::same_as<ResponseMessages<msg::BootMode3Ext>, TypeList<msg::Reset>>);
static_assert(response_policy(msg::BoardInfoRequest{}).response_required, "known at compile time");

TEST(Roles, OfFrames) {
  const std::vector<std::uint8_t> bytes = {77, 1, 2, 3, 4, 5, 6};
  const auto frame = [&](int id, std::size_t size) {
    return Frame{static_cast<std::uint8_t>(id), std::span(bytes).first(size), 0};
  };
  EXPECT_FALSE(roles::is_confirmation(frame(67, 0)));
  EXPECT_TRUE(roles::is_confirmation(frame(67, 1)));
  EXPECT_EQ(roles::confirmed_command(frame(67, 6)), 77);
  EXPECT_FALSE(roles::is_error(frame(255, 4)));
  EXPECT_TRUE(roles::is_error(frame(255, 5)));
  EXPECT_EQ(roles::failed_command(frame(255, 5)), 0);
  EXPECT_EQ(roles::failed_command(frame(255, 6)), 77);
  EXPECT_EQ(roles::error_reason(frame(255, 5)), roles::ErrorReason{77});
  EXPECT_EQ(roles::error_reason(frame(255, 6)), roles::ErrorReason{1});
  EXPECT_TRUE(roles::is_reset(frame(114, 0)));
  EXPECT_FALSE(roles::is_reset(frame(67, 1)));
}

TEST(Roles, SayWhyARequestFailed) {
  const auto code = [](std::uint8_t id, std::vector<std::uint8_t> body) {
    return roles::failure_code({id, body, 0});
  };
  EXPECT_EQ(code(255, {2, 0, 0, 0, 0}), 2U) << "CMD_ERROR";
  EXPECT_EQ(code(255, {73, 6, 0, 0, 0, 0}), 6U) << "CMD_ERROR that names the command";
  EXPECT_EQ(code(53, {3}), 3U) << "CMD_READ_FILE";
  EXPECT_EQ(code(53, {3, 0, 0, 0}), 0U) << "a part of a file";
  EXPECT_EQ(code(67, {54, 5}), 5U) << "CMD_WRITE_FILE, confirmed";
  EXPECT_EQ(code(67, {54}), 0U);
  EXPECT_EQ(code(67, {47, 5}), 0U) << "the confirmation of CMD_EEPROM_WRITE has no result";
  EXPECT_EQ(code(86, {7}), 0U);
}

static_assert(default_line == LineSettings{115200, Parity::none});
static_assert(SessionCapacity{}.streams == 10, "firmware 2.59 has no more");

TEST(LineFacts, AreThoseOfTheSpecification) {
  const std::span rates(baud_rates);
  EXPECT_THAT(std::vector(rates.begin(), rates.begin() + 6),
              ElementsAre(115200, 57600, 38400, 19200, 9600, 256000));
  EXPECT_EQ(named_baud_rates, 6U);
  EXPECT_THAT(parities, ElementsAre(Parity::none, Parity::even));
  EXPECT_EQ(shortest_pause_ms, 10U);
  EXPECT_EQ(longest_pause_ms, 20U);
  EXPECT_EQ(number_of(msg::SerialSpeed::baud_19200), 19200U);
  EXPECT_EQ(number_of(static_cast<msg::SerialSpeed>(77)), 0U);
}

}  // namespace
}  // namespace sbgc::test
