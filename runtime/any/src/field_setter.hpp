/// Sets one value of a message by its path.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include <sbgc/internal/table_access.hpp>
#include <sbgc/meta.hpp>
#include <sbgc/value_text.hpp>

#include "path_steps.hpp"

namespace sbgc::detail {

/// Walks along a path, adds what is missing on the way, and sets the value at its end; the value of
/// a list is its size. Without a value, it only adds what is missing, removes what is at the end,
/// or finds it.
class FieldSetter {
 public:
  enum class End : std::uint8_t { set, remove, find };

  FieldSetter(std::string_view path, const AnyValue* value, End end = End::set)
      : steps_(path), value_(value), end_(end) {}

  /// Returns true if the message has the field, and the field takes the value.
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

  /// True if the path ends here, and nothing else is asked.
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

}  // namespace sbgc::detail
