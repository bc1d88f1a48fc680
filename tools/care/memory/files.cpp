// sbgc files: the files in the memory of the board.

#include <cstdint>
#include <limits>
#include <string>

#include <fmt/format.h>

#include <sbgc/client/memory.hpp>
#include <sbgc/messages/storage.hpp>

#include "board/connection.hpp"
#include "board/local_file.hpp"
#include "board/progress_bar.hpp"
#include "command/common_options.hpp"
#include "command/interruption.hpp"
#include "command/remark.hpp"
#include "command/subcommand.hpp"
#include "command/wording.hpp"

namespace sbgc::tools {

namespace {

struct FilesToList {
  std::uint16_t first = 0;
  std::uint16_t last = 31;
};

struct FileToGet {
  std::uint16_t id = 0;
  std::string file{};
  bool force = false;
};

struct FileToPut {
  std::uint16_t id = 0;
  std::string file{};
  Arming arming{};
};

struct FilesToDelete {
  std::optional<std::uint16_t> id{};
  bool all = false;
  Arming arming{};
};

int list_files(const FilesToList& options, const CommandContext& context) {
  Client client = connect(context.gimbal);
  const Interruption interruption;
  ProgressBar bar("ids");
  const std::size_t total = options.last < options.first ? 0U : options.last - options.first + 1U;
  for (std::size_t done = 0; done < total; ++done) {
    bar.show(Progress{done, total, ""});
    if (was_interrupted()) throw CommandError("interrupted", interrupted);
    const auto id = static_cast<std::uint16_t>(options.first + done);
    const auto size = client.file_size(id);
    if (!size && size.error().code == ErrorCode::not_found) continue;
    bar.clear();
    fmt::print("{:5}  {}\n", id, counted(value_of(size), "byte"));
  }
  return success;
}

int get_file(const FileToGet& options, const CommandContext& context) {
  check_replaceable(options.file, options.force);
  Client client = connect(context.gimbal);
  const Interruption interruption;
  ProgressBar bar("bytes");
  const auto data = value_of(client.download_file(options.id, {.progress = bar.handler()}));
  write_local_file(options.file, data, options.force);
  bar.clear();
  remark("{} written to {}\n", counted(data.size(), "byte"), options.file);
  return success;
}

int put_file(const FileToPut& options, const CommandContext& context) {
  auto data = read_local_file(options.file, std::numeric_limits<std::uint16_t>::max());
  Client client = connect(context.gimbal);
  require_possible(client, msg::WriteFile{}, false);
  arm(options.arming,
      fmt::format("File {} in the memory of the board gets {}; a file with this id is replaced. If "
                  "it is a script, the next start of the board may run it.",
                  options.id, counted(data.size(), "byte")));
  const MustFinish writing(write_bound, "the board may have a part of the file");
  ProgressBar bar("bytes");
  const std::size_t size = data.size();
  value_of(client.upload_file(options.id, std::move(data), {.progress = bar.handler()}));
  bar.clear();
  remark("{} written and read back\n", counted(size, "byte"));
  return success;
}

int delete_files(const FilesToDelete& options, const CommandContext& context) {
  if (!options.id && !options.all) throw CommandError("say which file, or --all", wrong_usage);
  Client client = connect(context.gimbal);
  if (options.all) {
    require_possible(client, msg::FsClearAll{});
  } else {
    value_of(client.file_size(*options.id));
  }
  arm(options.arming,
      options.all ? "All files in the memory of the board are deleted."
                  : fmt::format("File {} in the memory of the board is deleted.", *options.id));
  value_of(options.all ? client.delete_all_files() : client.delete_file(*options.id));
  remark("deleted\n");
  return success;
}

}  // namespace

void add_files(CLI::App& app, CommandContext& context) {
  auto* const files = app.add_subcommand("files",
                                         "List, copy and delete files in the memory of "
                                         "the board");
  files->require_subcommand(1);
  const auto add_id = [](const auto& command) {
    return command->add_option("id", command.options().id, "The number of the file")
        ->type_name("ID");
  };
  const Subcommand<FilesToList> listing(*files, context, "list",
                                        "List the files in a range of ids");
  listing->add_option("--first", listing.options().first, "The first id to look for")
      ->type_name("ID")
      ->capture_default_str();
  listing->add_option("--last", listing.options().last, "The last id to look for")
      ->type_name("ID")
      ->capture_default_str();
  listing.examples({"sbgc files list --last 20"});
  listing.runs(list_files);
  const Subcommand<FileToGet> getting(*files, context, "get",
                                      "Copy a file of the board to this computer");
  add_id(getting)->required();
  getting->add_option("file", getting.options().file, "The file on this computer")
      ->type_name("FILE")
      ->required();
  getting->add_flag("--force", getting.options().force, "Replace the file if it exists");
  getting.examples({"sbgc files get 5 copy.bin"});
  getting.runs(get_file);
  const Subcommand<FileToPut> putting(*files, context, "put",
                                      "Copy a file of this computer to the board");
  add_id(putting)->required();
  putting->add_option("file", putting.options().file, "The file on this computer")
      ->type_name("FILE")
      ->required();
  putting.examples({"sbgc files put 6 part.bin"});
  putting.runs(put_file);
  const Subcommand<FilesToDelete> removing(*files, context, "delete",
                                           "Delete a file of the board, or all");
  removing->add_flag("--all", removing.options().all, "Delete all files")
      ->excludes(add_id(removing));
  removing.examples({"sbgc files delete 5"});
  removing.runs(delete_files);
  files->footer(
      "The protocol cannot list files, so `list` asks for each id. `put` reads the file back and "
      "compares it.\n"
      "\n"
      "The exit status is 0 for success, 1 for a failure, 2 for wrong usage, 130 after Ctrl-C.");
}

}  // namespace sbgc::tools
