/// Makes the tree of the fields of a message.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <sbgc/field_type.hpp>
#include <sbgc/internal/scalar_info.hpp>
#include <sbgc/internal/walk.hpp>
#include <sbgc/meta.hpp>
#include <sbgc/wire_size.hpp>

namespace sbgc::detail {

/// Makes the tree of a type. Instantiates functions per type of member, not per member.
class FieldTypes {
 public:
  using Place = FieldPlace;

  template <class T>
  std::vector<FieldType> members_of(const T& value) {
    std::vector<FieldType> members;
    Meta<T>::visit(value, Adder{*this, members});
    return members;
  }

  // The handlers of the walk.

  template <class T>
  FieldType scalar(const T& value, const Place&) {
    using Raw = RawOf<T>;
    using Limits = std::numeric_limits<Raw>;
    const ScalarInfo info = scalar_info<T>();
    if constexpr (std::is_floating_point_v<Raw>) {
      return number_type('f', wire_size<T>, info);
    } else {
      FieldType type = number_type(std::is_signed_v<Raw> ? 'i' : 'u', wire_size<T>, info);
      type.lowest = static_cast<std::int64_t>(Limits::min());
      type.highest = static_cast<std::int64_t>(Limits::max());
      if constexpr (is_integer24<T>) {
        type.lowest = Integer24<Raw>::lowest;
        type.highest = Integer24<Raw>::highest;
      }
      type.initial = static_cast<std::int64_t>(raw_of(value));
      type.is_wide = std::is_same_v<Raw, std::uint64_t>;
      return type;
    }
  }
  FieldType counter(const Counter&, const Place& place) {
    FieldType type = scalar(std::uint8_t{0}, place);
    type.is_counter = true;
    return type;
  }
  FieldType number(const Number&, const Place&) { return {.shape = FieldShape::announced}; }
  template <class T>
  FieldType bytes(const T& bytes, const Place&) {
    return sized(FieldShape::bytes, wire_size<T>, capacity_of(bytes), !is_bounded<T>);
  }
  template <class T>
  FieldType text(const T&, const Place&) {
    return sized(FieldShape::text, wire_size<T>, T::capacity(), !is_bounded<T>);
  }
  template <class T>
  FieldType list(const T&, const Place& place) {
    FieldType type = sized(FieldShape::list, wire_size<T>, T::capacity(), !is_bounded<T>);
    const typename T::value_type element{};
    type.members.push_back(walk(element, place, *this));
    return type;
  }
  template <class T>
  FieldType array(const T& array, const Place& place) {
    FieldType type = sized(FieldShape::list, wire_size<T>, array.size(), !is_bounded<T>);
    type.members.push_back(walk(array[0], place, *this));
    return type;
  }
  template <class T>
  FieldType axes(const T& axes, const Place& place) {
    FieldType type = array(axes, place);
    type.shape = FieldShape::axes;
    for (const FieldInfo& axis : Meta<T>::fields) type.axes.push_back(axis.name);
    if constexpr (requires { axes.roll; }) mark_axis(type.members.front());
    return type;
  }
  template <class T>
  FieldType optional(const T&, const Place& place) {
    const typename T::value_type value{};
    FieldType type = walk(value, place, *this);
    type.is_optional = true;
    return type;
  }
  template <class T>
  FieldType group(const T& value, const Place&) {
    return {.shape = FieldShape::group, .members = members_of(value), .size = wire_size<T>};
  }

 private:
  struct Adder {
    FieldTypes& types;
    std::vector<FieldType>& members;

    template <class T>
    void operator()(const FieldInfo& field, const T& member) const {
      add(field, walk(member, Place(field, {}), types));
    }

   private:
    void add(const FieldInfo& field, FieldType type) const {
      type.name = field.name;
      const bool is_limited = !type.has_count && field.max_count != 0;
      if (is_limited) type.count = std::min<std::size_t>(type.count, field.max_count);
      name(type, field);
      members.push_back(std::move(type));
    }

    /// Elements share the facts of the member that they belong to.
    static void name(FieldType& type, const FieldInfo& field) {
      type.info = &field;
      if (!type.has_elements()) return;
      if (type.members.front().info == nullptr) name(type.members.front(), field);
    }
  };

  static const char* type_name(char kind, std::size_t size) {
    static constexpr std::array names{"u8",  "i8",  "u16", "i16", "u24", "i24",
                                      "u32", "i32", "u64", "i64", "f32", "f64"};
    const std::string name = kind + std::to_string(8 * size);
    return *std::find(names.begin(), names.end(), name);
  }
  static FieldType number_type(char kind, std::size_t size, const ScalarInfo& info) {
    return {.shape = kind == 'f' ? FieldShape::real : FieldShape::integer,
            .size = size,
            .unit = info.unit,
            .names = info.names,
            .packed = info.packed,
            .type = type_name(kind, size)};
  }
  static FieldType sized(FieldShape shape, std::size_t size, std::size_t count, bool has_count) {
    return {.shape = shape, .size = size, .count = count, .has_count = has_count};
  }
  template <class T>
  static std::size_t capacity_of(const T& bytes) {
    if constexpr (is_bounded<T>) {
      return T::capacity();
    } else {
      return bytes.size();
    }
  }
  static void mark_axis(FieldType& type) {
    type.is_of_axis = true;
    for (FieldType& member : type.members) mark_axis(member);
  }
};

/// Returns the members of a message.
template <class M>
std::vector<FieldType> field_types() {
  return FieldTypes().members_of(M{});
}

}  // namespace sbgc::detail
