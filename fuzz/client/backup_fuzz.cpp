// Fuzzes the reader of backup files, with bombs (see hostile_text.hpp). Every text is a backup or
// an error with a message, in time in proportion to its size; a backup survives being written and
// read again.

#include <sbgc/client/backup.hpp>

#include "hostile_text.hpp"
#include "input.hpp"

namespace {

using sbgc::fuzz::require;

void check(const std::string& text) {
  const sbgc::Result<sbgc::Backup> backup = sbgc::parse_backup(text);
  if (!backup) return require(!backup.error().message.empty());
  const std::string written = to_json_text(*backup);
  const sbgc::Result<sbgc::Backup> again = sbgc::parse_backup(written);
  require(static_cast<bool>(again));
  require(again->parameters == backup->parameters);
  require(again->board.info == backup->board.info);
  require(again->board.details == backup->board.details);
  require(to_json_text(*again) == written);
  require(diff(backup->parameters, again->parameters).empty());
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text = sbgc::fuzz::text_with_bombs({data, size});
  sbgc::fuzz::require_linear_time(text.size(), std::chrono::microseconds(20), [&] { check(text); });
  return 0;
}
