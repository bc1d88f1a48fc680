// Tests of loading firmware into modules: what the board refuses.

#include <cstdint>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "replies.hpp"

namespace sbgc::test {
namespace {

using ::testing::IsEmpty;
using ::testing::SizeIs;

constexpr auto driver = msg::ModuleId::can_drv2;
// CRC-32 of the bytes 1 to 8, from the vendor's example.
constexpr std::uint32_t crc_of_part = 0x3FCA88C5;

msg::ModuleFlashStart start(std::uint32_t words, msg::ModuleId module = driver) {
  msg::ModuleFlashStart request{.device_id = module};
  request.firmware_size = msg::WordCount(words);
  return request;
}

msg::ModuleFlashWrite part(std::uint8_t packet, std::uint32_t address) {
  msg::ModuleFlashWrite request{
      .device_id = driver, .packet_id = packet, .address = address, .data_crc32 = crc_of_part};
  for (std::uint8_t byte = 1; byte <= 8; ++byte) request.data.push_back(byte);
  return request;
}

TEST(ModuleFlash, TakesPartsInTheirOrderOnly) {
  Host host(newest_board());
  using Code = msg::BoardErrorCode;
  EXPECT_EQ(refusal(host, part(0, 0)), Code::wrong_params) << "not started";
  EXPECT_EQ(refusal(host, start(4, msg::ModuleId::udrv1)), Code::wrong_params) << "no such module";
  EXPECT_EQ(refusal(host, start(0)), Code::wrong_params);
  EXPECT_TRUE(is_confirmed(host, start(4)));
  EXPECT_EQ(refusal(host, part(1, 0)), Code::wrong_params);
  EXPECT_EQ(refusal(host, part(0, 8)), Code::wrong_params);
  auto damaged = part(0, 0);
  damaged.data[3] ^= 1;
  EXPECT_EQ(refusal(host, damaged), Code::wrong_params);
  EXPECT_TRUE(is_confirmed(host, part(0, 0)));
  EXPECT_EQ(refusal(host, part(0, 0)), Code::wrong_params) << "repeated";
  const msg::ModuleFlashFinish early{.device_id = driver, .file_crc32 = crc_of_part};
  EXPECT_EQ(refusal(host, early), Code::wrong_params) << "half of it";
  EXPECT_THAT(host.board.module_firmware().at(driver), IsEmpty());
  EXPECT_TRUE(is_confirmed(host, part(1, 8)));
  EXPECT_EQ(refusal(host, part(2, 16)), Code::wrong_params) << "more than announced";
  EXPECT_EQ(refusal(host, early), Code::wrong_params) << "the sum of another file";
}

TEST(ModuleFlash, AnErrorNamesTheModuleAndThePart) {
  Host host(newest_board());
  host.ask(start(4));
  host.ask(part(0, 0));
  const auto errors = all<msg::ErrorExt>(host.ask(part(7, 0)));
  ASSERT_THAT(errors, SizeIs(1));
  EXPECT_THAT(errors[0].error_data, ::testing::ElementsAre(4, 0, 1, 0));  // CAN_DRV2, part 1
}

TEST(ModuleFlash, ARestartDropsWhatIsLoading) {
  Host host(newest_board());
  host.ask(start(2));
  host.board.restart(host.now);
  host.listen(seconds(1));
  EXPECT_EQ(refusal(host, part(0, 0)), msg::BoardErrorCode::wrong_params);
}

}  // namespace
}  // namespace sbgc::test
