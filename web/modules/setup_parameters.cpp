// Exports of the module `setup` for the parameters of the board.

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include <fmt/format.h>

#include <sbgc/any.hpp>
#include <sbgc/client/backup_tasks.hpp>
#include <sbgc/messages/parameters.hpp>
#include <sbgc/text.hpp>

#include "modules/client.hpp"
#include "modules/exchange.hpp"
#include "modules/message_form.hpp"
#include "modules/settable_text.hpp"
#include "modules/setup.hpp"
#include "parameters/parameter_blocks.hpp"
#include "parameters/vendor_file.hpp"
#include "parameters/vendor_values.hpp"
#include "values/search_words.hpp"

namespace sbgc::web {

namespace {

using tools::copy_count;
using tools::FieldTypes;
using tools::message_in;
using tools::types_of;
using tools::without_indices;

struct State {
  Backup read{};          // the parameters of the board
  ParameterSet before{};  // those before the last write
  ParameterSet wanted{};  // the blocks of the plan
  bool validates = true;  // false for values that a board has held
};

State& state() {
  static State value;
  return value;
}

std::uint8_t index_of(double profile) { return static_cast<std::uint8_t>(profile - 1); }

/// True for the blocks of a profile, and those that are the same in all of them.
bool is_in(const ParametersId& id, std::uint8_t profile) {
  return copy_count(id) == 1 || id.copy == profile;
}

std::string name_of(const std::string& message, const std::string& path) {
  return message + '.' + path;
}

/// Returns the topic in which a parameter is shown; null if there is none. Finding it compares
/// words.
const TopicReference* topic_of(const FieldInfo& field) {
  static std::map<const FieldInfo*, const TopicReference*> known;
  const auto [place, is_new] = known.try_emplace(&field, nullptr);
  if (is_new) {
    const auto topics = tools::topics_of(field);
    if (!topics.empty()) place->second = topics.front();
  }
  return place->second;
}

bool changes_line(const FieldInfo& field) {
  const TopicReference* const topic = topic_of(field);
  return topic != nullptr && topic->changes_line;
}

/// Returns a raw limit in the unit of the value.
double limit_of(const Leaf& leaf, double raw) {
  return leaf.unit != nullptr ? leaf.unit->real(raw) : raw;
}

const char* kind_of(const Leaf& leaf) {
  if (leaf.kind == LeafKind::text) return "text";
  if (leaf.kind == LeafKind::bytes) return "bytes";
  if (leaf.names == nullptr) return leaf.packed != nullptr ? "flags" : "number";
  return leaf.names->is_flags ? "flags" : "enum";
}

/// The first parameter with each list of names. Others refer to it: some lists are long, and a
/// worker that makes text does not stop the camera.
using KnownNames = std::map<const EnumInfo*, std::string>;

Json to_json(const std::string& message, const FieldType& type, const Leaf& leaf,
             KnownNames& known) {
  const std::string path = to_string(leaf.path);
  Json names = Json::array();
  const auto [first, is_first] = known.try_emplace(leaf.names, name_of(message, path));
  if (leaf.names != nullptr && !is_first) {
    names = first->second;
  } else if (leaf.names != nullptr) {
    for (const ValueInfo& value : leaf.names->values) names.push_back({value.name, value.summary});
  }
  const auto text_of = [&](const Leaf& value) {
    return tools::settable_text(type, value, 0, true);
  };
  Leaf usual = leaf;
  usual.integer = type.initial;
  Json result{{"name", name_of(message, path)},
              {"path", path},
              {"summary", leaf.field.summary},
              {"text", text_of(leaf)},
              {"unit", leaf.unit != nullptr ? leaf.unit->name : ""},
              {"least", Json()},
              {"most", Json()},
              {"names", std::move(names)},
              {"kind", kind_of(leaf)},
              {"general", leaf.field.role == FieldRole::general},
              {"default", type.initial == 0 ? "" : text_of(usual)}};
  if (leaf.field.range != nullptr) {
    result["least"] = limit_of(leaf, leaf.field.range->lowest);
    result["most"] = limit_of(leaf, leaf.field.range->highest);
  }
  return result;
}

/// Returns the plan without the values that change the line.
ParameterSet without_line(const ParameterSet& wanted, const ParameterSet& present) {
  ParameterSet result;
  for (const Parameters& block : wanted.all()) {
    const Parameters* const old = present.find(block.id);
    AnyMessage message = message_in(block);
    if (old != nullptr) {
      message_in(*old).for_each_leaf([&](const Leaf& leaf) {
        if (!changes_line(leaf.field)) return;
        static_cast<void>(message.assign(to_string(leaf.path), "raw:" + raw_text(leaf), false));
      });
    }
    static_cast<void>(tools::put_message(result, block.id, message));
  }
  return result;
}

/// Reads the lines that src/page/setup/parameters.tsx makes of a file: <NAME, =TEXT and >.
Result<tools::VendorFile> read_elements(std::string_view lines) {
  tools::VendorElements elements;
  while (!lines.empty() && !elements.has_failed()) {
    std::string_view line = take_until('\n', lines);
    if (line.empty()) continue;
    const char kind = line.front();
    line.remove_prefix(1);
    if (kind == '<') elements.open(line);
    if (kind == '=') elements.text(line);
    if (kind == '>') elements.close();
  }
  return elements.finish();
}

/// Plans to write these values, and outputs what differs from the board.
void put_plan(const ParameterSet& wanted, bool validates, const Json& remarks = Json::array(),
              const Json& problems = Json::array()) {
  state().wanted = wanted;
  state().validates = validates;
  Json changes = Json::array();
  Json last = Json::array();
  const Availability versions = state().read.board.versions();
  std::set<std::string> general;
  for (const ParametersChange& block : diff(state().read.parameters, wanted, versions, versions)) {
    for (const FieldChange& field : block.fields) {
      bool is_of_line = false;
      bool is_of_all = copy_count(block.id) == 1;
      message_in(*wanted.find(block.id)).with_leaf(field.path, [&](const Leaf& leaf) {
        is_of_line = changes_line(leaf.field);
        is_of_all = is_of_all || leaf.field.role == FieldRole::general;
      });
      const std::string name = name_of(block.id.message, field.path);
      if (is_of_all && !general.insert(name).second) continue;
      (is_of_line ? last : changes)
          .push_back(
              {{"name", name},
               {"profile", is_of_all ? 0 : block.id.copy + 1},
               {"before", field.before_meaning.empty() ? field.before : field.before_meaning},
               {"after", field.after_meaning.empty() ? field.after : field.after_meaning},
               {"line", is_of_line}});
    }
  }
  for (Json& one : last) changes.push_back(std::move(one));
  put({{"changes", changes}, {"problems", problems}, {"remarks", remarks}});
}

/// There is no plan if there are problems: pairs of a name and a sentence.
void put_problems(const Json& problems) { put_plan({}, true, Json::array(), problems); }
void put_problem(const std::string& sentence) {
  put_problems(Json::array({Json::array({"", sentence})}));
}

void plan_vendor_file(std::string_view text, std::uint8_t profile) {
  const auto file = read_elements(text);
  if (!file) return put_problem(file.error().message);
  auto values = tools::vendor_values(*file, state().read.parameters, profile);
  if (!values) return put_problem(values.error().message);
  Json remarks = Json::array();
  for (const tools::LeftOut& one : values->left_out) {
    remarks.push_back(
        fmt::format("not taken, because {}: {}", one.reason, fmt::join(one.names, ", ")));
  }
  put_plan(values->parameters, true, remarks);
}

void plan_backup(std::string_view text) {
  const BoardIdentity& board = state().read.board;
  const auto backup = parse_backup(text);
  if (!backup) return put_problem(backup.error().message);
  if (const auto fits = check_fit(board, backup->board, {}); !fits) {
    return put_problem(fits.error().message);
  }
  if (!backup->missing.empty()) {
    return put_problem("parameters were removed from the file: " + to_text(backup->missing));
  }
  Json remarks = mismatches(board, backup->board);
  if (const auto others = left_alone(board, *backup); !others.empty()) {
    remarks.push_back("not in the file, so they stay: " + to_text(others));
  }
  put_plan(backup->parameters, false, remarks);
}

Task<Result<Json>> read(double id, std::string created) {
  const auto show = [id](const Progress& progress) {
    report_progress(id, static_cast<double>(progress.done) / static_cast<double>(progress.total),
                    progress.what);
    return true;
  };
  Result<Backup> made = co_await tasks::make_backup(std::move(created), {.progress = show});
  if (!made) co_return made.error();
  state().read = *std::move(made);
  const ParameterSet& parameters = state().read.parameters;
  const auto first = parameters.get<msg::ReadParams3>(0);
  int profiles = 1;
  for (const auto& block : parameters.all()) profiles = std::max(profiles, block.id.copy + 1);
  co_return Json{{"active", (first ? first->cur_profile_id : 0) + 1}, {"profiles", profiles}};
}

/// Writes the plan, line settings last.
Task<WriteReport> write_plan() {
  const ParameterSet wanted = state().wanted;
  const WriteOptions options{.validate = state().validates};
  const ParameterSet first = without_line(wanted, state().read.parameters);
  const WriteReport begun = co_await tasks::write_parameters(first, options);
  if (!begun || first == wanted) co_return begun;
  WriteReport report = co_await tasks::write_parameters(wanted, options);
  for (std::size_t i = 0; i < std::min(report.parameters.size(), begun.parameters.size()); ++i) {
    ParametersState& state = report.parameters[i].state;
    if (state == ParametersState::equal) state = begun.parameters[i].state;
  }
  co_return report;
}

/// Writes the plan, and reads everything again.
Task<Result<Json>> write(std::string created) {
  state().before = state().read.parameters;
  const WriteReport report = co_await write_plan();
  Result<Backup> made = co_await tasks::make_backup(std::move(created));
  const bool is_read = static_cast<bool>(made);
  if (is_read) state().read = *std::move(made);
  co_return Json{{"ok", is_read && report}, {"text", to_text(report)}};
}

}  // namespace

void forget_parameters() { state() = {}; }

/// Reads all parameters, and reports the active profile; the input is the time, for backups.
SBGC_EXPORT(setup_read) void setup_read(double id) {
  start(id, read(id, std::string(input_text())));
}

/// Outputs a topic, from 0, with its parameters in a profile; null after the last topic.
SBGC_EXPORT(setup_topic) void setup_topic(double number, double profile) {
  const auto index = static_cast<std::size_t>(number);
  if (index >= topic_references.size()) return put(Json());
  const TopicReference& topic = topic_references[index];
  Json parameters = Json::array();
  KnownNames known;
  for (const Parameters& block : state().read.parameters.all()) {
    if (!is_in(block.id, index_of(profile))) continue;
    const AnyMessage message = message_in(block);
    std::optional<FieldTypes> types;
    message.for_each_leaf(
        [&](const Leaf& leaf) {
          if (topic_of(leaf.field) != &topic || leaf.kind == LeafKind::counter) return;
          if (!tools::is_settable(leaf.field)) return;
          if (!types) types = types_of(message.type());
          const FieldType& type = *types->at(without_indices(to_string(leaf.path)));
          parameters.push_back(to_json(block.id.message, type, leaf, known));
        },
        state().read.board.versions());
  }
  put({{"name", topic.name}, {"summary", topic.summary}, {"parameters", std::move(parameters)}});
}

/// Plans the values in the input, a line MESSAGE.PATH=TEXT each. The output is the plan.
SBGC_EXPORT(setup_plan) void setup_plan(double profile) {
  Json problems = Json::array();
  const Availability versions = state().read.board.versions();
  std::set<std::string, std::less<>> known;
  ParameterSet wanted;
  for (const Parameters& block : state().read.parameters.all()) {
    const bool is_own = is_in(block.id, index_of(profile));
    const auto object = [&](std::string_view name, std::string problem) {
      // General values are in each profile, but their problems are told once.
      if (is_own) problems.push_back(Json::array({name, std::move(problem)}));
    };
    AnyMessage message = message_in(block);
    std::set<std::string, std::less<>> changed;
    for_each_setting(input_text(), [&](std::string_view name, std::string_view value) {
      std::string_view path = name;
      if (take_until('.', path) != block.id.message) return;
      known.emplace(name);
      bool is_general = false;
      const bool is_there = message.with_leaf(
          path, [&](const Leaf& leaf) { is_general = leaf.field.role == FieldRole::general; },
          versions);
      if (!is_own && !is_general) return;
      std::string problem =
          is_there ? message.assign(path, value, false, versions) : "the board does not have it";
      if (!problem.empty()) return object(name, std::move(problem));
      changed.emplace(path);
    });
    if (changed.empty()) continue;
    message.validate(versions, [&](const Violation& violation) {
      const std::string path = to_string(violation.path);
      if (changed.contains(path)) object(name_of(block.id.message, path), to_string(violation));
    });
    if (const auto put = tools::put_message(wanted, block.id, message); !put) {
      problems.push_back(Json::array({"", put.error().message}));
    }
  }
  for_each_setting(input_text(), [&](std::string_view name, std::string_view) {
    if (known.contains(name)) return;
    problems.push_back(Json::array({name, "the board does not have it"}));
  });
  if (!problems.empty()) return put_problems(problems);
  put_plan(wanted, true);
}

/// Plans the file in the input: a backup, or the elements of one of the vendor's program.
SBGC_EXPORT(setup_plan_file) void setup_plan_file(double profile) {
  const std::string_view text = input_text();
  if (text.substr(0, 1) == "<") return plan_vendor_file(text, index_of(profile));
  plan_backup(text);
}

/// Plans to restore the parameters from before the last write.
SBGC_EXPORT(setup_plan_undo) void setup_plan_undo() {
  if (state().before.all().empty()) return put_problem("nothing was written before");
  put_plan(state().before, false);
}

/// Makes the next undo go back to the parameters that were read last.
SBGC_EXPORT(setup_remember) void setup_remember() { state().before = state().read.parameters; }

/// Writes the plan; the input is the time.
SBGC_EXPORT(setup_write) void setup_write(double id) {
  if (state().wanted.all().empty()) return client()->report_end(id, "there is no plan to write");
  start(id, write(std::string(input_text())));
}

/// The output is a backup of the board, or with `of_plan` of the board with the plan.
SBGC_EXPORT(setup_backup) void setup_backup(double of_plan) {
  Backup result = state().read;
  if (of_plan != 0) {
    for (const Parameters& block : state().wanted.all()) {
      static_cast<void>(result.parameters.put(block));
    }
  }
  tools::exchange().output = to_json_text(result);
}

}  // namespace sbgc::web
