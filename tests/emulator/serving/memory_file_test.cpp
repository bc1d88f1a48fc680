// Tests of the memory of a board as a file: it is restored completely, and damaged files are
// rejected.

#include "serving/memory_file.hpp"

#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <limits>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

namespace {

using sbgc::ErrorCode;
using sbgc::emulator::ImuCalibration;
using sbgc::emulator::Memory;
using sbgc::serving::load_memory;
using sbgc::serving::parse_memory;
using sbgc::serving::save_memory;
using sbgc::serving::SavedMemory;
using testing::HasSubstr;

ImuCalibration calibration(std::mt19937& random) {
  const auto small = [&] { return static_cast<std::int8_t>(random()); };
  const auto number = [&] { return (static_cast<double>(random()) - 2e9) / 3e6; };
  ImuCalibration imu;
  imu.gyro_is_calibrated = random() % 2 == 0;
  imu.acc_limits = static_cast<std::uint8_t>(random());
  imu.gyro_temperature_enabled = random() % 2 == 0;
  imu.acc_temperature_enabled = random() % 2 == 0;
  imu.gyro_temperature_min = small();
  imu.gyro_temperature_max = small();
  imu.acc_temperature_min = small();
  imu.acc_temperature_max = small();
  for (auto& slot : imu.acc_slots) slot = static_cast<std::uint8_t>(random());
  imu.gyro_offset = {number(), number(), number()};
  return imu;
}

SavedMemory random_memory(unsigned seed) {
  std::mt19937 random(seed);
  SavedMemory saved{sbgc::serving::owner_of({}), {}};
  saved.owner.firmware = sbgc::msg::FirmwareVersion(static_cast<std::uint16_t>(random()));
  for (auto& byte : saved.owner.device_id) byte = static_cast<std::uint8_t>(random());
  for (auto& byte : saved.memory.eeprom) byte = static_cast<std::uint8_t>(random());
  for (auto& imu : saved.memory.imus) imu = calibration(random);
  for (auto& imu : saved.memory.sensors) imu = calibration(random);
  saved.memory.battery_factor = 1.0 + static_cast<double>(random() % 1000) / 7000;
  saved.memory.profile = static_cast<std::uint8_t>(random() % 5);
  if (random() % 2 == 0) {
    saved.memory.profile_set = static_cast<std::uint8_t>(1 + random() % 6);
    for (auto& set : saved.memory.profile_sets) set.resize(random() % 3 * 100);
    for (auto& set : saved.memory.profile_sets) {
      for (auto& byte : set) byte = static_cast<std::uint8_t>(random());
    }
    saved.memory.pass_protect = static_cast<std::uint32_t>(random());
    saved.memory.state_variables.assign(192, static_cast<std::uint8_t>(random()));
  }
  return saved;
}

/// Returns `text` with the first `from` replaced by `to`; fails the test if there is none.
std::string changed(const std::string& text, const std::string& from, const std::string& to) {
  const auto at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return std::string(text).replace(at, from.size(), to);
}

void expect_error(const std::string& text, ErrorCode code, const std::string& words) {
  const auto result = parse_memory(text);
  ASSERT_FALSE(result) << words;
  EXPECT_EQ(name(result.error().code), std::string(name(code)));
  EXPECT_THAT(result.error().message, HasSubstr(words));
}

class MemoryFile : public testing::Test {
 public:
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;

 protected:
  MemoryFile() {
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
  }
  ~MemoryFile() override { std::filesystem::remove_all(folder_); }

  [[nodiscard]] std::string path(const std::string& file) const {
    return (folder_ / file).string();
  }
  static std::string content(const std::string& file) {
    std::ostringstream text;
    text << std::ifstream(file).rdbuf();
    return text.str();
  }

 private:
  std::filesystem::path folder_ =
      std::filesystem::temp_directory_path() / ("sbgc-memory-" + std::to_string(::getpid()));
};

TEST(MemoryText, AllOfItComesBack) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    const SavedMemory saved = random_memory(seed);
    const auto again = parse_memory(to_json_text(saved));
    ASSERT_TRUE(again) << again.error().message;
    EXPECT_EQ(again->memory, saved.memory);
    EXPECT_EQ(again->owner, saved.owner);
  }
}

TEST(MemoryText, TheRevisionIsNotKept) {
  SavedMemory saved = random_memory(1);
  saved.memory.revision = 17;
  const auto again = parse_memory(to_json_text(saved));
  ASSERT_TRUE(again);
  EXPECT_EQ(again->memory.revision, 0);
}

TEST(MemoryText, ACutFileIsNone) {
  const std::string text = to_json_text(random_memory(1));
  for (std::size_t size = 0; size + 2 < text.size(); size += size < 2000 ? 1 : 997) {
    ASSERT_FALSE(parse_memory(text.substr(0, size))) << size;
  }
}

TEST(MemoryText, EveryChangedCharacterIsNoticed) {
  const std::string text = to_json_text(random_memory(1));
  std::mt19937 random(3);
  int loaded = 0;
  for (int i = 0; i < 400; ++i) {
    std::string damaged = text;
    const std::size_t at = i < 200 ? random() % 2500 : random() % text.size();
    damaged[at] = static_cast<char>(damaged[at] ^ (1 << random() % 7));
    const auto result = parse_memory(damaged);
    if (!result) {
      EXPECT_NE(result.error().message, "");
      continue;
    }
    // Only white space or the case of a hex digit has changed, so the content is the same.
    EXPECT_EQ(result->memory, random_memory(1).memory);
    EXPECT_EQ(result->owner, random_memory(1).owner);
    ++loaded;
  }
  EXPECT_LT(loaded, 200);
}

TEST(MemoryText, SaysWhatIsWrongAndWhere) {
  const SavedMemory saved{sbgc::serving::owner_of({}), {}};
  const std::string text = to_json_text(saved);
  const auto bad = ErrorCode::bad_file;
  expect_error("", bad, "this is an empty file, not the memory of an emulated board");
  expect_error("<saved-configuration/>", bad,
               "this is XML of the vendor's program, not the memory");
  expect_error(std::string(200'000, '[') + std::string(200'000, ']'), bad,
               "nested deeper than 64 levels (line 1, column 65)");
  for (const char* const other : {"[]", "{}", R"({"format":"sbgc-backup"})"}) {
    expect_error(other, bad, "not the memory of an emulated board");
  }
  expect_error(R"({"format":"sbgc-board-memory"})", bad, "version: it is missing");
  expect_error(R"({"format":"sbgc-board-memory","version":2})", ErrorCode::incompatible,
               "version 2 of the format");
  expect_error(changed(text, "\"version\": 1,", "\"version\": 18446744073709551615,"),
               ErrorCode::incompatible, "version 18446744073709551615");
  const std::string line = '"' + std::string(128, 'f') + '"';
  struct Case {
    std::string from, to;
    const char* problem;
  };
  for (const Case& one : std::vector<Case>{
           {R"("version": 1)", R"("version": 0)", "version: expected 1"},
           {R"("version": 1)", R"("version": -1)", "version: expected a number"},
           {R"("version": 1)", R"("version": "1")", "version: expected a number"},
           {R"("profile": 0)", R"("profile": 0, "profile": 0)", "the key 'profile' occurs twice"},
           {R"("profile": 0)", R"("profile": 5)", "profile: expected a number below 5"},
           {R"("profile": 0)", R"("profile": -1)", "profile: expected a number"},
           {R"("profile": 0)", R"("profile": 0.5)", "profile: expected a number"},
           {R"("profile": 0)", R"("profile": 1)", "crc32: wrong checksum"},
           {R"("profile")", R"("colour": 1, "profile")", "colour: unknown key"},
           {R"("acc_limits")", R"("x": 1, "acc_limits")", "imus[0].x: unknown key"},
           {R"("acc_limits")", R"("acc_limit")", "imus[0].acc_limits: it is missing"},
           {R"(factor": 1.0)", R"(factor": 1e300)", "battery_factor: expected a number"},
           {R"(factor": 1.0)", R"(factor": null)", "battery_factor: expected a number"},
           {R"(factor": 1.0)", R"(factor": -1)", "battery_factor: must not be negative"},
           {R"(calibrated": true)", R"(calibrated": 1)",
            "imus[0].gyro_is_calibrated: expected true or false"},
           {R"("device_id": ")", R"("device_id": "00)",
            "board.device_id: expected hex digits of 9 bytes"},
           {line, line + "," + line, "eeprom: expected a list of 512"},
           {line, R"("ff")", "eeprom[0]: expected hex digits of 64 bytes"},
           {line, "7", "eeprom[0]: expected hex digits of 64 bytes"},
       }) {
    expect_error(changed(text, one.from, one.to), bad, one.problem);
  }
}

TEST_F(MemoryFile, IsLoadedAsItWasSaved) {
  const SavedMemory saved = random_memory(2);
  ASSERT_TRUE(save_memory(path("board.json"), saved));
  const auto again = load_memory(path("board.json"));
  ASSERT_TRUE(again) << again.error().message;
  EXPECT_EQ(again->memory, saved.memory);
}

TEST_F(MemoryFile, IsReplacedAndNothingElseStays) {
  ASSERT_TRUE(save_memory(path("board.json"), random_memory(2)));
  ASSERT_TRUE(save_memory(path("board.json"), random_memory(3)));
  EXPECT_EQ(load_memory(path("board.json"))->memory, random_memory(3).memory);
  const auto files = std::filesystem::directory_iterator(path(""));
  EXPECT_EQ(std::distance(begin(files), end(files)), 1);
}

TEST_F(MemoryFile, WhatCouldNotBeLoadedIsNotSaved) {
  ASSERT_TRUE(save_memory(path("board.json"), random_memory(2)));
  const std::string before = content(path("board.json"));
  for (const double factor : {std::nan(""), std::numeric_limits<double>::infinity(), -1.0}) {
    SavedMemory bad = random_memory(2);
    bad.memory.battery_factor = factor;
    const auto result = save_memory(path("board.json"), bad);
    ASSERT_FALSE(result);
    EXPECT_THAT(result.error().message, HasSubstr("battery_factor"));
  }
  SavedMemory small = random_memory(2);
  small.memory.eeprom.resize(100);
  EXPECT_FALSE(save_memory(path("board.json"), small));
  EXPECT_EQ(content(path("board.json")), before);
}

TEST_F(MemoryFile, ErrorsNameTheFile) {
  const auto missing = load_memory(path("none.json"));
  ASSERT_FALSE(missing);
  EXPECT_EQ(missing.error().code, ErrorCode::not_found);
  EXPECT_THAT(missing.error().message, HasSubstr("none.json"));
  std::ofstream(path("other.json")) << "{}";
  const auto other = load_memory(path("other.json"));
  ASSERT_FALSE(other);
  EXPECT_THAT(other.error().message, HasSubstr("other.json: this is other JSON, not the memory"));
  std::ofstream(path("large.json")) << std::string(2'000'000, ' ');
  const auto large = load_memory(path("large.json"));
  ASSERT_FALSE(large);
  EXPECT_EQ(large.error().code, ErrorCode::bad_file);
  const auto folder = load_memory(path(""));
  ASSERT_FALSE(folder);
  EXPECT_FALSE(save_memory(path("no/such/folder.json"), random_memory(1)));
}

TEST(MemoryText, AFileWithoutLaterStateIsComplete) {
  SavedMemory saved{sbgc::serving::owner_of({}), {}};
  const std::string text = sbgc::serving::to_json_text(saved);
  EXPECT_EQ(text.find("profile_set"), std::string::npos) << "as earlier emulators wrote it";
  EXPECT_EQ(text.find("state_variables"), std::string::npos);
  const auto read = parse_memory(text);
  ASSERT_TRUE(read);
  EXPECT_EQ(read->memory, saved.memory);
}

TEST(MemoryText, LaterStateHasItsLimits) {
  SavedMemory saved{sbgc::serving::owner_of({}), {}};
  saved.memory.profile_set = 6;
  saved.memory.state_variables.assign(3, 0xAB);
  const std::string text = sbgc::serving::to_json_text(saved);
  expect_error(changed(text, "\"profile_set\": 6", "\"profile_set\": 7"), ErrorCode::bad_file,
               "profile_set");
  expect_error(changed(text, "ababab", "ababa"), ErrorCode::bad_file, "state_variables");
  expect_error(changed(text, "ababab", "ababac"), ErrorCode::bad_file, "crc32");
}

}  // namespace
