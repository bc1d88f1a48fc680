/// The EEPROM of the board, and records in it: message bodies with a checksum.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <sbgc/emulator/memory.hpp>
#include <sbgc/enums.hpp>

namespace sbgc::emulator {

/// The layout of the EEPROM. Assumption: the specification does not define one.
namespace layout {
inline constexpr std::size_t parameters = 0x0000;  ///< records of Parameters
inline constexpr std::size_t files = 0x4000;       ///< FileSystem, up to the end
}  // namespace layout

/// The value of erased bytes.
inline constexpr std::uint8_t erased = 0xFF;

/// A view of Memory::eeprom that counts changes in Memory::revision.
class Eeprom {
 public:
  /// Resizes an EEPROM of a different size; new bytes are erased.
  explicit Eeprom(Memory& memory);

  /// The page size for reading and writing (CMD_EEPROM_WRITE).
  static std::size_t page_size();

  std::size_t size() const;
  /// Returns nothing if the range exceeds the EEPROM, or `address` or `size` is not a multiple of
  /// the page size.
  std::optional<std::vector<std::uint8_t>> read_pages(std::uint32_t address,
                                                      std::size_t size) const;
  /// Returns false, without effect, in the same cases.
  bool write_pages(std::uint32_t address, std::span<const std::uint8_t> bytes);

  /// Precondition for the functions below: the range is inside the EEPROM. The span is valid until
  /// the Memory is assigned.
  std::span<const std::uint8_t> bytes(std::size_t address, std::size_t size) const;
  /// Rewriting the same bytes is a change only if they are not saved yet.
  void write(std::size_t address, std::span<const std::uint8_t> bytes);
  /// Erases all bytes.
  void erase();

 private:
  bool is_pages(std::uint32_t address, std::size_t size) const;

  Memory& memory_;
};

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
