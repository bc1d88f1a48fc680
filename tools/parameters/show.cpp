// sbgc params show, get, profiles, rename.

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <sbgc/client/profiles.hpp>
#include <sbgc/internal/suggestions.hpp>
#include <sbgc/internal/words.hpp>
#include <sbgc/messages/parameters.hpp>
#include <sbgc/text.hpp>

#include "board/connection.hpp"
#include "command/common_options.hpp"
#include "command/option_values.hpp"
#include "command/remark.hpp"
#include "command/subcommand.hpp"
#include "command/terminal_text.hpp"
#include "command/wording.hpp"
#include "parameters/board_parameters.hpp"
#include "parameters/defaults.hpp"
#include "parameters/pager.hpp"
#include "parameters/parameter_messages.hpp"
#include "parameters/parameters_file.hpp"
#include "values/field_text.hpp"

namespace sbgc::tools {

namespace {

struct ShowOptions {
  std::vector<std::string> names{};
  bool changed = false;
  std::string format = "text";
  ProfileOption profile{};
};

constexpr const char* parameters_format = "sbgc-parameters";

void print_json(const ChosenProfile& profile, const std::vector<ShownParameter>& parameters) {
  Json list = Json::array();
  for (const ShownParameter& parameter : parameters) list.push_back(to_json(parameter));
  const Json document{{"format", parameters_format},
                      {"version", 1},
                      {"profile", profile.index + 1},
                      {"active", profile.is_active},
                      {"parameters", std::move(list)}};
  fmt::print("{}\n", detail::json_text(document, 2));
}

bool fits(const ShownParameter& parameter, const Query& query) {
  const std::string name = parameter.message + '.' + parameter.path + ' ' + parameter.spec_name;
  return query.fits(name, parameter.summary, parameter.topics, true);
}

/// Keeps those that contain all words or, if none does, that the only word names, such as P_PITCH.
void keep_wanted(std::vector<ShownParameter>& parameters, const std::vector<std::string>& words) {
  const std::string text = fmt::format("{}", fmt::join(words, " "));
  const Query query(text);
  if (std::ranges::any_of(parameters, [&](const auto& one) { return fits(one, query); })) {
    std::erase_if(parameters, [&](const auto& one) { return !fits(one, query); });
    return;
  }
  FoundParameters named;
  try {
    if (words.size() == 1) named = find_parameters(words.front());
  } catch (const ValueError&) {
    named = {};  // it is not a name
  }
  std::erase_if(parameters, [&](const ShownParameter& parameter) {
    return std::ranges::none_of(named.fields, [&](const FoundField& field) {
      return parameter.message == named.message->type->info->name &&
             detail::is_in_field(parameter.path, steps_text(field.steps));
    });
  });
  if (!parameters.empty()) return;
  if (const ParameterMessage* const message = find_parameter_message(query)) fail_lacking(*message);
  throw CommandError(fmt::format("no parameter has '{}' in its name, its description or its topics",
                                 clipped(text)));
}

/// Keeps those that differ from the factory defaults, and shows the defaults.
void keep_changed(std::vector<ShownParameter>& parameters,
                  const std::vector<ParametersChange>& changes) {
  const auto is_default = [&](ShownParameter& parameter) {
    for (const ParametersChange& block : changes) {
      if (block.id.message != parameter.message) continue;
      for (const FieldChange& field : block.fields) {
        if (field.path != parameter.path) continue;
        const std::string& text =
            field.before_meaning.empty() ? field.before : field.before_meaning;
        parameter.other_default = text.empty() ? "nothing" : text;
        return false;
      }
    }
    return true;
  };
  std::erase_if(parameters, is_default);
}

/// Returns the parameters that are listed under a topic.
std::vector<const ShownParameter*> parameters_of(const TopicReference& topic,
                                                 const std::vector<ShownParameter>& parameters) {
  std::vector<const ShownParameter*> result;
  for (const ShownParameter& parameter : parameters) {
    if (!parameter.topics.empty() && parameter.topics.front() == &topic) {
      result.push_back(&parameter);
    }
  }
  return result;
}

/// Lists the messages that contain the parameters.
std::string messages_of(const std::vector<const ShownParameter*>& parameters) {
  std::vector<std::string> names;
  for (const ShownParameter* const parameter : parameters) {
    if (std::ranges::find(names, parameter->message) == names.end()) {
      names.push_back(parameter->message);
    }
  }
  return fmt::format("{}", fmt::join(names, ", "));
}

std::string table_of(const std::vector<ShownParameter>& parameters) {
  std::string result;
  const Colors colors(stdout);
  std::size_t width = 0;
  for (const ShownParameter& parameter : parameters) {
    width = std::max(width, parameter.path.size());
  }
  constexpr std::size_t least_room = 12;  // for a value beside its name
  const bool is_below = width + 4 + least_room > line_width();
  const std::size_t column = is_below ? 6 : width + 4;
  for (const TopicReference& topic : topic_references) {
    const std::vector<const ShownParameter*> listed = parameters_of(topic, parameters);
    if (listed.empty()) continue;
    result += wrapped(fmt::format("{}: {} ({})", colors(Color::bold, topic.name),
                                  detail::without_period(topic.summary), messages_of(listed)),
                      line_width());
    result += '\n';
    for (const ShownParameter* const parameter : listed) {
      std::string text = parameter->short_text();
      if (!parameter->other_default.empty()) text += " (default " + parameter->other_default + ")";
      result +=
          fmt::format("  {:<{}}{}{}\n", parameter->path, is_below ? 0 : width,
                      is_below ? "\n      " : "  ", wrapped(text, line_width(), column, column));
    }
  }
  return result;
}

/// Shows the parameters, or with defaults, only those that differ from them.
int print_parameters(const ShowOptions& options, const ChosenProfile& profile,
                     const std::string& title, std::vector<ShownParameter> parameters,
                     const std::vector<ParametersChange>* changes = nullptr) {
  keep_wanted(parameters, options.names);
  if (changes != nullptr) keep_changed(parameters, *changes);
  if (options.format == "json") {
    print_json(profile, parameters);
  } else {
    const bool is_default = changes != nullptr && parameters.empty();
    print_paged(title + (is_default ? ": the factory defaults\n" : "\n") + table_of(parameters));
  }
  return success;
}

/// Returns the profile that was active in the backup.
std::uint8_t active_in(const ParameterSet& set) {
  const auto first = set.get<msg::ReadParams3>(0);
  return first && first->cur_profile_id < profile_count ? first->cur_profile_id : std::uint8_t{0};
}

/// Shows a file. The first name is that of the file.
int show_file(ShowOptions options) {
  ParametersFile file = load_parameters_file(options.names.front());
  options.names.erase(options.names.begin());
  if (options.changed) {
    throw CommandError("--changed needs a board, whose defaults are known", wrong_usage);
  }
  const Availability versions = file.backup.board.versions();
  const std::size_t last = file.vendor ? file.vendor->profiles.size() : profile_count;
  const std::uint8_t active = file.vendor ? std::uint8_t{0} : active_in(file.backup.parameters);
  const std::size_t chosen = options.profile.number.value_or(active + 1U);
  if (chosen > last) {
    throw CommandError(fmt::format("{} holds {}", file.name, counted(last, "profile")),
                       wrong_usage);
  }
  const auto index = static_cast<std::uint8_t>(chosen - 1);
  const Availability known{versions.firmware, versions.board};
  const VendorValues values = file.values(empty_parameters(known), index);
  std::vector<ShownParameter> parameters;
  for (const Parameters& block : values.parameters.all()) {
    if (copy_count(block.id) != 1 && block.id.copy != index) continue;
    for (ShownParameter& one : shown_parameters(block, versions)) {
      const std::pair<std::string, std::string> field{one.message, one.path};
      const bool is_held =
          !file.vendor || std::ranges::find(values.fields, field) != values.fields.end();
      if (is_held) parameters.push_back(std::move(one));
    }
  }
  const ChosenProfile profile{index, !file.vendor && index == active};
  const std::string title =
      fmt::format("{} of {}, of board {}, firmware {}", profile.text(), printable(file.name),
                  file.backup.board.board_version(), file.backup.board.firmware_version());
  return print_parameters(options, profile, title, std::move(parameters));
}

int show(const ShowOptions& options, const CommandContext& context) {
  if (!options.names.empty() && is_parameters_file(options.names.front()))
    return show_file(options);
  Client client = connect(context.gimbal);
  const ParameterSet defaults = options.changed ? kept_defaults(client.identity()) : ParameterSet();
  const ChosenProfile profile = choose_profile(client, options.profile);
  const ParameterSet set = read_parameters(client, [&](const ParametersId& id) {
    return copy_count(id) == 1 || id.copy == profile.index;
  });
  const Availability versions = client.identity().versions();
  std::vector<ShownParameter> parameters;
  for (const Parameters& block : set.all()) {
    for (ShownParameter& parameter : shown_parameters(block, versions)) {
      parameters.push_back(std::move(parameter));
    }
  }
  std::vector<ParametersChange> changes;
  if (options.changed) changes = diff(defaults, set, versions, versions);
  return print_parameters(options, profile, profile.text(), std::move(parameters),
                          options.changed ? &changes : nullptr);
}

int get(const ShowOptions& options, const CommandContext& context) {
  std::vector<FoundParameters> wanted;
  try {
    for (const std::string& name : options.names) wanted.push_back(find_parameters(name));
  } catch (const ValueError& error) {
    throw CommandError(clipped(error.what()), wrong_usage);
  }
  Client client = connect(context.gimbal);
  const ChosenProfile profile = choose_profile(client, options.profile);
  const ParameterSet set = read_parameters(client, [&](const ParametersId& id) {
    return std::ranges::any_of(wanted, [&](const FoundParameters& one) {
      return id.message == one.message->type->info->name &&
             (one.message->copies == 1 || id.copy == profile.index);
    });
  });
  std::vector<ShownParameter> parameters;
  std::vector<const FieldType*> types;
  for (const FoundParameters& one : wanted) {
    const char* const message = one.message->type->info->name;
    const std::uint8_t copy = one.message->copies == 1 ? std::uint8_t{0} : profile.index;
    const Parameters* const block = set.find({message, copy});
    if (block == nullptr) fail_lacking(*one.message);
    const std::vector<ShownParameter> all = shown_parameters(*block, client.identity().versions());
    for (const FoundField& field : one.fields) {
      const std::string path = steps_text(field.steps);
      const std::size_t before = parameters.size();
      for (const ShownParameter& parameter : all) {
        if (!detail::is_in_field(parameter.path, path)) continue;
        parameters.push_back(parameter);
        types.push_back(field.type);
      }
      if (parameters.size() != before) continue;
      fail_lacking(field);
    }
  }
  if (options.format == "json") {
    print_json(profile, parameters);
    return success;
  }
  const Colors colors(stdout);
  const FieldInfo* explained = nullptr;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    fmt::print("{} = {}\n", colors(Color::bold, parameters[i].path), parameters[i].text());
    const FieldInfo* const info = types[i]->info;
    const bool is_last = i + 1 == parameters.size() || types[i + 1]->info != info;
    if (info == nullptr || info == explained || !is_last) continue;
    explained = info;
    std::string facts = info->summary;
    for (const std::string& fact : field_facts(*types[i])) facts += "\n" + fact;
    for (std::size_t at = 0; at <= facts.size();) {
      const std::size_t end = std::min(facts.find('\n', at), facts.size());
      fmt::print("    {}\n", wrapped(facts.substr(at, end - at), line_width(), 4, 4));
      at = end + 1;
    }
  }
  remark("({})\n", profile.text());
  return success;
}

int list_profiles(const ShowOptions& options, const CommandContext& context) {
  Client client = connect(context.gimbal);
  const ProfileNames names = value_of(client.profile_names());
  const std::size_t active = value_of(client.active_profile());
  if (options.format == "json") {
    Json list = Json::array();
    for (std::size_t i = 0; i < names.size(); ++i) {
      list.push_back(
          {{"profile", i + 1}, {"name", detail::to_utf8(names[i])}, {"active", i == active}});
    }
    const Json document{{"format", "sbgc-profiles"}, {"version", 1}, {"profiles", std::move(list)}};
    fmt::print("{}\n", detail::json_text(document, 2));
    return success;
  }
  for (std::size_t i = 0; i < names.size(); ++i) {
    fmt::print("{} {}  {}\n", i == active ? '*' : ' ', i + 1, detail::quoted(names[i]));
  }
  remark("(* is active)\n");
  return success;
}

struct RenameOptions {
  unsigned profile = 1;
  std::string name{};
  Arming arming{};
};

int rename_one(const RenameOptions& options, const CommandContext& context) {
  if (const auto checked = check_profile_name(options.name); !checked) {
    throw CommandError(checked.error().message, wrong_usage);
  }
  Client client = connect(context.gimbal);
  const ProfileNames names = value_of(client.profile_names());
  const std::size_t index = options.profile - 1;
  if (names[index] == options.name) {
    fmt::print("profile {} already has this name\n", options.profile);
    return success;
  }
  require_possible(client, msg::WriteProfileNames{});
  arm(options.arming, fmt::format("Renames profile {} from {} to {}.", options.profile,
                                  detail::quoted(names[index]), detail::quoted(options.name)));
  value_of(client.rename_profile(index, options.name));
  fmt::print("profile {}: {} -> {}\n", options.profile, detail::quoted(names[index]),
             detail::quoted(options.name));
  return success;
}

}  // namespace

void add_params_show(CLI::App& params, CommandContext& context) {
  const Subcommand<ShowOptions> command(params, context, "show",
                                        "List the parameters of a profile");
  auto& options = command.options();
  command
      ->add_option(
          "words", options.names,
          "Only the parameters with all these words: a topic (pid), part of a name, or words "
          "of a description (tilt limit). If the first one ends in .json or .profile, the "
          "parameters "
          "of that file: a backup, or of the vendor's program")
      ->type_name("WORDS");
  command->add_flag("--changed", options.changed,
                    "List only parameters that differ from the factory defaults");
  add_profile_option(*command, options.profile);
  add_format(*command, options.format);
  command->footer(
      "On a terminal, $PAGER or less shows a page at a time. --changed compares the parameters "
      "of profiles with the defaults that `sbgc params diff --defaults` has read from this "
      "board, because no request only reads the defaults.");
  command.examples({"sbgc params show", "sbgc params show poles --profile 2",
                    "sbgc params show studio.profile pid"});
  command.runs(show);
}

void add_params_get(CLI::App& params, CommandContext& context) {
  const Subcommand<ShowOptions> command(params, context, "get",
                                        "Print parameters with their meanings");
  auto& options = command.options();
  command
      ->add_option("names", options.names,
                   "Paths (axes.pitch.p), ends of paths (pitch.p, tilt.p) or names of the "
                   "specification (P_PITCH); without an axis, all axes")
      ->type_name("PARAMETER")
      ->required();
  add_profile_option(*command, options.profile);
  add_format(*command, options.format);
  command.examples({"sbgc params get pitch.p rc_min_angle"});
  command.runs(get);
}

void add_params_profiles(CLI::App& params, CommandContext& context) {
  const Subcommand<ShowOptions> command(params, context, "profiles",
                                        "List the profiles and their names");
  auto& options = command.options();
  add_format(*command, options.format);
  command.examples({"sbgc params profiles"});
  command.runs(list_profiles);
}

void add_params_rename(CLI::App& params, CommandContext& context) {
  const Subcommand<RenameOptions> command(params, context, "rename", "Rename a profile");
  auto& options = command.options();
  command->add_option("profile", options.profile, "The profile, counted from 1")
      ->type_name("NUMBER")
      ->check(CLI::Range(1, static_cast<int>(profile_count)).description(""))
      ->required();
  command->add_option("name", options.name, "The new name, up to 48 bytes of UTF-8")->required();
  command.examples({"sbgc params rename 2 Handheld"});
  command.runs(rename_one);
}

}  // namespace sbgc::tools
