// Fuzzes the reader of capture files. It never reads out of bounds, buffers at most one record,
// accounts for every byte of the file, and reports the same items for every chunk size. The first
// byte of the input is the chunk size. The remaining bytes build the file in steps of an opcode and
// its operands, because no mutation finds a valid checksum:
//   0..199:   append as many bytes as the opcode specifies
//   200..209: append a valid session header of the version in the next byte
//   210..249: append a valid record with the kind and time in the next two bytes; the opcode minus
//   210
//             is the size of its data
//   250..254: remove the last bytes; the opcode minus 249 is their number
//   255:      append the remaining bytes

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include <sbgc/detail/crc32.hpp>
#include <sbgc/io/capture.hpp>

namespace {

using Bytes = std::vector<std::uint8_t>;
namespace io = sbgc::io;

void require(bool condition) {
  if (!condition) std::abort();
}

/// A comparable copy of an item.
struct Item {
  std::size_t type;
  std::uint64_t offset;
  std::uint64_t size;  // in the file
  std::int64_t time;
  int detail;
  Bytes bytes;

  bool operator==(const Item&) const = default;
};

Item item_of(const io::CaptureItem& item) {
  if (const auto* const session = std::get_if<io::CaptureSession>(&item)) {
    return {item.index(), session->offset, 24, session->start.time_since_epoch().count(), 0, {}};
  }
  if (const auto* const damage = std::get_if<io::CaptureDamage>(&item)) {
    require(!io::to_string(*damage).empty());
    return {item.index(), damage->offset, damage->size, 0, static_cast<int>(damage->reason), {}};
  }
  const auto& record = std::get<io::CaptureRecord>(item);
  require(record.time.count() >= 0);
  return {item.index(),
          record.offset,
          record.bytes.size() + 16,
          record.time.count(),
          static_cast<int>(record.kind),
          Bytes(record.bytes.begin(), record.bytes.end())};
}

std::vector<Item> read(std::span<const std::uint8_t> file, std::size_t piece) {
  std::vector<Item> result;
  io::CaptureParser parser;
  const auto take = [&] {
    while (const auto item = parser.next()) result.push_back(item_of(*item));
  };
  while (!file.empty()) {
    // On the heap and of exactly this size, so that a sanitizer detects a read out of bounds.
    const auto next = file.first(std::min(piece, file.size()));
    parser.feed(Bytes(next.begin(), next.end()));
    file = file.subspan(next.size());
    take();
  }
  parser.finish();
  take();
  require(!parser.next());
  return result;
}

void append_number(Bytes& out, std::uint64_t value, std::size_t size) {
  for (std::size_t i = 0; i < size; ++i) out.push_back(static_cast<std::uint8_t>(value >> 8 * i));
}

/// Appends `bytes` and their checksum.
void append_sound(Bytes& out, const Bytes& bytes) {
  out.insert(out.end(), bytes.begin(), bytes.end());
  append_number(out, sbgc::detail::crc32(bytes), 4);
}

Bytes make_file(std::span<const std::uint8_t> steps) {
  const auto take = [&steps](std::size_t count) {
    const auto taken = steps.first(std::min(count, steps.size()));
    steps = steps.subspan(taken.size());
    return taken;
  };
  const auto byte = [&]() -> std::uint8_t { return steps.empty() ? 0 : take(1)[0]; };
  Bytes file;
  while (!steps.empty()) {
    const std::uint8_t step = byte();
    if (step < 200 || step == 255) {
      const auto bytes = take(step == 255 ? steps.size() : step);
      file.insert(file.end(), bytes.begin(), bytes.end());
    } else if (step < 210) {
      Bytes header{0x89, 'S', 'B', 'G', 'C', 0x0D, 0x0A, 0x1A, byte()};
      header.resize(20);
      append_sound(file, header);
    } else if (step < 250) {
      Bytes record{0xA5, byte()};
      append_number(record, step - 210U, 2);
      append_number(record, byte(), 8);
      const auto content = take(step - 210U);
      record.insert(record.end(), content.begin(), content.end());
      append_sound(file, record);
    } else {
      file.resize(file.size() - std::min<std::size_t>(file.size(), step - 249U));
    }
  }
  return file;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const Bytes file = make_file(std::span(data, size).subspan(1));
  const std::vector<Item> items = read(file, std::size_t{data[0]} + 1);
  require(items == read(file, std::max<std::size_t>(file.size(), 1)));
  // The items cover the file without a gap.
  std::uint64_t end = 0;
  for (const Item& item : items) {
    require(item.offset == end && item.size > 0);
    end += item.size;
  }
  require(end == file.size());
  return 0;
}
