// Saves the parameters of a board, compares them with a backup, and restores a backup:
//
//     backup ADDRESS save FILE
//     backup ADDRESS diff FILE
//     backup ADDRESS restore FILE SAVE-PRESENT-STATE-TO [--yes]
//
// ADDRESS is a serial port such as /dev/ttyUSB0, or tcp:host:port. Restored parameters take effect
// at once, and the gimbal may move: see docs/2-safety.md. Therefore `restore` asks first, unless
// the last argument is --yes.

#include <cstdio>
#include <cstring>
#include <string>

#include <sbgc/client/backup.hpp>
#include <sbgc/client/client.hpp>

#include "careful.hpp"

namespace {

int fail(const sbgc::ClientError& error) {
  std::fprintf(stderr, "%s\n", error.message.c_str());
  return 1;
}

bool show(const sbgc::Progress& progress) {
  const std::string what(progress.what);
  std::fprintf(stderr, "%zu/%zu %s\n", progress.done, progress.total, what.c_str());
  return true;  // continue
}

int save(sbgc::Client& client, const char* file) {
  const auto backup = client.make_backup({.progress = show});
  if (!backup) return fail(backup.error());
  if (auto saved = sbgc::save_backup(*backup, file); !saved) return fail(saved.error());
  std::printf("saved the parameters of %zu messages of a board %s with firmware %s\n",
              backup->parameters.all().size(), backup->board.board_version().c_str(),
              backup->board.firmware_version().c_str());
  return 0;
}

int diff(sbgc::Client& client, const char* file) {
  const auto backup = sbgc::load_backup(file);
  if (!backup) return fail(backup.error());
  for (const std::string& mismatch : sbgc::mismatches(client.identity(), backup->board)) {
    std::printf("%s\n", mismatch.c_str());
  }
  const auto present = client.read_parameters({.progress = show});
  if (!present) return fail(present.error());
  const std::string changes = to_text(sbgc::diff(backup->parameters, *present));
  std::printf("%s", changes.empty() ? "no differences\n" : changes.c_str());
  return 0;
}

int restore(sbgc::Client& client, const char* file, const char* present, bool is_accepted) {
  const auto backup = sbgc::load_backup(file);
  if (!backup) return fail(backup.error());
  if (!careful::may_move(is_accepted, "The parameters take effect at once; the gimbal may move."))
    return 1;
  const sbgc::WriteReport report =
      client.restore(*backup, {.save_current = sbgc::save_to(present), .progress = show});
  std::printf("%s", to_text(report).c_str());
  return report ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  const bool is_accepted = careful::take_yes_flag(argc, argv);
  const bool is_restore = argc == 5 && std::strcmp(argv[2], "restore") == 0;
  const bool is_diff = argc == 4 && std::strcmp(argv[2], "diff") == 0;
  const bool is_save = argc == 4 && std::strcmp(argv[2], "save") == 0;
  if (!is_restore && !is_diff && !is_save) {
    std::fprintf(stderr,
                 "usage: backup ADDRESS save|diff FILE, "
                 "backup ADDRESS restore FILE FILE [--yes]\n");
    return 2;
  }
  auto client = sbgc::Client::connect(argv[1]);
  if (!client) return fail(client.error());
  if (is_save) return save(*client, argv[3]);
  if (is_diff) return diff(*client, argv[3]);
  return restore(*client, argv[3], argv[4], is_accepted);
}
