#include "parameters/defaults.hpp"

#include <cstdlib>
#include <filesystem>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include <sbgc/client/profiles.hpp>
#include <sbgc/messages/parameters.hpp>

#include "board/connection.hpp"
#include "board/progress_bar.hpp"
#include "command/interruption.hpp"
#include "command/remark.hpp"
#include "parameters/parameter_messages.hpp"

namespace sbgc::tools {

namespace {

/// Adds the block to `set` for a different profile.
Result<void> put_for(ParameterSet& set, const Parameters& block, std::uint8_t profile) {
  AnyMessage message = message_in(block);
  for (const FieldType& field : message.type().fields()) {
    if (field.info == nullptr || field.info->role != FieldRole::copy) continue;
    static_cast<void>(message.assign(field.name, fmt::format("raw:{}", profile), false));
  }
  return put_message(set, {block.id.message, profile}, message);
}

/// Returns the file for the defaults of a board; "" without a folder for it. Files with other names
/// are from versions that stored unconfirmed values.
std::filesystem::path defaults_file(const BoardIdentity& board) {
  const char* const cache = std::getenv("XDG_CACHE_HOME");
  const char* const home = std::getenv("HOME");
  std::filesystem::path folder = cache == nullptr ? "" : cache;
  if (folder.empty() && home != nullptr) folder = std::filesystem::path(home) / ".cache";
  if (folder.empty()) return {};
  return folder / "sbgc" /
         fmt::format("factory-{}-{}-{}.json", board.board_version(), board.firmware_version(),
                     board.serial_number());
}

/// Throws CommandError if parameters were not restored.
void check_way_back(const WriteReport& report) {
  if (report) return;
  std::string missing;
  for (const ParametersReport& block : report.parameters) {
    const bool is_back =
        block.state == ParametersState::equal || block.state == ParametersState::written;
    if (!is_back) missing += (missing.empty() ? "" : ", ") + to_text(block.id);
  }
  ClientError error = report.outcome.error();
  error.message += fmt::format("; these parameters are not restored: {}; restore the backup",
                               missing.empty() ? "unknown" : missing);
  fail(error);
}

}  // namespace

void keep_defaults(const BoardIdentity& board, const ParameterSet& defaults) {
  const std::filesystem::path file = defaults_file(board);
  if (file.empty()) return;
  std::error_code ignored;  // saving fails then, too
  std::filesystem::create_directories(file.parent_path(), ignored);
  const Backup kept{.board = board, .parameters = defaults, .created = utc_now()};
  const Result<void> saved = save_backup(kept, file, Existing::replace);
  if (!saved) remark("sbgc: the defaults are not kept: {}\n", saved.error().message);
}

ParameterSet kept_defaults(const BoardIdentity& board) {
  Result<Backup> kept = load_backup(defaults_file(board));
  if (kept) return std::move(kept->parameters);
  if (kept.error().code != ErrorCode::not_found) fail(kept.error());
  throw CommandError(
      fmt::format("the factory defaults of this board with firmware {} are not known here; `sbgc "
                  "params diff --defaults` reads them and keeps them",
                  board.firmware_version()));
}

ParameterSet read_defaults(Client& client, const Backup& before, std::uint8_t profile,
                           const CallOptions& options) {
  const CutShort second;
  // Written back even if that fails or is interrupted.
  const Result<ParameterSet> defaults =
      client.run(find_defaults(profile, before.parameters, options));
  const auto goes_on = [](const Progress&) { return !was_cut_short(); };
  const WriteReport restored =
      client.write_parameters(before.parameters, {.validate = false, .progress = goes_on});
  check_way_back(restored);
  if (was_interrupted()) {
    throw CommandError("interrupted; the parameters are back as they were before", interrupted);
  }
  if (!defaults) fail(defaults.error());
  ParameterSet result;
  for (const Parameters& block : defaults->all()) {
    for (std::uint8_t copy = 0; copy < copy_count(block.id); ++copy) {
      value_of(put_for(result, block, copy));
    }
  }
  return result;
}

namespace {

Task<Result<ParameterSet>> read_profile(std::uint8_t profile) {
  ReadOptions reading;
  reading.wanted = [profile](const ParametersId& id) {
    return id.copy == profile && copy_count(id) > 1;
  };
  return tasks::read_parameters(reading);
}

/// True if a block has different parameters in the two sets. State of the board does not count.
bool differ(const ParameterSet& a, const ParameterSet& b) {
  for (const ParametersChange& change : diff(a, b)) {
    if (change.kind == ParametersChange::Kind::changed) return true;
  }
  return false;
}

}  // namespace

Task<Result<void>> use_defaults(std::uint8_t profile, ParameterSet before, CallOptions options) {
  msg::UseDefaults request;
  request.profile_id = profile;
  const Result<void> done = co_await tasks::call(request, confirming(options));
  if (done || done.error().code != ErrorCode::unconfirmed) co_return done;
  const Result<ParameterSet> present = co_await read_profile(profile);
  const bool has_changed = present && differ(before, *present);
  co_return has_changed ? Result<void>() : done;
}

Task<Result<ParameterSet>> find_defaults(std::uint8_t profile, ParameterSet before,
                                         CallOptions options) {
  Result<void> done = co_await use_defaults(profile, before, options);
  if (!done && done.error().code == ErrorCode::unconfirmed) {
    auto parameters = before.get<msg::ReadParams3>(profile);
    if (!parameters) co_return parameters.error();
    parameters->axes.roll.p ^= 1U;
    ParameterSet changed;
    if (const auto put = changed.set(*parameters); !put) co_return put.error();
    WriteOptions writing;
    writing.validate = false;
    const WriteReport report = co_await tasks::write_parameters(changed, writing);
    if (!report) co_return report.outcome.error();
    done = co_await use_defaults(profile, changed, options);
  }
  if (!done) co_return done.error();
  co_return co_await read_profile(profile);
}

}  // namespace sbgc::tools
