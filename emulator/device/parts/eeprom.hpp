/// Bytes of the EEPROM.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <sbgc/emulator/memory.hpp>

namespace sbgc::emulator {

/// The layout of the EEPROM. An assumption: the specification does not give one.
namespace layout {
inline constexpr std::size_t parameters = 0x0000;  ///< records of Parameters
inline constexpr std::size_t files = 0x4000;       ///< FileSystem, up to the end
}  // namespace layout

/// The value of erased bytes.
inline constexpr std::uint8_t erased = 0xFF;

/// A view of Memory::eeprom that counts changes in Memory::revision.
class Eeprom {
 public:
  /// Resizes an EEPROM of another size; new bytes are erased ones.
  explicit Eeprom(Memory& memory);

  /// Size of the units that are read and written (CMD_EEPROM_WRITE).
  static std::size_t page_size();

  std::size_t size() const;
  /// Empty if the range exceeds the end, or `address` or `size` is not a multiple of a page.
  std::optional<std::vector<std::uint8_t>> read_pages(std::uint32_t address,
                                                      std::size_t size) const;
  /// False, without effect, in the same cases.
  bool write_pages(std::uint32_t address, std::span<const std::uint8_t> bytes);

  /// Precondition for all below: inside the EEPROM. The span is valid until the Memory is assigned.
  std::span<const std::uint8_t> bytes(std::size_t address, std::size_t size) const;
  /// Rewriting the same bytes is not a change, unless they are not saved yet.
  void write(std::size_t address, std::span<const std::uint8_t> bytes);
  /// Erases all bytes.
  void erase();

 private:
  bool is_pages(std::uint32_t address, std::size_t size) const;

  Memory& memory_;
};

}  // namespace sbgc::emulator
