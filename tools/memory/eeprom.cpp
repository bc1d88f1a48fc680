// sbgc eeprom: copies the EEPROM of the board.

#include <cstdint>
#include <optional>
#include <string>

#include <fmt/format.h>

#include <sbgc/client/memory.hpp>
#include <sbgc/messages/storage.hpp>
#include <sbgc/roles.hpp>

#include "board/connection.hpp"
#include "board/progress_bar.hpp"
#include "command/arming.hpp"
#include "command/interruption.hpp"
#include "command/remark.hpp"
#include "command/subcommand.hpp"
#include "command/wording.hpp"
#include "memory/local_file.hpp"

namespace sbgc::tools {

namespace {

struct EepromToRead {
  std::string file{};
  std::uint32_t address = 0;
  std::optional<std::size_t> size{};
  bool force = false;
};

struct EepromToWrite {
  std::string file{};
  std::uint32_t address = 0;
  Arming arming{};
};

/// Returns 0 if the board does not tell it.
std::size_t eeprom_size(const BoardIdentity& board) {
  return board.details ? roles::eeprom_size(*board.details).raw() : 0;
}

/// The number of bytes from the address to the end of the EEPROM.
std::size_t rest_of(const BoardIdentity& board, std::uint32_t address) {
  const std::size_t size = eeprom_size(board);
  if (size == 0) throw CommandError("the board does not tell the size of its EEPROM; use --size");
  if (address >= size) {
    throw CommandError(fmt::format("the EEPROM ends before address {}: it has {}", address,
                                   counted(size, "byte")));
  }
  return size - address;
}

int read_eeprom(const EepromToRead& options, const CommandContext& context) {
  check_replaceable(options.file, options.force);
  Client client = connect(context.gimbal);
  const Interruption interruption;
  const std::size_t size =
      options.size ? *options.size : rest_of(client.identity(), options.address);
  ProgressBar bar("bytes");
  const auto data =
      value_of(client.download_eeprom(options.address, size, {.progress = bar.handler()}));
  write_local_file(options.file, data, options.force);
  bar.clear();
  remark("{} written to {}\n", counted(data.size(), "byte"), options.file);
  return success;
}

int write_eeprom(const EepromToWrite& options, const CommandContext& context) {
  constexpr std::size_t most = 1U << 24U;
  auto data = read_local_file(options.file, most);
  Client client = connect(context.gimbal);
  require_possible(client, msg::EepromWrite{}, false);
  if (eeprom_size(client.identity()) != 0) {
    const std::size_t room = rest_of(client.identity(), options.address);
    if (data.size() > room) {
      throw CommandError(fmt::format("{} do not fit: the EEPROM has {} from address {} on",
                                     counted(data.size(), "byte"), room, options.address));
    }
  }
  arm(options.arming,
      fmt::format("{} of the EEPROM are overwritten, from address {} on. The EEPROM also holds the "
                  "parameters: wrong bytes can make the board unusable. The camera can move.",
                  counted(data.size(), "byte"), options.address));
  const Interruption interruption;
  ProgressBar bar("bytes");
  const std::size_t size = data.size();
  value_of(client.upload_eeprom(options.address, std::move(data), {.progress = bar.handler()}));
  bar.clear();
  remark("{} written and read back; some take effect at the next start\n", counted(size, "byte"));
  return success;
}

}  // namespace

void add_eeprom(CLI::App& app, CommandContext& context) {
  auto* const eeprom = app.add_subcommand("eeprom", "Copy the EEPROM of the board");
  eeprom->require_subcommand(1);
  const auto add_place = [](const auto& command) {
    command->add_option("file", command.options().file, "The file on this computer")
        ->type_name("FILE")
        ->required();
    command->add_option("--address", command.options().address, "The first byte in the EEPROM")
        ->type_name("BYTE")
        ->capture_default_str();
  };
  const Subcommand<EepromToRead> reading(*eeprom, context, "read", "Read the EEPROM into a file");
  add_place(reading);
  reading->add_option("--size", reading.options().size, "How many bytes; otherwise up to the end")
      ->type_name("BYTES");
  reading->add_flag("--force", reading.options().force, "Replace the file if it exists");
  reading.examples({"sbgc eeprom read eeprom.bin"});
  reading.runs(read_eeprom);
  const Subcommand<EepromToWrite> writing(*eeprom, context, "write", "Write a file to the EEPROM");
  add_place(writing);
  writing.examples({"sbgc eeprom write part.bin --address 1024"});
  writing.runs(write_eeprom);
  eeprom->footer(
      "Bytes that are written are read back and compared. For parameters, use `sbgc params`: it "
      "checks them.\n"
      "\n"
      "The exit status is 0 if everything was copied, 1 if not, 2 for wrong usage, 130 after "
      "Ctrl-C.");
}

}  // namespace sbgc::tools
