// With SBGC_SMALL_CRC_TABLES and SBGC_NO_DESCRIPTIONS, as a module of WebAssembly is compiled.

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include <gtest/gtest.h>

#include <sbgc/crc.hpp>
#include <sbgc/explain.hpp>
#include <sbgc/internal/crc32.hpp>
#include <sbgc/meta/all.hpp>

namespace sbgc {
namespace {

constexpr std::uint8_t check[] = {'1', '2', '3', '4', '5', '6', '7', '8', '9'};

TEST(SmallCrcTables, HaveTheSameSums) {
  // The check values of CRC-32/ISO-HDLC and CRC-16/ARC.
  EXPECT_EQ(detail::crc32(check), 0xCBF43926);
  struct Parameters {
    std::uint16_t polynomial = 0x8005, initial = 0, final_xor = 0;
    bool reflect_in = true, reflect_out = true;
  };
  constexpr Parameters arc;
  EXPECT_EQ((Crc<arc, CrcTable::nibbles>().add(check, sizeof check).value()), 0xBB3D);
  EXPECT_EQ((Crc<arc, CrcTable::bytes>().add(check, sizeof check).value()), 0xBB3D);
  EXPECT_EQ((Crc<arc, CrcTable::slices>().add(check, sizeof check).value()), 0xBB3D);
}

TEST(NoDescriptions, OnlyErrorsHaveSummaries) {
  EXPECT_STREQ(Meta<msg::Control>::info.summary, "");
  EXPECT_STREQ(Meta<msg::Control>::fields[0].summary, "");
  for (const ValueInfo& value : EnumMeta<msg::MenuCommand>::info.values) {
    EXPECT_STREQ(value.summary, "");
  }
  for (const ValueInfo& error : EnumMeta<msg::SystemError>::info.values) {
    EXPECT_STRNE(error.summary, "") << error.name;
  }
  for (const ValueInfo& error : EnumMeta<msg::FileError>::info.values) {
    EXPECT_STRNE(error.summary, "") << error.name;
  }
}

TEST(NoDescriptions, NamesAreThere) {
  EXPECT_STREQ(Meta<msg::Control>::info.command, "CMD_CONTROL");
  EXPECT_STREQ(Meta<msg::Control>::fields[0].name, "control_mode");
  EXPECT_EQ(objection_to(Meta<msg::RealtimeData4Request>::info, {.firmware = 1}),
            "needs board 3.0");
}

}  // namespace
}  // namespace sbgc
