#include "values/message_names.hpp"

#include <algorithm>
#include <string_view>

#include <fmt/format.h>

#include <sbgc/internal/parse_number.hpp>
#include <sbgc/internal/suggestions.hpp>
#include <sbgc/internal/words.hpp>
#include <sbgc/meta/all.hpp>
#include <sbgc/roles.hpp>
#include <sbgc/text.hpp>

#include "command/wording.hpp"
#include "values/field_lookup.hpp"

namespace sbgc::tools {

bool is_command_name(std::string_view word, std::string_view command) {
  constexpr std::string_view prefix = "CMD_";
  if (detail::is_same_word(word, command)) return true;
  return command.starts_with(prefix) && detail::is_same_word(word, command.substr(prefix.size()));
}

std::optional<std::uint8_t> parse_command_id(std::string_view word) {
  const bool is_hex = word.starts_with("0x") || word.starts_with("0X");
  if (is_hex) word.remove_prefix(2);
  return detail::parse_number<std::uint8_t>(word, is_hex ? 16 : 10);
}

std::vector<const MessageType*> messages_named(std::string_view name, Direction direction) {
  if (const MessageType* const found = find_message(name)) return {found};
  const auto id = parse_command_id(name);
  std::vector<const MessageType*> forms;
  for (const MessageType* const type : message_types()) {
    if (!type->info->travels(direction)) continue;
    if (is_command_name(name, type->info->command) || id == type->info->id) forms.push_back(type);
  }
  if (!forms.empty()) return forms;
  const MessageType* other = nullptr;
  for (const MessageType* const type : message_types()) {
    if (!detail::is_same_word(name, type->info->name) && id != type->info->id) continue;
    if (type->info->travels(direction)) return {type};
    other = type;
  }
  return other != nullptr ? std::vector{other} : std::vector<const MessageType*>{};
}

namespace {

bool has_field(const MessageType& message, const std::string& name) {
  try {
    return !find_fields(message.fields(), name).empty();
  } catch (const ValueError&) {
    return true;  // ambiguous, which is reported when it is set
  }
}

}  // namespace

const MessageType& form_with(const std::vector<const MessageType*>& forms,
                             const std::vector<std::string>& fields) {
  for (const MessageType* const form : forms) {
    const auto has = [&](const std::string& field) { return has_field(*form, field); };
    if (forms.size() == 1 || std::ranges::all_of(fields, has)) return *form;
  }
  std::vector<std::string> names;
  std::vector<FieldSource> sources;
  for (const MessageType* const form : forms) {
    names.emplace_back(form->info->name);
    sources.push_back({form->info->name, &form->fields()});
  }
  const char* const command = forms.front()->info->command;
  for (const std::string& field : fields) {
    const auto has_it = [&](const MessageType* form) { return has_field(*form, field); };
    if (std::ranges::any_of(forms, has_it)) continue;
    throw ValueError(
        fmt::format("{} has no field '{}'{}", command, clipped(field),
                    detail::did_you_mean(similar_fields(sources, field),
                                         fmt::format("`sbgc describe {}` lists them", command))));
  }
  throw ValueError(fmt::format("no form of {} has all these fields; its forms are {}", command,
                               detail::alternatives(names, false)));
}

std::string similar_messages(std::string_view name) {
  const std::vector<std::string> near = detail::nearest(name, message_names());
  return detail::did_you_mean(
      near.empty() ? detail::nearest("CMD_" + detail::upper_case(name), message_names()) : near);
}

std::vector<std::string> message_names() {
  std::vector<std::string> names;
  for (const MessageType* const type : message_types()) {
    if (!type->is_sent_to_board()) continue;
    names.emplace_back(type->info->name);
    names.emplace_back(type->info->command);
  }
  std::ranges::sort(names);
  names.erase(std::unique(names.begin(), names.end()), names.end());
  return names;
}

std::vector<std::string> field_names(std::string_view message) {
  std::vector<std::string> names;
  for (const MessageType* const form : messages_named(message, Direction::to_board)) {
    for (std::string& path : field_paths(form->fields())) {
      if (std::ranges::find(names, path) == names.end()) names.push_back(std::move(path));
    }
  }
  return names;
}

Effects effects_of(const AnyMessage& message) {
  Effects effects = message.type().info->effects;
  for (const MessageType* const other :
       messages_named(message.type().info->command, Direction::to_board)) {
    message.for_each_leaf([&](const Leaf& leaf) {
      const FieldPath* member = &leaf.path;
      while (member->parent != nullptr) member = member->parent;
      const bool is_shared = std::ranges::any_of(other->fields(), [&](const FieldType& field) {
        return std::string_view(field.name) == member->name;
      });
      const bool is_zero = leaf.path.parent == nullptr && raw_text(leaf) == "0";
      if (is_shared && !is_zero) effects = effects | other->info->effects;
    });
  }
  return effects;
}

bool needs_arming(const MessageInfo& info, Effects effects) {
  // A data stream ends with the connection, and changes nothing else.
  const bool is_stream = &info == &Meta<roles::StreamRequest>::info;
  return effects.has(Effect::stores) || effects.has(Effect::moves) ||
         effects.has(Effect::restarts) || effects.has(Effect::erases) ||
         effects.has(Effect::disconnects) || effects.has(Effect::unknown) ||
         (effects.has(Effect::sets) && !is_stream);
}

}  // namespace sbgc::tools
