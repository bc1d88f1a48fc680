// sbgc params backup, restore, diff, reset.

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include <fmt/format.h>

#include <sbgc/client/backup.hpp>
#include <sbgc/client/profiles.hpp>
#include <sbgc/messages/parameters.hpp>

#include "board/connection.hpp"
#include "board/progress_bar.hpp"
#include "command/common_options.hpp"
#include "command/interruption.hpp"
#include "command/option_values.hpp"
#include "command/remark.hpp"
#include "command/subcommand.hpp"
#include "command/wording.hpp"
#include "parameters/board_parameters.hpp"
#include "parameters/defaults.hpp"
#include "parameters/parameter_messages.hpp"
#include "parameters/parameters_file.hpp"

namespace sbgc::tools {

namespace {

/// Reads all parameters of the board. Shows the progress.
Backup read_backup(Client& client) {
  const Interruption interruption;
  ProgressBar bar;
  return value_of(client.make_backup({.progress = bar.handler()}));
}

std::string board_text(const BoardIdentity& board) {
  return fmt::format("board {}, firmware {}", board.board_version(), board.firmware_version());
}

/// Returns an unused file name: that of `file` with the time in it.
std::string dated_name(const std::filesystem::path& file, const char* what) {
  std::string time = utc_now();
  std::erase_if(time, [](char c) { return c == '-' || c == ':'; });
  std::filesystem::path result = file;
  const std::string extension = result.extension().string();
  result.replace_extension();
  result += fmt::format(".{}-{}", what, time);
  std::filesystem::path unique = result;
  unique += extension;
  for (int number = 2; std::filesystem::exists(unique); ++number) {
    unique = result;
    unique += fmt::format("-{}{}", number, extension);
  }
  return unique.string();
}

// ---- backup ----

struct BackupOptions {
  std::string file{};
  bool force = false;
};

int back_up(const BackupOptions& options, const CommandContext& context) {
  if (options.file == "-") {
    throw CommandError("name a file: a backup does not go to the standard output", wrong_usage);
  }
  std::error_code ignored;
  if (!options.force && std::filesystem::exists(options.file, ignored)) {
    throw CommandError(fmt::format("{} already exists; --force replaces it", options.file));
  }
  Client client = connect(context.gimbal);
  const Backup backup = read_backup(client);
  value_of(save_backup(backup, options.file, options.force ? Existing::replace : Existing::keep));
  remark("Saved {} of {} to {}.\n", counted(backup.parameters.all().size(), "parameter set"),
         board_text(backup.board), options.file);
  return success;
}

// ---- restore ----

struct RestoreChoice {
  std::string file{};
  std::string save_to{};
  bool dry_run = false;
  bool other_model = false;
  bool other_firmware = false;
  bool partial = false;
  ProfileOption profile{};
  Arming arming{};
};

/// Returns the option that allows the rejected operation.
std::string refusal_hint(const Backup& backup, const ClientError& error) {
  if (error.code == ErrorCode::incompatible) {
    return "; --other-model and --other-firmware allow that, at your own risk";
  }
  const bool has_others = error.code == ErrorCode::bad_file && !backup.parameters.all().empty();
  return has_others ? "; --partial restores the others" : "";
}

int restore_file(const RestoreChoice& options, const CommandContext& context) {
  ParametersFile file = load_parameters_file(options.file);
  if (options.profile.number && !file.is_of_one_profile()) {
    throw CommandError(fmt::format("{} holds all profiles, so it takes no --profile", file.name),
                       wrong_usage);
  }
  Client client = connect(context.gimbal);
  Backup backup = file.backup;
  RestoreOptions restoring{.dry_run = true,
                           .allow_other_model = options.other_model,
                           .allow_other_firmware = options.other_firmware,
                           .allow_partial = options.partial,
                           .validate = file.vendor.has_value()};
  std::string where = board_text(client.identity());
  if (file.vendor) {
    const ChosenProfile profile = choose_profile(client, options.profile);
    if (file.is_of_one_profile()) where = fmt::format("{} of {}", profile.text(), where);
    backup.board.info.frw_extra_id = client.identity().info.frw_extra_id;  // not in the file
    // Before its names are looked up: they may denote something else on another board.
    if (const auto fits = check_fit(client.identity(), backup.board, restoring); !fits) {
      fail({fits.error().code, fits.error().message + refusal_hint(backup, fits.error())});
    }
    backup.parameters = file.values(read_parameters(client), profile.index).parameters;
  }
  WriteReport plan;
  {
    const Interruption interruption;
    ProgressBar bar;
    restoring.progress = bar.handler();
    plan = client.restore(backup, restoring);
  }
  if (!plan) {
    ClientError error = plan.outcome.error();
    error.message += refusal_hint(backup, error);
    fail(error);
  }
  if (const auto others = left_alone(client.identity(), backup); !others.empty()) {
    remark("note: not in the {}, so left alone: {}\n", file.vendor ? "file" : "backup",
           to_text(others));
  }
  const std::string changes = changes_text(plan);
  if (changes.empty()) {
    fmt::print("the board holds the parameters of {} already\n", printable(options.file));
    return success;
  }
  fmt::print("{}", changes);
  std::fflush(stdout);
  if (options.dry_run) return success;
  const std::string save_to =
      options.save_to.empty() ? dated_name(options.file, "before-restore") : options.save_to;
  arm(options.arming,
      fmt::format("Saves the present parameters to {}, then writes {} to {}. Parameters take "
                  "effect at once, and the camera can move.",
                  save_to, counted(change_count(plan), "change"), where));
  bool is_saved = false;
  restoring.dry_run = false;
  restoring.save_current = [&](const Backup& present) {
    Result<void> saved = sbgc::save_to(save_to)(present);
    is_saved = static_cast<bool>(saved);
    return saved;
  };
  WriteReport report;
  {
    const MustFinish writing(
        write_bound, fmt::format("the board may hold a part of it; the parameters from before are "
                                 "in {}, if that file exists",
                                 printable(save_to)));
    ProgressBar bar;
    restoring.progress = bar.handler();
    report = client.restore(backup, restoring);
  }
  if (is_saved) remark("The parameters from before are in {}.\n", save_to);
  check_outcome(report);
  remark("Restored, read back and compared.\n");
  return success;
}

// ---- diff ----

struct DiffOptions {
  std::vector<std::string> files{};
  std::string format = "text";
  bool defaults = false;
  ProfileOption profile{};
  Arming arming{};
};

Json to_json(const std::vector<ParametersChange>& changes) {
  Json list = Json::array();
  for (const ParametersChange& change : changes) {
    Json fields = Json::array();
    for (const FieldChange& field : change.fields) {
      fields.push_back({{"path", field.path},
                        {"before", field.before},
                        {"after", field.after},
                        {"before_meaning", field.before_meaning},
                        {"after_meaning", field.after_meaning}});
    }
    const char* const kind = change.kind == ParametersChange::Kind::changed       ? "changed"
                             : change.kind == ParametersChange::Kind::only_before ? "removed"
                                                                                  : "added";
    list.push_back({{"message", change.id.message},
                    {"copy", change.id.copy},
                    {"kind", kind},
                    {"fields", std::move(fields)}});
  }
  return {{"format", "sbgc-diff"}, {"version", 1}, {"changes", std::move(list)}};
}

std::vector<ParametersChange> changes_of(const Backup& before, const Backup& after) {
  return diff(before.parameters, after.parameters, before.board.versions(), after.board.versions());
}

int report_differences(const DiffOptions& options, const std::vector<ParametersChange>& changes,
                       const std::string& before, const std::string& after) {
  if (options.format == "json") {
    fmt::print("{}\n", detail::json_text(to_json(changes), 2));
  } else if (!changes.empty()) {
    fmt::print("from {} to {}:\n{}", printable(before), printable(after), changes_text(changes));
  }
  return changes.empty() ? success : failure;
}

/// Compares one profile with the factory defaults.
int compare_with_defaults(const DiffOptions& options, const CommandContext& context) {
  Client client = connect(context.gimbal);
  require_possible(client, msg::UseDefaults{});
  const ChosenProfile profile = choose_profile(client, options.profile);
  const std::size_t active = value_of(client.active_profile());
  // The last profile that is not active.
  const std::size_t spare = active + 1 == profile_count ? profile_count - 2 : profile_count - 1;
  const std::string save_to = dated_name("parameters.json", "before-defaults");
  arm(options.arming,
      fmt::format("The protocol has no request for the factory defaults, only one that goes back "
                  "to them. Saves the present parameters to {}, sets profile {} to the defaults, "
                  "reads it, and writes everything back. Meanwhile, general parameters can have "
                  "their defaults, too, and the camera can move. If this command is killed "
                  "meanwhile, or the line breaks, restore that backup.",
                  save_to, spare + 1));
  const Interruption interruption;  // Ctrl-C must not leave the defaults on the board
  const Backup before = read_backup(client);
  value_of(save_backup(before, save_to));
  remark("The parameters from before are in {}.\n", save_to);
  if (was_interrupted()) throw CommandError("interrupted; nothing was changed", interrupted);
  const MustFinish way_back(
      write_bound,
      fmt::format("the parameters from before may not be back: `sbgc params restore {}`",
                  quoted_for_shell(save_to)));
  const ParameterSet all =
      read_defaults(client, before, static_cast<std::uint8_t>(spare), call_options(context.gimbal));
  keep_defaults(before.board, all);
  ParameterSet defaults;
  ParameterSet present;
  for (const Parameters& block : all.all()) {
    if (block.id.copy != profile.index) continue;
    value_of(defaults.put(block));
    value_of(present.put(*before.parameters.find(block.id)));
  }
  const Availability versions = before.board.versions();
  return report_differences(options, diff(defaults, present, versions, versions),
                            "the factory defaults", profile.text());
}

/// Converts the file to a backup. Values that a file of the vendor's program lacks are taken from
/// `other`.
Backup as_backup(ParametersFile& file, const Backup& other, std::uint8_t target) {
  Backup result = file.backup;
  result.parameters = file.values(other.parameters, target).parameters;
  for (const Parameters& block : other.parameters.all()) {
    if (file.vendor && result.parameters.find(block.id) == nullptr) {
      value_of(result.parameters.put(block));
    }
  }
  return result;
}

int compare(const DiffOptions& options, const CommandContext& context) {
  if (options.defaults) return compare_with_defaults(options, context);
  std::vector<ParametersFile> files;
  for (const std::string& file : options.files) files.push_back(load_parameters_file(file));
  if (options.profile.number && std::ranges::none_of(files, &ParametersFile::is_of_one_profile)) {
    throw CommandError("--profile needs --defaults, or a file with one profile", wrong_usage);
  }
  auto target = static_cast<std::uint8_t>(options.profile.number.value_or(1) - 1);
  Backup before;
  Backup after;
  std::string name = "the board";
  if (files.size() > 1) {
    name = options.files[1];
    Backup base = files[0].vendor ? files[1].backup : files[0].backup;
    if (files[0].vendor && files[1].vendor) {
      const Availability versions = base.board.versions();
      base.parameters = empty_parameters({versions.firmware, versions.board});
      base = as_backup(files[0], base, target);  // values that only one of them holds are in both
    }
    after = as_backup(files[1], base, target);
    before = as_backup(files[0], after, target);
  } else {
    Client client = connect(context.gimbal);
    if (files[0].is_of_one_profile()) target = choose_profile(client, options.profile).index;
    after = read_backup(client);
    before = as_backup(files[0], after, target);
  }
  const auto notes = files.size() == 1
                         ? mismatches(after.board, before.board)
                         : mismatches(after.board, before.board, "the board of " + options.files[1],
                                      options.files[0]);
  for (const std::string& note : notes) remark("note: {}\n", note);
  return report_differences(options, changes_of(before, after), options.files[0], name);
}

int compare_or_tell(const DiffOptions& options, const CommandContext& context) {
  if (options.files.empty() != options.defaults) {
    throw CommandError("name a backup to compare the board with, or --defaults", wrong_usage);
  }
  if (!options.defaults && options.arming.yes) {
    throw CommandError("--yes needs --defaults", wrong_usage);
  }
  try {
    return compare(options, context);
  } catch (const CommandError& error) {
    throw CommandError(error.what(), error.status() == failure ? cannot_tell : error.status());
  }
}

// ---- reset ----

struct ResetChoice {
  ProfileOption profile{};
  bool all = false;
  std::string save_to{};
  Arming arming{};
};

/// Returns, for example, "profile 1 is" or "profiles 1, 2 are".
std::string profiles_are(const std::vector<std::size_t>& profiles) {
  std::string numbers;
  for (const std::size_t profile : profiles) {
    numbers += fmt::format("{}{}", numbers.empty() ? "" : ", ", profile + 1);
  }
  return profiles.size() == 1 ? fmt::format("profile {} is", numbers)
                              : fmt::format("profiles {} are", numbers);
}

std::string reset_text(const std::vector<std::size_t>& profiles) {
  return profiles.empty() ? "no profile is reset" : profiles_are(profiles) + " reset";
}

/// Sets profiles to the factory defaults, and returns all resulting parameters. On failure or
/// interruption, the error names the profiles that are reset, and the backup. Profiles whose state
/// is uncertain become `unknown`.
Backup reset_profiles(Client& client, const std::vector<std::size_t>& profiles,
                      const Backup& before, const std::string& saved_to,
                      std::vector<std::size_t>& unknown, const CommandContext& context) {
  const MustFinish resetting(
      write_bound, fmt::format("some profiles may be reset; the parameters from before are in {}",
                               printable(saved_to)));
  std::vector<std::size_t> done;
  const auto give_up = [&](const std::string& reason, int status) {
    throw CommandError(fmt::format("{}; {}; the parameters from before are in {}", reason,
                                   reset_text(done), saved_to),
                       status);
  };
  for (const std::size_t profile : profiles) {
    if (was_interrupted()) give_up("interrupted", interrupted);
    const auto reset = client.run(use_defaults(static_cast<std::uint8_t>(profile),
                                               before.parameters, call_options(context.gimbal)));
    const bool is_unknown = !reset && reset.error().code == ErrorCode::unconfirmed;
    if (!reset && !is_unknown) {
      give_up(fmt::format("resetting profile {}: {}", profile + 1, reset.error().message), failure);
    }
    (is_unknown ? unknown : done).push_back(profile);
  }
  try {
    return read_backup(client);
  } catch (const CommandError& error) {
    give_up(error.what(), error.status());
  }
  return {};
}

int reset_parameters(const ResetChoice& options, const CommandContext& context) {
  if (options.all && options.profile.number) {
    throw CommandError("--all and --profile exclude each other", wrong_usage);
  }
  Client client = connect(context.gimbal);
  require_possible(client, msg::UseDefaults{});
  const ChosenProfile profile = choose_profile(client, options.profile);
  const std::string save_to =
      options.save_to.empty() ? dated_name("parameters.json", "before-reset") : options.save_to;
  arm(options.arming,
      fmt::format(
          "Saves the present parameters to {}, then goes back to the factory defaults in {}. They "
          "take effect at once, and the camera can move: the defaults know nothing of "
          "this gimbal's motors.",
          save_to, options.all ? "all profiles" : profile.text()));
  const Backup before = read_backup(client);
  value_of(save_backup(before, save_to));
  remark("The parameters from before are in {}.\n", save_to);
  std::vector<std::size_t> profiles;
  for (std::size_t i = 0; i < profile_count; ++i) {
    if (options.all || i == profile.index) profiles.push_back(i);
  }
  std::vector<std::size_t> unknown;
  const Backup after = reset_profiles(client, profiles, before, save_to, unknown, context);
  const std::string changes = changes_text(changes_of(before, after));
  const bool is_known = unknown.empty();
  fmt::print("{}",
             changes.empty() && is_known ? "the parameters already had their defaults\n" : changes);
  if (is_known) return success;
  throw CommandError(
      fmt::format("sent; the board did not confirm it, and {} as before", profiles_are(unknown)),
      cannot_tell);
}

}  // namespace

void add_params_backup(CLI::App& params, CommandContext& context) {
  const Subcommand<BackupOptions> command(params, context, "backup",
                                          "Save all parameters of the board");
  auto& options = command.options();
  command->add_option("file", options.file, "The new file; it appears only when it is complete")
      ->type_name("FILE")
      ->required();
  command->add_flag("--force", options.force, "Replace an existing file");
  command.examples({"sbgc params backup new.json"});
  command.runs(back_up);
}

void add_params_restore(CLI::App& params, CommandContext& context) {
  const Subcommand<RestoreChoice> command(params, context, "restore",
                                          "Write the parameters of a backup");
  auto& options = command.options();
  command->add_option("file", options.file, "A backup, or a .profile file of the vendor's program")
      ->type_name("FILE")
      ->required();
  add_profile_option(*command, options.profile);
  command->add_flag("--dry-run", options.dry_run, "Only print what would change");
  command
      ->add_option("--save-to", options.save_to,
                   "Where to save the present parameters first; by default next to FILE, with "
                   "the time in the name")
      ->type_name("FILE");
  command->add_flag("--other-model", options.other_model, "Accept a backup of another board model");
  command->add_flag("--other-firmware", options.other_firmware,
                    "Accept a backup of another firmware");
  command->add_flag("--partial", options.partial,
                    "Accept a backup from which parameter sets were removed");
  command->footer(
      "It writes only differences, block by block; it reads back and compares each block, and "
      "finally all of them. After a failure or Ctrl-C, it says within 60 s what the board holds. "
      "Entries of a .profile file without a certain counterpart in the protocol are listed, not "
      "written; --profile is for files with one profile.");
  command.examples({"sbgc params restore gimbal.json --dry-run", "sbgc params restore gimbal.json",
                    "sbgc params restore studio.profile --profile 2"});
  command.runs(restore_file);
}

void add_params_diff(CLI::App& params, CommandContext& context) {
  const Subcommand<DiffOptions> command(params, context, "diff",
                                        "Compare the board with a backup, or two backups");
  auto& options = command.options();
  command
      ->add_option("files", options.files,
                   "A backup or a .profile file to compare the board with, or two of them")
      ->type_name("FILE")
      ->expected(0, 2);
  command->add_flag("--defaults", options.defaults,
                    "Compare a profile with the factory defaults. To read them, the board resets "
                    "another profile for a moment");
  add_profile_option(*command, options.profile);
  add_format(*command, options.format);
  command->footer(
      "--defaults also keeps the defaults in ~/.cache/sbgc, for `sbgc params show --changed`. "
      "After a signal, it first restores the parameters, which may take 60 s; a second Ctrl-C, "
      "at least half a second later, cuts this short, and the command says what it did not "
      "restore. The exit status is 0 if there are no differences, 1 if there are, 3 if they "
      "could not be compared, 2 for wrong usage.");
  command.examples({"sbgc params diff gimbal.json", "sbgc params diff gimbal.json other.json",
                    "sbgc params diff --defaults --profile 2"});
  command.runs(compare_or_tell);
}

void add_params_reset(CLI::App& params, CommandContext& context) {
  const Subcommand<ResetChoice> command(params, context, "reset",
                                        "Set the parameters of a profile to the factory defaults");
  auto& options = command.options();
  add_profile_option(*command, options.profile);
  command->add_flag("--all", options.all, "All profiles");
  command
      ->add_option("--save-to", options.save_to,
                   "Where to save the present parameters first; by default in this folder, "
                   "with the time in the name")
      ->type_name("FILE");
  command.examples({"sbgc params reset --profile 2"});
  command.runs(reset_parameters);
}

}  // namespace sbgc::tools
