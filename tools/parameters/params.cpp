// sbgc params: the parameters that the board stores; and sbgc params set, which makes all checks
// before anything is written.

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <vector>

#include <fmt/format.h>

#include <sbgc/validate.hpp>

#include "board/connection.hpp"
#include "board/progress_bar.hpp"
#include "command/common_options.hpp"
#include "command/interruption.hpp"
#include "command/remark.hpp"
#include "command/subcommand.hpp"
#include "command/wording.hpp"
#include "parameters/board_parameters.hpp"
#include "parameters/parameter_messages.hpp"
#include "values/assignments.hpp"

namespace sbgc::tools {

namespace {

struct SetOptions {
  std::vector<std::string> values{};
  ProfileOption profile{};
  bool dry_run = false;
  bool no_validate = false;
  Arming arming{};
};

/// True if the change concerns a parameter that is the same in all profiles.
bool is_of_general(const FieldChange& change, const std::vector<MessageValues>& values) {
  for (const MessageValues& one : values) {
    for (const FieldValue& value : one.values) {
      if (is_general(value.field) && change.path.starts_with(steps_text(value.field.steps))) {
        return true;
      }
    }
  }
  return false;
}

/// Returns, e.g., "2 parameters of profile 1, which is active"; a general parameter counts once.
std::string what_is_written(const WriteReport& plan, const std::vector<MessageValues>& values,
                            const ChosenProfile& profile) {
  std::set<std::string> general;
  std::size_t own = 0;
  for (const ParametersReport& block : plan.parameters) {
    for (const FieldChange& change : block.wanted) {
      if (is_of_general(change, values)) {
        general.insert(block.id.message + '.' + change.path);
      } else {
        ++own;
      }
    }
  }
  std::string result;
  if (!general.empty()) {
    result = fmt::format("{} of all profiles{}", counted(general.size(), "general parameter"),
                         own == 0 ? "" : " and ");
  }
  if (own != 0) result += fmt::format("{} of {}", counted(own, "parameter"), profile.text());
  return result;
}

int set_parameters(const SetOptions& options, const CommandContext& context) {
  std::vector<MessageValues> values;
  try {
    values = values_of(parse_assignments(options.values), options.no_validate);
  } catch (const std::runtime_error& error) {
    throw CommandError(clipped(error.what()), wrong_usage);
  }
  Client client = connect(context.gimbal);
  const ChosenProfile profile = choose_profile(client, options.profile);
  const ParameterSet present = read_parameters(client, [&](const ParametersId& id) {
    return std::ranges::any_of(
        values, [&](const MessageValues& one) { return concerns(one, id, profile.index); });
  });
  const ParameterSet wanted =
      with_values(present, values, profile.index, client.identity().versions());
  // All checks come before the question to the user.
  const WriteReport plan =
      client.write_parameters(wanted, {.dry_run = true, .validate = !options.no_validate});
  if (!plan) fail(plan.outcome.error());
  const std::string changes = changes_text(plan);
  if (changes.empty()) {
    fmt::print("{}: nothing to change\n", profile.text());
    return success;
  }
  fmt::print("{}", changes);
  std::fflush(stdout);
  if (options.dry_run) return success;
  arm(options.arming,
      fmt::format(
          "Writes {}. Parameters take effect at once, and the camera can move; they survive "
          "a restart.",
          what_is_written(plan, values, profile)));
  WriteReport report;
  {
    const MustFinish writing(write_bound, "the board may hold some of the new values");
    ProgressBar bar;
    report = client.write_parameters(wanted,
                                     {.validate = !options.no_validate, .progress = bar.handler()});
  }
  check_outcome(report);
  remark("Written, read back and compared.\n");
  return success;
}

}  // namespace

void add_params_set(CLI::App& params, CommandContext& context) {
  const Subcommand<SetOptions> command(params, context, "set", "Change parameters");
  auto& options = command.options();
  command
      ->add_option(
          "values", options.values,
          "Parameters by their paths, unique ends of paths, or names in the specification; "
          "without an axis, all axes are set")
      ->type_name("PARAMETER=VALUE")
      ->required();
  add_profile_option(*command, options.profile);
  command->add_flag("--dry-run", options.dry_run, "Only check the values and print the changes");
  command->add_flag("--no-validate", options.no_validate,
                    "Also write values that the specification does not allow");
  command->footer(
      "Reads the parameters, changes them, checks ranges and contradictions, asks, writes, reads "
      "back and compares. Numbers have the unit that `params show` prints, with or without its "
      "name; raw:NUMBER is the number on the wire. NAME=+10% and NAME=-10% change the present "
      "value by a share, NAME+=VALUE and NAME-=VALUE by an amount. A general parameter is set in "
      "all profiles.\n"
      "\n"
      "Examples:\n"
      "  sbgc params set pitch.p=20\n"
      "  sbgc params set pitch.p=+10% yaw.rc_max_angle-=5deg\n"
      "  sbgc params set rc_min_angle=-30deg follow_mode=FOLLOW_MODE_FC --profile 2");
  command.runs(set_parameters);
}

void add_params(CLI::App& app, CommandContext& context) {
  auto* const params = app.add_subcommand("params", "Show, change, back up and restore parameters");
  params->require_subcommand(1);
  for (AddCommand* const add :
       {add_params_show, add_params_get, add_params_set, add_params_profiles, add_params_rename,
        add_params_backup, add_params_restore, add_params_diff, add_params_reset}) {
    add(*params, context);
  }
  params->footer(
      "You can name a parameter by its path (axes.pitch.p), by the end of the path (pitch.p), or "
      "as in the specification. Some parameters are general: they apply to the whole board, and "
      "are stored and set in every profile.");
}

}  // namespace sbgc::tools
