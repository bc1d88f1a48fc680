/// Backups of all parameters of a board, and restoring them.
///
/// The file is JSON. The bodies in hex are authoritative. The decoded fields are for human readers;
/// a file in which they disagree with the bodies is rejected. The format:
///
///     {"format": "sbgc-backup", "version": 1, "created": "2024-05-01T12:00:00Z",
///      "board": {"model": "3.0", "firmware": "2.59", "serial_number": "…",
///                "info": {"message": "BoardInfo", "body": "…", "fields": {…}},
///                "details": {"message": "BoardInfo3", …}},
///      "contents": [{"message": "ReadParams3", "copies": [0, 1, 2, 3, 4]}, …],
///      "checksum": "…",
///      "settings": [{"message": "ReadParams3", "copy": 0, "body": "…", "names": "…",
///                    "fields": {…}}, …]}
///
/// `copy` is the profile, counted from 0. `details` and `serial_number` are absent if the board
/// does not report them.
///
/// Edits of the identity of the board or of `contents` are detected: `checksum` is the CRC-32 of
/// the two. Values of parameters may be edited, in `body` and `fields` alike, but not the names of
/// fields, whose CRC-32 is `names`. Blocks removed from `settings` are in Backup::missing. Files of
/// version 0.1.0 have no `contents` and `checksum`, so only left_alone() shows what may be missing,
/// and files of early versions have no `names`.
///
/// Restored parameters take effect at once, and the camera can move. See docs/2-safety.md.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include <sbgc/client/board_identity.hpp>
#include <sbgc/client/parameters.hpp>
#include <sbgc/client/progress.hpp>
#include <sbgc/client/task.hpp>
#include <sbgc/result.hpp>

namespace sbgc {

/// The parameters of a board, and the identity of that board.
struct Backup {
  BoardIdentity board{};      ///< the board that had them
  ParameterSet parameters{};  ///< every block that the board has
  std::string created{};      ///< UTC, e.g. "2024-05-01T12:00:00Z"
  /// Parameters that the file lists but does not hold, because somebody removed them.
  std::vector<ParametersId> missing{};
};

/// Returns the content of a backup file.
std::string to_json_text(const Backup& backup);

/// Parses the content of a backup file. The JsonLimits of <sbgc/parse_json.hpp> apply: 16 MiB, 64
/// levels. Errors: `bad_file`, which names the position, if anything is missing, unknown,
/// contradictory or duplicated; `incompatible` if the format is newer.
Result<Backup> parse_backup(std::string_view text);

/// Returns the reasons why the parameters do not fit this board, e.g. "the board is a 3.1, the
/// backup is of a 3.0". A board of the same model with the same firmware fits.
std::vector<std::string> mismatches(const BoardIdentity& board, const BoardIdentity& backup,
                                    const std::string& board_name = "the board",
                                    const std::string& backup_name = "the backup");

/// Returns the parameters of this board that the backup does not hold: restoring leaves them alone.
std::vector<ParametersId> left_alone(const BoardIdentity& board, const Backup& backup);

/// Stores a backup. Runs on the thread that drives the task; an error ends the task.
using BackupHandler = std::function<Result<void>(const Backup&)>;

/// Options of restore().
struct RestoreOptions {
  /// Stores the current parameters before anything is written. Required unless `dry_run`.
  BackupHandler save_current{};
  /// Only reports what would change.
  bool dry_run = false;
  /// Restore even if the backup is from another board model or firmware.
  bool allow_other_model = false;
  bool allow_other_firmware = false;  ///< the same for the firmware alone
  /// Restore what the backup holds even if Backup::missing is not empty.
  bool allow_partial = false;
  /// Reject values that the protocol does not allow, as write_parameters() does; useful for
  /// parameters that no board held before.
  bool validate = false;
  /// The timeout of the whole operation.
  std::chrono::milliseconds timeout{180'000};
  ProgressHandler progress{};  ///< returning false ends it with ErrorCode::cancelled
};

/// Checks whether restore() accepts a backup of that board for this one. Errors: `incompatible`.
Result<void> check_fit(const BoardIdentity& board, const BoardIdentity& backup,
                       const RestoreOptions& options);

namespace tasks {

/// Reads all parameters of the board. `created` is stored in the backup: a task has no clock.
/// Errors: those of read_parameters().
Task<Result<Backup>> make_backup(std::string created, ReadOptions options = {});

/// Sets the parameters of the board to those of a backup; others keep their values. Writes like
/// write_parameters(), but by default does not validate values, because a board held them before.
/// Errors, in WriteReport::outcome: `bad_file` if parameters are missing, or if there are none at
/// all; `incompatible` like check_fit(); `invalid` without RestoreOptions::save_current; the errors
/// of that; and those of write_parameters().
Task<WriteReport> restore(Backup backup, RestoreOptions options = {});

}  // namespace tasks
}  // namespace sbgc
