/// Finds one value of a message by its path.
#pragma once

#include <cstddef>
#include <string_view>

#include <sbgc/text/leaves.hpp>

#include "path_steps.hpp"

namespace sbgc::detail {

/// Walks along a path by the tables, past the other values. The offset of the leaf is not known.
class LeafFinder : LeafWalk {
 public:
  LeafFinder(std::string_view path, Use use, void* user, const Availability& versions)
      : LeafWalk(use, user, versions), steps_(path) {}

  /// Uses the value at the path. Returns false if the message has none.
  bool find(const StructTable& table, const void* message) {
    table_ = &table;
    message_ = message;
    return members(table, message, nullptr);
  }

  /// Returns the number of elements at the path; 0 if the message has no such list.
  std::size_t count(const StructTable& table, const void* message) {
    members(table, message, nullptr);
    return count_;
  }

 private:
  bool members(const StructTable& table, const void* object, const FieldPath* parent) {
    const std::string_view name = steps_.take_name();
    const VariableInfo* variable = nullptr;
    const FieldInfo* field = table.fields;
    for (const Slot& slot : table.slots) {
      const void* const at = moved(object, slot.offset);
      if (slot.type->is_variable_id) variable = find_variable(load<msg::VariableId>(at));
      if (name == field->name) {
        const FieldPath path{parent, field->name};
        const bool has_variable = field->is_variable_value && is_plain_integer(*slot.type);
        return value(*field, *slot.type, at, path, has_variable ? variable : nullptr);
      }
      ++field;
    }
    if (table.tail.type == nullptr || name != tail_field.name) return false;
    const void* const tail = moved(object, table.tail.offset);
    if (size_at(*table.tail.type, tail) == 0) return false;
    return value(tail_field, *table.tail.type, tail, {parent, tail_field.name});
  }

  bool value(const FieldInfo& field, const ValueType& type, const void* at, const FieldPath& path,
             const VariableInfo* variable = nullptr) {
    switch (type.kind) {
      case Kind::group: return members(*type.group, at, &path);
      case Kind::axes: return axis(field, type, at, path);
      case Kind::array:
      case Kind::list: return element(field, type, at, path);
      case Kind::optional: return is_present(type, at) && value(field, *type.element, at, path);
      default: break;
    }
    if (!steps_.is_end()) return false;
    if (field.alternative != nullptr) skip(*table_, message_);
    if (variable != nullptr) {
      scalar(field, type, at, path, {.unit = &variable->unit}, variable->later);
    } else {
      LeafWalk::value(field, type, at, path);
    }
    return true;
  }

  bool axis(const FieldInfo& field, const ValueType& type, const void* at, const FieldPath& path) {
    const std::string_view name = steps_.take_name();
    for (std::size_t i = 0; i < type.count; ++i) {
      const char* const own = type.group->fields[i].name;
      if (name == own) return value(field, *type.element, element_at(type, at, i), {&path, own, i});
    }
    return false;
  }

  bool element(const FieldInfo& field, const ValueType& type, const void* at,
               const FieldPath& path) {
    const std::size_t size = size_at(type, at);
    if (steps_.is_end()) count_ = size;
    const std::size_t index = steps_.take_index();
    if (index >= size) return false;
    return value(field, *type.element, element_at(type, at, index), {&path, "", index});
  }

  PathSteps steps_;
  const StructTable* table_ = nullptr;
  const void* message_ = nullptr;
  std::size_t count_ = 0;
};

}  // namespace sbgc::detail
