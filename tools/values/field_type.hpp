/// The fields of a message as a tree, for code that handles any message at run time.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string_view>
#include <type_traits>
#include <vector>

#include <sbgc/meta.hpp>
#include <sbgc/meta/enums.hpp>
#include <sbgc/meta/units.hpp>
#include <sbgc/number.hpp>
#include <sbgc/wire_size.hpp>

namespace sbgc::tools {

enum class FieldShape : std::uint8_t {
  group,      ///< a struct: `members`
  axes,       ///< one element for each axis: `axes` names them, `members` has the type of one
  list,       ///< `members` has the type of one element
  integer,    ///< also an enum, flags, a packed value or a quantity
  real,       ///< a floating-point number
  bytes,      ///< opaque bytes
  text,       ///< UTF-8
  announced,  ///< a number whose type another message announces
};

/// A field of a message, or an element of one.
struct FieldType {
  const char* name = "";            ///< "" for an element
  const FieldInfo* info = nullptr;  ///< of the member that it is, or that it is an element of
  FieldShape shape{};
  std::vector<FieldType> members{};
  std::vector<const char*> axes{};  ///< of `axes`: roll, pitch, yaw or x, y, z
  std::size_t size = 0;             ///< on the wire in bytes; 0 if it varies
  std::size_t count = 0;  ///< of a list, bytes or text: the size, or the largest one if it varies
  bool has_count = true;  ///< false if the size of the list, the bytes or the text varies
  bool is_optional = false;  ///< shorter bodies lack it
  bool is_of_axis = false;   ///< an element of an axis of the gimbal, or part of one
  bool is_counter = false;   ///< the element count of a list, which follows from the list
  // Of an integer.
  std::int64_t lowest = 0;  ///< what the wire can carry
  std::int64_t highest = 0;
  std::int64_t initial = 0;  ///< in a new message
  bool is_wide = false;      ///< unsigned with 64 bits; `highest` is not set
  const UnitInfo* unit = nullptr;
  const EnumInfo* names = nullptr;
  const PackedInfo* packed = nullptr;
  const char* type = "";  ///< of a number on the wire, such as "i16"

  bool is_number() const noexcept {
    return shape == FieldShape::integer || shape == FieldShape::real;
  }
  bool has_elements() const noexcept {
    return shape == FieldShape::axes || shape == FieldShape::list;
  }
  /// The type of one value of axes or of a list, which may be nested; otherwise the type itself.
  const FieldType& innermost() const noexcept {
    return has_elements() ? members.front().innermost() : *this;
  }
  bool is_tail() const noexcept { return info == &tail_field; }
};

/// Makes the tree of a type. Instantiates functions per type of member, not per member.
class FieldTypes {
 public:
  template <class T>
  static std::vector<FieldType> members_of(const T& value) {
    std::vector<FieldType> members;
    Meta<T>::visit(value, Adder{members});
    return members;
  }

 private:
  struct Adder {
    std::vector<FieldType>& members;

    template <class T>
    void operator()(const FieldInfo& field, const T& member) const {
      FieldType type = of(member);
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

  template <class T>
  static FieldType integer(T value) {
    using Limits = std::numeric_limits<T>;
    FieldType type{.shape = FieldShape::integer, .size = sizeof(T)};
    type.lowest = static_cast<std::int64_t>(Limits::min());
    type.highest = static_cast<std::int64_t>(Limits::max());
    type.initial = static_cast<std::int64_t>(value);
    type.is_wide = std::is_same_v<T, std::uint64_t>;
    constexpr bool is_signed = std::is_signed_v<T>;
    switch (sizeof(T)) {
      case 1: type.type = is_signed ? "i8" : "u8"; break;
      case 2: type.type = is_signed ? "i16" : "u16"; break;
      case 4: type.type = is_signed ? "i32" : "u32"; break;
      default: type.type = is_signed ? "i64" : "u64";
    }
    return type;
  }

  template <class T>
  static FieldType number(T value) {
    if constexpr (std::is_floating_point_v<T>) {
      return {.shape = FieldShape::real, .size = sizeof(T), .type = sizeof(T) == 4 ? "f32" : "f64"};
    } else {
      return integer(value);
    }
  }

  template <class T>
  static FieldType of(const T& value) {
    if constexpr (std::is_enum_v<T>) {
      FieldType type = integer(static_cast<std::underlying_type_t<T>>(value));
      type.names = &EnumMeta<T>::info;
      return type;
    } else if constexpr (std::is_arithmetic_v<T>) {
      return number(value);
    } else if constexpr (RawValue<T>) {
      FieldType type = number(value.raw());
      if constexpr (requires { UnitMeta<T>::info; }) type.unit = &UnitMeta<T>::info;
      if constexpr (requires { typename T::flag_type; }) {
        type.names = &EnumMeta<typename T::flag_type>::info;
      }
      if constexpr (requires { PackedMeta<T>::info; }) type.packed = &PackedMeta<T>::info;
      if constexpr (requires { T::highest; }) {
        type.lowest = T::lowest;
        type.highest = T::highest;
        type.size = 3;
        type.type = T::lowest < 0 ? "i24" : "u24";
      }
      return type;
    } else {
      return {.shape = FieldShape::group, .members = members_of<T>(value), .size = wire_size<T>};
    }
  }
  static FieldType of(const Counter& /*counter*/) {
    FieldType type = integer(std::uint8_t{0});
    type.is_counter = true;
    return type;
  }
  static FieldType of(const Number& /*number*/) { return {.shape = FieldShape::announced}; }
  template <class T>
  static FieldType of(const Optional<T>& /*optional*/) {
    FieldType type = of(T{});
    type.is_optional = true;
    return type;
  }
  template <class T>
  static FieldType of(const Axes<T>& axes) {
    FieldType element = of(axes.roll);
    mark_axis(element);
    return each(std::move(element), {"roll", "pitch", "yaw"});
  }
  template <class T>
  static FieldType of(const Xyz<T>& xyz) {
    return each(of(xyz.x), {"x", "y", "z"});
  }
  static void mark_axis(FieldType& type) {
    type.is_of_axis = true;
    for (FieldType& member : type.members) mark_axis(member);
  }
  static FieldType each(FieldType element, std::vector<const char*> names) {
    FieldType type{.shape = FieldShape::axes, .axes = std::move(names)};
    type.count = type.axes.size();
    type.size = type.count * element.size;
    type.members.push_back(std::move(element));
    return type;
  }
  template <std::size_t n>
  static FieldType of(const Bytes<n>& /*bytes*/) {
    return {.shape = FieldShape::bytes, .size = n, .count = n};
  }
  template <std::size_t n>
  static FieldType of(const BoundedBytes<n>& /*bytes*/) {
    return {.shape = FieldShape::bytes, .count = n, .has_count = false};
  }
  template <std::size_t n>
  static FieldType of(const Text<n>& /*text*/) {
    return {.shape = FieldShape::text, .size = n, .count = n};
  }
  template <std::size_t n>
  static FieldType of(const BoundedText<n>& /*text*/) {
    return {.shape = FieldShape::text, .count = n, .has_count = false};
  }
  template <class T, std::size_t n>
  static FieldType of(const std::array<T, n>& array) {
    FieldType type{.shape = FieldShape::list, .count = n};
    type.members.push_back(of(array[0]));
    type.size = n * type.members.front().size;
    return type;
  }
  template <class T, std::size_t n>
  static FieldType of(const BoundedArray<T, n>& /*array*/) {
    FieldType type{.shape = FieldShape::list, .count = n, .has_count = false};
    type.members.push_back(of(T{}));
    return type;
  }
};

/// Returns the members of a message.
template <class M>
std::vector<FieldType> field_types() {
  return FieldTypes::members_of(M{});
}

}  // namespace sbgc::tools
