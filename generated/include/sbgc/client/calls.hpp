// Generated from spec/ by generator/: edit those, then run ./dev generate.

/// A function for each request of the protocol.
#pragma once

#include <optional>
#include <type_traits>
#include <utility>
#include <variant>

#include <sbgc/client/options.hpp>
#include <sbgc/client/result.hpp>

namespace sbgc {

// Declared only: who makes a call includes its message.
namespace msg {
struct BoardInfo;
struct BoardInfoRequest;
struct BoardInfoRequestOneByte;
struct BoardInfoRequestExt;
struct Confirm;
struct Error;
struct ErrorExt;
struct BoardInfo3;
struct BoardInfo3Request;
struct Reset;
struct ResetRequest;
struct ResetRequestExt;
struct BootMode3;
struct BootMode3Ext;
struct QueueParamsInfo3;
struct QueueParamsInfo3Request;
struct SystemState;
struct SystemStateRequest;
struct MavlinkInfo;
struct MavlinkInfoRequest;
struct MavlinkDebug;
struct MavlinkDebugRequest;
struct ReadParams3;
struct ReadParams3Request;
struct ReadParams;
struct ReadParamsExt;
struct ReadParamsExtRequest;
struct ReadParamsExt2;
struct ReadParamsExt2Request;
struct ReadProfileNames;
struct ReadProfileNamesRequest;
struct SaveParams3;
struct UseDefaults;
struct WriteParams3;
struct WriteParams;
struct WriteParamsExt;
struct WriteParamsExt2;
struct WriteProfileNames;
struct RealtimeData;
struct RealtimeData3;
struct RealtimeData3Request;
struct RealtimeData4;
struct RealtimeData4Request;
struct RealtimeDataCustom;
struct RealtimeDataCustomRequest;
struct DataStreamInterval;
struct Control;
struct ControlExt;
struct GetAngles;
struct GetAnglesRequest;
struct GetAnglesExt;
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
struct CalibInfo;
struct CalibInfoRequest;
struct CalibMotorMagLink;
struct CalibMotorMagLinkRequest;
struct EncodersCalibOffset4;
struct EncodersCalibFldOffset4;
struct AutoPid;
struct AutoPidRequest;
struct SelectImu3;
struct SelectImu3Ext;
struct AhrsHelper;
struct AhrsHelperRequest;
struct AhrsHelperRequestWide;
struct AhrsHelperRequestExt;
struct AhrsHelperRequestExtWide;
struct GyroCorrection;
struct BeepSound;
struct TriggerPin;
struct ServoOut;
struct I2cWriteRegBuf;
struct I2cReadRegBuf;
struct I2cReadRegBufRequest;
struct ApiVirtChControl;
struct SetAdjVarsVal;
struct GetAdjVarsVal;
struct ReadAdjVarsCfg;
struct ReadAdjVarsCfgRequest;
struct AdjVarsState;
struct AdjVarsStateRequest;
struct AdjVarsStateRequestExt;
struct WriteAdjVarsCfg;
struct EepromWrite;
struct ReadFile;
struct ReadFileError;
struct ReadFileRequest;
struct WriteFile;
struct FsClearAll;
struct EepromRead;
struct EepromReadRequest;
struct ReadExternalData;
struct ReadExternalDataRequest;
struct WriteExternalData;
struct RunScript;
struct ScriptDebug;
struct DebugVarsInfo3;
struct DebugVarsInfo3Request;
struct DebugVars3;
struct DebugVars3Request;
}  // namespace msg

namespace detail {

/// What a call with the request M delivers.
template <class M>
struct CallAnswerOf;
template <>
struct CallAnswerOf<msg::BoardInfoRequest> {
  using type = msg::BoardInfo;
};
template <>
struct CallAnswerOf<msg::BoardInfoRequestOneByte> {
  using type = msg::BoardInfo;
};
template <>
struct CallAnswerOf<msg::BoardInfoRequestExt> {
  using type = msg::BoardInfo;
};
template <>
struct CallAnswerOf<msg::BoardInfo3Request> {
  using type = msg::BoardInfo3;
};
template <>
struct CallAnswerOf<msg::ResetRequest> {
  using type = void;
};
template <>
struct CallAnswerOf<msg::ResetRequestExt> {
  using type = std::optional<msg::Reset>;
};
template <>
struct CallAnswerOf<msg::BootMode3> {
  using type = void;
};
template <>
struct CallAnswerOf<msg::BootMode3Ext> {
  using type = std::optional<msg::Reset>;
};
template <>
struct CallAnswerOf<msg::QueueParamsInfo3Request> {
  using type = void;
};
template <>
struct CallAnswerOf<msg::SystemStateRequest> {
  using type = void;
};
template <>
struct CallAnswerOf<msg::MavlinkInfoRequest> {
  using type = void;
};
template <>
struct CallAnswerOf<msg::MavlinkDebugRequest> {
  using type = void;
};
template <>
struct CallAnswerOf<msg::ReadParams3Request> {
  using type = msg::ReadParams3;
};
template <>
struct CallAnswerOf<msg::WriteParams3> {
  using type = void;
};
template <>
struct CallAnswerOf<msg::ReadParams> {
  using type = msg::ReadParams3;
};
template <>
struct CallAnswerOf<msg::WriteParams> {
  using type = void;
};
template <>
struct CallAnswerOf<msg::ReadParamsExtRequest> {
  using type = msg::ReadParamsExt;
};
template <>
struct CallAnswerOf<msg::WriteParamsExt> {
  using type = void;
};
template <>
struct CallAnswerOf<msg::ReadParamsExt2Request> {
  using type = msg::ReadParamsExt2;
};
template <>
struct CallAnswerOf<msg::WriteParamsExt2> {
  using type = void;
};
template <>
struct CallAnswerOf<msg::ReadProfileNamesRequest> {
  using type = msg::ReadProfileNames;
};
template <>
struct CallAnswerOf<msg::WriteProfileNames> {
  using type = void;
};
template <>
struct CallAnswerOf<msg::SaveParams3> {
  using type = void;
};
template <>
struct CallAnswerOf<msg::UseDefaults> {
  using type = void;
};
template <>
struct CallAnswerOf<msg::RealtimeData> {
  using type = msg::RealtimeData3;
};
template <>
struct CallAnswerOf<msg::RealtimeData3Request> {
  using type = msg::RealtimeData3;
};
template <>
struct CallAnswerOf<msg::RealtimeData4Request> {
  using type = msg::RealtimeData4;
};
template <>
struct CallAnswerOf<msg::RealtimeDataCustomRequest> {
  using type = msg::RealtimeDataCustom;
};
template <>
struct CallAnswerOf<msg::DataStreamInterval> {
  using type = void;
};
template <>
struct CallAnswerOf<msg::Control> {
  using type = void;
};
template <>
struct CallAnswerOf<msg::ControlExt> {
  using type = void;
};
template <>
struct CallAnswerOf<msg::GetAnglesRequest> {
  using type = msg::GetAngles;
};
template <>
struct CallAnswerOf<msg::GetAnglesExtRequest> {
  using type = msg::GetAnglesExt;
};
template <>
struct CallAnswerOf<msg::MotorsOn> {
  using type = void;
};
template <>
struct CallAnswerOf<msg::MotorsOff> {
  using type = void;
};
template <>
struct CallAnswerOf<msg::MotorsOffExt> {
  using type = void;
};
template <>
struct CallAnswerOf<msg::ExecuteMenu> {
  using type = void;
};
template <>
struct CallAnswerOf<msg::ExecuteMenuExt> {
  using type = void;
};
template <>
struct CallAnswerOf<msg::HelperData> {
  using type = void;
};
template <>
struct CallAnswerOf<msg::HelperDataExt> {
  using type = void;
};
template <>
struct CallAnswerOf<msg::CalibAcc> {
  using type = void;
};
template <>
struct CallAnswerOf<msg::CalibAccExt> {
  using type = void;
};
template <>
struct CallAnswerOf<msg::CalibGyro> {
  using type = void;
};
template <>
struct CallAnswerOf<msg::CalibGyroExt> {
  using type = void;
};
template <>
struct CallAnswerOf<msg::CalibMag> {
  using type = void;
};
template <>
struct CallAnswerOf<msg::CalibExtGain> {
  using type = void;
};
template <>
struct CallAnswerOf<msg::CalibPoles> {
  using type = void;
};
template <>
struct CallAnswerOf<msg::CalibOffset> {
  using type = void;
};
template <>
struct CallAnswerOf<msg::CalibBat> {
  using type = void;
};
template <>
struct CallAnswerOf<msg::CalibInfoRequest> {
  using type = msg::CalibInfo;
};
template <>
struct CallAnswerOf<msg::CalibMotorMagLinkRequest> {
  using type = void;
};
template <>
struct CallAnswerOf<msg::EncodersCalibOffset4> {
  using type = void;
};
template <>
struct CallAnswerOf<msg::EncodersCalibFldOffset4> {
  using type = void;
};
template <>
struct CallAnswerOf<msg::AutoPidRequest> {
  using type = void;
};
template <>
struct CallAnswerOf<msg::SelectImu3> {
  using type = void;
};
template <>
struct CallAnswerOf<msg::SelectImu3Ext> {
  using type = void;
};
template <>
struct CallAnswerOf<msg::AhrsHelperRequest> {
  using type = msg::AhrsHelper;
};
template <>
struct CallAnswerOf<msg::AhrsHelperRequestWide> {
  using type = msg::AhrsHelper;
};
template <>
struct CallAnswerOf<msg::AhrsHelperRequestExt> {
  using type = std::optional<msg::AhrsHelper>;
};
template <>
struct CallAnswerOf<msg::AhrsHelperRequestExtWide> {
  using type = std::optional<msg::AhrsHelper>;
};
template <>
struct CallAnswerOf<msg::GyroCorrection> {
  using type = void;
};
template <>
struct CallAnswerOf<msg::BeepSound> {
  using type = void;
};
template <>
struct CallAnswerOf<msg::TriggerPin> {
  using type = void;
};
template <>
struct CallAnswerOf<msg::ServoOut> {
  using type = void;
};
template <>
struct CallAnswerOf<msg::I2cWriteRegBuf> {
  using type = void;
};
template <>
struct CallAnswerOf<msg::I2cReadRegBufRequest> {
  using type = msg::I2cReadRegBuf;
};
template <>
struct CallAnswerOf<msg::ApiVirtChControl> {
  using type = void;
};
template <>
struct CallAnswerOf<msg::SetAdjVarsVal> {
  using type = void;
};
template <>
struct CallAnswerOf<msg::GetAdjVarsVal> {
  using type = msg::SetAdjVarsVal;
};
template <>
struct CallAnswerOf<msg::ReadAdjVarsCfgRequest> {
  using type = msg::ReadAdjVarsCfg;
};
template <>
struct CallAnswerOf<msg::WriteAdjVarsCfg> {
  using type = void;
};
template <>
struct CallAnswerOf<msg::AdjVarsStateRequest> {
  using type = msg::AdjVarsState;
};
template <>
struct CallAnswerOf<msg::AdjVarsStateRequestExt> {
  using type = msg::AdjVarsState;
};
template <>
struct CallAnswerOf<msg::EepromWrite> {
  using type = void;
};
template <>
struct CallAnswerOf<msg::ReadFileRequest> {
  using type = msg::ReadFile;
};
template <>
struct CallAnswerOf<msg::WriteFile> {
  using type = void;
};
template <>
struct CallAnswerOf<msg::FsClearAll> {
  using type = void;
};
template <>
struct CallAnswerOf<msg::EepromReadRequest> {
  using type = msg::EepromRead;
};
template <>
struct CallAnswerOf<msg::ReadExternalDataRequest> {
  using type = msg::ReadExternalData;
};
template <>
struct CallAnswerOf<msg::WriteExternalData> {
  using type = void;
};
template <>
struct CallAnswerOf<msg::RunScript> {
  using type = void;
};
template <>
struct CallAnswerOf<msg::DebugVarsInfo3Request> {
  using type = msg::DebugVarsInfo3;
};
template <>
struct CallAnswerOf<msg::DebugVars3Request> {
  using type = msg::DebugVars3;
};

template <class M>
using CallAnswer = typename CallAnswerOf<M>::type;

}  // namespace detail

/// Gives a client a function for each request: `client.get_angles()`,
/// `client.read_params_3({.profile_id = profile})`. They do what its call(request, options) does;
/// the errors are the same, too.
template <class Self>
class Calls {
 public:
  /// Ask for the version of board and firmware.
  /// Effect: reads.
  template <class M = msg::BoardInfoRequest>
  Result<detail::CallAnswer<M>> board_info(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Ask for the version of board and firmware, with a byte that means nothing.
  /// Effect: reads.
  template <class M = msg::BoardInfoRequestOneByte>
  Result<detail::CallAnswer<M>> board_info_one_byte(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Ask for the version of board and firmware, and configure this serial port.
  /// Effect: sets.
  template <class M = msg::BoardInfoRequestExt>
  Result<detail::CallAnswer<M>> board_info_ext(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Ask for serial numbers, memory and scripts of the board.
  /// Effect: reads.
  /// Since board 3.0.
  template <class M = msg::BoardInfo3Request>
  Result<detail::CallAnswer<M>> board_info_3(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Restart at once and without notice.
  /// Effect: restarts.
  template <class M = msg::ResetRequest>
  Result<detail::CallAnswer<M>> reset(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Restart after a while, with notice if that is asked for.
  /// Effect: restarts.
  template <class M = msg::ResetRequestExt>
  Result<detail::CallAnswer<M>> reset_ext(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Enter the bootloader at once and without notice.
  /// Effect: restarts.
  /// Since board 3.0.
  template <class M = msg::BootMode3>
  Result<detail::CallAnswer<M>> boot_mode_3(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Enter the bootloader after a while, with notice if that is asked for.
  /// Effect: restarts.
  /// Since board 3.0.
  template <class M = msg::BootMode3Ext>
  Result<detail::CallAnswer<M>> boot_mode_3_ext(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Body to the board, not documented.
  /// Effect: unknown.
  /// Since board 3.0.
  template <class M = msg::QueueParamsInfo3Request>
  Result<detail::CallAnswer<M>> queue_params_info_3(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Body to the board, not documented.
  /// Effect: unknown.
  /// Since board 3.0.
  template <class M = msg::SystemStateRequest>
  Result<detail::CallAnswer<M>> system_state(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Body to the board, not documented.
  /// Effect: unknown.
  /// Since board 3.0.
  template <class M = msg::MavlinkInfoRequest>
  Result<detail::CallAnswer<M>> mavlink_info(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Body to the board, not documented.
  /// Effect: unknown.
  /// Since board 3.0.
  template <class M = msg::MavlinkDebugRequest>
  Result<detail::CallAnswer<M>> mavlink_debug(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Ask for the settings of one profile.
  /// Effect: reads.
  /// Since board 3.0.
  template <class M = msg::ReadParams3Request>
  Result<detail::CallAnswer<M>> read_params_3(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Store the settings of one profile and the general ones.
  /// Effect: stores, moves.
  /// Since board 3.0.
  template <class M = msg::WriteParams3>
  Result<detail::CallAnswer<M>> write_params_3(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Ask for the settings of one profile, with the older id.
  /// Effect: reads.
  template <class M = msg::ReadParams>
  Result<detail::CallAnswer<M>> read_params(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Store the settings of one profile and the general ones, with the older id.
  /// Effect: stores, moves.
  template <class M = msg::WriteParams>
  Result<detail::CallAnswer<M>> write_params(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Ask for further settings of one profile.
  /// Effect: reads.
  /// Since board 3.0.
  template <class M = msg::ReadParamsExtRequest>
  Result<detail::CallAnswer<M>> read_params_ext(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Store further settings of one profile.
  /// Effect: stores, moves.
  /// Since board 3.0.
  template <class M = msg::WriteParamsExt>
  Result<detail::CallAnswer<M>> write_params_ext(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Ask for still further settings of one profile.
  /// Effect: reads.
  /// Since board 3.0.
  template <class M = msg::ReadParamsExt2Request>
  Result<detail::CallAnswer<M>> read_params_ext2(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Store still further settings of one profile.
  /// Effect: stores, moves.
  /// Since board 3.0.
  template <class M = msg::WriteParamsExt2>
  Result<detail::CallAnswer<M>> write_params_ext2(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Ask for the names of the profiles.
  /// Effect: reads.
  /// Since board 3.0.
  template <class M = msg::ReadProfileNamesRequest>
  Result<detail::CallAnswer<M>> read_profile_names(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Store the names of the profiles.
  /// Effect: stores.
  /// Since board 3.0.
  template <class M = msg::WriteProfileNames>
  Result<detail::CallAnswer<M>> write_profile_names(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Save the settings that are in use, with all changes to adjustable variables, to the active
  /// profile.
  /// Effect: stores.
  /// Since board 3.0.
  template <class M = msg::SaveParams3>
  Result<detail::CallAnswer<M>> save_params_3(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Return to the factory settings.
  /// Effect: stores, moves, erases.
  template <class M = msg::UseDefaults>
  Result<detail::CallAnswer<M>> use_defaults(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Ask for live data, with the older id.
  /// Effect: reads.
  template <class M = msg::RealtimeData>
  Result<detail::CallAnswer<M>> realtime_data(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Ask for live data.
  /// Effect: reads.
  /// Since board 3.0.
  template <class M = msg::RealtimeData3Request>
  Result<detail::CallAnswer<M>> realtime_data_3(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Ask for the longer live data.
  /// Effect: reads.
  /// Since board 3.0.
  template <class M = msg::RealtimeData4Request>
  Result<detail::CallAnswer<M>> realtime_data_4(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Ask for live data of the blocks that FLAGS names.
  /// Effect: reads.
  /// Since firmware 2.59, board 3.0.
  template <class M = msg::RealtimeDataCustomRequest>
  Result<detail::CallAnswer<M>> realtime_data_custom(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Start, change or end a data stream: messages that the board sends at a fixed rate, unasked.
  /// Effect: sets.
  /// Since firmware 2.59, board 3.0.
  template <class M = msg::DataStreamInterval>
  Result<detail::CallAnswer<M>> data_stream_interval(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Move the camera, one mode for all axes.
  /// Effect: moves.
  template <class M = msg::Control>
  Result<detail::CallAnswer<M>> control(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Move the camera, with a mode for each axis.
  /// Effect: moves.
  /// Since firmware 2.55b5.
  template <class M = msg::ControlExt>
  Result<detail::CallAnswer<M>> control_ext(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Ask for the angles and targets of the camera.
  /// Effect: reads.
  template <class M = msg::GetAnglesRequest>
  Result<detail::CallAnswer<M>> get_angles(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Ask for angles, targets and joint angles.
  /// Effect: reads.
  /// Since board 3.0.
  template <class M = msg::GetAnglesExtRequest>
  Result<detail::CallAnswer<M>> get_angles_ext(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Turn the motors on.
  /// Effect: moves.
  template <class M = msg::MotorsOn>
  Result<detail::CallAnswer<M>> motors_on(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Turn the motors off.
  /// Effect: moves.
  /// Firmware 2.68b7 and later takes MotorsOffExt instead, which is then sent.
  template <class M = msg::MotorsOff>
  Result<detail::CallAnswer<M>> motors_off(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Turn the motors off, in one of several ways.
  /// Effect: moves.
  /// Since firmware 2.68b7.
  template <class M = msg::MotorsOffExt>
  Result<detail::CallAnswer<M>> motors_off_ext(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Carry out an action of the menu.
  /// Effect: sets, stores, moves, restarts.
  template <class M = msg::ExecuteMenu>
  Result<detail::CallAnswer<M>> execute_menu(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Carry out an action of the menu, with a parameter that later firmware takes.
  /// Effect: sets, stores, moves, restarts.
  template <class M = msg::ExecuteMenuExt>
  Result<detail::CallAnswer<M>> execute_menu_ext(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Tell the board how the frame accelerates and leans.
  /// Effect: moves.
  template <class M = msg::HelperData>
  Result<detail::CallAnswer<M>> helper_data(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Tell the board how the frame accelerates, leans and turns.
  /// Effect: moves.
  /// Since firmware 2.59.
  template <class M = msg::HelperDataExt>
  Result<detail::CallAnswer<M>> helper_data_ext(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Calibrate the accelerometer of the active IMU.
  /// Effect: stores.
  template <class M = msg::CalibAcc>
  Result<detail::CallAnswer<M>> calib_acc(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Calibrate the accelerometer of an IMU, or manage its calibrations.
  /// Effect: stores, restarts, erases.
  template <class M = msg::CalibAccExt>
  Result<detail::CallAnswer<M>> calib_acc_ext(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Calibrate the gyroscope of the active IMU.
  /// Effect: stores.
  template <class M = msg::CalibGyro>
  Result<detail::CallAnswer<M>> calib_gyro(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Calibrate the gyroscope of an IMU, or manage its calibrations.
  /// Effect: stores, restarts, erases.
  template <class M = msg::CalibGyroExt>
  Result<detail::CallAnswer<M>> calib_gyro_ext(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Calibrate the magnetometer.
  /// Effect: stores.
  /// Since board 3.0.
  template <class M = msg::CalibMag>
  Result<detail::CallAnswer<M>> calib_mag(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Calibrate the gains of the signals from a flight controller.
  /// Effect: stores, moves.
  template <class M = msg::CalibExtGain>
  Result<detail::CallAnswer<M>> calib_ext_gain(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Find out poles and direction of the motors.
  /// Effect: stores, moves.
  template <class M = msg::CalibPoles>
  Result<detail::CallAnswer<M>> calib_poles(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Calibrate the offset of the follow mode.
  /// Effect: stores, moves.
  template <class M = msg::CalibOffset>
  Result<detail::CallAnswer<M>> calib_offset(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Calibrate the measurement of the battery voltage.
  /// Effect: stores.
  template <class M = msg::CalibBat>
  Result<detail::CallAnswer<M>> calib_bat(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Ask for what to show while sensors are calibrated.
  /// Effect: reads.
  /// Since board 3.0.
  template <class M = msg::CalibInfoRequest>
  Result<detail::CallAnswer<M>> calib_info(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Body to the board, not documented.
  /// Effect: unknown.
  /// Since board 3.0.
  template <class M = msg::CalibMotorMagLinkRequest>
  Result<detail::CallAnswer<M>> calib_motor_mag_link(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Calibrate the offsets of the encoders.
  /// Effect: stores.
  /// Since board 3.0.
  template <class M = msg::EncodersCalibOffset4>
  Result<detail::CallAnswer<M>> encoders_calib_offset_4(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Calibrate the offsets between encoders and the motors' magnetic fields.
  /// Effect: stores, moves.
  /// Since board 3.0.
  template <class M = msg::EncodersCalibFldOffset4>
  Result<detail::CallAnswer<M>> encoders_calib_fld_offset_4(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Start or stop the automatic tuning.
  /// Effect: stores, moves.
  /// Since board 3.0.
  template <class M = msg::AutoPidRequest>
  Result<detail::CallAnswer<M>> auto_pid(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Choose the IMU that is configured and calibrated.
  /// Effect: sets.
  /// Since board 3.0.
  template <class M = msg::SelectImu3>
  Result<detail::CallAnswer<M>> select_imu_3(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Choose an IMU, with parameters that later firmware takes.
  /// Effect: sets.
  /// Since board 3.0.
  template <class M = msg::SelectImu3Ext>
  Result<detail::CallAnswer<M>> select_imu_3_ext(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Ask for the attitude of an IMU.
  /// Effect: reads.
  /// Since board 3.0.
  /// Firmware 2.69b5 and later takes AhrsHelperRequestWide instead, which is then sent.
  template <class M = msg::AhrsHelperRequest>
  Result<detail::CallAnswer<M>> ahrs_helper(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Ask for the attitude of an IMU, with a mode of two bytes.
  /// Effect: reads.
  /// Since firmware 2.69b5.
  template <class M = msg::AhrsHelperRequestWide>
  Result<detail::CallAnswer<M>> ahrs_helper_wide(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Ask for the attitude of an IMU or set it.
  /// Effect: moves.
  /// Since board 3.0.
  /// Firmware 2.69b5 and later takes AhrsHelperRequestExtWide instead, which is then sent.
  template <class M = msg::AhrsHelperRequestExt>
  Result<detail::CallAnswer<M>> ahrs_helper_ext(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Ask for the attitude of an IMU or set it, with a mode of two bytes.
  /// Effect: moves.
  /// Since firmware 2.69b5.
  template <class M = msg::AhrsHelperRequestExtWide>
  Result<detail::CallAnswer<M>> ahrs_helper_ext_wide(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Correct the zero of a gyroscope by hand; the camera drifts if the correction is wrong.
  /// Effect: stores, moves.
  /// Since board 3.0.
  template <class M = msg::GyroCorrection>
  Result<detail::CallAnswer<M>> gyro_correction(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Play a melody through the motors, or one of the standard sounds.
  /// Effect: sets.
  /// Since firmware 2.59, board 3.0.
  template <class M = msg::BeepSound>
  Result<detail::CallAnswer<M>> beep_sound(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Switch an output pin.
  /// Effect: sets.
  template <class M = msg::TriggerPin>
  Result<detail::CallAnswer<M>> trigger_pin(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Send PWM signals to servos.
  /// Effect: moves.
  /// Since board 3.0.
  template <class M = msg::ServoOut>
  Result<detail::CallAnswer<M>> servo_out(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Write to a device on an I2C bus.
  /// Effect: sets, stores.
  /// Since board 3.0.
  template <class M = msg::I2cWriteRegBuf>
  Result<detail::CallAnswer<M>> i2c_write_reg_buf(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Read from a device on an I2C bus.
  /// Effect: reads.
  /// Since board 3.0.
  template <class M = msg::I2cReadRegBufRequest>
  Result<detail::CallAnswer<M>> i2c_read_reg_buf(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Set the virtual RC channels that the host provides; they can control the camera and more.
  /// Effect: sets, stores, moves, restarts.
  /// Since board 3.0.
  template <class M = msg::ApiVirtChControl>
  Result<detail::CallAnswer<M>> api_virt_ch_control(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Set adjustable variables; they are lost at the next start unless CMD_SAVE_PARAMS_3 follows.
  /// Effect: sets, moves.
  /// Since board 3.0.
  template <class M = msg::SetAdjVarsVal>
  Result<detail::CallAnswer<M>> set_adj_vars_val(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Ask for the values of adjustable variables.
  /// Effect: reads.
  /// Since board 3.0.
  template <class M = msg::GetAdjVarsVal>
  Result<detail::CallAnswer<M>> get_adj_vars_val(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Ask which RC signals start actions and which ones change adjustable variables.
  /// Effect: reads.
  /// Since board 3.0.
  template <class M = msg::ReadAdjVarsCfgRequest>
  Result<detail::CallAnswer<M>> read_adj_vars_cfg(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Store which RC signals start actions and which ones change adjustable variables.
  /// Effect: stores, moves.
  /// Since board 3.0.
  template <class M = msg::WriteAdjVarsCfg>
  Result<detail::CallAnswer<M>> write_adj_vars_cfg(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Ask what one trigger slot and one analog slot do.
  /// Effect: reads.
  /// Since board 3.0.
  template <class M = msg::AdjVarsStateRequest>
  Result<detail::CallAnswer<M>> adj_vars_state(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Ask for the state of adjustable variables, as later firmware does it.
  /// Effect: reads.
  /// Since firmware 2.62b5.
  template <class M = msg::AdjVarsStateRequestExt>
  Result<detail::CallAnswer<M>> adj_vars_state_ext(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Write a block to the EEPROM.
  /// Effect: stores, moves.
  /// Since board 3.0.
  template <class M = msg::EepromWrite>
  Result<detail::CallAnswer<M>> eeprom_write(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Read part of a file.
  /// Effect: reads.
  /// Since board 3.0.
  template <class M = msg::ReadFileRequest>
  Result<detail::CallAnswer<M>> read_file(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Write part of a file; without data the file is deleted.
  /// Effect: stores, erases.
  /// Since board 3.0.
  template <class M = msg::WriteFile>
  Result<detail::CallAnswer<M>> write_file(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Delete all files.
  /// Effect: erases.
  /// Since board 3.0.
  template <class M = msg::FsClearAll>
  Result<detail::CallAnswer<M>> fs_clear_all(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Read a block of the EEPROM.
  /// Effect: reads.
  /// Since board 3.0.
  template <class M = msg::EepromReadRequest>
  Result<detail::CallAnswer<M>> eeprom_read(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Ask for the data of the user in the EEPROM.
  /// Effect: reads.
  /// Since board 3.0.
  template <class M = msg::ReadExternalDataRequest>
  Result<detail::CallAnswer<M>> read_external_data(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Store data of the user in the EEPROM.
  /// Effect: stores.
  /// Since board 3.0.
  template <class M = msg::WriteExternalData>
  Result<detail::CallAnswer<M>> write_external_data(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Start or stop a script.
  /// Effect: sets, stores, moves, restarts.
  /// Since board 3.0.
  template <class M = msg::RunScript>
  Result<detail::CallAnswer<M>> run_script(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Ask for names and types of the debug variables.
  /// Effect: reads.
  /// Since board 3.0.
  template <class M = msg::DebugVarsInfo3Request>
  Result<detail::CallAnswer<M>> debug_vars_info_3(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

  /// Ask for the values of the debug variables.
  /// Effect: reads.
  /// Since board 3.0.
  template <class M = msg::DebugVars3Request>
  Result<detail::CallAnswer<M>> debug_vars_3(
      const std::type_identity_t<M>& request = {}, const CallOptions& options = {}) {
    return self().call(request, options);
  }

 protected:
  Calls() = default;

 private:
  Self& self() { return static_cast<Self&>(*this); }
};

}  // namespace sbgc
