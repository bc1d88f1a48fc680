
#include "device/storage/eeprom.hpp"

#include <algorithm>

#include <sbgc/framing.hpp>
#include <sbgc/internal/crc32.hpp>
#include <sbgc/internal/meta_limits.hpp>
#include <sbgc/meta/storage.hpp>
#include <sbgc/wire.hpp>

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

namespace {

// Assumption: message id, copy, body length, body, CRC-32 of all preceding bytes.
constexpr std::size_t header_size = 3;
constexpr std::size_t checksum_size = sizeof(std::uint32_t);
constexpr std::size_t largest_record = header_size + max_body_size + checksum_size;

static_assert(max_body_size <= 0xFF, "the length is one byte");

}  // namespace

std::size_t record_size() { return (largest_record + page - 1) / page * page; }

std::optional<std::vector<std::uint8_t>> read_record(const Eeprom& eeprom, std::size_t address,
                                                     RecordId id) {
  const auto bytes = eeprom.bytes(address, largest_record);
  if (bytes[0] != static_cast<std::uint8_t>(id.command) || bytes[1] != id.copy) return {};
  const std::size_t size = bytes[2];
  const auto sum = wire::load<std::uint32_t>(bytes.data() + header_size + size);
  if (sum != sbgc::detail::crc32(bytes.first(header_size + size))) return {};
  const auto body = bytes.subspan(header_size, size);
  return std::vector<std::uint8_t>(body.begin(), body.end());
}

bool write_record(Eeprom& eeprom, std::size_t address, RecordId id,
                  std::span<const std::uint8_t> body) {
  if (body.size() > max_body_size) return false;
  std::vector<std::uint8_t> record{static_cast<std::uint8_t>(id.command), id.copy,
                                   static_cast<std::uint8_t>(body.size())};
  record.insert(record.end(), body.begin(), body.end());
  const std::uint32_t sum = sbgc::detail::crc32(record);
  record.resize(record.size() + checksum_size);
  wire::store(record.data() + record.size() - checksum_size, sum);
  eeprom.write(address, record);
  return true;
}

}  // namespace sbgc::emulator
