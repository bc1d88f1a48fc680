// sbgc eeprom: copies the EEPROM of the board.

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include <fmt/format.h>

#include <sbgc/client/memory.hpp>
#include <sbgc/messages/storage.hpp>
#include <sbgc/roles.hpp>

#include "board/connection.hpp"
#include "board/progress_bar.hpp"
#include "command/arming.hpp"
#include "command/commands.hpp"
#include "command/interruption.hpp"
#include "command/remark.hpp"
#include "command/wording.hpp"
#include "memory/local_file.hpp"

namespace sbgc::tools {

namespace {

struct EepromOptions {
  std::string file{};
  std::uint32_t address = 0;
  std::optional<std::size_t> size{};
  bool force = false;
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

int read(const EepromOptions& options, const CommandContext& context) {
  check_replaceable(options.file, options.force);
  Client client = connect(context.gimbal);
  const Interruption interruption;
  const std::size_t size =
      options.size ? *options.size : rest_of(client.identity(), options.address);
  ProgressBar bar("bytes");
  TransferOptions transfer;
  transfer.progress = bar.handler();
  const auto data = value_of(client.download_eeprom(options.address, size, transfer));
  write_local_file(options.file, data, options.force);
  bar.clear();
  remark("{} written to {}\n", counted(data.size(), "byte"), options.file);
  return success;
}

int write(const EepromOptions& options, const CommandContext& context) {
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
  TransferOptions transfer;
  transfer.progress = bar.handler();
  const std::size_t size = data.size();
  value_of(client.upload_eeprom(options.address, std::move(data), transfer));
  bar.clear();
  remark("{} written and read back; some take effect at the next start\n", counted(size, "byte"));
  return success;
}

}  // namespace

void add_eeprom(CLI::App& app, CommandContext& context) {
  auto* const command = app.add_subcommand("eeprom", "Copy the EEPROM of the board");
  command->require_subcommand(1);
  auto options = std::make_shared<EepromOptions>();
  const auto add = [&](const char* name, const char* text) {
    auto* const part = command->add_subcommand(name, text);
    part->add_option("file", options->file, "The file on this computer")->required();
    part->add_option("--address", options->address, "The first byte in the EEPROM")
        ->type_name("BYTE")
        ->capture_default_str();
    add_gimbal_options(*part, context.gimbal);
    return part;
  };
  auto* const reading = add("read", "Read the EEPROM into a file");
  reading->add_option("--size", options->size, "How many bytes; otherwise up to the end")
      ->type_name("BYTES");
  reading->add_flag("--force", options->force, "Replace the file if it exists");
  reading->callback([options, &context] { context.status = read(*options, context); });
  auto* const writing = add("write", "Write a file to the EEPROM");
  add_arming(*writing, options->arming);
  writing->callback([options, &context] { context.status = write(*options, context); });
  command->footer(
      "Bytes that are written are read back and compared. For parameters, use `sbgc params`: it "
      "checks them.\n"
      "\n"
      "The exit status is 0 if everything was copied, 1 if not, 2 for wrong usage, 130 after "
      "Ctrl-C.");
}

}  // namespace sbgc::tools
