#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include <sbgc/any.hpp>
#include <sbgc/internal/suggestions.hpp>
#include <sbgc/internal/table_access.hpp>
#include <sbgc/internal/words.hpp>
#include <sbgc/meta.hpp>
#include <sbgc/text.hpp>
#include <sbgc/value_text.hpp>

#include "path_steps.hpp"

namespace sbgc::detail {
namespace {

/// Walks along a path, adds missing fields on the way, and sets the value at its end; the value of
/// a list is its size. Without a value, it only adds what is missing, removes the field at the end,
/// or finds it.
class FieldSetter {
 public:
  enum class End : std::uint8_t { set, remove, find };

  FieldSetter(std::string_view path, const AnyValue* value, End end = End::set)
      : steps_(path), value_(value), end_(end) {}

  /// Returns true if the message has the field, and the field accepts the value.
  bool set(const StructTable& table, void* message) {
    members(table, message);
    return is_done_;
  }

 private:
  void members(const StructTable& table, void* object) {
    if (is_found()) return;
    const std::string_view name = steps_.take_name();
    const FieldInfo* field = table.fields;
    for (const Slot& slot : table.slots) {
      if (name == (field++)->name) return value(*slot.type, moved(object, slot.offset));
    }
    if (table.tail.type == nullptr || name != tail_field.name) return;
    value(*table.tail.type, moved(object, table.tail.offset));
  }

  void value(const ValueType& type, void* at) {
    switch (type.kind) {
      case Kind::scalar: return scalar(type.raw, at);
      case Kind::axes:
      case Kind::group: return members(*type.group, at);
      case Kind::array: return array(type, at);
      case Kind::list: return list(type, at);
      case Kind::bytes: return chars<std::vector<std::uint8_t>>(type, at);
      case Kind::text: return chars<std::string>(type, at);
      case Kind::optional: return optional(type, at);
      case Kind::counter: return static_cast<void>(is_found());  // follows from the list
      case Kind::number:
        if (const auto* const value = taken<Number>()) store(at, *value);
        return;
    }
  }
  void scalar(RawType type, void* at) {
    if (is_real(type)) {
      if (const auto* const value = taken<double>()) store_number(type, at, *value);
    } else if (const auto* const value = taken<std::int64_t>()) {
      store_number(type, at, *value);
    }
  }
  template <class Chars>
  void chars(const ValueType& type, void* at) {
    const auto* const value = taken<Chars>();
    if (value == nullptr) return;
    const bool is_padded = type.kind == Kind::text && !type.is_bounded;
    is_done_ = is_padded ? value->size() <= type.count : resize(type, at, value->size());
    if (!is_done_) return;
    auto* const begin = static_cast<char*>(moved(at, type.begin));
    if (is_padded) std::fill_n(begin, type.count, '\0');
    std::copy(value->begin(), value->end(), begin);
  }
  void list(const ValueType& type, void* at) {
    if (steps_.is_end()) {
      if (end_ == End::remove) {
        is_done_ = resize(type, at, 0);
      } else if (const auto* const size = taken<std::int64_t>()) {
        is_done_ = resize(type, at, static_cast<std::size_t>(*size));
      }
      return;
    }
    const std::size_t index = steps_.take_index();
    if (index >= type.count) return;
    if (index >= size_at(type, at) && (end_ == End::find || !resize(type, at, index + 1))) return;
    value(*type.element, element_at(type, at, index));
  }
  void array(const ValueType& type, void* at) {
    if (is_found()) return;
    const std::size_t index = steps_.take_index();
    if (index < type.count) value(*type.element, element_at(type, at, index));
  }
  void optional(const ValueType& type, void* at) {
    if (steps_.is_end() && end_ == End::remove) {
      set_present(type, at, false);
      is_done_ = true;
      return;
    }
    if (!is_present(type, at) && end_ == End::find) return;
    set_present(type, at, true);
    value(*type.element, at);
  }

  /// True if the path ends here, and finding it is the only goal.
  bool is_found() {
    is_done_ = is_done_ || (steps_.is_end() && end_ == End::find);
    return is_done_;
  }

  /// Returns the value if the path ends here, and it is a V.
  template <class V>
  const V* taken() {
    if (!steps_.is_end() || end_ == End::remove) return nullptr;
    is_done_ = value_ == nullptr || std::holds_alternative<V>(*value_);
    return value_ != nullptr && is_done_ ? &std::get<V>(*value_) : nullptr;
  }

  PathSteps steps_;
  const AnyValue* value_;
  End end_;
  bool is_done_ = false;
};

}  // namespace
}  // namespace sbgc::detail

namespace sbgc {

namespace {

/// Returns the type of the field at a path; null if there is none. Indices are not checked.
const FieldType* type_at(const std::vector<FieldType>& fields, std::string_view path) {
  const std::vector<FieldType>* members = &fields;
  const FieldType* at = nullptr;
  while (!path.empty()) {
    if (path.front() == '[') {
      const std::size_t close = path.find(']');
      if (at == nullptr || at->shape != FieldShape::list || close == std::string_view::npos) {
        return nullptr;
      }
      path.remove_prefix(close + 1);
      at = &at->members.front();
    } else {
      if (at != nullptr) {
        if (path.front() != '.') return nullptr;
        path.remove_prefix(1);
      }
      const auto name = path.substr(0, std::min(path.find_first_of(".["), path.size()));
      path.remove_prefix(name.size());
      if (at != nullptr && at->shape == FieldShape::axes) {
        if (std::find(at->axes.begin(), at->axes.end(), name) == at->axes.end()) return nullptr;
        at = &at->members.front();
      } else {
        const auto found =
            std::find_if(members->begin(), members->end(),
                         [&](const FieldType& member) { return name == member.name; });
        if (found == members->end()) return nullptr;
        at = &*found;
      }
    }
    members = &at->members;
  }
  return at;
}

}  // namespace

std::string AnyMessage::assign(std::string_view path, std::string_view text, bool validates,
                               const Availability& versions) {
  const std::string name(path);
  const FieldType* const type = type_at(type_->fields(), path);
  if (type == nullptr) return std::string(type_->info->name) + " has no field '" + name + "'";
  AnyMessage changed = *this;
  std::string problem = changed.assign(*type, name, text, versions);
  if (!problem.empty()) return name + ": " + problem;
  auto note = [&](const Violation& violation) {
    const std::string place = sbgc::to_string(violation.path);
    if (!problem.empty()) return;
    if (!detail::is_in_field(place, name) && !detail::is_in_field(name, place)) return;
    problem = sbgc::to_string(violation);
  };
  if (validates) changed.validate(versions.firmware != 0 ? versions : newest, note);
  if (problem.empty()) *this = std::move(changed);
  return problem;
}

bool AnyMessage::has(std::string_view path) const {
  detail::FieldSetter finder(path, nullptr, detail::FieldSetter::End::find);
  return finder.set(table(), memory_.get());
}

std::string AnyMessage::assign(const FieldType& type, const std::string& path,
                               std::string_view text, const Availability& versions) {
  if (type.shape == FieldShape::group) {
    std::vector<std::string> names;
    for (const FieldType& member : type.members) names.emplace_back(member.name);
    return "it has fields of its own: " + detail::alternatives(names, false);
  }
  if (type.is_counter) return "it follows from the number of elements";
  if (type.has_elements()) {
    const bool is_list = type.shape == FieldShape::list;
    if (type.members.front().has_elements() || type.members.front().shape == FieldShape::group) {
      return is_list ? "name one of its elements and fields"
                     : "name one of its fields, for each axis";
    }
    std::vector<std::string_view> parts = parse_elements(text);
    const std::size_t count = is_list ? type.count : type.axes.size();
    if (!is_list && parts.size() == 1) parts.resize(count, parts.front());
    const bool fits = type.has_count ? parts.size() == count : parts.size() <= count;
    if (!fits && !is_list) {
      return "write one value, or " + std::to_string(count) + " with commas between them";
    }
    if (!fits) {
      return std::string("it has ") + (type.has_count ? "" : "at most ") + std::to_string(count) +
             " elements, not " + std::to_string(parts.size());
    }
    const AnyValue size = static_cast<std::int64_t>(parts.size());
    if (is_list && !type.has_count && !set(path, &size)) return "it takes no elements";
    for (std::size_t i = 0; i < parts.size(); ++i) {
      const std::string element =
          is_list ? path + '[' + std::to_string(i) + ']' : path + '.' + type.axes[i];
      auto problem = assign(type.members.front(), element, parts[i], versions);
      if (!problem.empty()) return problem;
    }
    return {};
  }
  if (!set(path, nullptr)) return "there is no such element";
  FieldType meant = type;
  std::uint64_t present = 0;
  const auto look = [&](const Leaf& leaf) {
    meant.unit = leaf.unit;
    meant.names = leaf.names;
    meant.packed = leaf.packed;
    present = detail::low_bits(static_cast<std::uint64_t>(leaf.integer), leaf.size);
  };
  with_leaf(path, look, versions);
  const ParsedValue parsed = parse_value(meant, meant.unit, text, present);
  if (!parsed) return parsed.problem;
  return set(path, &parsed.value) ? "" : "it cannot have this value";
}

bool AnyMessage::remove(std::string_view path) {
  detail::FieldSetter setter(path, nullptr, detail::FieldSetter::End::remove);
  return setter.set(table(), memory_.get());
}

bool AnyMessage::set(std::string_view path, const AnyValue* value) {
  detail::FieldSetter setter(path, value);
  return setter.set(table(), memory_.get());
}

}  // namespace sbgc
