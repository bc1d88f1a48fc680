/// Requests that mean the same as another one, which the board executes instead.
#pragma once

#include <algorithm>

#include <sbgc/messages.hpp>

namespace sbgc::emulator {

inline msg::AdjVarsInfoRequest equivalent(const msg::AdjVarsInfoRequestAll&) { return {}; }
inline msg::BoardInfoRequest equivalent(const msg::BoardInfoRequestOneByte&) { return {}; }
/// The configuration is for Bluetooth LE modules between board and host, which are not emulated.
inline msg::BoardInfoRequest equivalent(const msg::BoardInfoRequestExt&) { return {}; }
inline msg::BootMode3Ext equivalent(const msg::BootMode3&) { return {}; }
inline msg::CalibAccExt equivalent(const msg::CalibAcc&) {
  return {.imu_idx = msg::CalibImu::active, .action = msg::CalibAction::regular};
}
inline msg::CalibGyroExt equivalent(const msg::CalibGyro&) {
  return {.imu_idx = msg::CalibImu::active, .action = msg::CalibAction::regular};
}
inline msg::CalibMagExt equivalent(const msg::CalibMag&) {
  return {.imu_idx = msg::CalibImu::main, .action = msg::CalibAction::regular};
}
inline msg::ControlExt equivalent(const msg::Control& request) {
  const msg::ControlMode mode = request.control_mode;
  return {.control_mode = {mode, mode, mode}, .axes = request.axes};
}
inline msg::ExecuteMenuExt equivalent(const msg::ExecuteMenu& request) {
  return {.cmd_id = request.cmd_id};
}
inline msg::HelperDataExt equivalent(const msg::HelperData& request) {
  return {request.frame_acc, request.frame_angle_roll, request.frame_angle_pitch};
}
/// Assumption: the first register, as the emulated chips have no pointer of their own.
inline msg::I2cReadRegBufRequest equivalent(const msg::I2cReadRegBufRequestNoRegister& request) {
  return {.device_addr = request.device_addr, .data_len = request.data_len};
}
/// Assumption: the emulated chips use the lower byte of the address.
inline msg::I2cReadRegBufRequest equivalent(const msg::I2cReadRegBufRequestWideRegister& request) {
  return {request.device_addr, static_cast<std::uint8_t>(request.reg_addr), request.data_len};
}
inline msg::MotorsOffExt equivalent(const msg::MotorsOff&) {
  return {.mode = msg::MotorsOffMode::normal};
}
inline msg::ResetRequestExt equivalent(const msg::ResetRequest&) { return {}; }
/// The other parameters are undocumented.
inline msg::SelectImu3 equivalent(const msg::SelectImu3Ext& request) {
  return {.imu_type = request.imu_type};
}
inline msg::SelectImu3Calibrate equivalent(const msg::SelectImu3CalibrateShort& request) {
  return {.imu_type = request.imu_type, .action = request.action, .time_ms = request.time_ms};
}
inline msg::ServoOut equivalent(const msg::ServoOutFour& request) {
  msg::ServoOut all;
  all.servo_time.fill(msg::ServoPulse(msg::ServoOut::floating));
  std::copy(request.servo_time.begin(), request.servo_time.end(), all.servo_time.begin());
  return all;
}

}  // namespace sbgc::emulator
