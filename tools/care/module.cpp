// sbgc module: the modules of a board, and their firmware.

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>

#include <sbgc/client/modules.hpp>
#include <sbgc/internal/suggestions.hpp>
#include <sbgc/internal/words.hpp>
#include <sbgc/io/transport.hpp>
#include <sbgc/json.hpp>
#include <sbgc/meta/modules.hpp>
#include <sbgc/text.hpp>

#include "board/connection.hpp"
#include "board/local_file.hpp"
#include "board/progress_bar.hpp"
#include "command/common_options.hpp"
#include "command/interruption.hpp"
#include "command/option_values.hpp"
#include "command/remark.hpp"
#include "command/subcommand.hpp"
#include "command/wording.hpp"

namespace sbgc::tools {

namespace {

struct ModuleListChoice {
  std::string format = "text";
};

struct ModuleFlashChoice {
  std::string file{};
  std::string module{};
  Arming arming{};
};

msg::ModuleList modules_on(Client& client) {
  return value_of(Result<msg::ModuleList>(client.call(msg::ModuleListRequest{})));
}

int list_modules(const ModuleListChoice& options, const CommandContext& context) {
  Client client = connect(context.gimbal);
  const msg::ModuleList list = modules_on(client);
  if (options.format == "json") {
    fmt::print("{}\n", sbgc::to_json(list));
    return success;
  }
  if (list.modules.empty()) {
    remark("The board has no modules.\n");
    return success;
  }
  fmt::print("{:14} {:>8} {:>10} {:>8}\n", "module", "board", "bootloader", "firmware");
  for (const msg::ModuleInfo& one : list.modules) {
    fmt::print("{:14} {:>8} {:>10} {:>8}\n", to_string(one.id), to_string(one.board_ver),
               to_string(one.bootloader_ver), to_string(one.firmware_ver));
  }
  return success;
}

/// Confirmations do not name their part: a duplicate would release the next part too early.
std::unique_ptr<io::Transport> refuse_repeating_line(std::unique_ptr<io::Transport> transport) {
  if (!transport->may_repeat()) return transport;
  throw CommandError(
      fmt::format("no firmware is loaded over {}, which may repeat packets: use a "
                  "serial port, or TCP",
                  transport->description()));
}

/// Returns the module of the board with this name.
const msg::ModuleInfo& module_named(const msg::ModuleList& list, const std::string& name) {
  std::vector<std::string> names;
  for (const msg::ModuleInfo& one : list.modules) {
    names.push_back(to_string(one.id));
    if (sbgc::detail::is_same_word(name, names.back())) return one;
  }
  const auto near = sbgc::detail::nearest(sbgc::detail::upper_case(name), names);
  throw CommandError(
      fmt::format("the board has no module '{}'{}", clipped(name),
                  sbgc::detail::did_you_mean(near, "`sbgc module list` shows its modules")));
}

int flash_firmware(const ModuleFlashChoice& options, const CommandContext& context) {
  const std::vector<std::uint8_t> firmware = read_local_file(options.file, max_module_firmware);
  if (const auto problem = module_firmware_problem(firmware.size())) {
    throw CommandError(fmt::format("{}: {}", options.file, problem->message));
  }
  Client client = connect(context.gimbal, refuse_repeating_line);
  const msg::ModuleList list = modules_on(client);
  const msg::ModuleInfo& module = module_named(list, options.module);
  arm(options.arming,
      fmt::format(
          "{}, which has firmware {}, restarts, is erased and gets {} of {}. The file does not say "
          "for which "
          "module it is: a wrong one can make the module unusable. Until the end, keep the power "
          "on, with a full battery, and let nothing hang on the motors: the module does not work.",
          to_string(module.id), to_string(module.firmware_ver), counted(firmware.size(), "byte"),
          options.file));
  const MustFinish writing(write_bound, "the module has a part of its firmware, and does not work");
  const ProgressBar bar("bytes");
  const Result<void> done = client.run(tasks::flash_module(module.id, firmware, bar.handler()));
  bar.clear();
  if (!done) {
    throw CommandError(
        fmt::format("{}: `sbgc module flash {} --module {}{}`", done.error().message,
                    quoted_for_shell(options.file), to_string(module.id), words_of(context.gimbal)),
        was_interrupted() ? interrupted : failure);
  }
  remark("The firmware of {} is loaded. Restart the board: `sbgc reset{}`.\n", to_string(module.id),
         words_of(context.gimbal));
  return success;
}

}  // namespace

void add_module(CLI::App& app, CommandContext& context) {
  const Subcommand<NoOptions> command(app, context, "module",
                                      "List CAN modules, and load their firmware");
  command->require_subcommand(1);
  command->footer(
      "The exit status is 0 for success; 1 for a failure; 2 for wrong usage; 130 after Ctrl-C.");

  const Subcommand<ModuleListChoice> list(*command, context, "list", "List the modules");
  add_format(*list, list.options().format);
  list.examples({"sbgc module list"});
  list.runs(list_modules);

  const Subcommand<ModuleFlashChoice> flash(*command, context, "flash",
                                            "Load firmware into a module");
  flash->add_option("file", flash.options().file, "The firmware")->required()->type_name("FILE");
  flash->add_option("--module", flash.options().module, "Its name in `sbgc module list`")
      ->required()
      ->type_name("MODULE");
  flash->footer(
      "It sends each part of the file once, after the board has confirmed the previous part. "
      "After an error, it says which part was confirmed last; then start again from the "
      "beginning.\n"
      "\n"
      "Example:\n"
      "  sbgc module flash driver.bin --module CAN_DRV1\n"
      "\n"
      "The exit status is 0 if the board has confirmed all parts; 1 if not; 2 for wrong usage; "
      "130 after Ctrl-C.");
  flash.runs(flash_firmware);
}

}  // namespace sbgc::tools
