#include <string>
#include <vector>

#include <fmt/format.h>

#include <sbgc/client/backup_tasks.hpp>

#include "parameters_kind.hpp"
#include "tasks/tools.hpp"

namespace sbgc {

namespace {

/// The names of both in messages.
struct Names {
  std::string board = "the board";
  std::string backup = "the backup";
};

std::string allow_other_model(const BoardIdentity& board, const BoardIdentity& backup,
                              const Names& names = {}) {
  if (board.versions().board == backup.versions().board) return "";
  return fmt::format("{} is a {}, {} is of a {}", names.board, board.board_version(), names.backup,
                     backup.board_version());
}

std::string allow_other_firmware(const BoardIdentity& board, const BoardIdentity& backup,
                                 const Names& names = {}) {
  const bool is_other = board.versions().firmware != backup.versions().firmware;
  const bool is_special = board.info.frw_extra_id != backup.info.frw_extra_id;
  if (is_other) {
    return fmt::format("{} has the firmware {}, {} is of {}", names.board, board.firmware_version(),
                       names.backup, backup.firmware_version());
  }
  if (!is_special) return "";
  return fmt::format("{} has the special firmware {:#x}, {} is of {:#x}", names.board,
                     board.info.frw_extra_id, names.backup, backup.info.frw_extra_id);
}

/// Returns the difference between the backup and what was saved; "" if it is complete.
std::string incomplete(const Backup& backup, bool allow_partial) {
  if (backup.parameters.all().empty()) return "the backup holds no parameters";
  if (backup.missing.empty() || allow_partial) return "";
  return fmt::format("the backup lacks what it lists: {}", to_text(backup.missing));
}

}  // namespace

std::vector<ParametersId> left_alone(const BoardIdentity& board, const Backup& backup) {
  std::vector<ParametersId> result = detail::readable_parameters(board.versions());
  std::erase_if(result, [&](const ParametersId& id) { return backup.parameters.find(id); });
  return result;
}

std::vector<std::string> mismatches(const BoardIdentity& board, const BoardIdentity& backup,
                                    const std::string& board_name, const std::string& backup_name) {
  const Names names{board_name, backup_name};
  std::vector<std::string> result{allow_other_model(board, backup, names),
                                  allow_other_firmware(board, backup, names)};
  std::erase(result, "");
  return result;
}

Result<void> check_fit(const BoardIdentity& board, const BoardIdentity& backup,
                       const RestoreOptions& options) {
  std::string refused = options.allow_other_model ? "" : allow_other_model(board, backup);
  if (refused.empty() && !options.allow_other_firmware) {
    refused = allow_other_firmware(board, backup);
  }
  if (!refused.empty()) return ClientError{ErrorCode::incompatible, refused};
  return {};
}

namespace tasks {

Task<Result<Backup>> make_backup(std::string created, ReadOptions options) {
  const TaskMachine& task = co_await this_task();
  Result<ParameterSet> parameters = co_await read_parameters(std::move(options));
  if (!parameters) co_return parameters.error();
  co_return Backup{task.identity(), *std::move(parameters), std::move(created)};
}

Task<WriteReport> restore(Backup backup, RestoreOptions options) {
  const TaskMachine& task = co_await this_task();
  const detail::Deadline deadline(task, options.timeout);
  if (const std::string why = incomplete(backup, options.allow_partial); !why.empty()) {
    co_return ClientError{ErrorCode::bad_file, why};
  }
  if (auto fits = check_fit(task.identity(), backup.board, options); !fits) co_return fits.error();
  if (!options.dry_run) {
    if (!options.save_current) {
      co_return ClientError{ErrorCode::invalid, "restoring requires RestoreOptions::save_current"};
    }
    const std::string saving = "saving the present parameters";
    ReadOptions reading{deadline.left(), options.progress};
    const Result<Backup> present = co_await make_backup("", std::move(reading));
    if (!present) co_return detail::during(saving, present.error());
    const Result<void> saved = options.save_current(*present);
    if (!saved) co_return detail::during(saving, saved.error());
  }
  WriteOptions writing{.timeout = deadline.left(),
                       .dry_run = options.dry_run,
                       .validate = options.validate,
                       .progress = options.progress};
  co_return co_await write_parameters(std::move(backup.parameters), std::move(writing));
}

}  // namespace tasks
}  // namespace sbgc
