/// Bytes of the EEPROM, and records with checksums in it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <sbgc/board/memory.hpp>

namespace sbgc::board {

/// Where things stand. Ours: the specification says nothing of the order.
namespace layout {
inline constexpr std::size_t settings = 0x0000;  ///< records of Settings
inline constexpr std::size_t files = 0x4000;     ///< FileSystem, up to the end
}  // namespace layout

/// A view of Memory::eeprom that counts changes in Memory::revision.
class Eeprom {
 public:
  explicit Eeprom(Memory& memory) : memory_(memory) {}

  std::size_t size() const;
  /// Nothing if it lies (partly) behind the end or `address` or `size` are no multiples of a page.
  std::optional<std::vector<std::uint8_t>> read_pages(std::uint32_t address,
                                                      std::size_t size) const;
  bool write_pages(std::uint32_t address, std::span<const std::uint8_t> bytes);

  /// Precondition for all below: inside the EEPROM.
  std::span<const std::uint8_t> bytes(std::size_t address, std::size_t size) const;
  void write(std::size_t address, std::span<const std::uint8_t> bytes);
  void erase();

 private:
  Memory& memory_;
};

}  // namespace sbgc::board
