// sbgc vars: the adjustable variables.

#include <algorithm>
#include <string>
#include <variant>
#include <vector>

#include <fmt/format.h>

#include <sbgc/availability.hpp>
#include <sbgc/client/variables.hpp>
#include <sbgc/internal/suggestions.hpp>
#include <sbgc/internal/words.hpp>
#include <sbgc/json_dom.hpp>
#include <sbgc/messages/adjustable_variables.hpp>
#include <sbgc/messages/parameters.hpp>
#include <sbgc/meta/enums.hpp>
#include <sbgc/text.hpp>
#include <sbgc/value_text.hpp>

#include "board/connection.hpp"
#include "command/common_options.hpp"
#include "command/interruption.hpp"
#include "command/option_values.hpp"
#include "command/remark.hpp"
#include "command/subcommand.hpp"
#include "command/wording.hpp"
#include "values/assignments.hpp"
#include "values/field_text.hpp"
#include "values/message_names.hpp"

namespace sbgc::tools {

namespace {

struct VariablesToShow {
  std::vector<std::string> names{};  ///< all if empty
  std::string format = "text";
};

struct VariablesToSet {
  std::vector<std::string> values{};
  bool save = false;
  Arming arming{};
};

const VariableInfo& variable_named(const std::string& name) {
  for (const VariableInfo& variable : variables) {
    if (detail::is_same_word(name, variable.name)) return variable;
  }
  const auto near = detail::nearest(detail::upper_case(name), variable_names());
  throw CommandError(fmt::format("there is no adjustable variable '{}'{}", clipped(name),
                                 detail::did_you_mean(near, "`sbgc vars list` lists them")),
                     wrong_usage);
}

/// Describes the variable as a field with this unit, for parsing values.
FieldType field_of(const VariableInfo& variable, const UnitInfo& unit, FieldInfo& info) {
  info.range = &variable.range;
  return {.info = &info,
          .shape = FieldShape::integer,
          .lowest = static_cast<std::int64_t>(variable.range.lowest),
          .highest = static_cast<std::int64_t>(variable.range.highest),
          .unit = &unit};
}

std::string range_of(const VariableInfo& variable, const UnitInfo& unit) {
  FieldInfo info;
  return range_text(field_of(variable, unit, info));
}

/// Returns the raw value for a text in the unit, on a board with these versions. Throws ValueError.
double read_value(const VariableInfo& variable, const std::string& text,
                  const Availability& versions) {
  FieldInfo info;
  const UnitInfo unit = variable.unit_in(versions);
  const ParsedValue parsed = parse_value(field_of(variable, unit, info), &unit, text);
  if (!parsed) throw ValueError(fmt::format("{}: {}", variable.name, parsed.problem));
  const auto* const raw = std::get_if<std::int64_t>(&parsed.value);
  return unit.real(raw != nullptr ? static_cast<double>(*raw) : std::get<double>(parsed.value));
}

/// Returns the raw value that results from an assignment to a variable with a present value. Throws
/// ValueError.
double read_value(const VariableInfo& variable, const Assignment& assignment, double present,
                  const Availability& versions) {
  if (assignment.change == Change::set) return read_value(variable, assignment.value, versions);
  try {
    const PresentNumber number{present, variable.unit_in(versions), true, variable.range.lowest,
                               variable.range.highest};
    const std::string text = changed_value(number, assignment.change, assignment.value);
    return read_value(variable, text, versions);
  } catch (const ValueError& error) {
    const std::string problem = error.what();
    const std::string name = std::string(variable.name) + ": ";
    throw ValueError(problem.starts_with(name) ? problem : name + problem);
  }
}

/// Returns the variables that this firmware has.
std::vector<const VariableInfo*> variables_of(const BoardIdentity& board) {
  std::vector<const VariableInfo*> result;
  for (const VariableInfo& variable : variables) {
    for (const ValueInfo& known : EnumMeta<msg::VariableId>::info.values) {
      const bool is_it = known.value == static_cast<std::int64_t>(variable.id);
      if (is_it && is_available(known.since, board.versions())) result.push_back(&variable);
    }
  }
  return result;
}

int print_variables(const VariablesToShow& options, const CommandContext& context) {
  std::vector<const VariableInfo*> wanted;
  for (const std::string& name : options.names) wanted.push_back(&variable_named(name));
  Client client = connect(context.gimbal);
  if (wanted.empty()) wanted = variables_of(client.identity());
  const Availability versions = client.identity().versions();
  std::vector<std::string> names;
  std::size_t width = 0;
  for (const VariableInfo* const variable : wanted) {
    names.emplace_back(variable->name);
    width = std::max(width, names.back().size());
  }
  const std::vector<double> values = value_of(client.get_variables(names));
  if (options.format == "json") {
    Json list = Json::array();
    for (std::size_t i = 0; i < wanted.size(); ++i) {
      const VariableInfo& variable = *wanted[i];
      const UnitInfo unit = variable.unit_in(versions);
      list.push_back({{"name", variable.name},
                      {"id", static_cast<int>(variable.id)},
                      {"value", values[i]},
                      {"unit", *unit.name == '\0' ? Json() : Json(unit.name)},
                      {"min", unit.real(variable.range.lowest)},
                      {"max", unit.real(variable.range.highest)}});
    }
    const Json document{{"format", "sbgc-variables"}, {"version", 1}, {"variables", list}};
    fmt::print("{}\n", detail::json_text(document, 2));
    return success;
  }
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    const UnitInfo unit = wanted[i]->unit_in(versions);
    fmt::print("{:<{}}  {:<14}  {}\n", names[i], width, detail::unit_text(values[i], unit),
               range_of(*wanted[i], unit));
  }
  return success;
}

/// Returns the sentences for the confirmation.
std::string what_happens(std::size_t changes, bool is_saved) {
  constexpr const char* saving =
      "all parameters in use to the active profile, so that they survive a restart";
  if (changes == 0) return fmt::format("Saves {}.", saving);
  return fmt::format("Sets {}{}{}. {} effect at once, and the camera can move.",
                     counted(changes, "variable"),
                     is_saved ? ", and saves " : " until the board restarts",
                     is_saved ? saving : "", changes == 1 ? "It takes" : "They take");
}

int set_them(const VariablesToSet& options, const CommandContext& context) {
  std::vector<VariableValue> values;
  std::vector<const VariableInfo*> wanted;
  std::vector<std::string> names;
  std::vector<Assignment> assignments;
  try {
    assignments = parse_assignments(options.values);
    for (const Assignment& assignment : assignments) {
      const VariableInfo& variable = variable_named(assignment.name);
      if (std::ranges::find(wanted, &variable) != wanted.end()) {
        throw ValueError(fmt::format("{} is set twice", variable.name));
      }
      // Most mistakes are found without a board.
      const bool is_certain = variable.later.empty() && assignment.change == Change::set;
      if (is_certain) read_value(variable, assignment.value, {});
      wanted.push_back(&variable);
      names.emplace_back(variable.name);
    }
  } catch (const ValueError& error) {
    throw CommandError(clipped(error.what()), wrong_usage);
  }
  Client client = connect(context.gimbal);
  const Availability versions = client.identity().versions();
  const std::vector<double> before = value_of(client.get_variables(names));
  try {
    for (std::size_t i = 0; i < wanted.size(); ++i) {
      values.push_back({names[i], read_value(*wanted[i], assignments[i], before[i], versions)});
    }
  } catch (const ValueError& error) {
    throw CommandError(clipped(error.what()), wrong_usage);
  }
  const auto value_in_unit = [&](const VariableInfo& variable, double value) {
    return detail::unit_text(value, variable.unit_in(versions));
  };
  std::vector<VariableValue> changed;
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    if (before[i] == values[i].value) continue;
    changed.push_back(values[i]);
    fmt::print("{}: {} -> {}\n", names[i], value_in_unit(*wanted[i], before[i]),
               value_in_unit(*wanted[i], values[i].value));
  }
  if (changed.empty()) fmt::print("nothing to change\n");
  std::fflush(stdout);
  if (changed.empty() && !options.save) return success;
  if (!changed.empty()) require_possible(client, msg::SetAdjVarsVal{}, false);
  if (options.save) require_possible(client, msg::SaveParams3{});
  arm(options.arming, what_happens(changed.size(), options.save));
  const MustFinish setting(write_bound, "the board may have some of the new values");
  if (!changed.empty()) value_of(client.set_variables(changed));
  const std::vector<double> after = value_of(client.get_variables(names));
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    if (after[i] == values[i].value) continue;
    throw CommandError(fmt::format("{} is {} on the board, although {} was set", names[i],
                                   value_in_unit(*wanted[i], after[i]),
                                   value_in_unit(*wanted[i], values[i].value)));
  }
  if (was_interrupted()) {
    throw CommandError(fmt::format("interrupted; {} set{}",
                                   values.size() == 1 ? "the variable is" : "the variables are",
                                   options.save ? ", but not saved" : ""),
                       interrupted);
  }
  if (options.save) value_of(client.save_variables());
  remark("{}\n", options.save ? "Set, read back and saved."
                              : "Set and read back; --save makes it permanent.");
  return success;
}

}  // namespace

std::vector<std::string> variable_names() {
  std::vector<std::string> names;
  for (const VariableInfo& variable : variables) names.emplace_back(variable.name);
  return names;
}

void add_vars(CLI::App& app, CommandContext& context) {
  auto* const vars = app.add_subcommand("vars", "Show and set the adjustable variables");
  vars->require_subcommand(1);
  const Subcommand<VariablesToShow> list(*vars, context, "list",
                                         "List all variables with their values and ranges");
  add_format(*list, list.options().format);
  list.examples({"sbgc vars list"});
  list.runs(print_variables);

  const Subcommand<VariablesToShow> get(*vars, context, "get", "Print variables");
  get->add_option("names", get.options().names, "Names as `vars list` prints them")
      ->type_name("VARIABLE")
      ->required();
  add_format(*get, get.options().format);
  get.examples({"sbgc vars get LPF_FREQ_ROLL P_PITCH"});
  get.runs(print_variables);

  const Subcommand<VariablesToSet> set(*vars, context, "set", "Set variables");
  set->add_option("values", set.options().values, "Names and units as `vars list` prints them")
      ->type_name("VARIABLE=VALUE")
      ->required();
  set->add_flag("--save", set.options().save, "Save the change, so that it survives a restart");
  set->footer(
      "NAME=+10% and NAME=-10% change the present value by a share, NAME+=VALUE and NAME-=VALUE "
      "by an amount.\n"
      "\n"
      "Examples:\n"
      "  sbgc vars set LPF_FREQ_ROLL=30Hz --save\n"
      "  sbgc vars set P_ROLL=+10%");
  set.runs(set_them);
}

}  // namespace sbgc::tools
