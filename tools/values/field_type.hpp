/// The fields of a message as a tree, for code that handles any message at run time.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include <sbgc/detail/scalar_info.hpp>
#include <sbgc/detail/walk.hpp>
#include <sbgc/meta.hpp>
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
  using Place = detail::FieldPlace;

  template <class T>
  std::vector<FieldType> members_of(const T& value) {
    std::vector<FieldType> members;
    Meta<T>::visit(value, Adder{*this, members});
    return members;
  }

  // The handlers of the walk.

  template <class T>
  FieldType scalar(const T& value, const Place&) {
    using Raw = detail::RawOf<T>;
    using Limits = std::numeric_limits<Raw>;
    const detail::ScalarInfo info = detail::scalar_info<T>();
    FieldType type{
        .size = wire_size<T>, .unit = info.unit, .names = info.names, .packed = info.packed};
    if constexpr (std::is_floating_point_v<Raw>) {
      type.shape = FieldShape::real;
      type.type = type_name('f', type.size);
    } else {
      type.shape = FieldShape::integer;
      type.type = type_name(std::is_signed_v<Raw> ? 'i' : 'u', type.size);
      type.lowest = static_cast<std::int64_t>(Limits::min());
      type.highest = static_cast<std::int64_t>(Limits::max());
      if constexpr (detail::is_integer24<T>) {
        type.lowest = T::lowest;
        type.highest = T::highest;
      }
      type.initial = static_cast<std::int64_t>(detail::raw_of(value));
      type.is_wide = std::is_same_v<Raw, std::uint64_t>;
    }
    return type;
  }
  FieldType counter(const Counter&, const Place& place) {
    FieldType type = scalar(std::uint8_t{0}, place);
    type.is_counter = true;
    return type;
  }
  FieldType number(const Number&, const Place&) { return {.shape = FieldShape::announced}; }
  template <class T>
  FieldType bytes(const T& bytes, const Place&) {
    return sized<T>(FieldShape::bytes, capacity_of(bytes));
  }
  template <class T>
  FieldType text(const T&, const Place&) {
    return sized<T>(FieldShape::text, T::capacity());
  }
  template <class T>
  FieldType list(const T&, const Place& place) {
    FieldType type = sized<T>(FieldShape::list, T::capacity());
    const typename T::value_type element{};
    type.members.push_back(detail::walk(element, place, *this));
    return type;
  }
  template <class T>
  FieldType array(const T& array, const Place& place) {
    FieldType type = sized<T>(FieldShape::list, array.size());
    type.members.push_back(detail::walk(array[0], place, *this));
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
    FieldType type = detail::walk(value, place, *this);
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
      FieldType type = detail::walk(member, Place(field, {}), types);
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
    return *std::ranges::find(names, name);
  }
  template <class T>
  static FieldType sized(FieldShape shape, std::size_t count) {
    return {
        .shape = shape, .size = wire_size<T>, .count = count, .has_count = !detail::is_bounded<T>};
  }
  template <class T>
  static std::size_t capacity_of(const T& bytes) {
    if constexpr (detail::is_bounded<T>) {
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

}  // namespace sbgc::tools
