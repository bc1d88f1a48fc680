// sbgc eeprom: copies the EEPROM of the board.

#include <cstdint>
#include <optional>
#include <string>
#include <utility>

#include <fmt/format.h>

#include <sbgc/client/memory.hpp>
#include <sbgc/messages/storage.hpp>
#include <sbgc/roles.hpp>

#include "board/connection.hpp"
#include "board/local_file.hpp"
#include "board/progress_bar.hpp"
#include "care/memory/eeprom_image.hpp"
#include "command/common_options.hpp"
#include "command/interruption.hpp"
#include "command/remark.hpp"
#include "command/subcommand.hpp"
#include "command/wording.hpp"

namespace sbgc::tools {

namespace {

struct EepromToRead {
  std::string file{};
  std::uint32_t address = 0;
  std::optional<std::size_t> size{};
  bool force = false;
  bool raw = false;
};

struct EepromToWrite {
  std::string file{};
  std::optional<std::uint32_t> address{};
  bool raw = false;
  bool other_model = false;
  bool other_firmware = false;
  Arming arming{};
};

/// Returns 0 if the board does not report it.
std::size_t eeprom_size(const BoardIdentity& board) {
  return board.details ? roles::eeprom_size(*board.details).raw() : 0;
}

/// Returns the number of bytes from the address to the end of the EEPROM.
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
  auto data = value_of(client.download_eeprom(options.address, size, {.progress = bar.handler()}));
  if (!options.raw) {
    const std::string text = to_text(image_of(client.identity(), options.address, std::move(data)));
    data.assign(text.begin(), text.end());
  }
  write_local_file(options.file, data, options.force);
  bar.clear();
  remark("{} written to {}\n", counted(size, "byte"), options.file);
  return success;
}

/// Returns, for example, " (special build 0x1f)".
std::string special_text(std::uint32_t extra_id) {
  return extra_id == 0 ? "" : fmt::format(" (special build {:#x})", extra_id);
}

/// Returns the image of the options. Throws CommandError if the origin of the bytes is uncertain.
EepromImage image_to_write(const EepromToWrite& options) {
  constexpr std::size_t most = 1U << 24U;
  auto bytes = read_local_file(options.file, most);
  auto image = parse_image({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
  if (image && options.raw) {
    throw CommandError("--raw is for bytes alone; this file says what it is", wrong_usage);
  }
  if (image && options.address) {
    throw CommandError("the file says its address; --address is for --raw", wrong_usage);
  }
  if (image) return *std::move(image);
  if (!options.raw) {
    throw CommandError(
        "the file does not say of which board it is, and nothing shows whether it is whole, as in "
        "files of `sbgc eeprom read`; --raw writes it nevertheless");
  }
  return {.address = options.address.value_or(0), .data = std::move(bytes)};
}

/// Returns the origin of the bytes. Throws CommandError if they are from another board.
std::string origin_text(const EepromImage& image, const BoardIdentity& board,
                        const EepromToWrite& options) {
  if (options.raw)
    return "Nothing is known of these bytes: neither their board nor whether they are whole.";
  if (image.model != board.board_version() && !options.other_model) {
    throw CommandError(
        fmt::format("the image is of a board {}, this one is a {}; --other-model "
                    "allows that, at your own risk",
                    printable(image.model), board.board_version()));
  }
  const bool is_other =
      image.firmware != board.firmware_version() || image.extra_id != board.info.frw_extra_id;
  if (is_other && !options.other_firmware) {
    throw CommandError(
        fmt::format("the image is of firmware {}{}, the board has {}; "
                    "--other-firmware allows that, at your own risk",
                    printable(image.firmware), special_text(image.extra_id),
                    board.firmware_version() + special_text(board.info.frw_extra_id)));
  }
  if (image.serial_number == board.serial_number()) return "They are of this board.";
  return fmt::format("They are of another board, with the serial number {}; this one has {}.",
                     printable(image.serial_number), board.serial_number());
}

int write_eeprom(const EepromToWrite& options, const CommandContext& context) {
  EepromImage image = image_to_write(options);
  const std::size_t size = image.data.size();
  Client client = connect(context.gimbal);
  require_possible(client, msg::EepromWrite{}, false);
  const std::string origin = origin_text(image, client.identity(), options);
  if (eeprom_size(client.identity()) != 0) {
    const std::size_t room = rest_of(client.identity(), image.address);
    if (size > room) {
      throw CommandError(fmt::format("{} do not fit: the EEPROM has {} from address {} on",
                                     counted(size, "byte"), room, image.address));
    }
  }
  arm(options.arming,
      fmt::format("{} of the EEPROM are overwritten, from address {} on. {} The EEPROM also holds "
                  "the parameters: wrong bytes can make the board unusable. The camera can move.",
                  counted(size, "byte"), image.address, origin));
  const MustFinish writing(write_bound, "a part of the EEPROM may be overwritten");
  ProgressBar bar("bytes");
  value_of(client.upload_eeprom(image.address, std::move(image.data), {.progress = bar.handler()}));
  bar.clear();
  remark("{} written and read back; some take effect at the next start\n", counted(size, "byte"));
  return success;
}

}  // namespace

void add_eeprom(CLI::App& app, CommandContext& context) {
  auto* const eeprom = app.add_subcommand("eeprom", "Copy the EEPROM of the board");
  eeprom->require_subcommand(1);
  const auto add_file = [](const auto& command) {
    command->add_option("file", command.options().file, "The file on this computer")
        ->type_name("FILE")
        ->required();
  };
  const Subcommand<EepromToRead> reading(*eeprom, context, "read", "Read the EEPROM into a file");
  add_file(reading);
  reading->add_option("--address", reading.options().address, "The first byte in the EEPROM")
      ->type_name("BYTE")
      ->capture_default_str();
  reading
      ->add_option("--size", reading.options().size,
                   "Number of bytes; by default up to the "
                   "end")
      ->type_name("BYTES");
  reading->add_flag("--raw", reading.options().raw,
                    "Only the bytes, without the line that describes them");
  reading->add_flag("--force", reading.options().force, "Replace the file if it exists");
  reading.examples({"sbgc eeprom read eeprom.bin"});
  reading.runs(read_eeprom);
  const Subcommand<EepromToWrite> writing(*eeprom, context, "write", "Write a file to the EEPROM");
  add_file(writing);
  writing->add_flag("--raw", writing.options().raw,
                    "The file holds only bytes, without a description");
  writing
      ->add_option("--address", writing.options().address,
                   "The first byte in the EEPROM, with --raw; 0 by default")
      ->type_name("BYTE");
  writing->add_flag("--other-model", writing.options().other_model,
                    "Accept an image of another board model");
  writing->add_flag("--other-firmware", writing.options().other_firmware,
                    "Accept an image of another firmware");
  writing.examples(
      {"sbgc eeprom write eeprom.bin", "sbgc eeprom write part.bin --raw --address 1024"});
  writing.runs(write_eeprom);
  eeprom->footer(
      "The file begins with a line of JSON: board, firmware, serial number, address, size and "
      "checksum; `tail -n +2` prints the bytes. `write` refuses a changed file, and reads back "
      "and compares what it has written. For parameters, use `sbgc params`: it checks them.\n"
      "\n"
      "The exit status is 0 if all bytes were copied, 1 if not, 2 for wrong usage, 130 after "
      "Ctrl-C.");
}

}  // namespace sbgc::tools
