#include <chrono>
#include <ctime>
#include <utility>

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <sbgc/client/atomic_file.hpp>
#include <sbgc/client/backup.hpp>
#include <sbgc/parse_json.hpp>

#include "tasks/tools.hpp"

namespace sbgc {

std::string utc_now() {
  const auto now = std::chrono::system_clock::now();
  const auto seconds = std::chrono::floor<std::chrono::seconds>(now);
  return fmt::format("{:%Y-%m-%dT%H:%M:%SZ}",
                     fmt::gmtime(std::chrono::system_clock::to_time_t(seconds)));
}

Result<void> save_backup(const Backup& backup, const std::filesystem::path& file,
                         Existing existing) {
  return detail::write_file_atomically(file, to_json_text(backup), existing);
}

Result<Backup> load_backup(const std::filesystem::path& file) {
  const Result<std::string> content = detail::read_whole_file(file, JsonLimits{}.size);
  if (!content) return content.error();
  Result<Backup> backup = parse_backup(*content);
  if (!backup) return detail::during(file.string(), backup.error());
  return backup;
}

BackupHandler save_to(std::filesystem::path file) {
  return [file = std::move(file)](const Backup& backup) {
    if (!backup.created.empty()) return save_backup(backup, file);
    Backup dated = backup;
    dated.created = utc_now();
    return save_backup(dated, file);
  };
}

}  // namespace sbgc
