/// Backups of all parameters: their files, and the tasks that make and restore them, which
/// <sbgc/client/backup_tasks.hpp> describes.
#pragma once

#include <filesystem>
#include <string>

#include <sbgc/client/backup_tasks.hpp>
#include <sbgc/io/existing.hpp>
#include <sbgc/result.hpp>

namespace sbgc {

/// Returns the current time of the host in the format of Backup::created.
std::string utc_now();

/// Writes a backup file atomically: at any moment, and after any failure, the path holds either
/// what it held before or the complete new file. The file is flushed to disk on return. Errors:
/// `invalid` if it exists already or is no regular file, `not_found` for its folder, `io`.
Result<void> save_backup(const Backup& backup, const std::filesystem::path& file,
                         Existing existing = Existing::keep);

/// Reads a backup file. Errors: `not_found`, `io`; `bad_file` and `incompatible` as parse_backup().
Result<Backup> load_backup(const std::filesystem::path& file);

/// Saves to a file that must not exist yet; see save_backup().
BackupHandler save_to(std::filesystem::path file);

}  // namespace sbgc
