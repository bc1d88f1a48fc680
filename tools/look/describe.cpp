// sbgc describe: the reference in the terminal.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include <fmt/format.h>

#include <sbgc/internal/suggestions.hpp>
#include <sbgc/internal/words.hpp>
#include <sbgc/meta/variables.hpp>
#include <sbgc/reference.hpp>
#include <sbgc/text.hpp>

#include "command/subcommand.hpp"
#include "command/terminal_text.hpp"
#include "command/wording.hpp"
#include "values/effect_text.hpp"
#include "values/field_lookup.hpp"
#include "values/field_text.hpp"
#include "values/message_json.hpp"
#include "values/message_names.hpp"
#include "values/search_words.hpp"

namespace sbgc::tools {

namespace {

struct DescribeOptions {
  std::vector<std::string> words{};
};

/// Returns the reference of a message: one entry for each direction in which it travels.
std::vector<const MessageReference*> references_of(const MessageInfo& info) {
  std::vector<const MessageReference*> found;
  for (const MessageReference& reference : message_references) {
    if (std::string_view(info.name) == reference.name) found.push_back(&reference);
  }
  return found;
}

/// Returns the description of a message; "" if it has none.
std::string_view description_of(const MessageInfo& info) {
  for (const MessageReference* const reference : references_of(info)) {
    if (*reference->description != '\0') return reference->description;
  }
  return "";
}

const char* summary_of_type(std::string_view name) {
  const auto* const found = std::ranges::find(type_references, name, &TypeReference::name);
  return found != std::end(type_references) ? found->summary : "";
}

/// Prints text wrapped at the width of the terminal.
class PageText {
 public:
  void heading(std::string_view text, std::string_view rest = "") const {
    fmt::print("{}{}\n", colors_(Color::bold, text), rest);
  }
  void paragraph(std::string_view text, std::size_t indent) const {
    if (text.empty()) return;
    fmt::print("{:{}}{}\n", "", indent, wrapped(text, line_width(), indent, indent));
  }
  /// Prints a name in a column of `width` characters, and a text next to it or below.
  void entry(std::string_view name, std::string_view text, std::size_t indent,
             std::size_t width) const {
    // A narrow column after the name is hard to read: then the text goes below it.
    constexpr std::size_t narrow = 24;
    const bool is_below = line_width() < indent + width + narrow;
    const std::size_t column = indent + (is_below ? 2 : width);
    if (text.empty()) return fmt::print("{:{}}{}\n", "", indent, colors_(Color::cyan, name));
    const std::string body = wrapped(text, line_width(), column, column);
    if (is_below || name.size() + 2 > width) {
      fmt::print("{:{}}{}\n{:{}}{}\n", "", indent, colors_(Color::cyan, name), "", column, body);
    } else {
      fmt::print("{:{}}{}{:{}}{}\n", "", indent, colors_(Color::cyan, name), "",
                 width - name.size(), body);
    }
  }
  void gap() const { fmt::print("\n"); }

 private:
  Colors colors_{stdout};
};

// ---- Messages ----

/// A field with its position in the body.
struct PlacedField {
  std::string path{};
  std::string offset{};  ///< "" if it depends on other values
  const FieldType* type = nullptr;
};

/// The positions of a field: one for each axis.
using Offsets = std::optional<std::vector<std::size_t>>;

std::string offsets_text(const Offsets& offsets) {
  if (!offsets) return "";
  if (offsets->size() <= 3) return fmt::format("{}", fmt::join(*offsets, ", "));
  return fmt::format("{}, {}, ...", offsets->at(0), offsets->at(1));
}

/// Collects the values of a message with their positions.
class Layout {
 public:
  explicit Layout(const std::vector<FieldType>& members) {
    members_at(members, "", std::vector<std::size_t>{0});
  }
  std::vector<PlacedField> take() { return std::move(fields_); }

 private:
  /// Returns the offsets after the members.
  Offsets members_at(const std::vector<FieldType>& members, const std::string& path, Offsets at) {
    for (const FieldType& member : members) {
      // Conditions determine whether a field is present, so its position is not fixed.
      if (member.is_optional) at.reset();
      field_at(member, path.empty() ? member.name : path + '.' + member.name, at);
      if (member.size == 0) at.reset();
      if (at) {
        for (std::size_t& offset : *at) offset += member.size;
      }
    }
    return at;
  }

  void field_at(const FieldType& type, const std::string& path, const Offsets& at) {
    if (type.shape == FieldShape::group) {
      if (type.info != nullptr && *type.info->summary != '\0') fields_.push_back({path, "", &type});
      std::size_t sum = 0;
      for (const FieldType& member : type.members) sum += member.size;
      members_at(type.members, path, sum == type.size ? at : Offsets{});
      return;
    }
    const bool has_groups = type.has_elements() && type.members.front().shape != FieldShape::list;
    if (type.shape == FieldShape::axes ||
        (has_groups && type.members.front().shape == FieldShape::group)) {
      const bool is_axes = type.shape == FieldShape::axes;
      const std::string name =
          is_axes ? fmt::format("{}.{}", path, fmt::join(type.axes, "|")) : path + "[]";
      return field_at(type.members.front(), name, element_offsets(type, at));
    }
    fields_.push_back({path, offsets_text(at), &type});
  }

  static Offsets element_offsets(const FieldType& type, const Offsets& at) {
    const std::size_t size = type.members.front().size;
    if (!at || size == 0) return std::nullopt;
    std::vector<std::size_t> result;
    for (const std::size_t offset : *at) {
      for (std::size_t i = 0; i < type.count; ++i) result.push_back(offset + i * size);
    }
    return result;
  }

  std::vector<PlacedField> fields_{};
};

std::string size_text(const MessageInfo& info) {
  if (info.min_size == info.max_size) return counted(info.max_size, "byte");
  return fmt::format("{} to {} bytes", info.min_size, info.max_size);
}

const char* direction_text(Direction direction) {
  switch (direction) {
    case Direction::to_board: return "to the board";
    case Direction::from_board: return "from the board";
    case Direction::both: break;
  }
  return "in both directions";
}

std::string answer_text(const MessageInfo& info, const MessageReference& reference) {
  std::string result = fmt::format("{}", fmt::join(info.answers, " or "));
  const std::string_view confirm = reference.confirm;
  if (confirm == "always" || confirm == "possible") {
    const std::string number = reference.confirmations > 1
                                   ? fmt::format("{} confirmations", reference.confirmations)
                                   : std::string("a confirmation");
    result +=
        (result.empty() ? "" : ", ") + (confirm == "possible" ? "possibly " + number : number);
  }
  if (result.empty()) return "none";
  result += fmt::format(" within {} ms", reference.timeout_ms);
  return result + (reference.is_repeatable ? "; may be repeated" : "; must not be repeated");
}

/// Prints the facts of a field on as many lines as they need.
void print_facts(const PageText& page, const FieldType& type, std::string facts,
                 std::size_t indent) {
  for (const std::string& fact : field_facts(type)) facts += (facts.empty() ? "" : "; ") + fact;
  page.paragraph(facts, indent);
}

void print_fields(const PageText& page, const std::vector<FieldType>& members) {
  bool is_first = true;
  for (const PlacedField& field : Layout(members).take()) {
    if (field.type->is_tail()) continue;
    if (is_first) page.gap();
    is_first = false;
    const FieldInfo* const info = field.type->info;
    const bool has_other_name = info != nullptr && *info->spec_name != '\0' &&
                                !detail::is_same_word(info->spec_name, info->name);
    page.entry(has_other_name ? fmt::format("{} ({})", field.path, info->spec_name) : field.path,
               "", 4, 0);
    if (field.type->shape == FieldShape::group) {
      page.paragraph(info->summary, 8);
      continue;
    }
    if (info != nullptr) page.paragraph(info->summary, 8);
    std::string type = type_text(*field.type);
    if (!field.offset.empty()) type += " at " + field.offset;
    print_facts(page, *field.type, type, 8);
  }
}

void print_message(const PageText& page, const MessageType& type, bool is_described = true) {
  const MessageInfo& info = *type.info;
  page.heading(info.name, fmt::format("  {}, {}", direction_text(info.direction), size_text(info)));
  const std::vector<const MessageReference*> references = references_of(info);
  for (const MessageReference* const reference : references) {
    const bool is_one_way = references.size() > 1;
    page.paragraph((is_one_way ? std::string(direction_text(reference->direction)) + ": " : "") +
                       reference->summary,
                   2);
    if (is_described) page.paragraph(reference->description, 2);
  }
  constexpr std::size_t width = 12;
  if (info.direction != Direction::from_board) {
    page.entry("effect", effect_words(info.effects) + ". " + effect_text(info.effects), 2, width);
    for (const MessageReference* const reference : references) {
      if (*reference->confirm == '\0') continue;
      page.entry("response", answer_text(info, *reference), 2, width);
    }
  }
  if (*info.stores != '\0') page.entry("stores", info.stores, 2, width);
  if (const std::string since = versions_text(info.since); !since.empty()) {
    page.entry("since", since, 2, width);
  }
  if (const std::string until = versions_text(info.until); !until.empty()) {
    page.entry("until", until, 2, width);
  }
  for (const MessageReference* const reference : references) {
    if (*reference->replaced_by == '\0') continue;
    page.entry("deprecated", std::string("use ") + reference->replaced_by, 2, width);
  }
  if (info.unconfirmed) page.entry("certainty", "from a single source, or contradicted", 2, width);
  print_fields(page, type.fields());
}

bool print_command(const PageText& page, const CommandReference& command) {
  page.heading(
      command.name,
      fmt::format("  {}{}", command.id < 0 ? "id unknown" : fmt::format("id {}", command.id),
                  fmt::format(", {}", command.family)));
  page.paragraph(command.summary, 2);
  bool has_messages = false;
  std::string_view described;
  for (const MessageType* const type : message_types()) {
    if (std::string_view(type->info->command) != command.name) continue;
    page.gap();
    const std::string_view description = description_of(*type->info);
    print_message(page, *type, description != described);
    described = description;
    has_messages = true;
  }
  if (!has_messages) page.paragraph("The specification does not describe its messages.", 2);
  return true;
}

// ---- Enums and packed values ----

/// An enum, a flag set or a packed value, and the fields that use it.
struct NamedType {
  std::string_view name{};
  const EnumInfo* names = nullptr;
  const PackedInfo* packed = nullptr;
  std::vector<std::string> uses{};
};

/// Returns all of them, by name.
std::vector<NamedType> named_types() {
  std::vector<NamedType> types;
  const auto add = [&](std::string_view name, const EnumInfo* names, const PackedInfo* packed,
                       const std::string& use) {
    auto found = std::ranges::find(types, name, &NamedType::name);
    if (found == types.end()) {
      types.push_back({name, names, packed, {}});
      found = types.end() - 1;
    }
    const bool is_new = std::ranges::find(found->uses, use) == found->uses.end();
    if (is_new) found->uses.push_back(use);
  };
  for (const MessageType* const message : message_types()) {
    for_each_field(message->fields(), [&](const std::vector<WayStep>& way, const FieldType& type) {
      if (type.names == nullptr && type.packed == nullptr) return;
      const std::string use = fmt::format("{}.{}", message->info->name, way_text(way));
      if (type.names != nullptr) add(type.names->name, type.names, nullptr, use);
      if (type.packed == nullptr) return;
      add(type.packed->name, nullptr, type.packed, use);
      if (type.packed->names != nullptr) {
        add(type.packed->names->name, type.packed->names, nullptr, use);
      }
      for (const PartInfo& part : type.packed->parts) {
        if (part.values != nullptr) add(part.values->name, part.values, nullptr, use);
      }
    });
  }
  std::ranges::sort(types, {}, &NamedType::name);
  return types;
}

void print_value(const PageText& page, const EnumInfo& info, const ValueInfo& value) {
  std::string text =
      info.is_flags ? fmt::format("{:#x}", value.value) : std::to_string(value.value);
  if (*value.summary != '\0') text += fmt::format(": {}", value.summary);
  if (const std::string since = versions_text(value.since); !since.empty()) {
    text += fmt::format(" Since {}.", since);
  }
  page.entry(value.name, text, 2, 28);
}

void print_uses(const PageText& page, const std::vector<std::string>& uses) {
  page.gap();
  page.heading("Used in");
  constexpr std::size_t most = 12;
  for (std::size_t i = 0; i < std::min(uses.size(), most); ++i) page.paragraph(uses[i], 2);
  if (uses.size() > most) page.paragraph(fmt::format("and {} more", uses.size() - most), 2);
}

void print_type(const PageText& page, const NamedType& type) {
  if (type.packed != nullptr) {
    page.heading(type.name, "  several values in one number");
    page.paragraph(summary_of_type(type.name), 2);
    page.gap();
    FieldType field{.shape = FieldShape::integer, .packed = type.packed};
    for (const std::string& fact : field_facts(field)) page.paragraph(fact, 2);
  } else {
    page.heading(type.name, type.names->is_flags ? "  flags" : "  enum");
    page.paragraph(summary_of_type(type.name), 2);
    page.gap();
    for (const ValueInfo& value : type.names->values) print_value(page, *type.names, value);
  }
  print_uses(page, type.uses);
}

// ---- Everything else ----

void print_variable(const PageText& page, const VariableInfo& variable) {
  page.heading(variable.name,
               fmt::format("  adjustable variable {}", static_cast<int>(variable.id)));
  page.paragraph(variable.summary, 2);
  const FieldInfo info{.summary = variable.summary,
                       .range = &variable.range,
                       .directed = variable.directed,
                       .later = variable.later};
  const FieldType field{.info = &info,
                        .shape = FieldShape::integer,
                        .lowest = static_cast<std::int64_t>(variable.range.lowest),
                        .highest = static_cast<std::int64_t>(variable.range.highest),
                        .unit = &variable.unit};
  print_facts(page, field, "", 2);
}

/// Calls `use(path, field)` for each field, at its first occurrence in a message.
template <class Use>
void for_each_known_field(const Use& use) {
  std::set<const FieldInfo*> known;
  for (const MessageType* const message : message_types()) {
    for_each_field(message->fields(), [&](const std::vector<WayStep>& way, const FieldType& type) {
      const FieldInfo* const info = way.back().member != nullptr ? type.info : nullptr;
      if (info == nullptr || info->reserved || !known.insert(info).second) return;
      use(fmt::format("{}.{}", message->info->name, way_text(way)), *info);
    });
  }
}

void print_topic(const PageText& page, const TopicReference& topic) {
  page.heading(topic.name, "  topic of parameters");
  page.paragraph(topic.summary, 2);
  page.gap();
  for_each_known_field([&](const std::string& path, const FieldInfo& field) {
    if (std::ranges::count(topics_of(field), &topic) == 0) return;
    page.entry(path, field.summary, 2, 40);
  });
}

/// Calls `use(name, summary, topics)` for everything that a search looks at.
template <class Use>
void for_each_searched(const Use& use) {
  const std::vector<const TopicReference*> none;
  for (const CommandReference& command : command_references) {
    use(std::string(command.name), command.summary, none);
  }
  for_each_known_field([&](const std::string& path, const FieldInfo& field) {
    use(path, field.summary, topics_of(field));
  });
  // Adjustable variables are values of an enum, too.
  for (const NamedType& type : named_types()) {
    use(std::string(type.name), summary_of_type(type.name), none);
    if (type.names == nullptr) continue;
    for (const ValueInfo& value : type.names->values) use(value.name, value.summary, none);
  }
}

/// Prints everything with these words in its name or description. Returns false if none has them.
bool print_search(const PageText& page, const std::string& words) {
  const Query query(words);
  std::vector<std::pair<std::string, const char*>> found;
  for_each_searched([&](const std::string& name, const char* summary, const auto& topics) {
    if (query.fits(name, summary, topics, false)) found.emplace_back(name, summary);
  });
  if (found.empty()) return false;
  page.heading(words, fmt::format("  occurs at {}", counted(found.size(), "place")));
  constexpr std::size_t most = 40;
  for (std::size_t i = 0; i < std::min(found.size(), most); ++i) {
    page.entry(found[i].first, found[i].second, 2, 40);
  }
  if (found.size() > most) page.paragraph("and more; search for several words", 2);
  return true;
}

/// Prints the entries with the most and rarest of the words. Returns false if no entry has a third
/// of them.
bool print_nearest(const PageText& page, const std::string& words) {
  struct Place {
    std::string name{};
    const char* summary = nullptr;
    std::vector<WordPlace> words{};
    double weight = 0;
  };
  const Query query(words);
  std::vector<Place> found;
  std::vector<std::size_t> counts;  // the places that have each word
  std::size_t all = 0;
  for_each_searched([&](const std::string& name, const char* summary, const auto& topics) {
    ++all;
    Place place{name, summary, query.places(name, summary, topics), 0};
    counts.resize(place.words.size());
    std::size_t has = 0;
    for (std::size_t i = 0; i < counts.size(); ++i) {
      if (place.words[i] == WordPlace::nowhere) continue;
      ++counts[i];
      ++has;
    }
    if (has > 0 && 3 * has >= counts.size()) found.push_back(std::move(place));
  });
  if (found.empty()) return false;
  for (Place& place : found) {
    for (std::size_t i = 0; i < counts.size(); ++i) {
      if (place.words[i] == WordPlace::nowhere) continue;
      const double weight = std::log2(static_cast<double>(all) / static_cast<double>(counts[i]));
      place.weight += weight * (place.words[i] == WordPlace::name ? 1.5 : 1);
    }
  }
  std::ranges::stable_sort(found, std::ranges::greater{}, &Place::weight);
  page.heading(words, "  nothing has all these words; the nearest are");
  constexpr std::size_t most = 10;
  for (std::size_t i = 0; i < std::min(found.size(), most); ++i) {
    page.entry(found[i].name, found[i].summary, 2, 40);
  }
  return true;
}

/// The messages in which a field occurs.
struct Occurrence {
  const MessageType* message = nullptr;
  std::string path{};
  const FieldType* type = nullptr;
};

/// Returns the fields with this path or name in all messages, or in one whose name precedes it.
std::vector<Occurrence> occurrences_of(std::string word) {
  const std::size_t dot = std::min(word.find('.'), word.size());
  const std::string first = word.substr(0, dot);
  const bool is_of_one = std::ranges::any_of(message_types(), [&](const MessageType* message) {
    return detail::is_same_word(first, message->info->name);
  });
  if (is_of_one) word.erase(0, dot + 1);
  std::vector<Occurrence> found;
  for (const MessageType* const message : message_types()) {
    if (is_of_one && !detail::is_same_word(first, message->info->name)) continue;
    std::vector<FoundField> fields;
    try {
      fields = find_fields(message->fields(), word);
    } catch (const ValueError&) {
      // Several fields of the message: each whose path ends with the name.
      for_each_field(message->fields(),
                     [&](const std::vector<WayStep>& way, const FieldType& type) {
                       const FieldType* const last = way.back().member;
                       if (last != nullptr && (detail::is_same_word(last->name, word) ||
                                               detail::is_same_word(last->info->spec_name, word))) {
                         found.push_back({message, way_text(way), &type});
                       }
                     });
      continue;
    }
    if (fields.empty()) continue;
    const std::string path = fields.size() > 1 ? steps_text(fields.front().steps) + ", ..."
                                               : steps_text(fields.front().steps);
    found.push_back({message, path, fields.front().type});
  }
  return found;
}

void print_occurrences(const PageText& page, const std::string& word,
                       const std::vector<Occurrence>& found) {
  page.heading(word, fmt::format("  field of {}", counted(found.size(), "message")));
  const FieldInfo* last = nullptr;
  for (const Occurrence& one : found) {
    page.entry(fmt::format("{}.{}", one.message->info->name, one.path), "", 2, 0);
    if (one.type->info == nullptr || one.type->info == last) continue;
    last = one.type->info;
    page.paragraph(last->summary, 6);
    print_facts(page, *one.type, type_text(*one.type), 6);
    if (one.type->shape != FieldShape::group) continue;
    for (const FieldType& member : one.type->members) {
      page.entry(member.name, member.info == nullptr ? "" : member.info->summary, 6, 24);
    }
  }
}

bool is_listed(const CommandReference& command, const FamilyReference& family) {
  return std::string_view(command.family) == family.name;
}

void print_family(const PageText& page, const FamilyReference& family) {
  page.heading(family.name, fmt::format("  {}", family.summary));
  for (const CommandReference& command : command_references) {
    if (is_listed(command, family)) page.entry(command.name, command.summary, 2, 34);
  }
}

void print_all(const PageText& page) {
  for (const FamilyReference& family : family_references) {
    const bool has_commands = std::ranges::any_of(
        command_references, [&](const auto& command) { return is_listed(command, family); });
    if (!has_commands) continue;
    print_family(page, family);
    page.gap();
  }
  page.paragraph(
      "`sbgc describe` also takes a message, a number, a field, an enum or one of its values, an "
      "adjustable variable, and a family.",
      0);
}

/// Prints everything that the word names. Returns false if there is nothing.
bool print_word(const PageText& page, const std::string& word) {
  bool is_known = false;
  const auto separate = [&] {
    if (is_known) page.gap();
    is_known = true;
  };
  const std::optional<std::uint8_t> id = parse_command_id(word);
  const MessageType* const message = find_message(word);
  for (const CommandReference& command : command_references) {
    const bool is_meant = id ? command.id == *id : is_command_name(word, command.name);
    if (!is_meant || message != nullptr) continue;
    separate();
    print_command(page, command);
  }
  if (id) return is_known;
  if (!is_known) {
    for (const MessageType* const type : message_types()) {
      if (!detail::is_same_word(word, type->info->name)) continue;
      separate();
      page.heading(type->info->command, fmt::format("  id {}", type->info->id));
      print_message(page, *type);
    }
  }
  for (const FamilyReference& family : family_references) {
    if (is_known || !detail::is_same_word(word, family.name)) continue;
    separate();
    print_family(page, family);
  }
  for (const VariableInfo& variable : variables) {
    if (!detail::is_same_word(word, variable.name)) continue;
    separate();
    print_variable(page, variable);
  }
  const bool is_entry = is_known;
  for (const TopicReference& topic : topic_references) {
    if (!is_named(topic, word)) continue;
    separate();
    print_topic(page, topic);
  }
  if (is_entry) return true;
  for (const NamedType& type : named_types()) {
    if (detail::is_same_word(word, type.name)) {
      separate();
      print_type(page, type);
      continue;
    }
    if (type.names == nullptr) continue;
    for (const ValueInfo& value : type.names->values) {
      if (!detail::is_same_word(word, value.name)) continue;
      separate();
      page.heading(type.name, type.names->is_flags ? "  flags" : "  enum");
      print_value(page, *type.names, value);
      print_uses(page, type.uses);
    }
  }
  // A name may be that of a field and of one of its flags.
  const std::vector<Occurrence> found = occurrences_of(word);
  if (!found.empty()) {
    separate();
    print_occurrences(page, word, found);
  }
  return is_known;
}

/// Prints the entry that the words name together, or a name with a foreign prefix: "motors on",
/// "command 67", SBGC_CMD_CONTROL. Returns false if nothing has this name.
bool print_name(const PageText& page, const std::string& words) {
  std::string name = words;
  std::ranges::replace(name, ' ', '_');
  if (name != words && print_word(page, name)) return true;
  const std::string shorter = without_fillers(words);
  name = shorter;
  std::ranges::replace(name, ' ', '_');
  if (!name.empty() && name != words && print_word(page, name)) return true;
  if (words.find(' ') != std::string::npos) return false;
  for (std::size_t at = name.find('_'); at != std::string::npos; at = name.find('_')) {
    name.erase(0, at + 1);
    if (name.find('_') != std::string::npos && print_word(page, name)) return true;
  }
  return false;
}

std::vector<std::string> all_words() {
  std::set<std::string> words;
  for (const CommandReference& command : command_references) words.insert(command.name);
  for (const FamilyReference& family : family_references) words.insert(family.name);
  for (const VariableInfo& variable : variables) words.insert(variable.name);
  for (const TopicReference& topic : topic_references) words.insert(topic.name);
  for (const NamedType& type : named_types()) {
    words.insert(std::string(type.name));
    if (type.names == nullptr) continue;
    for (const ValueInfo& value : type.names->values) words.insert(value.name);
  }
  for (const MessageType* const message : message_types()) {
    words.insert(message->info->name);
    for_each_field(message->fields(), [&](const std::vector<WayStep>& way, const FieldType&) {
      if (way.back().member != nullptr) words.insert(way.back().member->name);
    });
  }
  return {words.begin(), words.end()};
}

/// Returns the words that are nearest to this one, ignoring case.
std::vector<std::string> similar_words(const std::string& word) {
  std::multimap<std::string, std::string> words;
  for (const std::string& name : all_words()) {
    words.emplace(detail::lower_case(name), name);
    if (name.starts_with("CMD_")) words.emplace(detail::lower_case(name.substr(4)), name);
  }
  std::vector<std::string> lower;
  for (const auto& [key, name] : words) {
    if (lower.empty() || lower.back() != key) lower.push_back(key);
  }
  std::vector<std::string> result;
  for (const std::string& key : detail::nearest(detail::lower_case(word), lower)) {
    const auto [begin, end] = words.equal_range(key);
    for (auto at = begin; at != end; ++at) result.push_back(at->second);
  }
  return result;
}

int describe(const DescribeOptions& options) {
  const PageText page;
  if (options.words.empty()) {
    print_all(page);
    return success;
  }
  const std::string word = fmt::format("{}", fmt::join(options.words, " "));
  const std::string significant = fmt::format("{}", fmt::join(significant_words(word), " "));
  if (print_word(page, word) || print_name(page, word) || print_search(page, word)) return success;
  // A question about a number: "what is 69".
  if (parse_command_id(significant) && print_word(page, significant)) return success;
  if (significant != word && print_search(page, significant)) return success;
  std::vector<std::string> near = similar_words(word);
  if (near.empty()) near = similar_words(word.substr(word.rfind('.') + 1));
  if (near.empty() && print_nearest(page, significant)) return success;
  constexpr std::size_t most = 8;
  if (near.size() > most) near.resize(most);
  throw CommandError(fmt::format("nothing is named '{}'{}", clipped(word),
                                 detail::did_you_mean(near, "`sbgc describe` lists the commands")));
}

}  // namespace

std::vector<std::string> described_words() { return all_words(); }

void add_describe(CLI::App& app, CommandContext& context) {
  const Subcommand<DescribeOptions> command(app, context, "describe",
                                            "Explain a command, message, field, enum or variable");
  auto& options = command.options();
  command
      ->add_option(
          "name", options.words,
          "A command (CMD_CONTROL, control, 67, 0x43), a message (ControlExt), a field "
          "(control_mode, axes.pitch.angle, Control.axes), an enum or one of its values "
          "(MODE_ANGLE), an adjustable variable (LPF_FREQ_ROLL), a topic of parameters (pid) or "
          "a family. Other words are searched in names and descriptions. Without a word, it "
          "lists all commands")
      ->type_name("WORD");
  command->footer("The exit status is 0 if something is found, 1 if not, 2 for wrong usage.");
  command.examples({"sbgc describe CMD_CONTROL", "sbgc describe bat_level",
                    "sbgc describe MODE_ANGLE", "sbgc describe pid"});
  command.runs(describe);
}

}  // namespace sbgc::tools
