#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include <fmt/format.h>

#include <sbgc/any.hpp>
#include <sbgc/messages/parameters.hpp>
#include <sbgc/text.hpp>

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

/// Returns the text of a value that is read back as the same value.
std::string text_of(const FieldTypes& types, const Leaf& leaf) {
  const auto type = types.find(without_indices(to_string(leaf.path)));
  if (type == types.end()) return raw_text(leaf);
  return tools::settable_text(*type->second, leaf, 0, true);
}

/// The first parameter with each list of names. Others refer to it: some lists are long, and a
/// worker that makes text does not stop the camera.
using KnownNames = std::map<const EnumInfo*, std::string>;

Json to_json(const std::string& message, const FieldTypes& types, const Leaf& leaf,
             KnownNames& known) {
  const std::string path = to_string(leaf.path);
  Json names = Json::array();
  const auto [first, is_first] = known.try_emplace(leaf.names, name_of(message, path));
  if (leaf.names != nullptr && !is_first) {
    names = first->second;
  } else if (leaf.names != nullptr) {
    for (const ValueInfo& value : leaf.names->values) names.push_back({value.name, value.summary});
  }
  const auto type = types.find(without_indices(path));
  const std::int64_t initial = type == types.end() ? 0 : type->second->initial;
  Leaf usual = leaf;
  usual.integer = initial;
  Json result{{"name", name_of(message, path)},
              {"path", path},
              {"summary", leaf.field.summary},
              {"text", text_of(types, leaf)},
              {"unit", leaf.unit != nullptr ? leaf.unit->name : ""},
              {"least", Json()},
              {"most", Json()},
              {"names", std::move(names)},
              {"kind", kind_of(leaf)},
              {"general", leaf.field.role == FieldRole::general},
              {"default", initial == 0 ? "" : text_of(types, usual)}};
  if (leaf.field.range != nullptr) {
    result["least"] = limit_of(leaf, leaf.field.range->lowest);
    result["most"] = limit_of(leaf, leaf.field.range->highest);
  }
  return result;
}

/// Returns the plan without the values that change the line.
ParameterSet without_line(const ParameterSet& wanted, const ParameterSet& present) {
  ParameterSet result;
  for (const sbgc::Parameters& block : wanted.all()) {
    const sbgc::Parameters* const old = present.find(block.id);
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

}  // namespace

void report_progress(double id, double share, std::string_view text) {
  client()->report([&](JsonWriter& out) {
    out.member("progress", static_cast<std::int64_t>(id));
    out.key("of").object([&] {
      if (share >= 0) out.member("share", share);
      out.member("text", text);
    });
  });
}

void report_result(double id, const Json& result) {
  client()->report_end(
      id, "", [&](JsonWriter& out) { out.key("result").value().put(detail::json_text(result)); });
}

void Parameters::read(double id, std::string created) {
  const auto show = [id](const Progress& progress) {
    report_progress(id, static_cast<double>(progress.done) / static_cast<double>(progress.total),
                    progress.what);
    return true;
  };
  client()->passive().start(
      tasks::make_backup(std::move(created), {.progress = show}), [this, id](Result<Backup> made) {
        if (!made) return client()->report_end(id, made.error().message);
        read_ = *std::move(made);
        const auto first = read_.parameters.get<msg::ReadParams3>(0);
        const int active = first ? first->cur_profile_id : 0;
        std::uint8_t most = 1;
        for (const auto& block : read_.parameters.all()) {
          most = std::max<std::uint8_t>(most, static_cast<std::uint8_t>(block.id.copy + 1));
        }
        report_result(id, {{"active", active + 1}, {"profiles", most}});
      });
}

Json Parameters::topic(std::size_t number, std::uint8_t profile) const {
  if (number >= topic_references.size()) return {};
  const TopicReference& topic = topic_references[number];
  Json parameters = Json::array();
  KnownNames known;
  const Availability versions = read_.board.versions();
  for (const sbgc::Parameters& block : read_.parameters.all()) {
    if (copy_count(block.id) != 1 && block.id.copy != profile) continue;
    const AnyMessage message = message_in(block);
    std::optional<FieldTypes> types;
    message.for_each_leaf(
        [&](const Leaf& leaf) {
          if (topic_of(leaf.field) != &topic || leaf.kind == LeafKind::counter) return;
          if (!tools::is_settable(leaf.field)) return;
          if (!types) types = types_of(message.type());
          parameters.push_back(to_json(block.id.message, *types, leaf, known));
        },
        versions);
  }
  return {{"name", topic.name}, {"summary", topic.summary}, {"parameters", std::move(parameters)}};
}

Json Parameters::plan_values(std::string_view lines, std::uint8_t profile) {
  Problems problems;
  const Availability versions = read_.board.versions();
  std::set<std::string, std::less<>> known;
  wanted_ = {};
  validates_ = true;
  for (const sbgc::Parameters& block : read_.parameters.all()) {
    AnyMessage message = message_in(block);
    std::vector<std::string> changed;
    for_each_setting(lines, [&](std::string_view name, std::string_view value) {
      const std::string_view path = name.substr(std::min(name.find('.') + 1, name.size()));
      if (name.substr(0, name.find('.')) != block.id.message) return;
      known.emplace(name);
      bool is_general = false;
      const bool is_there = message.with_leaf(
          path, [&](const Leaf& leaf) { is_general = leaf.field.role == FieldRole::general; },
          versions);
      const bool is_here = copy_count(block.id) == 1 || block.id.copy == profile || is_general;
      if (!is_here) return;
      std::string problem =
          is_there ? message.assign(path, value, false, versions) : "the board does not have it";
      if (problem.empty()) return changed.emplace_back(path), void();
      if (is_general && block.id.copy != profile) return;  // reported once
      problems.emplace_back(name, std::move(problem));
    });
    if (changed.empty()) continue;
    message.validate(versions, [&](const Violation& violation) {
      const std::string path = to_string(violation.path);
      const bool is_own = std::find(changed.begin(), changed.end(), path) != changed.end();
      if (is_own && (copy_count(block.id) == 1 || block.id.copy == profile)) {
        problems.emplace_back(name_of(block.id.message, path), to_string(violation));
      }
    });
    if (const auto put = tools::put_message(wanted_, block.id, message); !put) {
      problems.emplace_back("", put.error().message);
    }
  }
  for_each_setting(lines, [&](std::string_view name, std::string_view) {
    if (!known.contains(name)) problems.emplace_back(name, "the board does not have it");
  });
  return planned(problems, {});
}

Json Parameters::plan_file(std::string_view text, std::uint8_t profile) {
  wanted_ = {};
  const auto fail = [&](std::string message) {
    wanted_ = {};
    return planned({{"", std::move(message)}}, {});
  };
  std::vector<std::string> remarks;
  if (text.substr(0, 1) == "<") {
    const auto file = read_elements(text);
    if (!file) return fail(file.error().message);
    auto values = tools::vendor_values(*file, read_.parameters, profile);
    if (!values) return fail(values.error().message);
    wanted_ = values->parameters;
    validates_ = true;
    for (const tools::LeftOut& one : values->left_out) {
      remarks.push_back(
          fmt::format("not taken, because {}: {}", one.reason, fmt::join(one.names, ", ")));
    }
    return planned({}, remarks);
  }
  const auto backup = parse_backup(text);
  if (!backup) return fail(backup.error().message);
  if (const auto fits = check_fit(read_.board, backup->board, {}); !fits) {
    return fail(fits.error().message);
  }
  remarks = mismatches(read_.board, backup->board);
  if (!backup->missing.empty()) {
    return fail("parameters were removed from the file: " + to_text(backup->missing));
  }
  if (const auto others = left_alone(read_.board, *backup); !others.empty()) {
    remarks.push_back("not in the file, so they stay: " + to_text(others));
  }
  wanted_ = backup->parameters;
  validates_ = false;
  return planned({}, remarks);
}

Json Parameters::plan_undo() {
  wanted_ = before_;
  validates_ = false;
  if (before_.all().empty()) return planned({{"", "nothing was written before"}}, {});
  return planned({}, {});
}

Json Parameters::planned(const Problems& problems, const std::vector<std::string>& remarks) {
  Json changes = Json::array();
  Json last = Json::array();
  const Availability versions = read_.board.versions();
  if (!problems.empty()) wanted_ = {};
  ParameterSet present;
  for (const sbgc::Parameters& block : wanted_.all()) {
    const sbgc::Parameters* const old = read_.parameters.find(block.id);
    if (old != nullptr) static_cast<void>(present.put(*old));
  }
  std::set<std::string> general;
  for (const ParametersChange& block : diff(present, wanted_, versions, versions)) {
    const sbgc::Parameters* const old = present.find(block.id);
    for (const FieldChange& field : block.fields) {
      bool is_of_line = false;
      bool is_of_all = copy_count(block.id) == 1;
      if (old != nullptr) {
        message_in(*old).with_leaf(field.path, [&](const Leaf& leaf) {
          is_of_line = changes_line(leaf.field);
          is_of_all = is_of_all || leaf.field.role == FieldRole::general;
        });
      }
      const std::string name = name_of(block.id.message, field.path);
      if (is_of_all && !general.insert(name).second) continue;
      Json change{{"name", name},
                  {"profile", is_of_all ? 0 : block.id.copy + 1},
                  {"before", field.before_meaning.empty() ? field.before : field.before_meaning},
                  {"after", field.after_meaning.empty() ? field.after : field.after_meaning},
                  {"line", is_of_line}};
      (is_of_line ? last : changes).push_back(std::move(change));
    }
  }
  for (Json& one : last) changes.push_back(std::move(one));
  Json said = Json::array();
  for (const auto& [name, sentence] : problems) said.push_back({name, sentence});
  return {{"changes", std::move(changes)}, {"problems", std::move(said)}, {"remarks", remarks}};
}

Task<WriteReport> Parameters::write_plan() {
  const WriteOptions options{.validate = validates_};
  const ParameterSet first = without_line(wanted_, read_.parameters);
  const WriteReport begun = co_await tasks::write_parameters(first, options);
  if (!begun || first == wanted_) co_return begun;
  WriteReport report = co_await tasks::write_parameters(wanted_, options);
  for (std::size_t i = 0; i < std::min(report.parameters.size(), begun.parameters.size()); ++i) {
    ParametersState& state = report.parameters[i].state;
    if (state == ParametersState::equal) state = begun.parameters[i].state;
  }
  co_return report;
}

void Parameters::write(double id, std::string created) {
  if (wanted_.all().empty()) return client()->report_end(id, "there is no plan to write");
  before_ = read_.parameters;
  const auto ended = [this, id, created = std::move(created)](const WriteReport& report) {
    Json result{{"ok", static_cast<bool>(report)}, {"text", to_text(report)}};
    const auto read = [this, id, result = std::move(result)](Result<Backup> made) mutable {
      if (made) {
        read_ = *std::move(made);
      } else {
        result["ok"] = false;
      }
      report_result(id, result);
    };
    client()->passive().start(tasks::make_backup(created), read);
  };
  client()->passive().start(write_plan(), ended);
}

std::string Parameters::backup(bool of_plan) const {
  Backup result = read_;
  if (of_plan) {
    for (const sbgc::Parameters& block : wanted_.all()) {
      static_cast<void>(result.parameters.put(block));
    }
  }
  return to_json_text(result);
}

}  // namespace sbgc::web
