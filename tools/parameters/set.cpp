// sbgc params set: changes parameters, with all checks before anything is written.

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <vector>

#include <fmt/format.h>

#include <sbgc/validate.hpp>

#include "board/connection.hpp"
#include "board/progress_bar.hpp"
#include "command/arming.hpp"
#include "command/interruption.hpp"
#include "command/remark.hpp"
#include "command/subcommand.hpp"
#include "command/wording.hpp"
#include "parameters/parameter_messages.hpp"
#include "parameters/params_commands.hpp"
#include "parameters/profile_choice.hpp"
#include "parameters/write_outcome.hpp"
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

/// The values to set in one message.
struct MessageValues {
  const ParameterMessage* message = nullptr;
  std::vector<FieldValue> values{};

  bool has_general() const {
    return std::ranges::any_of(values, [](const auto& value) { return is_general(value.field); });
  }
};

/// True if what is written has another meaning on later boards.
bool depends_on_firmware(const FieldValue& value) {
  const FieldInfo* const info = value.field.type->innermost().info;
  return info != nullptr && !info->later.empty();
}

/// Returns the values by message. Reads each on a new message first, so that most mistakes are
/// found without a board. Throws ValueError.
std::vector<MessageValues> values_of(const std::vector<Assignment>& assignments, bool no_validate) {
  std::vector<MessageValues> result;
  for (const Assignment& assignment : assignments) {
    const FoundParameters found = find_parameters(assignment.name);
    auto at = std::ranges::find(result, found.message, &MessageValues::message);
    if (at == result.end()) at = result.insert(at, {found.message, {}});
    for (FieldValue& value : values_for(found.fields, assignment.value)) {
      add_value(at->values, std::move(value));
    }
  }
  for (const MessageValues& one : result) {
    AnyMessage message = one.message->type->make();
    std::vector<FieldValue> certain = one.values;
    std::erase_if(certain, depends_on_firmware);
    set_values(message, certain);
    if (!no_validate) check_ranges(message, certain);
  }
  return result;
}

bool concerns(const MessageValues& one, const ParametersId& id, std::uint8_t profile) {
  if (id.message != one.message->type->info->name) return false;
  return one.message->copies == 1 || id.copy == profile || one.has_general();
}

/// Returns the values that the block with this id gets: general ones in every profile.
std::vector<FieldValue> values_in(const MessageValues& one, const ParametersId& id,
                                  std::uint8_t profile) {
  if (one.message->copies == 1 || id.copy == profile) return one.values;
  std::vector<FieldValue> general;
  for (const FieldValue& value : one.values) {
    if (is_general(value.field)) general.push_back(value);
  }
  return general;
}

/// True if the change is one of a parameter that is the same in all profiles.
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

/// For example "2 parameters of profile 1, which is active"; a general parameter counts once.
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
  ParameterSet wanted;
  for (const MessageValues& one : values) {
    const char* const name = one.message->type->info->name;
    bool is_present = false;
    for (const Parameters& block : present.all()) {
      if (block.id.message != name) continue;
      is_present = true;
      AnyMessage message = message_in(block);
      const std::vector<FieldValue> here = values_in(one, block.id, profile.index);
      for (const FieldValue& value : here) {
        if (!message.has(std::get<std::string>(value.field.steps.front()))) {
          fail_lacking(value.field);
        }
      }
      try {
        set_values(message, here, client.identity().versions());
        value_of(wanted.put(block_of(block.id, message)));
      } catch (const CommandError&) {
        throw;
      } catch (const std::runtime_error& error) {
        throw CommandError(clipped(error.what()), wrong_usage);
      }
    }
    if (!is_present) throw CommandError(fmt::format("this board does not have {}", name));
  }
  // All checks, before the user is asked.
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
    const Interruption interruption;
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
      "back and compares. A number is in the unit that `params show` prints, which may be written "
      "after it; raw:NUMBER is the number on the wire. A general parameter is set in all "
      "profiles.\n"
      "\n"
      "Examples:\n"
      "  sbgc params set pitch.p=20\n"
      "  sbgc params set rc_min_angle=-30deg follow_mode=FOLLOW_MODE_FC --profile 2");
  command.runs(set_parameters);
}

}  // namespace sbgc::tools
