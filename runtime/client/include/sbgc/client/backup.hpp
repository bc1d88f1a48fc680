/// Backups: all parameters of a board in a file, and back.
///
/// The file is JSON. What counts are the bodies in hex; the fields beside them are for reading, and
/// a file in which both disagree is refused. The format:
///
///     {"format": "sbgc-backup", "version": 1, "created": "2024-05-01T12:00:00Z",
///      "board": {"model": "3.0", "firmware": "2.59", "serial_number": "…",
///                "info": {"message": "BoardInfo", "body": "…", "fields": {…}},
///                "details": {"message": "BoardInfo3", …}},
///      "settings": [{"message": "ReadParams3", "copy": 0, "body": "…", "fields": {…}}, …]}
///
/// `copy` counts profiles from 0. `details` and `serial_number` are missing if the board has none.
///
/// Parameters that are brought back act at once, and the camera can move. See docs/2-safety.md.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include <sbgc/client/board_identity.hpp>
#include <sbgc/client/parameters.hpp>
#include <sbgc/client/result.hpp>
#include <sbgc/client/tasks.hpp>

namespace sbgc {

/// The parameters of a board, and which board it was.
struct Backup {
  BoardIdentity board{};
  ParameterSet parameters{};
  std::string created{};  ///< when, in UTC: "2024-05-01T12:00:00Z"
};

/// The content of a backup file.
std::string to_json_text(const Backup& backup);

/// A backup from the content of a file. ErrorCode::bad_file with the place if anything in it is
/// missing, unknown, contradictory or there twice, ErrorCode::incompatible if the format is a newer
/// one. The text is read within the JsonLimits of <sbgc/parse_json.hpp>: 16 MiB, 64 levels.
Result<Backup> parse_backup(std::string_view text);

/// What to do with a file that is there already.
enum class Existing : std::uint8_t {
  keep,     ///< fail with ErrorCode::invalid
  replace,  ///< the new one takes its place in one step
};

/// Writes a backup file. At any moment, whatever fails, the file is either not there, or the one
/// that was there before, or the whole new one; when this returns it has reached the disk.
Result<void> save_backup(const Backup& backup, const std::filesystem::path& file,
                         Existing existing = Existing::keep);

/// Reads a backup file; ErrorCode::not_found, io, bad_file or incompatible.
Result<Backup> load_backup(const std::filesystem::path& file);

/// Why the parameters do not belong to this board: "the board is a 3.1, the backup is of a 3.0".
/// Another board of the same model with the same firmware fits.
std::vector<std::string> mismatches(const BoardIdentity& board, const BoardIdentity& backup);

/// Keeps a backup. It runs on the thread that drives the task; an error ends the task.
using BackupHandler = std::function<Result<void>(const Backup&)>;

/// Saves to a file that does not exist yet; see save_backup().
BackupHandler save_to(std::filesystem::path file);

/// How a backup is restored.
struct RestoreOptions {
  /// Keeps the present parameters before anything is written; needed unless dry_run.
  BackupHandler save_present{};
  /// Only reports what would change.
  bool dry_run = false;
  /// Restore although the backup is of another board model, or another firmware.
  bool other_model = false;
  bool other_firmware = false;
  /// For all of it.
  std::chrono::milliseconds timeout{180'000};
  ProgressHandler progress{};
};

namespace tasks {

/// Reads all parameters of the board. `created` is for the backup; a task has no clock of its own.
Task<Result<Backup>> make_backup(std::string created, ReadOptions options = {});

/// Makes the parameters of the board those of a backup; what the backup does not have stays. See
/// write_parameters() for how; values are not checked, because a board had them.
Task<WriteReport> restore(Backup backup, RestoreOptions options = {});

}  // namespace tasks
}  // namespace sbgc
