#include <gtest/gtest.h>

#include "values/field_text.hpp"

namespace sbgc::tools {
namespace {

TEST(FirmwareText, Versions) {
  EXPECT_EQ(parse_firmware("2.43b9"), msg::FirmwareVersion(2439));
  EXPECT_EQ(parse_firmware("2.59"), msg::FirmwareVersion(2590));
  EXPECT_EQ(parse_firmware("2.59")->minor(), 59);
  EXPECT_EQ(parse_firmware("2.59b0"), msg::FirmwareVersion(2590)) << "as decode prints it";
  EXPECT_EQ(parse_firmware("2.73.1"), msg::FirmwareVersion(2731));
  EXPECT_EQ(parse_firmware("2.74.5"), msg::FirmwareVersion(2745));
  for (const char* text : {"", "2", "2.5", "2.590", "2.59b", "2.59.", "2.59b10", "2.5.9", "x.59",
                           "2.59 ", "2.-9", "2..59", ".59", "2.59b1.", "2.59.1b"}) {
    EXPECT_EQ(parse_firmware(text), std::nullopt) << text;
  }
}

}  // namespace
}  // namespace sbgc::tools
