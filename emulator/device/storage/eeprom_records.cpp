#include "device/storage/eeprom_records.hpp"

#include <sbgc/framing.hpp>
#include <sbgc/internal/crc32.hpp>
#include <sbgc/wire.hpp>

namespace sbgc::emulator {
namespace {

// Assumption: message id, copy, body length, body, CRC-32 of all preceding bytes.
constexpr std::size_t header_size = 3;
constexpr std::size_t checksum_size = sizeof(std::uint32_t);
constexpr std::size_t largest_record = header_size + max_body_size + checksum_size;

static_assert(max_body_size <= 0xFF, "the length is one byte");

}  // namespace

std::size_t record_size() {
  const std::size_t page = Eeprom::page_size();
  return (largest_record + page - 1) / page * page;
}

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
