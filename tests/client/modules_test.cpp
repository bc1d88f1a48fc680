// Tests of loading firmware into modules, in virtual time.

#include <sbgc/client/modules.hpp>

#include "testing.hpp"
#include "virtual_client.hpp"

namespace sbgc::test {
namespace {

constexpr auto driver = msg::ModuleId::can_drv1;

std::vector<std::uint8_t> firmware(std::size_t size, unsigned seed = 1) {
  std::mt19937 random(seed);
  std::vector<std::uint8_t> bytes(size);
  for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(random());
  return bytes;
}

emulator::EmulatorOptions newest() {
  emulator::EmulatorOptions options;
  options.board.board = msg::BoardVersion(36);
  options.board.firmware = msg::FirmwareVersion(newest_firmware);
  return options;
}

/// Loses one frame of either direction, and keeps the parts that reach the board.
class PartsLine : public VirtualLine {
 public:
  explicit PartsLine(bool may_repeat = false) : may_repeat_(may_repeat) {}

  bool may_repeat() const override { return may_repeat_; }
  void lose(Way way, int number) { lost_ = {way, number}; }
  void lose_nothing() { lost_.reset(); }

  void send(Way way, std::span<const std::uint8_t> bytes, Instant at) override {
    parsers_[way == Way::to_board ? 0 : 1].feed(bytes, [&](const Frame& frame) {
      if (lost_ && lost_->first == way && --lost_->second == 0) return;
      if (way == Way::to_board && frame.id == 81) take(frame);
      std::array<std::uint8_t, max_frame_size> out{};
      const std::size_t size = write_frame(frame.framing, frame.id, frame.body, out).size;
      VirtualLine::send(way, std::span(out).first(size), at);
    });
  }

  std::vector<msg::ModuleFlashWrite> parts{};

 private:
  void take(const Frame& frame) { ASSERT_TRUE(decode(frame.body, parts.emplace_back())); }

  bool may_repeat_;
  std::optional<std::pair<Way, int>> lost_{};
  std::array<BasicParser<AnyFrameFormats>, 2> parsers_{};
};

/// Fails unless the parts follow each other from the first one, each once.
void expect_in_order(const std::vector<msg::ModuleFlashWrite>& parts) {
  std::uint32_t address = 0;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    EXPECT_EQ(parts[i].packet_id, i % 256);
    EXPECT_EQ(parts[i].address, address);
    address += static_cast<std::uint32_t>(parts[i].data.size());
  }
}

TEST(Modules, FirmwareArrivesWhole) {
  PartsLine line;
  VirtualClient client(newest(), {}, &line);
  const auto bytes = firmware(300U * 128 + 12);  // more parts than their number can count
  std::vector<std::size_t> seen;
  require(client.run(tasks::flash_module(driver, bytes, [&](const Progress& progress) {
    seen.push_back(progress.done);
    return progress.total == bytes.size();
  })));
  EXPECT_THAT(client.emulator().board().module_firmware().at(driver), ElementsAreArray(bytes));
  EXPECT_EQ(line.parts.size(), 301U);
  expect_in_order(line.parts);
  EXPECT_EQ(seen.back(), bytes.size());
}

TEST(Modules, WhatCannotBeFirmwareIsRefusedBeforeAnythingIsErased) {
  VirtualClient client(newest());
  for (const std::size_t size : {std::size_t{0}, std::size_t{126}, max_module_firmware + 4}) {
    EXPECT_EQ(client.run(tasks::flash_module(driver, firmware(size))).error().code,
              ErrorCode::invalid);
  }
  EXPECT_THAT(client.run(tasks::flash_module(msg::ModuleId::udrv1, firmware(8))),
              fails(ErrorCode::not_found, "no module UDRV1"));
  const auto refuses = [](const Progress&) { return false; };
  EXPECT_EQ(client.run(tasks::flash_module(driver, firmware(8), refuses)).error().code,
            ErrorCode::cancelled);
  EXPECT_THAT(client.emulator().board().module_firmware(), IsEmpty());
}

TEST(Modules, AnErrorSaysWhichPartWasConfirmedLastAndHowToGoOn) {
  PartsLine line;
  VirtualClient client(newest(), {}, &line);
  line.lose(VirtualLine::Way::to_host, 1 + 1 + 4);  // the list, the start, the fourth part
  EXPECT_THAT(client.run(tasks::flash_module(driver, firmware(1280))),
              fails(ErrorCode::timeout,
                    AllOf(HasSubstr("writing part 3: "), HasSubstr("part 2 was confirmed last"),
                          HasSubstr("again from the beginning"))));
  EXPECT_EQ(line.parts.size(), 4U);
}

TEST(Modules, ALineThatMayRepeatPacketsIsRefused) {
  for (const bool is_known_by_its_kind : {true, false}) {
    PartsLine line(is_known_by_its_kind);
    ConnectOptions options;
    if (!is_known_by_its_kind) options.duplicate_window = Ms(200);
    VirtualClient client(newest(), {}, &line, options);
    EXPECT_THAT(client.run(tasks::flash_module(driver, firmware(1280))),
                fails(ErrorCode::unsupported, "may repeat packets"));
    EXPECT_THAT(client.emulator().board().module_firmware(), IsEmpty());
  }
}

// A program that is killed sends nothing more, as one that is interrupted.
TEST(Modules, LossesAndKillsNeverRepeatOrSkipAPart) {
  std::mt19937 random(38);
  const auto bytes = firmware(1920);  // 15 parts
  int failures = 0;
  for (int run = 0; run < 200; ++run) {
    SCOPED_TRACE(run);
    PartsLine line;
    VirtualClient client(newest(), {}, &line);
    const int number = 2 + static_cast<int>(random() % 18);
    const bool is_killed = random() % 2 == 0;
    if (!is_killed) {
      line.lose(random() % 2 == 0 ? VirtualLine::Way::to_board : VirtualLine::Way::to_host, number);
    }
    int steps = 0;
    const auto done = client.run(tasks::flash_module(
        driver, bytes, [&](const Progress&) { return !is_killed || ++steps < number; }));
    if (!done) ++failures;
    expect_in_order(line.parts);
    const auto& loaded = client.emulator().board().module_firmware();
    if (done) {
      EXPECT_THAT(loaded.at(driver), ElementsAreArray(bytes));
    }
    // The next time starts from the beginning.
    line.parts.clear();
    line.lose_nothing();
    require(client.run(tasks::flash_module(driver, bytes)));
    expect_in_order(line.parts);
    EXPECT_THAT(loaded.at(driver), ElementsAreArray(bytes));
  }
  EXPECT_GT(failures, 100);
}

}  // namespace
}  // namespace sbgc::test
