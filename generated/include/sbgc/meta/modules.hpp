// Generated from spec/ by generator/: edit those, then run ./dev generate.

/// Run-time metadata of the messages in <sbgc/messages/modules.hpp>.
#pragma once

#include <cstddef>

#include <sbgc/internal/table.hpp>
#include <sbgc/messages/modules.hpp>
#include <sbgc/meta.hpp>
#include <sbgc/meta/enums.hpp>
#include <sbgc/meta/units.hpp>

namespace sbgc {

template <>
struct Meta<msg::ModuleInfo> {
  static constexpr FieldInfo fields[] = {
      {.name = "id", .spec_name = "ID", .summary = "The module."},
      {.name = "board_ver", .spec_name = "BOARD_VER", .summary = "Hardware version."},
      {.name = "bootloader_ver", .spec_name = "BOOTLOADER_VER",
       .summary = "Version of the bootloader."},
      {.name = "firmware_ver", .spec_name = "FIRMWARE_VER", .summary = "Firmware version."},
      {.name = "reserved", .spec_name = "RESERVED", .summary = "Reserved; kept as it is.",
       .reserved = true},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, id), &detail::value_type<decltype(T::id)>},
      {offsetof(T, board_ver), &detail::value_type<decltype(T::board_ver)>},
      {offsetof(T, bootloader_ver), &detail::value_type<decltype(T::bootloader_ver)>},
      {offsetof(T, firmware_ver), &detail::value_type<decltype(T::firmware_ver)>},
      {offsetof(T, reserved), &detail::value_type<decltype(T::reserved)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.id);
    visitor(fields[1], value.board_ver);
    visitor(fields[2], value.bootloader_ver);
    visitor(fields[3], value.firmware_ver);
    visitor(fields[4], value.reserved);
  }
};

template <>
struct Meta<msg::CanDevice> {
  static constexpr FieldInfo fields[] = {
      {.name = "uid", .spec_name = "UID", .summary = "Identifies the device."},
      {.name = "id", .spec_name = "ID", .summary = "Id assigned to the device."},
      {.name = "type", .spec_name = "TYPE", .summary = "Kind of the device."},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, uid), &detail::value_type<decltype(T::uid)>},
      {offsetof(T, id), &detail::value_type<decltype(T::id)>},
      {offsetof(T, type), &detail::value_type<decltype(T::type)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.uid);
    visitor(fields[1], value.id);
    visitor(fields[2], value.type);
  }
};

template <>
struct Meta<msg::ModuleList> {
  static constexpr MessageInfo info{
      .name = "ModuleList", .command = "CMD_MODULE_LIST",
      .summary = "Modules connected to the board.", .id = 76, .direction = Direction::from_board,
      .min_size = 1, .max_size = 222, .since = {.firmware = 2600}};
  static constexpr Range device_num_range{0, 17};
  static constexpr FieldInfo fields[] = {
      {.name = "device_num", .spec_name = "DEVICE_NUM", .summary = "Number of modules that follow.",
       .range = &device_num_range},
      {.name = "modules", .spec_name = "modules", .summary = "The modules."},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, modules), &detail::counter_type<decltype(T::modules)>},
      {offsetof(T, modules), &detail::value_type<decltype(T::modules)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], Counter{value.modules.size()});
    visitor(fields[1], value.modules);
    visitor(tail_field, value.tail);
  }
};

template <>
struct Meta<msg::ModuleListRequest> {
  static constexpr const char* answers[] = {"ModuleList"};
  static constexpr MessageInfo info{
      .name = "ModuleListRequest", .command = "CMD_MODULE_LIST",
      .summary = "Request the list of the modules connected to the board.", .id = 76,
      .direction = Direction::to_board, .min_size = 0, .max_size = 0, .since = {.firmware = 2600},
      .answers = answers, .effects = Effects(Effect::reads)};

  static constexpr void visit(auto&, auto&&) {
  }
};

template <>
struct Meta<msg::CanDeviceScan> {
  static constexpr MessageInfo info{
      .name = "CanDeviceScan", .command = "CMD_CAN_DEVICE_SCAN",
      .summary = "Devices on the CAN bus.", .id = 96, .direction = Direction::from_board,
      .min_size = 0, .max_size = 252, .since = {.firmware = 2600, .features = 0x400}};
  static constexpr FieldInfo fields[] = {
      {.name = "devices", .spec_name = "devices", .summary = "The devices.", .max_count = 18},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, devices), &detail::value_type<decltype(T::devices)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.devices);
  }
};

template <>
struct Meta<msg::CanDeviceScanRequest> {
  static constexpr const char* answers[] = {"CanDeviceScan"};
  static constexpr MessageInfo info{
      .name = "CanDeviceScanRequest", .command = "CMD_CAN_DEVICE_SCAN",
      .summary = "Search for devices on the CAN bus.", .id = 96, .direction = Direction::to_board,
      .min_size = 0, .max_size = 0, .since = {.firmware = 2600, .features = 0x400},
      .answers = answers, .effects = Effects(Effect::reads)};

  static constexpr void visit(auto&, auto&&) {
  }
};

template <>
struct Meta<msg::TransparentSapi> {
  static constexpr MessageInfo info{
      .name = "TransparentSapi", .command = "CMD_TRANSPARENT_SAPI",
      .summary = "Data from a serial port of a device on the CAN bus.", .id = 151,
      .direction = Direction::from_board, .min_size = 1, .max_size = 255,
      .since = {.firmware = 2720, .board = 36}};
  static constexpr FieldInfo fields[] = {
      {.name = "target", .spec_name = "TARGET", .summary = "Device and port that sent the data.",
       .unconfirmed = true},
      {.name = "payload", .spec_name = "PAYLOAD", .summary = "The data."},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, target), &detail::value_type<decltype(T::target)>},
      {offsetof(T, payload), &detail::value_type<decltype(T::payload)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.target);
    visitor(fields[1], value.payload);
  }
};

template <>
struct Meta<msg::TransparentSapiRequest> {
  static constexpr MessageInfo info{
      .name = "TransparentSapiRequest", .command = "CMD_TRANSPARENT_SAPI",
      .summary = "Send data to a serial port of a device on the CAN bus.", .id = 151,
      .direction = Direction::to_board, .min_size = 1, .max_size = 255,
      .since = {.firmware = 2720, .board = 36},
      .effects = Effects(Effect::sets) | Effect::stores | Effect::moves | Effect::restarts | Effect::erases};
  static constexpr FieldInfo fields[] = {
      {.name = "target", .spec_name = "TARGET", .summary = "Device and port that receive the data.",
       .unconfirmed = true},
      {.name = "payload", .spec_name = "PAYLOAD", .summary = "The data."},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, target), &detail::value_type<decltype(T::target)>},
      {offsetof(T, payload), &detail::value_type<decltype(T::payload)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.target);
    visitor(fields[1], value.payload);
  }
};

template <>
struct Meta<msg::ModuleFlashStart> {
  static constexpr MessageInfo info{
      .name = "ModuleFlashStart", .command = "CMD_MODULE_FLASH_START",
      .summary = "Begin to load new firmware into a module.", .id = 78,
      .direction = Direction::to_board, .min_size = 5, .max_size = 5, .since = {.firmware = 2745},
      .effects = Effects(Effect::restarts) | Effect::erases};
  static constexpr Range firmware_size_range{1, 4294967295};
  static constexpr FieldInfo fields[] = {
      {.name = "device_id", .spec_name = "DEVICE_ID", .summary = "The module."},
      {.name = "firmware_size", .spec_name = "FIRMWARE_SIZE", .summary = "Size of the file.",
       .unit = &UnitMeta<msg::WordCount>::info, .range = &firmware_size_range},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, device_id), &detail::value_type<decltype(T::device_id)>},
      {offsetof(T, firmware_size), &detail::value_type<decltype(T::firmware_size)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.device_id);
    visitor(fields[1], value.firmware_size);
  }
};

template <>
struct Meta<msg::ModuleFlashWrite> {
  static constexpr MessageInfo info{
      .name = "ModuleFlashWrite", .command = "CMD_MODULE_FLASH_WRITE",
      .summary = "Load a part of new firmware into a module.", .id = 81,
      .direction = Direction::to_board, .min_size = 14, .max_size = 138, .since = {.firmware = 2745},
      .effects = Effects(Effect::stores)};
  static constexpr FieldInfo fields[] = {
      {.name = "device_id", .spec_name = "DEVICE_ID", .summary = "The module."},
      {.name = "packet_id", .spec_name = "PACKET_ID",
       .summary = "Number of the part from 0, modulo 256."},
      {.name = "address", .spec_name = "ADDRESS", .summary = "Offset of the part in the file.",
       .align = 4},
      {.name = "data_crc32", .spec_name = "DATA_CRC32",
       .summary = "CRC-32/ISO-HDLC of DATA, as in a zip file."},
      {.name = "data", .spec_name = "DATA", .summary = "The part.", .min_count = 4, .max_count = 128,
       .align = 4},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, device_id), &detail::value_type<decltype(T::device_id)>},
      {offsetof(T, packet_id), &detail::value_type<decltype(T::packet_id)>},
      {offsetof(T, address), &detail::value_type<decltype(T::address)>},
      {offsetof(T, data_crc32), &detail::value_type<decltype(T::data_crc32)>},
      {offsetof(T, data), &detail::value_type<decltype(T::data)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.device_id);
    visitor(fields[1], value.packet_id);
    visitor(fields[2], value.address);
    visitor(fields[3], value.data_crc32);
    visitor(fields[4], value.data);
  }
};

template <>
struct Meta<msg::ModuleFlashFinish> {
  static constexpr MessageInfo info{
      .name = "ModuleFlashFinish", .command = "CMD_MODULE_FLASH_FINISH",
      .summary = "End the loading of firmware into a module.", .id = 83,
      .direction = Direction::to_board, .min_size = 5, .max_size = 5, .since = {.firmware = 2745},
      .effects = Effects(Effect::stores)};
  static constexpr FieldInfo fields[] = {
      {.name = "device_id", .spec_name = "DEVICE_ID", .summary = "The module."},
      {.name = "file_crc32", .spec_name = "FILE_CRC32",
       .summary = "CRC-32/ISO-HDLC of the whole file."},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, device_id), &detail::value_type<decltype(T::device_id)>},
      {offsetof(T, file_crc32), &detail::value_type<decltype(T::file_crc32)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.device_id);
    visitor(fields[1], value.file_crc32);
  }
};

template <>
struct Meta<msg::UdrvDeviceScan> {
  static constexpr const char* answers[] = {"CanDeviceScan"};
  static constexpr MessageInfo info{
      .name = "UdrvDeviceScan", .command = "CMD_UDRV_DEVICE_SCAN",
      .summary = "Search for uDrv modules and give them ids.", .id = 144,
      .direction = Direction::to_board, .min_size = 0, .max_size = 0, .since = {.firmware = 2745},
      .answers = answers, .effects = Effects(Effect::stores)};

  static constexpr void visit(auto&, auto&&) {
  }
};

template <>
struct Meta<msg::SetTranspProxy> {
  static constexpr MessageInfo info{
      .name = "SetTranspProxy", .command = "CMD_SET_TRANSP_PROXY",
      .summary = "Connect two serial ports of the board.", .id = 143,
      .direction = Direction::to_board, .min_size = 2, .max_size = 2, .since = {.firmware = 2745},
      .effects = Effects(Effect::sets) | Effect::disconnects};
  static constexpr Special port1_special[] = {
      {0, "the port of this request"},
  };
  static constexpr Special port2_special[] = {
      {0, "the port of this request"},
  };
  static constexpr FieldInfo fields[] = {
      {.name = "port1", .spec_name = "PORT1", .summary = "A port; the first is 1.",
       .special = port1_special},
      {.name = "port2", .spec_name = "PORT2", .summary = "Another port.", .special = port2_special},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, port1), &detail::value_type<decltype(T::port1)>},
      {offsetof(T, port2), &detail::value_type<decltype(T::port2)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.port1);
    visitor(fields[1], value.port2);
  }
};

template <>
struct Meta<msg::UartBypass> {
  static constexpr MessageInfo info{
      .name = "UartBypass", .command = "CMD_UART_BYPASS",
      .summary = "Undocumented body from the board.", .id = 60, .direction = Direction::from_board,
      .min_size = 0, .max_size = 255, .since = {.firmware = 2500, .board = 30}, .unconfirmed = true};
  static constexpr FieldInfo fields[] = {
      {.name = "data", .spec_name = "DATA", .summary = "Undocumented content."},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, data), &detail::value_type<decltype(T::data)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.data);
  }
};

template <>
struct Meta<msg::UartBypassRequest> {
  static constexpr MessageInfo info{
      .name = "UartBypassRequest", .command = "CMD_UART_BYPASS",
      .summary = "Undocumented body to the board.", .id = 60, .direction = Direction::to_board,
      .min_size = 0, .max_size = 255, .since = {.firmware = 2500, .board = 30}, .unconfirmed = true,
      .effects = Effects(Effect::unknown)};
  static constexpr FieldInfo fields[] = {
      {.name = "data", .spec_name = "DATA", .summary = "Undocumented content."},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, data), &detail::value_type<decltype(T::data)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.data);
  }
};

template <>
struct Meta<msg::SetDeviceAddr> {
  static constexpr MessageInfo info{
      .name = "SetDeviceAddr", .command = "CMD_SET_DEVICE_ADDR",
      .summary = "Undocumented body from the board.", .id = 107, .direction = Direction::from_board,
      .min_size = 0, .max_size = 255, .since = {.firmware = 2600}};
  static constexpr FieldInfo fields[] = {
      {.name = "data", .spec_name = "DATA", .summary = "Undocumented content."},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, data), &detail::value_type<decltype(T::data)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.data);
  }
};

template <>
struct Meta<msg::SetDeviceAddrRequest> {
  static constexpr MessageInfo info{
      .name = "SetDeviceAddrRequest", .command = "CMD_SET_DEVICE_ADDR",
      .summary = "Undocumented body to the board.", .id = 107, .direction = Direction::to_board,
      .min_size = 0, .max_size = 255, .since = {.firmware = 2600},
      .effects = Effects(Effect::unknown)};
  static constexpr FieldInfo fields[] = {
      {.name = "data", .spec_name = "DATA", .summary = "Undocumented content."},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, data), &detail::value_type<decltype(T::data)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.data);
  }
};

template <>
struct Meta<msg::SerialProxy> {
  static constexpr MessageInfo info{
      .name = "SerialProxy", .command = "CMD_SERIAL_PROXY",
      .summary = "Undocumented body from the board.", .id = 113, .direction = Direction::from_board,
      .min_size = 0, .max_size = 255, .since = {.firmware = 2600}};
  static constexpr FieldInfo fields[] = {
      {.name = "data", .spec_name = "DATA", .summary = "Undocumented content."},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, data), &detail::value_type<decltype(T::data)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.data);
  }
};

template <>
struct Meta<msg::SerialProxyRequest> {
  static constexpr MessageInfo info{
      .name = "SerialProxyRequest", .command = "CMD_SERIAL_PROXY",
      .summary = "Undocumented body to the board.", .id = 113, .direction = Direction::to_board,
      .min_size = 0, .max_size = 255, .since = {.firmware = 2600},
      .effects = Effects(Effect::unknown)};
  static constexpr FieldInfo fields[] = {
      {.name = "data", .spec_name = "DATA", .summary = "Undocumented content."},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, data), &detail::value_type<decltype(T::data)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.data);
  }
};

}  // namespace sbgc
