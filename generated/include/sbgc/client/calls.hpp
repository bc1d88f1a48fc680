// Generated from spec/ by generator/: edit those, then run ./dev generate.

/// A function for each request of the protocol.
#pragma once

#include <type_traits>

#include <sbgc/client/call_result.hpp>
#include <sbgc/client/options.hpp>

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wdeprecated-declarations"

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
struct ReadStateVarsRequest;
struct WriteStateVars;
struct SignMessageRequest;
struct PassProtectReadRequest;
struct PassProtectWrite;
struct QueueParamsInfo3Request;
struct SystemStateRequest;
struct MavlinkInfoRequest;
struct MavlinkDebugRequest;
struct ExtLicenseInfoRequest;
struct ReadParams3Request;
struct WriteParams3;
struct ReadParams;
struct WriteParams;
struct ReadParamsExtRequest;
struct WriteParamsExt;
struct ReadParamsExt2Request;
struct WriteParamsExt2;
struct WriteParamsSet;
struct ReadProfileNamesRequest;
struct WriteProfileNames;
struct ProfileSet;
struct SaveParams3;
struct UseDefaults;
struct ReadParamsExt3Request;
struct WriteParamsExt3;
struct RealtimeData;
struct RealtimeData3Request;
struct RealtimeData4Request;
struct RealtimeDataCustomRequest;
struct RealtimeDataCustom2Request;
struct DataStreamInterval;
struct CanDrvStateRequest;
struct RealtimeDataCanDrvRequest;
struct Control;
struct ControlExt;
struct ControlExtCommand;
struct ControlConfig;
struct ControlQuatDisabled;
struct ControlQuatSpeed;
struct ControlQuatAttitude;
struct ControlQuatAttitudePacked;
struct ControlQuatSpeedAttitude;
struct ControlQuatSpeedAttitudePacked;
struct ControlQuatStatusRequest;
struct ControlQuatConfig;
struct GetAnglesRequest;
struct GetAnglesExtRequest;
struct MotorsOn;
struct MotorsOff;
struct MotorsOffExt;
struct SyncMotors;
struct ExecuteMenu;
struct ExecuteMenuExt;
struct HelperData;
struct HelperDataExt;
struct ExtMotorsAction;
struct ExtMotorsControl;
struct ExtMotorsControlConfig;
struct ExtMotorsStateRequest;
struct CalibAcc;
struct CalibAccExt;
struct CalibGyro;
struct CalibGyroExt;
struct CalibMag;
struct CalibMagExt;
struct CalibExtGain;
struct CalibPoles;
struct CalibOffset;
struct CalibBat;
struct CalibInfoRequest;
struct CalibMotorMagLinkRequest;
struct EncodersCalibOffset4;
struct EncodersCalibFldOffset4;
struct AutoPidRequest;
struct AutoPid2;
struct CalibOrientCorr;
struct CalibCogging;
struct CalibAccExtRef;
struct BodeTestStartStopRequest;
struct CoggingCalibInfoRequest;
struct CanDrvHardParamsRequest;
struct CanDrvCalibrateRequest;
struct CalibEncoderLutRequest;
struct CalibEncoderLutResRequest;
struct CalibCurSensRequest;
struct EncIntCalibRequest;
struct VibrationTestStartStopRequest;
struct VibrationTestDataRequest;
struct SelectImu3;
struct SelectImu3Ext;
struct SelectImu3CalibrateShort;
struct SelectImu3Calibrate;
struct AhrsHelperRequest;
struct AhrsHelperRequestWide;
struct AhrsHelperRequestExt;
struct AhrsHelperRequestExtWide;
struct GyroCorrection;
struct ExtImuDebugInfoRequest;
struct ExtImuCmd;
struct ExtSensCmdRequest;
struct ImuAdvancedCalibRequest;
struct BeepSound;
struct TriggerPin;
struct ServoOut;
struct ServoOutFour;
struct ServoOutExt;
struct I2cWriteRegBuf;
struct I2cReadRegBufRequest;
struct I2cReadRegBufRequestNoRegister;
struct I2cReadRegBufRequestWideRegister;
struct ApiVirtChControl;
struct ApiVirtChHighRes;
struct ReadRcInputsRequest;
struct ModuleListRequest;
struct CanDeviceScanRequest;
struct TransparentSapiRequest;
struct ModuleFlashStart;
struct ModuleFlashWrite;
struct ModuleFlashFinish;
struct UdrvDeviceScan;
struct SetTranspProxy;
struct UartBypassRequest;
struct SetDeviceAddrRequest;
struct SerialProxyRequest;
struct SetAdjVarsVal;
struct GetAdjVarsVal;
struct ReadAdjVarsCfgRequest;
struct WriteAdjVarsCfg;
struct AdjVarsStateRequest;
struct AdjVarsStateRequestExt;
struct AdjVarsInfoRequest;
struct AdjVarsInfoRequestAll;
struct SetAdjVarsValF;
struct GetAdjVarsValF;
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
struct DebugVars3RequestSelected;
struct SetDebugPortRequest;
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
  /// Effect: restarts, disconnects.
  /// Since board 3.0.
  template <class M = msg::BootMode3>
  CallResult<M> boot_mode_3(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Enter the bootloader after a delay, with an optional notification.
  /// Effect: restarts, disconnects.
  /// Since board 3.0.
  template <class M = msg::BootMode3Ext>
  CallResult<M> boot_mode_3_ext(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Request the statistics of the board's whole life.
  /// Effect: reads.
  /// Since firmware 2.68b7, board 3.6.
  template <class M = msg::ReadStateVarsRequest>
  CallResult<M> read_state_vars(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Store the statistics of the board's whole life.
  /// Effect: stores.
  /// Since firmware 2.68b7, board 3.6.
  template <class M = msg::WriteStateVars>
  CallResult<M> write_state_vars(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Sign a message with the keys of the board.
  /// Effect: reads.
  /// Since firmware 2.50, board 3.0.
  template <class M = msg::SignMessageRequest>
  CallResult<M> sign_message(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Request what a password protects.
  /// Effect: reads.
  /// Since firmware 2.73.6.
  template <class M = msg::PassProtectReadRequest>
  CallResult<M> pass_protect_read(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Choose what a password protects.
  /// Effect: stores.
  /// Since firmware 2.73.6.
  template <class M = msg::PassProtectWrite>
  CallResult<M> pass_protect_write(
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

  /// Undocumented body to the board.
  /// Effect: unknown.
  /// Since firmware 2.60.
  template <class M = msg::ExtLicenseInfoRequest>
  CallResult<M> ext_license_info(
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

  /// Begin or end a series of commands that store parameters.
  /// Effect: sets, moves, restarts.
  /// Since firmware 2.70b4.
  template <class M = msg::WriteParamsSet>
  CallResult<M> write_params_set(
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

  /// Save, clear or load a profile set.
  /// Effect: stores, moves, erases.
  /// Since firmware 2.65.
  template <class M = msg::ProfileSet>
  CallResult<M> profile_set(
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

  /// Request the fourth set of parameters of one profile.
  /// Effect: reads.
  /// Since firmware 2.66.
  template <class M = msg::ReadParamsExt3Request>
  CallResult<M> read_params_ext3(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Store the fourth set of parameters of one profile.
  /// Effect: stores, moves.
  /// Since firmware 2.66.
  template <class M = msg::WriteParamsExt3>
  CallResult<M> write_params_ext3(
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

  /// Request live data of the blocks in FLAGS.
  /// Effect: reads.
  /// Since firmware 2.74.2.
  template <class M = msg::RealtimeDataCustom2Request>
  CallResult<M> realtime_data_custom2(
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

  /// Undocumented body to the board.
  /// Effect: unknown.
  /// Since firmware 2.60.
  template <class M = msg::CanDrvStateRequest>
  CallResult<M> can_drv_state(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Undocumented body to the board.
  /// Effect: unknown.
  /// Since firmware 2.60.
  template <class M = msg::RealtimeDataCanDrvRequest>
  CallResult<M> realtime_data_can_drv(
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

  /// Move the camera, with the data that each axis needs.
  /// Effect: moves.
  /// Since firmware 2.68.
  template <class M = msg::ControlExtCommand>
  CallResult<M> control_ext_command(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Configure serial control until the next start.
  /// Effect: sets, moves.
  /// Since firmware 2.61.
  template <class M = msg::ControlConfig>
  CallResult<M> control_config(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// End control with quaternions.
  /// Effect: moves.
  /// Since firmware 2.73.
  template <class M = msg::ControlQuatDisabled>
  CallResult<M> control_quat_disabled(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Turn the camera at a speed.
  /// Effect: moves.
  /// Since firmware 2.73.
  template <class M = msg::ControlQuatSpeed>
  CallResult<M> control_quat_speed(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Turn the camera to an attitude.
  /// Effect: moves.
  /// Since firmware 2.73.
  template <class M = msg::ControlQuatAttitude>
  CallResult<M> control_quat_attitude(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Turn the camera to an attitude, packed.
  /// Effect: moves.
  /// Since firmware 2.73.
  template <class M = msg::ControlQuatAttitudePacked>
  CallResult<M> control_quat_attitude_packed(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Turn the camera at a speed and hold it to an attitude.
  /// Effect: moves.
  /// Since firmware 2.73.
  template <class M = msg::ControlQuatSpeedAttitude>
  CallResult<M> control_quat_speed_attitude(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Turn the camera at a speed and hold it to an attitude, packed.
  /// Effect: moves.
  /// Since firmware 2.73.
  template <class M = msg::ControlQuatSpeedAttitudePacked>
  CallResult<M> control_quat_speed_attitude_packed(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Request the state of the control with quaternions.
  /// Effect: reads.
  /// Since firmware 2.73.
  template <class M = msg::ControlQuatStatusRequest>
  CallResult<M> control_quat_status(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Configure the control with quaternions.
  /// Effect: sets.
  /// Since firmware 2.73.
  template <class M = msg::ControlQuatConfig>
  CallResult<M> control_quat_config(
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

  /// Power one motor as a synchronous motor for some time, then turn the motors off.
  /// Effect: moves.
  /// Since firmware 2.70b9.
  template <class M = msg::SyncMotors>
  CallResult<M> sync_motors(
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

  /// Execute a menu action and say when to confirm it.
  /// Effect: sets, stores, moves, restarts.
  /// Since firmware 2.73.8.
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

  /// Turn external motors on or off, or move them to their home position.
  /// Effect: moves.
  /// Since firmware 2.73.
  template <class M = msg::ExtMotorsAction>
  CallResult<M> ext_motors_action(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Set targets of external motors.
  /// Effect: moves.
  /// Since firmware 2.73.
  template <class M = msg::ExtMotorsControl>
  CallResult<M> ext_motors_control(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Configure external motors.
  /// Effect: sets.
  /// Since firmware 2.73.
  template <class M = msg::ExtMotorsControlConfig>
  CallResult<M> ext_motors_control_config(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Request the state of external motors.
  /// Effect: reads.
  /// Since firmware 2.73.
  template <class M = msg::ExtMotorsStateRequest>
  CallResult<M> ext_motors_state(
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

  /// Calibrate the magnetometer of an IMU, or manage its calibrations.
  /// Effect: stores, restarts, erases.
  /// Since board 3.0.
  template <class M = msg::CalibMagExt>
  CallResult<M> calib_mag_ext(
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
  /// Firmware 2.73 and later no longer accepts it.
  template <class M = msg::AutoPidRequest>
  CallResult<M> auto_pid(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Tune the PID controllers automatically, in later firmware.
  /// Effect: stores, moves.
  /// Since firmware 2.73.
  template <class M = msg::AutoPid2>
  CallResult<M> auto_pid2(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Calibrate the orientation of the IMU.
  /// Effect: stores, moves.
  /// Since firmware 2.61.
  template <class M = msg::CalibOrientCorr>
  CallResult<M> calib_orient_corr(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Calibrate the cogging of the motors, or delete this calibration.
  /// Effect: stores, moves, erases.
  /// Since firmware 2.60.
  template <class M = msg::CalibCogging>
  CallResult<M> calib_cogging(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Calibrate the accelerometer with an external reference.
  /// Effect: stores.
  /// Since firmware 2.62b7.
  template <class M = msg::CalibAccExtRef>
  CallResult<M> calib_acc_ext_ref(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Start the recording of a frequency response.
  /// Effect: moves.
  /// Since firmware 2.50, board 3.0.
  template <class M = msg::BodeTestStartStopRequest>
  CallResult<M> bode_test_start_stop(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Undocumented body to the board.
  /// Effect: unknown.
  /// Since firmware 2.60.
  template <class M = msg::CoggingCalibInfoRequest>
  CallResult<M> cogging_calib_info(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Undocumented body to the board.
  /// Effect: unknown.
  /// Since firmware 2.60.
  template <class M = msg::CanDrvHardParamsRequest>
  CallResult<M> can_drv_hard_params(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Undocumented body to the board.
  /// Effect: unknown.
  /// Since firmware 2.60.
  template <class M = msg::CanDrvCalibrateRequest>
  CallResult<M> can_drv_calibrate(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Undocumented body to the board.
  /// Effect: unknown.
  /// Since firmware 2.60.
  template <class M = msg::CalibEncoderLutRequest>
  CallResult<M> calib_encoder_lut(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Undocumented body to the board.
  /// Effect: unknown.
  /// Since firmware 2.60.
  template <class M = msg::CalibEncoderLutResRequest>
  CallResult<M> calib_encoder_lut_res(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Undocumented body to the board.
  /// Effect: unknown.
  /// Since firmware 2.60.
  template <class M = msg::CalibCurSensRequest>
  CallResult<M> calib_cur_sens(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Undocumented body to the board.
  /// Effect: unknown.
  /// Since firmware 2.60.
  template <class M = msg::EncIntCalibRequest>
  CallResult<M> enc_int_calib(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Undocumented body to the board.
  /// Effect: unknown.
  /// Since firmware 2.60.
  template <class M = msg::VibrationTestStartStopRequest>
  CallResult<M> vibration_test_start_stop(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Undocumented body to the board.
  /// Effect: unknown.
  /// Since firmware 2.60.
  template <class M = msg::VibrationTestDataRequest>
  CallResult<M> vibration_test_data(
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

  /// Select an IMU, with parameters that no source describes.
  /// Effect: sets.
  /// Since firmware 2.60.
  template <class M = msg::SelectImu3Ext>
  CallResult<M> select_imu_3_ext(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// The same, with one byte less.
  /// Effect: stores, restarts, erases.
  /// Since firmware 2.60.
  template <class M = msg::SelectImu3CalibrateShort>
  CallResult<M> select_imu_3_calibrate_short(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Select an IMU and calibrate it, or manage its calibrations.
  /// Effect: stores, restarts, erases.
  /// Since firmware 2.60.
  template <class M = msg::SelectImu3Calibrate>
  CallResult<M> select_imu_3_calibrate(
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

  /// Request the state of the attitude estimation and of the external IMU.
  /// Effect: reads.
  /// Since firmware 2.66.
  template <class M = msg::ExtImuDebugInfoRequest>
  CallResult<M> ext_imu_debug_info(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Forward a command to the external IMU.
  /// Effect: sets, stores, moves.
  /// Since firmware 2.60.
  template <class M = msg::ExtImuCmd>
  CallResult<M> ext_imu_cmd(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Forward a command to an external sensor.
  /// Effect: sets, stores, moves.
  /// Since firmware 2.68b7, board 3.6.
  template <class M = msg::ExtSensCmdRequest>
  CallResult<M> ext_sens_cmd(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Undocumented body to the board.
  /// Effect: unknown.
  /// Since firmware 2.60.
  template <class M = msg::ImuAdvancedCalibRequest>
  CallResult<M> imu_advanced_calib(
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

  /// Send PWM signals to eight servos.
  /// Effect: moves.
  /// Since board 3.0.
  template <class M = msg::ServoOut>
  CallResult<M> servo_out(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Send PWM signals to the servos 1 to 4.
  /// Effect: moves.
  /// Since board 3.0.
  template <class M = msg::ServoOutFour>
  CallResult<M> servo_out_four(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Send PWM signals to servos of the board and of its CAN motor drivers.
  /// Effect: moves.
  /// Since firmware 2.73.2.
  template <class M = msg::ServoOutExt>
  CallResult<M> servo_out_ext(
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

  /// Read from a device without registers.
  /// Effect: reads.
  /// Since board 3.0.
  template <class M = msg::I2cReadRegBufRequestNoRegister>
  CallResult<M> i2c_read_reg_buf_no_register(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Read from a device with 16-bit register addresses.
  /// Effect: reads.
  /// Since board 3.0.
  template <class M = msg::I2cReadRegBufRequestWideRegister>
  CallResult<M> i2c_read_reg_buf_wide_register(
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

  /// Set the host's virtual RC channels in high resolution; they can control the camera and more.
  /// Effect: sets, stores, moves, restarts.
  /// Since firmware 2.68b7.
  template <class M = msg::ApiVirtChHighRes>
  CallResult<M> api_virt_ch_high_res(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Request the RC signals of selected inputs.
  /// Effect: sets.
  /// Since firmware 2.60.
  template <class M = msg::ReadRcInputsRequest>
  CallResult<M> read_rc_inputs(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Request the list of the modules connected to the board.
  /// Effect: reads.
  /// Since firmware 2.60.
  template <class M = msg::ModuleListRequest>
  CallResult<M> module_list(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Search for devices on the CAN bus.
  /// Effect: reads.
  /// Since firmware 2.60.
  template <class M = msg::CanDeviceScanRequest>
  CallResult<M> can_device_scan(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Send data to a serial port of a device on the CAN bus.
  /// Effect: sets, stores, moves, restarts, erases.
  /// Since firmware 2.72, board 3.6.
  template <class M = msg::TransparentSapiRequest>
  CallResult<M> transparent_sapi(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Begin to load new firmware into a module.
  /// Effect: restarts, erases.
  /// Since firmware 2.74.5.
  template <class M = msg::ModuleFlashStart>
  CallResult<M> module_flash_start(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Load a part of new firmware into a module.
  /// Effect: stores.
  /// Since firmware 2.74.5.
  template <class M = msg::ModuleFlashWrite>
  CallResult<M> module_flash_write(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// End the loading of firmware into a module.
  /// Effect: stores.
  /// Since firmware 2.74.5.
  template <class M = msg::ModuleFlashFinish>
  CallResult<M> module_flash_finish(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Search for uDrv modules and give them ids.
  /// Effect: stores.
  /// Since firmware 2.74.5.
  template <class M = msg::UdrvDeviceScan>
  CallResult<M> udrv_device_scan(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Connect two serial ports of the board.
  /// Effect: sets, disconnects.
  /// Since firmware 2.74.5.
  template <class M = msg::SetTranspProxy>
  CallResult<M> set_transp_proxy(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Undocumented body to the board.
  /// Effect: unknown.
  /// Since firmware 2.50, board 3.0.
  template <class M = msg::UartBypassRequest>
  CallResult<M> uart_bypass(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Undocumented body to the board.
  /// Effect: unknown.
  /// Since firmware 2.60.
  template <class M = msg::SetDeviceAddrRequest>
  CallResult<M> set_device_addr(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Undocumented body to the board.
  /// Effect: unknown.
  /// Since firmware 2.60.
  template <class M = msg::SerialProxyRequest>
  CallResult<M> serial_proxy(
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

  /// Request the state of a trigger slot, two RC signals and two variables.
  /// Effect: reads.
  /// Since firmware 2.62b5.
  template <class M = msg::AdjVarsStateRequestExt>
  CallResult<M> adj_vars_state_ext(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Request names, ranges and values of adjustable variables.
  /// Effect: reads.
  /// Since firmware 2.73.
  template <class M = msg::AdjVarsInfoRequest>
  CallResult<M> adj_vars_info(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Request names, ranges and values of adjustable variables, starting with the first.
  /// Effect: reads.
  /// Since firmware 2.73.
  template <class M = msg::AdjVarsInfoRequestAll>
  CallResult<M> adj_vars_info_all(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Set adjustable variables in floating point; the next restart discards them unless
  /// CMD_SAVE_PARAMS_3 follows.
  /// Effect: sets, moves.
  /// Since firmware 2.73.4.
  template <class M = msg::SetAdjVarsValF>
  CallResult<M> set_adj_vars_val_f(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Request the values of adjustable variables in floating point.
  /// Effect: reads.
  /// Since firmware 2.73.4.
  template <class M = msg::GetAdjVarsValF>
  CallResult<M> get_adj_vars_val_f(
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

  /// Request the values of selected debug variables.
  /// Effect: reads.
  /// Since firmware 2.72.
  template <class M = msg::DebugVars3RequestSelected>
  CallResult<M> debug_vars_3_selected(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Start or stop the copies of the messages on the board's other ports.
  /// Effect: sets.
  /// Since firmware 2.60.
  template <class M = msg::SetDebugPortRequest>
  CallResult<M> set_debug_port(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

 protected:
  Calls() = default;

 private:
  Self& self() { return static_cast<Self&>(*this); }
};

}  // namespace sbgc

#pragma GCC diagnostic pop
