#include "device/storage/file_system.hpp"

#include <algorithm>

#include <sbgc/internal/crc32.hpp>
#include <sbgc/internal/find_by.hpp>
#include <sbgc/units.hpp>
#include <sbgc/wire.hpp>

namespace sbgc::emulator {
namespace {

constexpr auto page_size = static_cast<std::size_t>(msg::Pages(1).bytes());

// The table: id, size and CRC-32 of each file, followed by the CRC-32 of the table. An entry
// without a file is erased, including its size.
constexpr std::size_t entry_size = 8;
constexpr std::size_t entries_size = FileSystem::most_files * entry_size;
constexpr std::size_t table_size = entries_size + sizeof(std::uint32_t);
constexpr std::uint16_t no_file = 0xFFFF;

constexpr std::size_t pages(std::size_t bytes) { return (bytes + page_size - 1) / page_size; }

constexpr std::size_t data_begin = layout::files + pages(table_size) * page_size;
constexpr std::size_t data_size = (Memory::eeprom_size - data_begin) / page_size * page_size;

static_assert(data_size < no_file, "a file size never equals the marker of an empty entry");

}  // namespace

FileSystem::FileSystem(Memory& memory) : eeprom_(memory) {}

std::optional<std::vector<FileSystem::File>> FileSystem::load() const {
  const auto table = eeprom_.bytes(layout::files, table_size);
  std::vector<File> files;
  if (std::all_of(table.begin(), table.end(), [](std::uint8_t byte) { return byte == erased; }))
    return files;
  const auto sum = wire::load<std::uint32_t>(table.data() + entries_size);
  if (sum != sbgc::detail::crc32(table.first(entries_size))) return std::nullopt;
  std::size_t at = 0;
  for (std::size_t i = 0; i < most_files; ++i) {
    const std::uint8_t* const entry = table.data() + i * entry_size;
    const auto size = wire::load<std::uint16_t>(entry + 2);
    if (size == no_file) continue;
    File file{wire::load<std::uint16_t>(entry), wire::load<std::uint32_t>(entry + 4), {}};
    // A valid checksum does not prove that a board wrote the table.
    const bool is_there_twice = sbgc::detail::find_by(files, file.id, &File::id) != files.end();
    if (size == 0 || is_there_twice || size > data_size - at) return std::nullopt;
    const auto content = eeprom_.bytes(data_begin + at, size);
    file.content.assign(content.begin(), content.end());
    files.push_back(std::move(file));
    at += pages(size) * page_size;
  }
  return files;
}

void FileSystem::store(const std::vector<File>& files) {
  std::vector<std::uint8_t> table(table_size, erased);
  std::vector<std::uint8_t> data(data_size, erased);
  std::uint8_t* entry = table.data();
  std::size_t at = 0;
  for (const File& file : files) {
    wire::store(entry, file.id);
    wire::store(entry + 2, static_cast<std::uint16_t>(file.content.size()));
    wire::store(entry + 4, file.checksum);
    entry += entry_size;
    std::copy(file.content.begin(), file.content.end(),
              data.begin() + static_cast<std::ptrdiff_t>(at));
    at += pages(file.content.size()) * page_size;
  }
  wire::store(table.data() + entries_size,
              sbgc::detail::crc32(std::span(table).first(entries_size)));
  eeprom_.write(layout::files, table);
  eeprom_.write(data_begin, data);
}

FileSystem::Part FileSystem::read(std::uint16_t file, std::uint16_t page,
                                  std::size_t max_size) const {
  const auto files = load();
  if (!files) return {.error = msg::FileError::fat};
  const auto found = sbgc::detail::find_by(*files, file, &File::id);
  if (found == files->end()) return {.error = msg::FileError::file_not_found};
  const std::span content(found->content);
  if (sbgc::detail::crc32(content) != found->checksum) return {.error = msg::FileError::crc};
  Part part{.file_size = static_cast<std::uint16_t>(content.size())};
  const auto rest = content.subspan(std::min(content.size(), page * page_size));
  const auto data = rest.first(std::min(rest.size(), max_size));
  part.data.assign(data.begin(), data.end());
  return part;
}

msg::FileError FileSystem::write(std::uint16_t file, std::uint16_t size, std::uint16_t page,
                                 std::span<const std::uint8_t> data) {
  auto files = load();
  if (!files) return msg::FileError::fat;
  auto found = sbgc::detail::find_by(*files, file, &File::id);
  const bool is_present = found != files->end();
  if (data.empty()) {
    if (!is_present) return msg::FileError::file_not_found;
    files->erase(found);
    store(*files);
    return msg::FileError::no_error;
  }
  const std::size_t begin = page * page_size;
  if (begin > size || data.size() > size - begin) return msg::FileError::file_size;
  if (!is_present) {
    if (files->size() == most_files) return msg::FileError::fat_is_full;
    found = files->insert(files->end(), File{.id = file, .checksum = sbgc::detail::crc32({})});
  }
  // A new checksum would hide the remaining damaged bytes.
  if (sbgc::detail::crc32(found->content) != found->checksum) return msg::FileError::crc;
  found->content.resize(size);
  std::copy(data.begin(), data.end(), found->content.begin() + static_cast<std::ptrdiff_t>(begin));
  found->checksum = sbgc::detail::crc32(found->content);
  std::size_t taken = 0;
  for (const File& each : *files) taken += pages(each.content.size());
  if (taken * page_size > data_size) return msg::FileError::no_free_space;
  store(*files);
  return msg::FileError::no_error;
}

msg::FileError FileSystem::clear() {
  store({});
  return msg::FileError::no_error;
}

std::uint16_t FileSystem::size(std::uint16_t file) const {
  const Part part = read(file, 0, 0);
  return part.file_size;
}

}  // namespace sbgc::emulator
