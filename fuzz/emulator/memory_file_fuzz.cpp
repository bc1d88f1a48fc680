// Fuzzes files that hold the memory of a board. Every text is a memory or an error with a message;
// a memory survives being written and read again, and a board can use it.
//
// The input is the text, with bombs (see hostile_text.hpp). If it starts with the byte 0 or 2, the
// text is instead a valid file, without or with sets of profiles, changed by the remaining bytes,
// each three of which are an offset (2 bytes) and a new byte. This way, mutations reach the
// verification of the checksum. The time is in proportion to the size.

#include "device/parameters/parameters.hpp"
#include "device/storage/file_system.hpp"
#include "hostile_text.hpp"
#include "input.hpp"
#include "serving/memory_file.hpp"

namespace {

using sbgc::emulator::Memory;
using sbgc::fuzz::require;

/// A memory that differs from that of a new board.
Memory memory_with_sets() {
  Memory memory;
  memory.profile_set = 2;
  memory.profile_sets[0].assign(100, 0xA5);
  return memory;
}

std::string text_of(const Memory& memory) {
  return to_json_text(sbgc::serving::SavedMemory{sbgc::serving::owner_of({}), memory});
}

std::string text_of(std::span<const std::uint8_t> input) {
  if (input.empty() || (input.front() != 0 && input.front() != 2)) {
    return sbgc::fuzz::text_with_bombs(input);
  }
  static const std::array written{text_of(Memory{}), text_of(memory_with_sets())};
  std::string text = written[input.front() / 2];
  for (input = input.subspan(1); input.size() >= 3; input = input.subspan(3)) {
    text[(input[0] * 256U + input[1]) % text.size()] = static_cast<char>(input[2]);
  }
  return text;
}

void check(const std::string& text) {
  const auto saved = sbgc::serving::parse_memory(text);
  if (!saved) return require(!saved.error().message.empty());
  const std::string written = to_json_text(*saved);
  auto again = sbgc::serving::parse_memory(written);
  require(static_cast<bool>(again));
  require(again->memory == saved->memory);
  require(again->owner == saved->owner);
  require(to_json_text(*again) == written);
  const sbgc::emulator::Parameters parameters(again->memory);
  const sbgc::emulator::FileSystem files(again->memory);
  require(parameters.profile() == again->memory.profile);
  require(files.read(0, 0, 64).data.size() <= 64);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text = text_of({data, size});
  sbgc::fuzz::require_linear_time(text.size(), std::chrono::microseconds(20), [&] { check(text); });
  return 0;
}
