// Checks of calibrations, the attitude and connected devices.

#include <cmath>

#include <gmock/gmock.h>

#include "table.hpp"

namespace sbgc::test {
namespace {

using ::testing::ElementsAre;
using ::testing::SizeIs;

}  // namespace

void Table::add_calibration() {
  for (const msg::CalibAction action :
       {msg::CalibAction::regular, msg::CalibAction::reset, msg::CalibAction::temperature,
        msg::CalibAction::enable_temperature, msg::CalibAction::disable_temperature,
        msg::CalibAction::restore_factory, msg::CalibAction::store_in_sensor}) {
    add<msg::CalibAccExt>({.request = {.imu_idx = msg::CalibImu::main, .action = action}});
    add<msg::CalibGyroExt>({.request = {.imu_idx = msg::CalibImu::frame, .action = action}});
  }
  add<msg::CalibMag>({.comes = Comes::confirmation});
  add<msg::CalibOffset>({.comes = Comes::confirmation});
  add<msg::CalibBat>({.request = {.actual_voltage = msg::Voltage(1500)},
                      .comes = Comes::confirmation,
                      .after = [](Host& host, const Packets&) {
                        const auto data = host.get<msg::RealtimeData3>(msg::RealtimeData3Request{});
                        EXPECT_NEAR(data.bat_level.real(), 15.0, 0.1);
                      }});
  add<msg::CalibInfoRequest>(
      {.request = {.imu_type = msg::SelectedImu::main},
       .before = [](Host& host) { host.ask(msg::CalibGyro{}, milliseconds(500)); },
       .after =
           [](Host&, const Packets& packets) {
             const auto info = all<msg::CalibInfo>(packets);
             ASSERT_THAT(info, SizeIs(1));
             EXPECT_GT(info[0].progress.raw(), 0);
             EXPECT_LT(info[0].progress.raw(), 100);
           }});
  add<msg::EncodersCalibOffset4>({.comes = Comes::confirmation});
  add<msg::EncodersCalibFldOffset4>({.comes = Comes::confirmation});
  add<msg::AutoPidRequest>(
      {.request = {.profile_id = 1, .cfg_flags = msg::AutoPidFlag::roll},
       .comes = Comes::confirmation,
       .after = [](Host& host, const Packets&) {
         EXPECT_EQ(host.get<msg::RealtimeData3>(msg::RealtimeData3Request{}).cur_profile, 1);
       }});
}

void Table::add_imu() {
  const auto is_selected = [](Host& host, const Packets&) {
    EXPECT_EQ(host.get<msg::RealtimeData3>(msg::RealtimeData3Request{}).cur_imu,
              msg::SelectedImu::frame);
  };
  add<msg::SelectImu3>({.request = {.imu_type = msg::SelectedImu::frame},
                        .comes = Comes::confirmation,
                        .after = is_selected});
  add<msg::SelectImu3Ext>({.request = {.imu_type = msg::SelectedImu::frame},
                           .comes = Comes::confirmation,
                           .after = is_selected});
  const auto points_up = [](Host&, const Packets& packets) {
    const auto attitude = only<msg::AhrsHelper>(packets);
    EXPECT_NEAR(static_cast<double>(attitude.z1_vector.z), 1, 0.01);
    EXPECT_NEAR(std::hypot(static_cast<double>(attitude.h1_vector.x),
                           static_cast<double>(attitude.h1_vector.y),
                           static_cast<double>(attitude.h1_vector.z)),
                1, 1e-5);
  };
  add<msg::AhrsHelperRequest>({.after = points_up});
  add<msg::AhrsHelperRequestExt>({.after = points_up});
  msg::AhrsHelperRequestExt set;
  set.mode = msg::AhrsHelperModeBit::set;
  set.z1_vector = {0, 0, 1};
  set.h1_vector = {0, 1, 0};
  add<msg::AhrsHelperRequestExt>({.request = set});
  emulator::BoardOptions later;
  later.firmware = msg::FirmwareVersion(2695);
  add<msg::AhrsHelperRequestWide>({.after = points_up, .options = later});
  add<msg::AhrsHelperRequestExtWide>({.after = points_up, .options = later});
  add<msg::AhrsHelperRequestExtWide>({.request = later_form(set), .options = later});
  add<msg::GyroCorrection>({.comes = Comes::confirmation});
}

void Table::add_peripherals() {
  msg::BeepSound beep;
  beep.mode = msg::BeepMode::custom_melody;
  beep.note_length = msg::NoteLength(5);
  beep.note_freq_hz.push_back(msg::NoteFrequency(1000));
  add<msg::BeepSound>({.request = beep, .comes = Comes::confirmation});
  add<msg::TriggerPin>(
      {.request = {.pin_id = msg::OutputPin::pin_aux1, .state = msg::PinState::high},
       .comes = Comes::confirmation});
  msg::ServoOut servos;
  servos.servo_time.fill(msg::ServoPulse(-1));
  servos.servo_time[3] = msg::ServoPulse(1500);
  add<msg::ServoOut>({.request = servos, .comes = Comes::confirmation});
  add<msg::ServoOutFour>(
      {.request = {.servo_time = {msg::ServoPulse(1500)}}, .comes = Comes::confirmation});
  // The first register that can be written and read back.
  msg::I2cDevice imu;
  imu.set_port(msg::I2cPort::main);
  imu.set_address(0x68);
  msg::I2cWriteRegBuf write;
  write.device_addr = imu;
  write.reg_addr = 0x1B;
  write.data.push_back(0x18);
  const auto is_written = [](Host&, const Packets& packets) {
    const auto data = all<msg::I2cReadRegBuf>(packets);
    ASSERT_THAT(data, SizeIs(1));
    EXPECT_THAT(data[0].data, ElementsAre(0x18));
  };
  const msg::I2cReadRegBufRequest read{
      .device_addr = imu, .reg_addr = 0x1B, .data_len = msg::SmallByteCount(1)};
  add<msg::I2cWriteRegBuf>({.request = write, .after = [=](Host& host, const Packets&) {
                              is_written(host, host.ask(read));
                            }});
  add<msg::I2cReadRegBufRequest>(
      {.request = read, .before = [=](Host& host) { host.ask(write); }, .after = is_written});
  msg::ApiVirtChControl channels;
  channels.val_ch.push_back(msg::CentredRcSignal(100));
  add<msg::ApiVirtChControl>({.request = channels});
}

}  // namespace sbgc::test
