/// The configuration of an emulated board.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include <sbgc/emulator/board_faults.hpp>
#include <sbgc/emulator/gimbal.hpp>
#include <sbgc/messages/system.hpp>
#include <sbgc/time.hpp>

namespace sbgc::emulator {

/// The model and firmware of the emulated board, and the state in which it starts.
struct BoardOptions {
  msg::BoardVersion board{30};          ///< as on the wire: 30 is 3.0
  msg::FirmwareVersion firmware{2590};  ///< as on the wire: 2590 is 2.59b0
  msg::BoardFeatures features = msg::BoardFeature::three_axis | msg::BoardFeature::bat_monitoring |
                                msg::BoardFeature::encoders | msg::BoardFeature::bode_test |
                                msg::BoardFeature::scripting | msg::BoardFeature::current_sensor;
  /// Features of the firmware; it only reports those that it knows.
  msg::BoardFeaturesExt features_ext =
      msg::BoardFeaturesExtBit::ext_imu | msg::BoardFeaturesExtBit::state_vars;
  msg::BoardFeaturesExt2 features_ext2 =
      msg::BoardFeaturesExt2Bit::plus_ver | msg::BoardFeaturesExt2Bit::ext_motors |
      msg::BoardFeaturesExt2Bit::quat_control | msg::BoardFeaturesExt2Bit::shake_generator;
  Bytes<9> device_id{{0x53, 0x42, 0x47, 0x43, 0, 0, 0, 0, 1}};
  Bytes<12> mcu_id{{'e', 'm', 'u', 'l', 'a', 't', 'e', 'd', 0, 0, 0, 1}};
  bool has_frame_imu = true;  ///< a second IMU, on the frame
  BoardFaults faults{};
  Gimbal::Options gimbal{};
  /// The size of the request queue in bytes; a request that does not fit is lost as a whole. 0
  /// selects one megabyte, more than a host that waits for responses ever fills.
  std::size_t input_buffer = 0;
  /// The size of the output buffer in bytes. Responses wait until they fit; stream samples are
  /// skipped. 0 means unlimited.
  std::size_t output_buffer = 1024;
  /// The time from a restart until the board listens again.
  Duration start_time = milliseconds(500);
  /// The time that the bootloader waits for firmware before it restarts the board.
  Duration bootloader_time = seconds(5);
  /// The recording of frequency responses.
  struct Response {
    double noise = 1;          ///< standard deviation of the output; a stimulus makes 100 or more
    bool is_confirmed = true;  ///< some firmware omits the confirmation of the start
    bool reports_last_index = false;  ///< at the end, instead of the number of samples
  };
  Response response{};
  /// The duration of calibrations, in percent of a real board's.
  unsigned calibration_time = 100;
  /// The password that a host must send first, unless empty; see Board. A request with a new
  /// password replaces it.
  std::string password{};
  /// Reject requests with more bytes than the firmware knows. Real boards ignore the excess.
  bool is_strict = false;
  /// Delay frames that report a change of the memory until Board::memory_saved() is called.
  bool waits_for_saving = false;
};

}  // namespace sbgc::emulator
