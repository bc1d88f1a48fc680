#include "device/storage/eeprom.hpp"

#include <algorithm>

#include <sbgc/internal/meta_limits.hpp>
#include <sbgc/meta/storage.hpp>

namespace sbgc::emulator {
namespace {

constexpr std::size_t page = sbgc::detail::field_info<msg::EepromWrite>("addr").align;

static_assert(sbgc::detail::field_info<msg::EepromRead>("addr").align == page);
static_assert(sbgc::detail::field_info<msg::EepromReadRequest>("addr").align == page);
static_assert(Memory::eeprom_size % page == 0 && layout::files % page == 0);

}  // namespace

Eeprom::Eeprom(Memory& memory) : memory_(memory) {
  if (memory.eeprom.size() != Memory::eeprom_size) {
    memory.eeprom.resize(Memory::eeprom_size, erased);
  }
}

std::size_t Eeprom::page_size() { return page; }

std::size_t Eeprom::size() const { return memory_.eeprom.size(); }

bool Eeprom::is_pages(std::uint32_t address, std::size_t size) const {
  if (address % page != 0 || size % page != 0) return false;
  return size <= this->size() && address <= this->size() - size;
}

std::optional<std::vector<std::uint8_t>> Eeprom::read_pages(std::uint32_t address,
                                                            std::size_t size) const {
  if (!is_pages(address, size)) return std::nullopt;
  const auto found = bytes(address, size);
  return std::vector<std::uint8_t>(found.begin(), found.end());
}

bool Eeprom::write_pages(std::uint32_t address, std::span<const std::uint8_t> bytes) {
  if (!is_pages(address, bytes.size())) return false;
  write(address, bytes);
  return true;
}

std::span<const std::uint8_t> Eeprom::bytes(std::size_t address, std::size_t size) const {
  return std::span<const std::uint8_t>(memory_.eeprom).subspan(address, size);
}

void Eeprom::write(std::size_t address, std::span<const std::uint8_t> bytes) {
  const auto place = std::span(memory_.eeprom).subspan(address, bytes.size());
  if (!memory_.is_unsaved && std::equal(place.begin(), place.end(), bytes.begin())) return;
  std::copy(bytes.begin(), bytes.end(), place.begin());
  ++memory_.revision;
}

void Eeprom::erase() {
  const std::vector<std::uint8_t> empty(size(), erased);
  write(0, empty);
}

}  // namespace sbgc::emulator
