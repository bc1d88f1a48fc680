// sbgc completion: completion for shells, from the same source as the help.

#include "shell/completion.hpp"

#include <algorithm>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <sbgc/client/calibrations.hpp>
#include <sbgc/io/open.hpp>
#include <sbgc/meta/all.hpp>
#include <sbgc/reference.hpp>
#include <sbgc/roles.hpp>

#include "board/configuration.hpp"
#include "board/listed_ports.hpp"
#include "command/command_error.hpp"
#include "command/command_line.hpp"
#include "command/option_values.hpp"
#include "command/subcommand.hpp"
#include "command/wording.hpp"
#include "frames/stream_type.hpp"
#include "shell/scripts.hpp"
#include "values/axis_values.hpp"
#include "values/field_lookup.hpp"
#include "values/message_names.hpp"
#include "values/search_words.hpp"

namespace sbgc::tools {

namespace {

using Candidates = std::vector<Candidate>;

/// Returns the beginning of a description, enough for a list.
std::string brief(const std::string& description) {
  return clipped(description.substr(0, description.find_first_of(".:;(\n")));
}

Candidates words(const std::vector<std::string>& names) {
  Candidates result;
  for (const std::string& name : names) result.push_back({name, ""});
  return result;
}

Candidates addresses() {
  Candidates result;
  for (const io::PortInfo& port : listed_ports().ports) {
    result.push_back({port.name, port.description});
  }
  for (const io::AddressKind& kind : io::address_kinds) {
    if (kind.leads_to_gimbal) result.push_back({std::string(kind.name) + ':', ""});
  }
  return result;
}

Candidates gimbals() {
  Candidates result;
  for (const NamedGimbal& gimbal : named_gimbals()) result.push_back({gimbal.name, gimbal.port});
  return result;
}

Candidates calibration_names() {
  Candidates result;
  for (const Calibration& one : calibrations()) result.push_back({one.name, one.info().summary});
  return result;
}

template <class E>
Candidates values_in() {
  Candidates result;
  for (const ValueInfo& value : EnumMeta<E>::info.values) {
    result.push_back({value.name, value.summary});
  }
  return result;
}

/// The words of a command line before the one to complete, and that word.
struct Place {
  const CLI::App& app;
  std::vector<std::string> arguments{};  ///< of the command
  std::string word{};
};

/// Names that can be assigned a value.
Candidates assignable(const std::vector<std::string>& names) {
  Candidates result;
  for (const std::string& name : names) result.push_back({name + '=', ""});
  return result;
}

/// Returns the paths with synonyms for their axes, such as tilt.p for pitch.p.
std::vector<std::string> with_synonyms(const std::vector<std::string>& paths) {
  std::vector<std::string> result;
  for (const std::string& path : paths) {
    for (const auto& group : synonyms) {
      for (const char* const axis : axis_names) {
        const std::string dotted = '.' + path + '.';
        const std::size_t at = dotted.find(fmt::format(".{}.", axis));
        if (at == std::string::npos) continue;
        for (const char* const word : group) {
          if (!means_same(word, axis) || word == std::string_view(axis)) continue;
          result.push_back(std::string(path).replace(at, std::string_view(axis).size(), word));
        }
      }
    }
  }
  return result;
}

/// Returns the paths of parameters, and unambiguous ends of them, as on the command line; and
/// synonyms for the axes, once one is begun.
std::vector<std::string> parameter_words(const Place& place) {
  const std::vector<std::string> paths = parameter_names();
  std::map<std::string, unsigned> ends;
  for (const std::string& path : paths) {
    for (std::size_t dot = path.find('.'); dot != std::string::npos;
         dot = path.find('.', dot + 1)) {
      ++ends[path.substr(dot + 1)];
    }
  }
  std::vector<std::string> result = paths;
  for (const auto& [end, count] : ends) {
    if (count == 1) result.push_back(end);
  }
  if (place.word.empty()) return result;
  for (std::string& path : with_synonyms(result)) result.push_back(std::move(path));
  return result;
}

/// Returns "FIELD=" for the fields of a message, or after "FIELD=" the names of its values.
Candidates field_values(const std::string& message, const std::string& word) {
  Candidates result;
  const std::size_t equals = word.find('=');
  if (equals == std::string::npos) return assignable(field_names(message));
  for (const MessageType* const form : messages_named(message, Direction::to_board)) {
    std::vector<FoundField> found;
    try {
      found = find_fields(form->fields(), word.substr(0, equals));
    } catch (const ValueError&) {
      continue;  // it is not a single field
    }
    if (found.empty()) continue;
    const FieldType& type = *found.front().type;
    const auto add = [&](const EnumInfo* names) {
      if (names == nullptr) return;
      for (const ValueInfo& value : names->values) {
        result.push_back({word.substr(0, equals + 1) + value.name, value.summary});
      }
    };
    add(type.names);
    if (type.packed == nullptr) continue;
    for (const PartInfo& part : type.packed->parts) add(part.values);
  }
  return result;
}

/// Synonyms for topics and axes, once one is begun: they would only lengthen a whole list.
Candidates topic_synonyms(const Place& place) {
  Candidates result;
  if (place.word.empty()) return result;
  for (const TopicReference& topic : topic_references) {
    for (const char* const word : topic.words) result.push_back({word, topic.summary});
  }
  for (const std::string& word : with_synonyms({axis_names.begin(), axis_names.end()})) {
    result.push_back({word, ""});
  }
  return result;
}

Candidates topics(const Place& place) {
  Candidates result = topic_synonyms(place);
  for (const TopicReference& topic : topic_references) {
    result.push_back({topic.name, topic.summary});
  }
  return result;
}

Candidates described(const Place& place) {
  Candidates result = topic_synonyms(place);
  for (Candidate& word : words(described_words())) result.push_back(std::move(word));
  return result;
}

Candidates streams() {
  Candidates result;
  for (const MessageType* const type : stream_types()) {
    result.push_back({type->info->name, type->info->summary});
  }
  return result;
}

/// Completes a list: the last of the words between these separators is one of the names.
Candidates list_items(const std::vector<std::string>& names, const std::string& word,
                      const char* separators) {
  const std::string before = word.substr(0, word.find_last_of(separators) + 1);
  Candidates result;
  for (const std::string& name : names) result.push_back({before + name, ""});
  return result;
}

/// Returns the kind of stream that the command line names, if any.
std::optional<StreamType> stream_of(const Place& place) {
  if (place.arguments.empty()) return std::nullopt;
  try {
    return StreamType::find(place.arguments[0]);
  } catch (const CommandError&) {
    return std::nullopt;
  }
}

/// Returns all fields that samples of a stream can have.
Candidates sample_fields(const Place& place) {
  std::optional<StreamType> stream = stream_of(place);
  if (!stream) return {};
  stream->configure_for("*");
  std::vector<std::string> paths;
  for (const StreamField& field : stream->fields()) paths.push_back(field.path);
  return list_items(paths, place.word, ",");
}

/// Returns the flags that select the contents of samples.
Candidates sample_flags(const Place& place) {
  const std::optional<StreamType> stream = stream_of(place);
  return stream ? list_items(stream->flags(), place.word, ",|") : Candidates();
}

/// Returns the words of a type such as "rest|drone|FILE".
Candidates choices_in(std::string_view type) {
  Candidates result;
  while (!type.empty()) {
    const std::string_view one = type.substr(0, type.find('|'));
    const bool is_file = one == "FILE";
    const bool is_word = std::ranges::none_of(one, [](char c) { return c >= 'A' && c <= 'Z'; });
    if (is_file || is_word) result.push_back({std::string(is_file ? files_directive : one), ""});
    type.remove_prefix(std::min(one.size() + 1, type.size()));
  }
  return result;
}

Candidates commands(const CLI::App& app) {
  Candidates result;
  for (const CLI::App* const one : subcommands_of(app)) {
    result.push_back({one->get_name(), one->get_description()});
  }
  return result;
}

/// Returns the values of an option or argument, by the name of its type.
Candidates values_of(const CLI::Option& option, const Place& place) {
  if (const auto choices = choices_of(option); !choices.empty()) return words(choices);
  using Source = std::function<Candidates(const Place&)>;
  static const std::map<std::string, Source> sources{
      {"ADDRESS", [](const Place&) { return addresses(); }},
      {"GIMBAL", [](const Place&) { return gimbals(); }},
      {"MESSAGE", [](const Place&) { return words(message_names()); }},
      {"STREAM", [](const Place&) { return streams(); }},
      {"ACTION", [](const Place&) { return values_in<msg::MenuCommand>(); }},
      {"STIMULUS", [](const Place&) { return values_in<msg::BodeStimulus>(); }},
      {"SYSTEM", [](const Place&) { return values_in<msg::BodeSystem>(); }},
      {"PARAMETER", [](const Place& place) { return words(parameter_words(place)); }},
      {"PARAMETER=VALUE", [](const Place& place) { return assignable(parameter_words(place)); }},
      {"VARIABLE", [](const Place&) { return words(variable_names()); }},
      {"VARIABLE=VALUE", [](const Place&) { return assignable(variable_names()); }},
      {"FIELD=VALUE",
       [](const Place& place) {
         return place.arguments.empty() ? Candidates()
                                        : field_values(place.arguments[0], place.word);
       }},
      {"WORDS", topics},
      {"WORD", described},
      {"NAME[:WITH]", [](const Place&) { return streams(); }},
      {"CALIBRATION", [](const Place&) { return calibration_names(); }},
      {"FIELDS", sample_fields},
      {"FLAGS", sample_flags},
      {"COMMAND", [](const Place& place) { return commands(place.app); }},
  };
  const std::string type = value_name(option);
  if (type == "FILE" || type == "FOLDER") return {{std::string(files_directive), ""}};
  if (type.find('|') != std::string::npos) return choices_in(type);
  const auto source = sources.find(type);
  return source == sources.end() ? Candidates() : source->second(place);
}

void add_options(const CLI::App& command, Candidates& result) {
  for (const CLI::Option* const option : options_of(command)) {
    for (const std::string& name : option->get_lnames()) {
      result.push_back({"--" + name, option->get_description()});
    }
  }
}

/// The command and option that the words before the last one select.
struct ChosenCommand {
  const CLI::App* command = nullptr;
  std::vector<std::string> arguments{};
  const CLI::Option* awaiting = nullptr;  ///< the option whose value comes next
};

ChosenCommand chosen_by(const CLI::App& app, const std::vector<std::string>& line) {
  ChosenCommand result{.command = &app};
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    const std::string& word = line[i];
    if (result.awaiting != nullptr) {
      result.awaiting = nullptr;
    } else if (word.starts_with('-') && word != "-") {
      const CLI::Option* const option =
          result.command->get_option_no_throw(word.substr(0, word.find('=')));
      if (option != nullptr && takes_value(*option) && word.find('=') == std::string::npos) {
        result.awaiting = option;
      }
    } else if (const CLI::App* const nested = find_subcommand(*result.command, word)) {
      result.command = nested;
    } else {
      result.arguments.push_back(word);
    }
  }
  return result;
}

/// Returns all possible words at the position.
Candidates complete(const CLI::App& app, const std::vector<std::string>& line) {
  const auto [command, arguments, awaiting] = chosen_by(app, line);
  const Place place{app, arguments, line.empty() ? "" : line.back()};
  if (awaiting != nullptr) return values_of(*awaiting, place);
  Candidates result;
  if (!line.empty() && line.back().starts_with('-')) {
    add_options(*command, result);
    return result;
  }
  result = commands(*command);
  const auto positional = arguments_of(*command);
  if (!positional.empty()) {
    const std::size_t index = std::min(arguments.size(), positional.size() - 1);
    const bool has_place =
        index == arguments.size() || positional[index]->get_items_expected_max() > 1;
    if (has_place) {
      for (Candidate& value : values_of(*positional[index], place)) result.push_back(value);
    }
  }
  return result;
}

/// Prints the candidates, one per line, with descriptions after a tab.
void print_candidates(const CLI::App& app, const std::vector<std::string>& line) {
  for (const Candidate& candidate : candidates_for(app, line)) {
    fmt::print("{}\t{}\n", candidate.word, candidate.description);
  }
}

struct CompletionOptions {
  std::string shell{};
};

struct WordsToComplete {
  std::vector<std::string> words{};
};

}  // namespace

Candidates candidates_for(const CLI::App& app, const std::vector<std::string>& line) {
  const std::string word = line.empty() ? "" : line.back();
  Candidates result;
  for (const Candidate& candidate : complete(app, line)) {
    const bool fits = candidate.word.starts_with(word) || candidate.word == files_directive;
    // No shell shows or inserts other words unchanged.
    const bool is_plain = clipped(candidate.word) == candidate.word;
    const bool is_new = std::ranges::find(result, candidate.word, &Candidate::word) == result.end();
    if (fits && is_plain && is_new)
      result.push_back({candidate.word, brief(candidate.description)});
  }
  return result;
}

const CLI::App& command_of(const CLI::App& app, const std::vector<std::string>& line) {
  std::vector<std::string> and_next = line;
  and_next.emplace_back();
  return *chosen_by(app, and_next).command;
}

void add_completion(CLI::App& app, CommandContext& context) {
  const Subcommand<CompletionOptions> command(app, context, "completion",
                                              "Print the completion script of a shell");
  auto& options = command.options();
  command->add_option("shell", options.shell, "The shell")
      ->required()
      ->transform(one_of({"bash", "zsh", "fish"}));
  command->footer(
      "An installed sbgc has completion. Otherwise:\n"
      "  bash:  source <(sbgc completion bash)\n"
      "  zsh:   sbgc completion zsh > ~/.zfunc/_sbgc\n"
      "  fish:  sbgc completion fish > ~/.config/fish/completions/sbgc.fish");
  command.runs([](const CompletionOptions& chosen) {
    fmt::print("{}", completion_script(chosen.shell));
    return success;
  });

  // The scripts call this.
  const Subcommand<WordsToComplete> hidden(app, context, std::string(complete_command));
  hidden->group("")->add_option("words", hidden.options().words);
  hidden.runs([&app](const WordsToComplete& chosen) {
    print_candidates(app, chosen.words);
    return success;
  });
}

}  // namespace sbgc::tools
