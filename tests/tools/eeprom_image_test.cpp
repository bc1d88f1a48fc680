// Files with bytes of an EEPROM.

#include "care/memory/eeprom_image.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include <gtest/gtest.h>

#include "command/command_error.hpp"

namespace sbgc::tools {
namespace {

std::string sample() { return to_text({"3.0", "2.59", 7, "0a0b", 4096, {'{', 0, '\n', 255, '"'}}); }

TEST(EepromImage, IsReadAsItWasWritten) {
  const std::optional<EepromImage> image = parse_image(sample());
  ASSERT_TRUE(image);
  EXPECT_EQ(image->model, "3.0");
  EXPECT_EQ(image->firmware, "2.59");
  EXPECT_EQ(image->extra_id, 7U);
  EXPECT_EQ(image->serial_number, "0a0b");
  EXPECT_EQ(image->address, 4096U);
  EXPECT_EQ(image->data, (std::vector<std::uint8_t>{'{', 0, '\n', 255, '"'}));
  EXPECT_FALSE(parse_image("bytes alone"));
}

TEST(EepromImage, NoChangeOfAnyBitAndNoCutPasses) {
  const std::string good = sample();
  const auto is_refused = [](const std::string& text) {
    try {
      return !parse_image(text).has_value();
    } catch (const CommandError&) {
      return true;
    }
  };
  for (std::size_t bit = 0; bit < good.size() * 8; ++bit) {
    std::string changed = good;
    changed[bit / 8] = static_cast<char>(changed[bit / 8] ^ 1 << bit % 8);
    EXPECT_TRUE(is_refused(changed)) << bit;
  }
  for (std::size_t size = 0; size < good.size(); ++size) {
    EXPECT_TRUE(is_refused(good.substr(0, size))) << size;
    EXPECT_TRUE(is_refused(good.substr(size + 1))) << size;
  }
  EXPECT_TRUE(is_refused(good + '\n'));
}

}  // namespace
}  // namespace sbgc::tools
