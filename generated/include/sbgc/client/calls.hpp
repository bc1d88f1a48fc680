// Generated from spec/ by generator/: edit those, then run ./dev generate.

/// A function for each request of the protocol.
#pragma once

#include <type_traits>

#include <sbgc/client/call_result.hpp>
#include <sbgc/client/options.hpp>

namespace sbgc {

// Only declared: a program that makes a call must include its message.
namespace msg {
struct BoardInfoRequest;
struct BoardInfoRequestOneByte;
struct BoardInfoRequestExt;
struct BoardInfo3Request;
struct ResetRequest;
struct ResetRequestExt;
struct BootMode3;
struct BootMode3Ext;
struct QueueParamsInfo3Request;
struct SystemStateRequest;
struct MavlinkInfoRequest;
struct MavlinkDebugRequest;
struct ReadParams3Request;
struct WriteParams3;
struct ReadParams;
struct WriteParams;
struct ReadParamsExtRequest;
struct WriteParamsExt;
struct ReadParamsExt2Request;
struct WriteParamsExt2;
struct ReadProfileNamesRequest;
struct WriteProfileNames;
struct SaveParams3;
struct UseDefaults;
struct RealtimeData;
struct RealtimeData3Request;
struct RealtimeData4Request;
struct RealtimeDataCustomRequest;
struct DataStreamInterval;
struct Control;
struct ControlExt;
struct GetAnglesRequest;
struct GetAnglesExtRequest;
struct MotorsOn;
struct MotorsOff;
struct MotorsOffExt;
struct ExecuteMenu;
struct ExecuteMenuExt;
struct HelperData;
struct HelperDataExt;
struct CalibAcc;
struct CalibAccExt;
struct CalibGyro;
struct CalibGyroExt;
struct CalibMag;
struct CalibExtGain;
struct CalibPoles;
struct CalibOffset;
struct CalibBat;
struct CalibInfoRequest;
struct CalibMotorMagLinkRequest;
struct EncodersCalibOffset4;
struct EncodersCalibFldOffset4;
struct AutoPidRequest;
struct SelectImu3;
struct SelectImu3Ext;
struct AhrsHelperRequest;
struct AhrsHelperRequestWide;
struct AhrsHelperRequestExt;
struct AhrsHelperRequestExtWide;
struct GyroCorrection;
struct BeepSound;
struct TriggerPin;
struct ServoOut;
struct I2cWriteRegBuf;
struct I2cReadRegBufRequest;
struct ApiVirtChControl;
struct SetAdjVarsVal;
struct GetAdjVarsVal;
struct ReadAdjVarsCfgRequest;
struct WriteAdjVarsCfg;
struct AdjVarsStateRequest;
struct AdjVarsStateRequestExt;
struct EepromWrite;
struct ReadFileRequest;
struct WriteFile;
struct FsClearAll;
struct EepromReadRequest;
struct ReadExternalDataRequest;
struct WriteExternalData;
struct RunScript;
struct DebugVarsInfo3Request;
struct DebugVars3Request;
}  // namespace msg

/// Adds a function for each request to a client: `client.get_angles()`,
/// `client.read_params_3({.profile_id = profile})`. Each is equivalent to call(request, options),
/// with the same errors.
template <class Self>
class Calls {
 public:
  /// Request the board and firmware version.
  /// Effect: reads.
  template <class M = msg::BoardInfoRequest>
  CallResult<M> board_info(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Request the board and firmware version, with a byte that has no meaning.
  /// Effect: reads.
  template <class M = msg::BoardInfoRequestOneByte>
  CallResult<M> board_info_one_byte(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Request the board and firmware version, and configure this serial port.
  /// Effect: sets.
  template <class M = msg::BoardInfoRequestExt>
  CallResult<M> board_info_ext(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Request serial numbers, memory and scripts of the board.
  /// Effect: reads.
  /// Since board 3.0.
  template <class M = msg::BoardInfo3Request>
  CallResult<M> board_info_3(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Restart immediately, without notification.
  /// Effect: restarts.
  template <class M = msg::ResetRequest>
  CallResult<M> reset(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Restart after a delay, with an optional notification.
  /// Effect: restarts.
  template <class M = msg::ResetRequestExt>
  CallResult<M> reset_ext(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Enter the bootloader immediately, without notification.
  /// Effect: restarts.
  /// Since board 3.0.
  template <class M = msg::BootMode3>
  CallResult<M> boot_mode_3(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Enter the bootloader after a delay, with an optional notification.
  /// Effect: restarts.
  /// Since board 3.0.
  template <class M = msg::BootMode3Ext>
  CallResult<M> boot_mode_3_ext(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Undocumented body to the board.
  /// Effect: unknown.
  /// Since board 3.0.
  template <class M = msg::QueueParamsInfo3Request>
  CallResult<M> queue_params_info_3(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Undocumented body to the board.
  /// Effect: unknown.
  /// Since board 3.0.
  template <class M = msg::SystemStateRequest>
  CallResult<M> system_state(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Undocumented body to the board.
  /// Effect: unknown.
  /// Since board 3.0.
  template <class M = msg::MavlinkInfoRequest>
  CallResult<M> mavlink_info(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Undocumented body to the board.
  /// Effect: unknown.
  /// Since board 3.0.
  template <class M = msg::MavlinkDebugRequest>
  CallResult<M> mavlink_debug(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Request the parameters of one profile.
  /// Effect: reads.
  /// Since board 3.0.
  template <class M = msg::ReadParams3Request>
  CallResult<M> read_params_3(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Store the parameters of one profile and the general parameters.
  /// Effect: stores, moves.
  /// Since board 3.0.
  template <class M = msg::WriteParams3>
  CallResult<M> write_params_3(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Request the parameters of one profile, with the older id.
  /// Effect: reads.
  template <class M = msg::ReadParams>
  CallResult<M> read_params(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Store the parameters of one profile and the general parameters, with the older id.
  /// Effect: stores, moves.
  template <class M = msg::WriteParams>
  CallResult<M> write_params(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Request more parameters of one profile.
  /// Effect: reads.
  /// Since board 3.0.
  template <class M = msg::ReadParamsExtRequest>
  CallResult<M> read_params_ext(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Store more parameters of one profile.
  /// Effect: stores, moves.
  /// Since board 3.0.
  template <class M = msg::WriteParamsExt>
  CallResult<M> write_params_ext(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Request the third set of parameters of one profile.
  /// Effect: reads.
  /// Since board 3.0.
  template <class M = msg::ReadParamsExt2Request>
  CallResult<M> read_params_ext2(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Store the third set of parameters of one profile.
  /// Effect: stores, moves.
  /// Since board 3.0.
  template <class M = msg::WriteParamsExt2>
  CallResult<M> write_params_ext2(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Request the profile names.
  /// Effect: reads.
  /// Since board 3.0.
  template <class M = msg::ReadProfileNamesRequest>
  CallResult<M> read_profile_names(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Store the profile names.
  /// Effect: stores.
  /// Since board 3.0.
  template <class M = msg::WriteProfileNames>
  CallResult<M> write_profile_names(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Save the parameters in use, with all changes to adjustable variables, to the active profile.
  /// Effect: stores.
  /// Since board 3.0.
  template <class M = msg::SaveParams3>
  CallResult<M> save_params_3(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Restore the factory defaults.
  /// Effect: stores, moves, erases.
  template <class M = msg::UseDefaults>
  CallResult<M> use_defaults(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Request live data, with the older id.
  /// Effect: reads.
  template <class M = msg::RealtimeData>
  CallResult<M> realtime_data(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Request live data.
  /// Effect: reads.
  /// Since board 3.0.
  template <class M = msg::RealtimeData3Request>
  CallResult<M> realtime_data_3(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Request the longer live data.
  /// Effect: reads.
  /// Since board 3.0.
  template <class M = msg::RealtimeData4Request>
  CallResult<M> realtime_data_4(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Request live data of the blocks in FLAGS.
  /// Effect: reads.
  /// Since firmware 2.59, board 3.0.
  template <class M = msg::RealtimeDataCustomRequest>
  CallResult<M> realtime_data_custom(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Start, change or end a data stream: messages that the board sends at a fixed rate.
  /// Effect: sets.
  /// Since firmware 2.59, board 3.0.
  template <class M = msg::DataStreamInterval>
  CallResult<M> data_stream_interval(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Move the camera, with one mode for all axes.
  /// Effect: moves.
  template <class M = msg::Control>
  CallResult<M> control(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Move the camera, with a mode for each axis.
  /// Effect: moves.
  /// Since firmware 2.55b5.
  template <class M = msg::ControlExt>
  CallResult<M> control_ext(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Request camera angles and targets.
  /// Effect: reads.
  template <class M = msg::GetAnglesRequest>
  CallResult<M> get_angles(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Request angles, targets and joint angles.
  /// Effect: reads.
  /// Since board 3.0.
  template <class M = msg::GetAnglesExtRequest>
  CallResult<M> get_angles_ext(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Turn the motors on.
  /// Effect: moves.
  template <class M = msg::MotorsOn>
  CallResult<M> motors_on(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Turn the motors off.
  /// Effect: moves.
  /// Firmware 2.68b7 and later accepts MotorsOffExt instead, which is then sent.
  template <class M = msg::MotorsOff>
  CallResult<M> motors_off(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Turn the motors off, in one of several ways.
  /// Effect: moves.
  /// Since firmware 2.68b7.
  template <class M = msg::MotorsOffExt>
  CallResult<M> motors_off_ext(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Execute a menu action.
  /// Effect: sets, stores, moves, restarts.
  template <class M = msg::ExecuteMenu>
  CallResult<M> execute_menu(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Execute a menu action, with a parameter of later firmware.
  /// Effect: sets, stores, moves, restarts.
  template <class M = msg::ExecuteMenuExt>
  CallResult<M> execute_menu_ext(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Report acceleration and tilt of the frame to the board.
  /// Effect: moves.
  template <class M = msg::HelperData>
  CallResult<M> helper_data(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Report acceleration, tilt and rotation of the frame to the board.
  /// Effect: moves.
  /// Since firmware 2.59.
  template <class M = msg::HelperDataExt>
  CallResult<M> helper_data_ext(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Calibrate the accelerometer of the active IMU.
  /// Effect: stores.
  template <class M = msg::CalibAcc>
  CallResult<M> calib_acc(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Calibrate the accelerometer of an IMU, or manage its calibrations.
  /// Effect: stores, restarts, erases.
  template <class M = msg::CalibAccExt>
  CallResult<M> calib_acc_ext(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Calibrate the gyroscope of the active IMU.
  /// Effect: stores.
  template <class M = msg::CalibGyro>
  CallResult<M> calib_gyro(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Calibrate the gyroscope of an IMU, or manage its calibrations.
  /// Effect: stores, restarts, erases.
  template <class M = msg::CalibGyroExt>
  CallResult<M> calib_gyro_ext(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Calibrate the magnetometer.
  /// Effect: stores.
  /// Since board 3.0.
  template <class M = msg::CalibMag>
  CallResult<M> calib_mag(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Calibrate the gains of a flight controller's signals.
  /// Effect: stores, moves.
  template <class M = msg::CalibExtGain>
  CallResult<M> calib_ext_gain(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Detect the poles and the direction of the motors.
  /// Effect: stores, moves.
  template <class M = msg::CalibPoles>
  CallResult<M> calib_poles(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Calibrate the follow mode offset.
  /// Effect: stores, moves.
  template <class M = msg::CalibOffset>
  CallResult<M> calib_offset(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Calibrate the battery voltage measurement.
  /// Effect: stores.
  template <class M = msg::CalibBat>
  CallResult<M> calib_bat(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Request the calibration status.
  /// Effect: reads.
  /// Since board 3.0.
  template <class M = msg::CalibInfoRequest>
  CallResult<M> calib_info(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Undocumented body to the board.
  /// Effect: unknown.
  /// Since board 3.0.
  template <class M = msg::CalibMotorMagLinkRequest>
  CallResult<M> calib_motor_mag_link(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Calibrate the offsets of the encoders.
  /// Effect: stores.
  /// Since board 3.0.
  template <class M = msg::EncodersCalibOffset4>
  CallResult<M> encoders_calib_offset_4(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Calibrate the offsets between encoders and the motors' magnetic fields.
  /// Effect: stores, moves.
  /// Since board 3.0.
  template <class M = msg::EncodersCalibFldOffset4>
  CallResult<M> encoders_calib_fld_offset_4(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Start or stop the automatic tuning.
  /// Effect: stores, moves.
  /// Since board 3.0.
  template <class M = msg::AutoPidRequest>
  CallResult<M> auto_pid(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Select the IMU to configure and calibrate.
  /// Effect: sets.
  /// Since board 3.0.
  template <class M = msg::SelectImu3>
  CallResult<M> select_imu_3(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Select an IMU, with parameters of later firmware.
  /// Effect: sets.
  /// Since board 3.0.
  template <class M = msg::SelectImu3Ext>
  CallResult<M> select_imu_3_ext(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Query the attitude of an IMU.
  /// Effect: reads.
  /// Since board 3.0.
  /// Firmware 2.69b5 and later accepts AhrsHelperRequestWide instead, which is then sent.
  template <class M = msg::AhrsHelperRequest>
  CallResult<M> ahrs_helper(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Query the attitude of an IMU, with a two-byte mode.
  /// Effect: reads.
  /// Since firmware 2.69b5.
  template <class M = msg::AhrsHelperRequestWide>
  CallResult<M> ahrs_helper_wide(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Query or set the attitude of an IMU.
  /// Effect: moves.
  /// Since board 3.0.
  /// Firmware 2.69b5 and later accepts AhrsHelperRequestExtWide instead, which is then sent.
  template <class M = msg::AhrsHelperRequestExt>
  CallResult<M> ahrs_helper_ext(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Query or set the attitude of an IMU, with a two-byte mode.
  /// Effect: moves.
  /// Since firmware 2.69b5.
  template <class M = msg::AhrsHelperRequestExtWide>
  CallResult<M> ahrs_helper_ext_wide(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Correct the zero of a gyroscope manually; the camera drifts if the correction is wrong.
  /// Effect: stores, moves.
  /// Since board 3.0.
  template <class M = msg::GyroCorrection>
  CallResult<M> gyro_correction(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Play a melody through the motors, or a standard sound.
  /// Effect: sets.
  /// Since firmware 2.59, board 3.0.
  template <class M = msg::BeepSound>
  CallResult<M> beep_sound(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Switch an output pin.
  /// Effect: sets.
  template <class M = msg::TriggerPin>
  CallResult<M> trigger_pin(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Send PWM signals to servos.
  /// Effect: moves.
  /// Since board 3.0.
  template <class M = msg::ServoOut>
  CallResult<M> servo_out(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Write to a device on an I2C bus.
  /// Effect: sets, stores.
  /// Since board 3.0.
  template <class M = msg::I2cWriteRegBuf>
  CallResult<M> i2c_write_reg_buf(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Read from a device on an I2C bus.
  /// Effect: reads.
  /// Since board 3.0.
  template <class M = msg::I2cReadRegBufRequest>
  CallResult<M> i2c_read_reg_buf(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Set the host's virtual RC channels, which can control the camera and more.
  /// Effect: sets, stores, moves, restarts.
  /// Since board 3.0.
  template <class M = msg::ApiVirtChControl>
  CallResult<M> api_virt_ch_control(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Set adjustable variables; the next restart discards them unless CMD_SAVE_PARAMS_3 follows.
  /// Effect: sets, moves.
  /// Since board 3.0.
  template <class M = msg::SetAdjVarsVal>
  CallResult<M> set_adj_vars_val(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Request the values of adjustable variables.
  /// Effect: reads.
  /// Since board 3.0.
  template <class M = msg::GetAdjVarsVal>
  CallResult<M> get_adj_vars_val(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Request the RC signals that trigger actions or change adjustable variables.
  /// Effect: reads.
  /// Since board 3.0.
  template <class M = msg::ReadAdjVarsCfgRequest>
  CallResult<M> read_adj_vars_cfg(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Store the RC signals that trigger actions or change adjustable variables.
  /// Effect: stores, moves.
  /// Since board 3.0.
  template <class M = msg::WriteAdjVarsCfg>
  CallResult<M> write_adj_vars_cfg(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Request the state of one trigger slot and one analog slot.
  /// Effect: reads.
  /// Since board 3.0.
  template <class M = msg::AdjVarsStateRequest>
  CallResult<M> adj_vars_state(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Request the state of adjustable variables, in the form of later firmware.
  /// Effect: reads.
  /// Since firmware 2.62b5.
  template <class M = msg::AdjVarsStateRequestExt>
  CallResult<M> adj_vars_state_ext(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Write a block to the EEPROM.
  /// Effect: stores, moves.
  /// Since board 3.0.
  template <class M = msg::EepromWrite>
  CallResult<M> eeprom_write(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Read part of a file.
  /// Effect: reads.
  /// Since board 3.0.
  template <class M = msg::ReadFileRequest>
  CallResult<M> read_file(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Write part of a file; without data, delete it.
  /// Effect: stores, erases.
  /// Since board 3.0.
  template <class M = msg::WriteFile>
  CallResult<M> write_file(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Delete all files.
  /// Effect: erases.
  /// Since board 3.0.
  template <class M = msg::FsClearAll>
  CallResult<M> fs_clear_all(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Read a block of the EEPROM.
  /// Effect: reads.
  /// Since board 3.0.
  template <class M = msg::EepromReadRequest>
  CallResult<M> eeprom_read(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Request the user data in the EEPROM.
  /// Effect: reads.
  /// Since board 3.0.
  template <class M = msg::ReadExternalDataRequest>
  CallResult<M> read_external_data(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Store user data in the EEPROM.
  /// Effect: stores.
  /// Since board 3.0.
  template <class M = msg::WriteExternalData>
  CallResult<M> write_external_data(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Start or stop a script.
  /// Effect: sets, stores, moves, restarts.
  /// Since board 3.0.
  template <class M = msg::RunScript>
  CallResult<M> run_script(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Request the names and types of the debug variables.
  /// Effect: reads.
  /// Since board 3.0.
  template <class M = msg::DebugVarsInfo3Request>
  CallResult<M> debug_vars_info_3(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Request the values of the debug variables.
  /// Effect: reads.
  /// Since board 3.0.
  template <class M = msg::DebugVars3Request>
  CallResult<M> debug_vars_3(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

 protected:
  Calls() = default;

 private:
  Self& self() { return static_cast<Self&>(*this); }
};

}  // namespace sbgc
