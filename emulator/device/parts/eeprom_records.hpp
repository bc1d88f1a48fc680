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

/// What a record holds. The record contains it as well, so a record in a wrong place does not
/// count.
struct RecordId {
  msg::CommandFromBoard command{};
  std::uint8_t copy{};
};

/// Size of a record, for a body of any length. Whole pages, so writing one with CMD_EEPROM_WRITE
/// does not touch the others.
std::size_t record_size();

/// The body; empty if the record is not there or damaged. Precondition: record_size() bytes from
/// `address` on are inside the EEPROM.
std::optional<std::vector<std::uint8_t>> read_record(const Eeprom& eeprom, std::size_t address,
                                                     RecordId id);
/// False, without effect, if the body is longer than any message.
bool write_record(Eeprom& eeprom, std::size_t address, RecordId id,
                  std::span<const std::uint8_t> body);

}  // namespace sbgc::emulator
