/// Records in the EEPROM: message bodies with a checksum.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <sbgc/enums.hpp>

#include "device/storage/eeprom.hpp"

namespace sbgc::emulator {

/// Identifies the content of a record. It is part of the record, so a record in the wrong place is
/// invalid.
struct RecordId {
  msg::CommandFromBoard command{};
  std::uint8_t copy{};
};

/// The size of a record for a body of any length, in whole pages, so that writing a record with
/// CMD_EEPROM_WRITE does not affect others.
std::size_t record_size();

/// Returns the body; nothing if the record is missing or damaged. Precondition: record_size() bytes
/// from `address` are inside the EEPROM.
std::optional<std::vector<std::uint8_t>> read_record(const Eeprom& eeprom, std::size_t address,
                                                     RecordId id);
/// Returns false, without effect, if the body is longer than any message.
bool write_record(Eeprom& eeprom, std::size_t address, RecordId id,
                  std::span<const std::uint8_t> body);

}  // namespace sbgc::emulator
