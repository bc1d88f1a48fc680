/// Records in the EEPROM: bodies of messages with a checksum.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <sbgc/enums.hpp>

#include "device/parts/eeprom.hpp"

namespace sbgc::emulator {

/// What a record holds. It stands in the record as well, so that one that lies at a wrong place is
/// no record there.
struct RecordId {
  msg::CommandFromBoard command{};
  std::uint8_t copy{};
};

/// Bytes that a record takes, for a body of any size that a message can have. Whole pages, so that
/// writing one with CMD_EEPROM_WRITE leaves the others alone.
std::size_t record_size();

/// The body; nothing if no such record stands there, or a damaged one. Precondition: record_size()
/// bytes from `address` on are inside.
std::optional<std::vector<std::uint8_t>> read_record(const Eeprom& eeprom, std::size_t address,
                                                     RecordId id);
/// False, and nothing is written, if the body has more bytes than a message can have.
bool write_record(Eeprom& eeprom, std::size_t address, RecordId id,
                  std::span<const std::uint8_t> body);

}  // namespace sbgc::emulator
