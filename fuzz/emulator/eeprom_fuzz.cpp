// Fuzzes a board whose EEPROM has any contents: parameters and files load and work. The input is a
// sequence of steps: bytes written to any address of the EEPROM, with or without valid checksums,
// and operations.
//
// Invariants: parameters that were written are read back, also after a restart; a failing operation
// on files changes nothing, and a successful one has its effect.

#include <memory>

#include <sbgc/internal/crc32.hpp>
#include <sbgc/meta/variables.hpp>
#include <sbgc/wire.hpp>

#include "device/parameters/parameters.hpp"
#include "device/storage/file_system.hpp"
#include "input.hpp"

namespace {

using sbgc::fuzz::require;

namespace msg = sbgc::msg;
using sbgc::ParameterMessages;
using sbgc::ParametersOf;
using sbgc::Type;
using sbgc::emulator::Eeprom;
using sbgc::emulator::FileSystem;
using sbgc::emulator::Memory;
using sbgc::emulator::Parameters;

class Player {
 public:
  explicit Player(std::span<const std::uint8_t> input) : input_(input) {}

  void play() {
    while (!input_.empty()) step();
    restart();
    read_all();
  }

 private:
  std::uint16_t number() {
    const std::uint8_t high = input_.byte();
    return static_cast<std::uint16_t>(high * 256 + input_.byte());
  }

  void step() {
    switch (input_.byte() % 12) {
      case 0: return write_raw();
      case 1: return write_pages();
      case 2: return write_record();
      case 3: return write_table();
      case 4: return restart();
      case 5:
        return settings_->select_profile(input_.byte() %
                                         ParametersOf<sbgc::msg::ReadParams3>::copies);
      case 6: return set_variable();
      case 7: return write_parameters();
      case 8: return write_file();
      case 9: return read_all();
      case 10: return save();
      default: return reset();
    }
  }

  void write_raw() {
    const std::size_t at = number() % Memory::eeprom_size;
    const auto written =
        input_.bytes(std::min<std::size_t>(input_.byte(), Memory::eeprom_size - at));
    eeprom_.write(at, written);
  }
  void write_pages() {
    const std::uint32_t address = number() * 65536U + number();
    const std::vector<std::uint8_t> page(input_.byte(), input_.byte());
    const Memory before = memory_;
    if (!eeprom_.write_pages(address, page)) {
      require(memory_ == before);
      require(!eeprom_.read_pages(address, page.size()));
    } else {
      require(eeprom_.read_pages(address, page.size()) == page);
    }
  }
  /// Writes a valid record of any message at any address.
  void write_record() {
    const std::size_t size = sbgc::emulator::record_size();
    const std::size_t at = input_.byte() % 24U * size;
    const sbgc::emulator::RecordId id{static_cast<sbgc::msg::CommandFromBoard>(input_.byte()),
                                      input_.byte()};
    require(sbgc::emulator::write_record(eeprom_, at, id, input_.bytes(input_.byte())));
  }
  /// Writes a file table with a valid checksum.
  void write_table() {
    std::array<std::uint8_t, FileSystem::most_files * 8 + 4> table{};
    table.fill(0xFF);
    const auto entries = std::span(table).first(FileSystem::most_files * 8);
    std::ranges::copy(input_.bytes(std::min<std::size_t>(input_.byte(), entries.size())),
                      table.begin());
    sbgc::wire::store(table.data() + entries.size(), sbgc::detail::crc32(entries));
    eeprom_.write(sbgc::emulator::layout::files, table);
  }
  void restart() { settings_ = std::make_unique<Parameters>(memory_); }
  void set_variable() {
    const auto id = static_cast<sbgc::msg::VariableId>(input_.byte());
    const auto value = static_cast<std::int32_t>(number() * 65536U + number());
    const auto before = settings_->variable(id);
    require(before.has_value() == (sbgc::find_variable(id) != nullptr));
    const bool is_set = settings_->set_variable(id, value);
    require(settings_->variable(id) == (is_set ? value : before));
  }
  void write_parameters() {
    const std::uint8_t which = input_.byte() % 6, copy = input_.byte();
    std::uint8_t number = 0;
    ParameterMessages::for_each([&]<class M>(Type<M>) {
      if (number++ != which || copy >= ParametersOf<M>::copies) return;
      M message{};
      if (!sbgc::decode(input_.bytes(M::min_size + input_.byte() % 16), message)) return;
      require(settings_->write(copy, message));
      if constexpr (ParametersOf<M>::copies > 1) ParametersOf<M>::copy(message) = copy;
      require(settings_->template read<M>(copy) == message);
      require(Parameters(memory_).template read<M>(copy) == message);
    });
  }
  void write_file() {
    FileSystem files(memory_);
    const std::uint16_t file = input_.byte() % 40, size = number(), page = input_.byte();
    const auto data = input_.bytes(input_.byte() % 250);
    const Memory before = memory_;
    const msg::FileError error = files.write(file, size, page, data);
    if (error != msg::FileError::no_error) {
      require(memory_ == before);
      return;
    }
    const auto part = files.read(file, page, data.size());
    if (data.empty()) {
      require(part.error == msg::FileError::file_not_found);
    } else {
      require(part.error == msg::FileError::no_error && part.file_size == size);
      require(std::ranges::equal(part.data, data));
    }
  }
  void save() {
    settings_->save();
    require(Parameters(memory_).of<sbgc::msg::ReadParams3>() ==
            settings_->of<sbgc::msg::ReadParams3>());
  }
  void reset() {
    const std::uint8_t what = input_.byte();
    if (what < ParametersOf<sbgc::msg::ReadParams3>::copies) return settings_->use_defaults(what);
    if (what % 2 == 0) return settings_->erase();
    FileSystem files(memory_);
    require(files.clear() == msg::FileError::no_error);
    require(files.read(0, 0, 1).error == msg::FileError::file_not_found);
  }
  void read_all() {
    ParameterMessages::for_each([&]<class M>(Type<M>) {
      for (std::uint8_t copy = 0; copy < ParametersOf<M>::copies; ++copy) {
        const M message = settings_->template read<M>(copy);
        if constexpr (ParametersOf<M>::copies > 1) require(ParametersOf<M>::copy(message) == copy);
      }
    });
    for (const sbgc::VariableInfo& variable : sbgc::variables) {
      require(settings_->variable(variable.id).has_value());
    }
    const FileSystem files(memory_);
    for (std::uint16_t file = 0; file < 40; ++file) {
      const auto part = files.read(file, 1, 255);
      const std::size_t rest = part.file_size < 64 ? 0 : part.file_size - 64U;
      require(part.data.size() == std::min<std::size_t>(rest, 255));
    }
  }

  sbgc::fuzz::Input input_;
  Memory memory_{};
  Eeprom eeprom_{memory_};
  std::unique_ptr<Parameters> settings_ = std::make_unique<Parameters>(memory_);
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Player({data, size}).play();
  return 0;
}
