// Fuzzes the reader of backup files. Every text is a backup or an error with a message; a backup
// survives being written and read again.

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

#include <sbgc/client/backup.hpp>

namespace {

void require(bool condition) {
  if (!condition) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(data, data + size);
  const sbgc::Result<sbgc::Backup> backup = sbgc::parse_backup(text);
  if (!backup) {
    require(!backup.error().message.empty());
    return 0;
  }
  const std::string written = to_json_text(*backup);
  const sbgc::Result<sbgc::Backup> again = sbgc::parse_backup(written);
  require(static_cast<bool>(again));
  require(again->parameters == backup->parameters);
  require(again->board.info == backup->board.info);
  require(again->board.details == backup->board.details);
  require(to_json_text(*again) == written);
  require(diff(backup->parameters, again->parameters).empty());
  return 0;
}
