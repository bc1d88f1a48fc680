// Checks of calibrations, the attitude and what is connected to the board.

#include <cmath>

#include <gmock/gmock.h>

#include "table.hpp"

namespace sbgc::test {
namespace {

using ::testing::ElementsAre;
using ::testing::SizeIs;

}  // namespace

void Table::add_calibration() {
  add<CalibAcc>({});
  add<CalibGyro>({});
  for (const CalibAction action :
       {CalibAction::regular, CalibAction::reset, CalibAction::temperature,
        CalibAction::enable_temperature, CalibAction::disable_temperature,
        CalibAction::restore_factory, CalibAction::store_in_sensor}) {
    add<CalibAccExt>({.request = {.imu_idx = CalibImu::main, .action = action}});
    add<CalibGyroExt>({.request = {.imu_idx = CalibImu::frame, .action = action}});
  }
  add<CalibMag>({.comes = Comes::confirmation});
  add<CalibExtGain>({});
  add<CalibPoles>({});
  add<CalibOffset>({.comes = Comes::confirmation});
  add<CalibBat>({.request = {.actual_voltage = Voltage(1500)},
                 .comes = Comes::confirmation,
                 .after = [](Host& host, const Packets&) {
                   const auto data = host.get<RealtimeData3>(RealtimeData3Request{});
                   EXPECT_NEAR(data.bat_level.real(), 15.0, 0.1);
                 }});
  add<CalibInfoRequest>({.request = {.imu_type = SelectedImu::main},
                         .before = [](Host& host) { host.ask(CalibGyro{}, milliseconds(500)); },
                         .after =
                             [](Host&, const Packets& packets) {
                               const auto info = all<CalibInfo>(packets);
                               ASSERT_THAT(info, SizeIs(1));
                               EXPECT_GT(info[0].progress.raw(), 0);
                               EXPECT_LT(info[0].progress.raw(), 100);
                             }});
  add<CalibMotorMagLinkRequest>({.comes = Comes::nothing});
  add<EncodersCalibOffset4>({.comes = Comes::confirmation});
  add<EncodersCalibFldOffset4>({.comes = Comes::confirmation});
  add<AutoPidRequest>({.request = {.profile_id = 1, .cfg_flags = AutoPidFlag::roll},
                       .comes = Comes::confirmation,
                       .after = [](Host& host, const Packets&) {
                         EXPECT_EQ(host.get<RealtimeData3>(RealtimeData3Request{}).cur_profile, 1);
                       }});
}

void Table::add_imu() {
  const auto is_selected = [](Host& host, const Packets&) {
    EXPECT_EQ(host.get<RealtimeData3>(RealtimeData3Request{}).cur_imu, SelectedImu::frame);
  };
  add<SelectImu3>({.request = {.imu_type = SelectedImu::frame},
                   .comes = Comes::confirmation,
                   .after = is_selected});
  add<SelectImu3Ext>({.request = {.imu_type = SelectedImu::frame},
                      .comes = Comes::confirmation,
                      .after = is_selected});
  const auto points_up = [](Host&, const Packets& packets) {
    const auto attitude = only<AhrsHelper>(packets);
    EXPECT_NEAR(static_cast<double>(attitude.z1_vector.z), 1, 0.01);
    EXPECT_NEAR(std::hypot(static_cast<double>(attitude.h1_vector.x),
                           static_cast<double>(attitude.h1_vector.y),
                           static_cast<double>(attitude.h1_vector.z)),
                1, 1e-5);
  };
  add<AhrsHelperRequest>({.after = points_up});
  add<AhrsHelperRequestExt>({.after = points_up});
  AhrsHelperRequestExt set;
  set.mode = AhrsHelperModeBit::set;
  set.z1_vector = {0, 0, 1};
  set.h1_vector = {0, 1, 0};
  add<AhrsHelperRequestExt>({.request = set});
  board::Options later;
  later.firmware = FirmwareVersion(2695);
  add<AhrsHelperRequestWide>({.after = points_up, .options = later});
  add<AhrsHelperRequestExtWide>({.after = points_up, .options = later});
  add<AhrsHelperRequestExtWide>({.request = later_form(set), .options = later});
  add<GyroCorrection>({.comes = Comes::confirmation});
}

void Table::add_peripherals() {
  BeepSound beep;
  beep.mode = BeepMode::custom_melody;
  beep.note_length = NoteLength(5);
  beep.note_freq_hz.push_back(NoteFrequency(1000));
  add<BeepSound>({.request = beep, .comes = Comes::confirmation});
  add<TriggerPin>({.request = {.pin_id = OutputPin::pin_aux1, .state = PinState::high},
                   .comes = Comes::confirmation});
  ServoOut servos;
  servos.servo_time.fill(ServoPulse(-1));
  servos.servo_time[3] = ServoPulse(1500);
  add<ServoOut>({.request = servos, .comes = Comes::confirmation});
  // The first register that can be written and read back.
  I2cDevice imu;
  imu.set_port(I2cPort::main);
  imu.set_address(0x68);
  I2cWriteRegBuf write;
  write.device_addr = imu;
  write.reg_addr = 0x1B;
  write.data.push_back(0x18);
  const auto is_written = [](Host&, const Packets& packets) {
    const auto data = all<I2cReadRegBuf>(packets);
    ASSERT_THAT(data, SizeIs(1));
    EXPECT_THAT(data[0].data, ElementsAre(0x18));
  };
  const I2cReadRegBufRequest read{
      .device_addr = imu, .reg_addr = 0x1B, .data_len = SmallByteCount(1)};
  add<I2cWriteRegBuf>({.request = write, .after = [=](Host& host, const Packets&) {
                         is_written(host, host.ask(read));
                       }});
  add<I2cReadRegBufRequest>(
      {.request = read, .before = [=](Host& host) { host.ask(write); }, .after = is_written});
  ApiVirtChControl channels;
  channels.val_ch.push_back(CentredRcSignal(100));
  add<ApiVirtChControl>({.request = channels});
}

}  // namespace sbgc::test
