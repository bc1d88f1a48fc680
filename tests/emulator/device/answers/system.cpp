// Checks of the board itself, its restarts, storage, scripts and debugging.

#include <algorithm>
#include <array>
#include <cstdint>
#include <string_view>

#include <gmock/gmock.h>

#include "table.hpp"

namespace sbgc::test {
namespace {

using ::testing::Each;
using ::testing::ElementsAre;
using ::testing::SizeIs;

}  // namespace

void Table::add_system() {
  const auto introduces = [](Host& host, const Packets& packets) {
    const auto info = only<msg::BoardInfo>(packets);
    EXPECT_EQ(info.board_ver, host.board.options().board);
    EXPECT_EQ(info.firmware_ver, host.board.options().firmware);
    EXPECT_EQ(info.board_features, host.board.options().features);
    EXPECT_FALSE(info.connection_flags.has(msg::ConnectionFlag::usb));
  };
  add<msg::BoardInfoRequest>({.after = introduces});
  add<msg::BoardInfoRequestOneByte>({.after = introduces});
  add<msg::BoardInfoRequestExt>({.request = {.cfg = msg::Milliseconds(20)}, .after = introduces});
  add<msg::BoardInfo3Request>({.after = [](Host& host, const Packets& packets) {
    const auto details = only<msg::BoardInfo3>(packets);
    EXPECT_EQ(details.device_id, host.board.options().device_id);
    EXPECT_EQ(details.mcu_id, host.board.options().mcu_id);
    EXPECT_EQ(details.eeprom_size.raw(), host.board.memory().eeprom.size());
  }});
  msg::ResetRequestExt reset;
  reset.delay_ms = msg::Milliseconds(300);
  add<msg::ResetRequestExt>({.request = reset});
  reset.confirm = msg::ResetOption::notify;
  add<msg::ResetRequestExt>({.request = reset});
  msg::BootMode3Ext boot;
  boot.delay_ms = msg::Milliseconds(300);
  add<msg::BootMode3Ext>({.request = boot});
  boot.confirm = msg::ResetOption::notify;
  add<msg::BootMode3Ext>({.request = boot});
}

void Table::add_storage() {
  msg::EepromWrite write;
  write.addr = 64 * 40;
  ASSERT_TRUE(write.data.resize(64));
  std::fill(write.data.begin(), write.data.end(), std::uint8_t{0xA5});
  const msg::EepromReadRequest read{.addr = write.addr, .size = msg::ByteCount(64)};
  const auto is_written = [=](Host&, const Packets& packets) {
    const auto data = all<msg::EepromRead>(packets);
    ASSERT_THAT(data, SizeIs(1));
    EXPECT_EQ(data[0].addr, write.addr);
    EXPECT_THAT(data[0].data, SizeIs(64));
    EXPECT_THAT(data[0].data, Each(0xA5));
  };
  add<msg::EepromWrite>({.request = write, .after = [=](Host& host, const Packets&) {
                           is_written(host, host.ask(read));
                         }});
  add<msg::EepromReadRequest>(
      {.request = read, .before = [=](Host& host) { host.ask(write); }, .after = is_written});

  msg::WriteFile file;
  file.file_id = 300;
  file.file_size = msg::ByteCount(3);
  for (const std::uint8_t byte : std::array<std::uint8_t, 3>{1, 2, 3}) file.data.push_back(byte);
  const msg::ReadFileRequest look{.file_id = 300, .max_data_size = msg::ByteCount(100)};
  const auto is_present = [](Host&, const Packets& packets) {
    const auto part = all<msg::ReadFile>(packets);
    ASSERT_THAT(part, SizeIs(1));
    EXPECT_EQ(part[0].file_size.raw(), 3);
    EXPECT_THAT(part[0].data, ElementsAre(1, 2, 3));
  };
  add<msg::WriteFile>({.request = file, .after = [=](Host& host, const Packets&) {
                         is_present(host, host.ask(look));
                       }});
  add<msg::ReadFileRequest>(
      {.request = look, .before = [=](Host& host) { host.ask(file); }, .after = is_present});
  add<msg::FsClearAll>({.before = [=](Host& host) { host.ask(file); },
                        .after =
                            [=](Host& host, const Packets&) {
                              EXPECT_EQ(host.get<msg::ReadFileError>(look).err_code,
                                        msg::FileError::file_not_found);
                            }});
}

void Table::add_scripting_and_debug() {
  add<msg::RunScript>({.request = {.mode = msg::ScriptMode::start, .slot = 0},
                       .comes = Comes::confirmation,
                       .before = [](Host& host) {
                         msg::WriteFile script;
                         const std::string_view text = "one\ntwo\n";
                         script.file_size = msg::ByteCount(static_cast<std::uint16_t>(text.size()));
                         for (const char c : text)
                           script.data.push_back(static_cast<std::uint8_t>(c));
                         host.ask(script);
                       }});
  add<msg::DebugVarsInfo3Request>({.after = [](Host&, const Packets& packets) {
    EXPECT_GT(only<msg::DebugVarsInfo3>(packets).vars.size(), 5U);
  }});
  add<msg::DebugVars3Request>(
      {.after = [](Host&, const Packets& packets) { EXPECT_THAT(packets, SizeIs(1)); }});
}

}  // namespace sbgc::test
