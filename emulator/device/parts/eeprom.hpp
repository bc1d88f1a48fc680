/// Bytes of the EEPROM.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <sbgc/emulator/memory.hpp>

namespace sbgc::emulator {

/// Where things stand. Ours: the specification says nothing of the order.
namespace layout {
inline constexpr std::size_t parameters = 0x0000;  ///< records of Parameters
inline constexpr std::size_t files = 0x4000;       ///< FileSystem, up to the end
}  // namespace layout

/// What erased bytes are.
inline constexpr std::uint8_t erased = 0xFF;

/// A view of Memory::eeprom that counts changes in Memory::revision.
class Eeprom {
 public:
  /// Gives an EEPROM of another size the right one: new bytes are erased ones.
  explicit Eeprom(Memory& memory);

  /// Bytes that are read and written together (CMD_EEPROM_WRITE).
  static std::size_t page_size();

  std::size_t size() const;
  /// Nothing if it lies (partly) behind the end or `address` or `size` are no multiples of a page.
  std::optional<std::vector<std::uint8_t>> read_pages(std::uint32_t address,
                                                      std::size_t size) const;
  /// False, and nothing is written, in the same cases.
  bool write_pages(std::uint32_t address, std::span<const std::uint8_t> bytes);

  /// Precondition for all below: inside the EEPROM. The span is valid until the Memory is assigned.
  std::span<const std::uint8_t> bytes(std::size_t address, std::size_t size) const;
  /// Bytes that are there already are no change, unless they are not safe yet.
  void write(std::size_t address, std::span<const std::uint8_t> bytes);
  /// All bytes become erased ones.
  void erase();

 private:
  bool is_pages(std::uint32_t address, std::size_t size) const;

  Memory& memory_;
};

}  // namespace sbgc::emulator
