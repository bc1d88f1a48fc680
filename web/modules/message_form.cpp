#include "modules/message_form.hpp"

#include <algorithm>

#include <sbgc/text.hpp>

#include "modules/settable_text.hpp"
#include "values/field_text.hpp"

namespace sbgc::tools {

using web::JsonWriter;

namespace {

/// True for a field that nobody sets: it follows from other values, or has no meaning.
bool is_left_out(const FieldType& type) {
  return type.is_counter || type.is_tail() || (type.info != nullptr && type.info->reserved);
}

/// True for a list whose elements are written in one line, with commas between them.
bool is_line(const FieldType& type) {
  if (type.shape != FieldShape::list) return false;
  const FieldType& element = type.members.front();
  return element.is_number() || element.shape == FieldShape::announced;
}

std::string member_path(const std::string& path, const char* name) {
  return path.empty() ? name : path + '.' + name;
}

std::string element_path(const std::string& path, std::size_t index) {
  return path + '[' + std::to_string(index) + ']';
}

void add_types(const FieldType& type, const std::string& path, FieldTypes& types) {
  types.emplace(path, &type);
  if (type.shape == FieldShape::list) {
    add_types(type.members.front(), path + "[]", types);
  } else if (type.shape == FieldShape::axes) {
    for (const char* const axis : type.axes) {
      add_types(type.members.front(), member_path(path, axis), types);
    }
  } else {
    for (const FieldType& member : type.members) {
      add_types(member, member_path(path, member.name), types);
    }
  }
}

void put_names(JsonWriter& out, const EnumInfo& info) {
  out.key("names").list([&] {
    for (const ValueInfo& value : info.values) {
      if (!info.is_flags || value.value != 0) out.put(value.name);
    }
  });
}

void put_part(JsonWriter& out, const PartInfo& part, std::uint64_t raw) {
  const bool has_names = part.values != nullptr && !part.values->values.empty();
  out.object([&] {
    out.member("name", part.name);
    out.member("kind", !has_names ? "number" : part.values->is_flags ? "flags" : "enum");
    out.member("value", settable_part(part, raw));
    if (has_names) put_names(out, *part.values);
    if (part.unit != nullptr) out.member("unit", part.unit->name);
  });
}

/// Returns the limits of a number, and the values with special meanings.
std::string hint_of(const FieldType& field) {
  std::string hint = range_text(field);
  const FieldType& type = field.innermost();
  if (type.info == nullptr) return hint;
  for (const Special& special : type.info->special) {
    hint += hint.empty() ? "" : "; ";
    hint += std::to_string(special.value) + ": " + special.meaning;
  }
  return hint;
}

}  // namespace

std::string without_indices(std::string_view path) {
  std::string result;
  bool is_index = false;
  for (const char c : path) {
    is_index = is_index && c != ']';
    if (!is_index) result += c;
    is_index = is_index || c == '[';
  }
  return result;
}

FieldTypes types_of(const MessageType& type) {
  FieldTypes types;
  for (const FieldType& field : type.fields()) add_types(field, field.name, types);
  return types;
}

MessageForm::MessageForm(const AnyMessage& message)
    : message_(message), types_(types_of(message.type())) {
  read(message.type().make());
  std::map<std::string, Value, std::less<>> initial;
  initial.swap(values_);
  sizes_.clear();
  read(message);
  for (auto& [path, value] : values_) {
    const auto found = initial.find(path);
    if (found != initial.end()) value.initial = found->second.text;
  }
}

void MessageForm::read(const AnyMessage& message) {
  message.for_each_leaf([&](const Leaf& leaf) {
    const std::string path = to_string(leaf.path);
    for (std::size_t open = path.find('['); open != std::string::npos;
         open = path.find('[', open + 1)) {
      std::size_t& size = sizes_[path.substr(0, open)];
      const auto index = static_cast<std::size_t>(std::atoi(path.c_str() + open + 1));
      size = std::max(size, index + 1);
    }
    const auto type = types_.find(without_indices(path));
    if (type == types_.end()) return;
    const auto present = detail::low_bits(static_cast<std::uint64_t>(type->second->initial),
                                          std::max(type->second->size, std::size_t{1}));
    Value value{.raw = leaf.integer, .unit = leaf.unit};
    value.text = settable_text(*type->second, leaf, present, path.ends_with(']'));
    values_.emplace(path, std::move(value));
  });
}

const MessageForm::Value* MessageForm::value_at(const std::string& path) const {
  const auto found = values_.find(path);
  return found == values_.end() ? nullptr : &found->second;
}

std::size_t MessageForm::size_at(const std::string& path) const {
  const auto found = sizes_.find(path);
  return found == sizes_.end() ? 0 : found->second;
}

std::string MessageForm::joined(const std::string& path, bool is_initial) const {
  std::string text;
  for (std::size_t i = 0; i < size_at(path); ++i) {
    const Value* const value = value_at(element_path(path, i));
    if (value == nullptr) continue;
    text += (i == 0 ? "" : ",") + (is_initial ? value->initial : value->text);
  }
  return text;
}

void MessageForm::put_fields(JsonWriter& out) const {
  put_members(out, message_.type().fields(), "", false);
}

void MessageForm::put_members(JsonWriter& out, const std::vector<FieldType>& members,
                              const std::string& path, bool is_optional) const {
  out.list([&] {
    for (const FieldType& member : members) {
      if (is_left_out(member)) continue;
      put(out, member, member.name, member_path(path, member.name),
          is_optional || member.is_optional);
    }
  });
}

void MessageForm::put_elements(JsonWriter& out, const FieldType& type, const std::string& path,
                               bool is_optional) const {
  const FieldType& element = type.members.front();
  out.list([&] {
    for (const char* const axis : type.axes) {
      put(out, element, axis, member_path(path, axis), is_optional);
    }
    if (type.shape != FieldShape::list) return;
    for (std::size_t i = 0; i < (type.has_count ? type.count : size_at(path)); ++i) {
      put(out, element, element_path("", i), element_path(path, i), is_optional);
    }
  });
}

void MessageForm::put(JsonWriter& out, const FieldType& type, const std::string& name,
                      const std::string& path, bool is_optional) const {
  out.object([&] {
    out.member("path", path);
    out.member("name", name);
    if (is_optional) out.member("optional", true);
    if (type.shape == FieldShape::group) {
      out.member("kind", "group");
      put_members(out.key("fields"), type.members, path, is_optional);
    } else if (type.has_elements() && !is_line(type)) {
      const bool is_list = type.shape == FieldShape::list;
      out.member("kind", is_list ? "list" : "axes");
      if (is_list && !type.has_count) out.member("grows", type.count);
      put_elements(out.key("fields"), type, path, is_optional);
    } else {
      put_value(out, type, path);
    }
  });
}

void MessageForm::put_value(JsonWriter& out, const FieldType& type, const std::string& path) const {
  const Value* const value = value_at(path);
  const auto kind = [&] {
    if (type.has_elements()) return "numbers";
    if (type.shape == FieldShape::text) return "text";
    if (type.shape == FieldShape::bytes) return "bytes";
    if (type.packed != nullptr) return "packed";
    if (type.names != nullptr) return type.names->is_flags ? "flags" : "enum";
    return "number";
  };
  out.member("kind", kind());
  if (type.info != nullptr && type.info->secret) out.member("secret", true);
  out.member("value", type.has_elements() ? joined(path, false)
                      : value == nullptr  ? ""
                                          : value->text);
  if (type.packed != nullptr && !type.has_elements()) {
    const auto raw = static_cast<std::uint64_t>(value == nullptr ? type.initial : value->raw);
    return out.key("parts").list([&] {
      for (const PartInfo& part : type.packed->parts) {
        put_part(out, part, detail::low_bits(raw, type.size));
      }
    });
  }
  if (type.names != nullptr && !type.has_elements()) put_names(out, *type.names);
  const FieldType& element = type.innermost();
  const UnitInfo* const unit = value == nullptr ? element.unit : value->unit;
  if (unit != nullptr && *unit->name != '\0') out.member("unit", unit->name);
  const std::string hint = hint_of(type);
  if (!hint.empty()) out.member("hint", hint);
}

std::vector<FormLine> MessageForm::lines() const {
  std::vector<FormLine> lines;
  for (const FieldType& field : message_.type().fields()) {
    add_lines(lines, field, field.name, false);
  }
  std::stable_sort(lines.begin(), lines.end(), [](const FormLine& a, const FormLine& b) {
    return !a.is_in_unit && b.is_in_unit;
  });
  return lines;
}

void MessageForm::add_lines(std::vector<FormLine>& lines, const FieldType& type,
                            const std::string& path, bool is_always) const {
  if (is_left_out(type)) return;
  is_always = is_always || type.is_optional;
  if (type.shape == FieldShape::group) {
    for (const FieldType& member : type.members) {
      add_lines(lines, member, member_path(path, member.name), is_always);
    }
    return;
  }
  if (type.shape == FieldShape::axes) {
    for (const char* const axis : type.axes) {
      add_lines(lines, type.members.front(), member_path(path, axis), is_always);
    }
    return;
  }
  const bool varies = type.shape == FieldShape::list && !type.has_count;
  if (type.shape == FieldShape::list && !is_line(type)) {
    for (std::size_t i = 0; i < size_at(path); ++i) {
      add_lines(lines, type.members.front(), element_path(path, i), is_always || varies);
    }
    return;
  }
  const FieldType& element = type.innermost();
  const bool is_in_unit =
      element.unit != nullptr || (element.info != nullptr && element.info->is_variable_value);
  const bool is_secret = element.info != nullptr && element.info->secret;
  if (is_line(type)) {
    if (size_at(path) == 0) return;
    std::string text = joined(path, false);
    if (!varies && !is_always && text == joined(path, true)) return;
    lines.push_back({path, std::move(text), is_secret, is_in_unit});
    return;
  }
  const Value* const value = value_at(path);
  if (value == nullptr || (!is_always && value->text == value->initial)) return;
  lines.push_back({path, value->text, is_secret, is_in_unit});
}

}  // namespace sbgc::tools
