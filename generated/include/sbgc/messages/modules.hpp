// Generated from spec/ by generator/: edit those, then run ./dev generate.

/// Modules on the board's CAN bus, and connections through the board.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include <sbgc/codec.hpp>
#include <sbgc/internal/compiler.hpp>
#include <sbgc/enums.hpp>
#include <sbgc/response.hpp>
#include <sbgc/units.hpp>

namespace sbgc::msg {

static_assert(codec_version == 3, "generated code and runtime do not match");

struct CanDeviceScan;
struct ModuleList;

/// The modules.
struct ModuleInfo {
  /// The module.
  ModuleId id{};
  /// Hardware version.
  ModuleVersion board_ver{};
  /// Version of the bootloader.
  ModuleVersion bootloader_ver{};
  /// Firmware version.
  ModuleVersion firmware_ver{};
  /// Reserved; kept as it is.
  Bytes<6> reserved{};

  bool operator==(const ModuleInfo&) const = default;
  using FixedMembers = Members<&ModuleInfo::id, &ModuleInfo::board_ver, &ModuleInfo::bootloader_ver,
      &ModuleInfo::firmware_ver, &ModuleInfo::reserved>;
};

/// The devices.
struct CanDevice {
  /// Identifies the device.
  Bytes<12> uid{};
  /// Id assigned to the device.
  CanDeviceId id{};
  /// Kind of the device.
  CanDeviceType type{};

  bool operator==(const CanDevice&) const = default;
  using FixedMembers = Members<&CanDevice::uid, &CanDevice::id, &CanDevice::type>;
};

/// Modules connected to the board.
///
/// CMD_MODULE_LIST (76), from the board; 1 to 222 bytes, and later firmware may append more. Since
/// firmware 2.60. Source: Later firmware.
struct ModuleList {
  static constexpr CommandFromBoard command = CommandFromBoard::module_list;
  static constexpr Direction direction = Direction::from_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 1;
  static constexpr std::size_t max_size = 222;
  static constexpr Availability since{.firmware = 2600};

  /// The modules.
  BoundedArray<ModuleInfo, 19> modules{};
  /// Bytes appended by later firmware; preserved and written back.
  BoundedBytes<254> tail{};

  bool operator==(const ModuleList&) const = default;
  SBGC_ALWAYS_INLINE
  static constexpr void varying_members(auto& self, auto& cursor) noexcept {
    std::uint8_t device_num_count = 0;
    cursor.count(device_num_count, self.modules, "device_num");
    cursor.counted(self.modules, device_num_count, "modules");
  }
};

/// Request the list of the modules connected to the board.
///
/// CMD_MODULE_LIST (76), to the board; 0 bytes. Effect: reads. Since firmware 2.60. Source: Later
/// firmware.
struct ModuleListRequest {
  static constexpr CommandToBoard command = CommandToBoard::module_list;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 0;
  static constexpr std::size_t max_size = 0;
  static constexpr Availability since{.firmware = 2600};
  using Response = ModuleList;

  bool operator==(const ModuleListRequest&) const = default;
};

/// Devices on the CAN bus.
///
/// CMD_CAN_DEVICE_SCAN (96), from the board; 0 to 252 bytes. Since firmware 2.60. Source: Later
/// firmware.
struct CanDeviceScan {
  static constexpr CommandFromBoard command = CommandFromBoard::can_device_scan;
  static constexpr Direction direction = Direction::from_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 0;
  static constexpr std::size_t max_size = 252;
  static constexpr Availability since{.firmware = 2600, .features = 0x400};

  /// The devices. At most 18.
  BoundedArray<CanDevice, 18> devices{};

  bool operator==(const CanDeviceScan&) const = default;
  SBGC_ALWAYS_INLINE
  static constexpr void varying_members(auto& self, auto& cursor) noexcept {
    cursor.rest(self.devices, "devices");
  }
};

/// Search for devices on the CAN bus. Without devices the answer is empty.
///
/// CMD_CAN_DEVICE_SCAN (96), to the board; 0 bytes. Effect: reads. Since firmware 2.60. Source:
/// Later firmware.
struct CanDeviceScanRequest {
  static constexpr CommandToBoard command = CommandToBoard::can_device_scan;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 0;
  static constexpr std::size_t max_size = 0;
  static constexpr Availability since{.firmware = 2600, .features = 0x400};
  using Response = CanDeviceScan;

  bool operator==(const CanDeviceScanRequest&) const = default;
};

/// Data from a serial port of a device on the CAN bus.
///
/// CMD_TRANSPARENT_SAPI (151), from the board; 1 to 255 bytes. Since firmware 2.72, board 3.6.
/// Source: Later firmware.
struct TransparentSapi {
  static constexpr CommandFromBoard command = CommandFromBoard::transparent_sapi;
  static constexpr Direction direction = Direction::from_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 1;
  static constexpr std::size_t max_size = 255;
  static constexpr Availability since{.firmware = 2720, .board = 36};

  /// Device and port that sent the data. Unconfirmed.
  TransparentTarget target{};
  /// The data.
  BoundedBytes<254> payload{};

  bool operator==(const TransparentSapi&) const = default;
  using FixedMembers = Members<&TransparentSapi::target>;
  SBGC_ALWAYS_INLINE
  static constexpr void varying_members(auto& self, auto& cursor) noexcept {
    cursor.rest(self.payload, "payload");
  }
};

/// Send data to a serial port of a device on the CAN bus. The effect is that of the data. The
/// device's own data come at any time.
///
/// CMD_TRANSPARENT_SAPI (151), to the board; 1 to 255 bytes. Effect: sets, stores, moves, restarts,
/// erases. Since firmware 2.72, board 3.6. Source: Later firmware.
struct TransparentSapiRequest {
  static constexpr CommandToBoard command = CommandToBoard::transparent_sapi;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 1;
  static constexpr std::size_t max_size = 255;
  static constexpr Availability since{.firmware = 2720, .board = 36};
  using Response = void;

  /// Device and port that receive the data. Unconfirmed.
  TransparentTarget target{};
  /// The data.
  BoundedBytes<254> payload{};

  bool operator==(const TransparentSapiRequest&) const = default;
  using FixedMembers = Members<&TransparentSapiRequest::target>;
  SBGC_ALWAYS_INLINE
  static constexpr void varying_members(auto& self, auto& cursor) noexcept {
    cursor.rest(self.payload, "payload");
  }
};

/// Begin to load new firmware into a module. It is the module that restarts, to take its firmware;
/// what it drives has no power meanwhile. CMD_MODULE_FLASH_WRITE and CMD_MODULE_FLASH_FINISH
/// follow. Errors of the three commands carry the module and the packet, two u16, in ERROR_DATA.
///
/// CMD_MODULE_FLASH_START (78), to the board; 5 bytes. Effect: restarts, erases. Since firmware
/// 2.74.5. Source: Vendor's code of 2026.
struct ModuleFlashStart {
  static constexpr CommandToBoard command = CommandToBoard::module_flash_start;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 5;
  static constexpr std::size_t max_size = 5;
  static constexpr Availability since{.firmware = 2745};
  using Response = void;

  /// The module.
  ModuleId device_id{};
  /// Size of the file. Range: 4 to 1.71799e+10 byte.
  WordCount firmware_size{};

  bool operator==(const ModuleFlashStart&) const = default;
  using FixedMembers = Members<&ModuleFlashStart::device_id, &ModuleFlashStart::firmware_size>;
};

/// Load a part of new firmware into a module. A host waits for the confirmation before the next
/// part, and never repeats a part.
///
/// CMD_MODULE_FLASH_WRITE (81), to the board; 14 to 138 bytes. Effect: stores. Since firmware
/// 2.74.5. Source: Vendor's code of 2026.
struct ModuleFlashWrite {
  static constexpr CommandToBoard command = CommandToBoard::module_flash_write;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 14;
  static constexpr std::size_t max_size = 138;
  static constexpr Availability since{.firmware = 2745};
  using Response = void;

  /// The module.
  ModuleId device_id{};
  /// Number of the part from 0, modulo 256.
  std::uint8_t packet_id{};
  /// Offset of the part in the file. A multiple of 4.
  std::uint32_t address{};
  /// CRC-32/ISO-HDLC of DATA, as in a zip file.
  std::uint32_t data_crc32{};
  /// The part. At least 4. At most 128. A multiple of 4.
  BoundedBytes<245> data{};

  bool operator==(const ModuleFlashWrite&) const = default;
  using FixedMembers = Members<&ModuleFlashWrite::device_id, &ModuleFlashWrite::packet_id,
      &ModuleFlashWrite::address, &ModuleFlashWrite::data_crc32>;
  SBGC_ALWAYS_INLINE
  static constexpr void varying_members(auto& self, auto& cursor) noexcept {
    cursor.rest(self.data, "data", 4);
  }
};

/// End the loading of firmware into a module.
///
/// CMD_MODULE_FLASH_FINISH (83), to the board; 5 bytes. Effect: stores. Since firmware 2.74.5.
/// Source: Vendor's code of 2026.
struct ModuleFlashFinish {
  static constexpr CommandToBoard command = CommandToBoard::module_flash_finish;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 5;
  static constexpr std::size_t max_size = 5;
  static constexpr Availability since{.firmware = 2745};
  using Response = void;

  /// The module.
  ModuleId device_id{};
  /// CRC-32/ISO-HDLC of the whole file.
  std::uint32_t file_crc32{};

  bool operator==(const ModuleFlashFinish&) const = default;
  using FixedMembers = Members<&ModuleFlashFinish::device_id, &ModuleFlashFinish::file_crc32>;
};

/// Search for uDrv modules and give them ids. The board detects the connection of the IMU and
/// stores the ids that it assigns.
///
/// CMD_UDRV_DEVICE_SCAN (144), to the board; 0 bytes. Effect: stores. Since firmware 2.74.5.
/// Source: Vendor's code of 2026.
struct UdrvDeviceScan {
  static constexpr CommandToBoard command = CommandToBoard::udrv_device_scan;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 0;
  static constexpr std::size_t max_size = 0;
  static constexpr Availability since{.firmware = 2745};
  using Response = CanDeviceScan;

  bool operator==(const UdrvDeviceScan&) const = default;
};

/// Connect two serial ports of the board. Afterwards each port passes its bytes to the other one
/// and no longer speaks this protocol. No source says how to end that. There is no response; an
/// error is possible. The ports must differ, and be enabled for this protocol.
///
/// CMD_SET_TRANSP_PROXY (143), to the board; 2 bytes. Effect: sets, disconnects. Since firmware
/// 2.74.5. Source: Vendor's code of 2026.
struct SetTranspProxy {
  static constexpr CommandToBoard command = CommandToBoard::set_transp_proxy;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 2;
  static constexpr std::size_t max_size = 2;
  static constexpr Availability since{.firmware = 2745};
  using Response = void;

  /// For port1 and port2: the port of this request.
  static constexpr std::uint8_t this_port{0};

  /// A port; the first is 1.
  std::uint8_t port1{};
  /// Another port.
  std::uint8_t port2{};

  bool operator==(const SetTranspProxy&) const = default;
  using FixedMembers = Members<&SetTranspProxy::port1, &SetTranspProxy::port2>;
};

/// Undocumented body from the board.
///
/// CMD_UART_BYPASS (60), from the board; 0 to 255 bytes. Since firmware 2.50, board 3.0.
/// Unconfirmed. Source: Later firmware.
struct UartBypass {
  static constexpr CommandFromBoard command = CommandFromBoard::uart_bypass;
  static constexpr Direction direction = Direction::from_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 0;
  static constexpr std::size_t max_size = 255;
  static constexpr Availability since{.firmware = 2500, .board = 30};

  /// Undocumented content.
  BoundedBytes<255> data{};

  bool operator==(const UartBypass&) const = default;
  SBGC_ALWAYS_INLINE
  static constexpr void varying_members(auto& self, auto& cursor) noexcept {
    cursor.rest(self.data, "data");
  }
};

/// Undocumented body to the board.
///
/// CMD_UART_BYPASS (60), to the board; 0 to 255 bytes. Effect: unknown. Since firmware 2.50, board
/// 3.0. Unconfirmed. Source: Later firmware.
struct UartBypassRequest {
  static constexpr CommandToBoard command = CommandToBoard::uart_bypass;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 0;
  static constexpr std::size_t max_size = 255;
  static constexpr Availability since{.firmware = 2500, .board = 30};
  using Response = void;

  /// Undocumented content.
  BoundedBytes<255> data{};

  bool operator==(const UartBypassRequest&) const = default;
  SBGC_ALWAYS_INLINE
  static constexpr void varying_members(auto& self, auto& cursor) noexcept {
    cursor.rest(self.data, "data");
  }
};

/// Undocumented body from the board.
///
/// CMD_SET_DEVICE_ADDR (107), from the board; 0 to 255 bytes. Since firmware 2.60. Source: Later
/// firmware.
struct SetDeviceAddr {
  static constexpr CommandFromBoard command = CommandFromBoard::set_device_addr;
  static constexpr Direction direction = Direction::from_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 0;
  static constexpr std::size_t max_size = 255;
  static constexpr Availability since{.firmware = 2600};

  /// Undocumented content.
  BoundedBytes<255> data{};

  bool operator==(const SetDeviceAddr&) const = default;
  SBGC_ALWAYS_INLINE
  static constexpr void varying_members(auto& self, auto& cursor) noexcept {
    cursor.rest(self.data, "data");
  }
};

/// Undocumented body to the board.
///
/// CMD_SET_DEVICE_ADDR (107), to the board; 0 to 255 bytes. Effect: unknown. Since firmware 2.60.
/// Source: Later firmware.
struct SetDeviceAddrRequest {
  static constexpr CommandToBoard command = CommandToBoard::set_device_addr;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 0;
  static constexpr std::size_t max_size = 255;
  static constexpr Availability since{.firmware = 2600};
  using Response = void;

  /// Undocumented content.
  BoundedBytes<255> data{};

  bool operator==(const SetDeviceAddrRequest&) const = default;
  SBGC_ALWAYS_INLINE
  static constexpr void varying_members(auto& self, auto& cursor) noexcept {
    cursor.rest(self.data, "data");
  }
};

/// Undocumented body from the board.
///
/// CMD_SERIAL_PROXY (113), from the board; 0 to 255 bytes. Since firmware 2.60. Source: Later
/// firmware.
struct SerialProxy {
  static constexpr CommandFromBoard command = CommandFromBoard::serial_proxy;
  static constexpr Direction direction = Direction::from_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 0;
  static constexpr std::size_t max_size = 255;
  static constexpr Availability since{.firmware = 2600};

  /// Undocumented content.
  BoundedBytes<255> data{};

  bool operator==(const SerialProxy&) const = default;
  SBGC_ALWAYS_INLINE
  static constexpr void varying_members(auto& self, auto& cursor) noexcept {
    cursor.rest(self.data, "data");
  }
};

/// Undocumented body to the board.
///
/// CMD_SERIAL_PROXY (113), to the board; 0 to 255 bytes. Effect: unknown. Since firmware 2.60.
/// Source: Later firmware.
struct SerialProxyRequest {
  static constexpr CommandToBoard command = CommandToBoard::serial_proxy;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 0;
  static constexpr std::size_t max_size = 255;
  static constexpr Availability since{.firmware = 2600};
  using Response = void;

  /// Undocumented content.
  BoundedBytes<255> data{};

  bool operator==(const SerialProxyRequest&) const = default;
  SBGC_ALWAYS_INLINE
  static constexpr void varying_members(auto& self, auto& cursor) noexcept {
    cursor.rest(self.data, "data");
  }
};

}  // namespace sbgc::msg
