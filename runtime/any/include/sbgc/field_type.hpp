/// The fields of a message as a tree, for code that handles any message at run time.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <sbgc/meta.hpp>

namespace sbgc {

/// The kinds of members of a message.
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
  const char* name = "";             ///< "" for an element
  const FieldInfo* info = nullptr;   ///< of the member that it is, or that it is an element of
  FieldShape shape{};                ///< number, list, struct or another
  std::vector<FieldType> members{};  ///< of a struct; or the element of axes or of a list
  std::vector<const char*> axes{};   ///< of `axes`: roll, pitch, yaw or x, y, z
  std::size_t size = 0;              ///< on the wire in bytes; 0 if it varies
  std::size_t count = 0;  ///< of a list, bytes or text: the size, or the largest one if it varies
  bool has_count = true;  ///< false if the size of the list, the bytes or the text varies
  bool is_optional = false;  ///< shorter bodies lack it
  bool is_of_axis = false;   ///< an element of an axis of the gimbal, or part of one
  bool is_counter = false;   ///< the element count of a list, which follows from the list
  // For integers.
  std::int64_t lowest = 0;  ///< what the wire can carry
  std::int64_t highest = 0;
  std::int64_t initial = 0;            ///< in a new message
  bool is_wide = false;                ///< unsigned with 64 bits; `highest` is not set
  const UnitInfo* unit = nullptr;      ///< null if it has none
  const EnumInfo* names = nullptr;     ///< of its values; null if they have none
  const PackedInfo* packed = nullptr;  ///< null unless bits have meanings of their own
  const char* type = "";               ///< of a number on the wire, such as "i16"

  /// True for an integer or a float.
  bool is_number() const noexcept {
    return shape == FieldShape::integer || shape == FieldShape::real;
  }
  /// True for arrays and lists.
  bool has_elements() const noexcept {
    return shape == FieldShape::axes || shape == FieldShape::list;
  }
  /// The type of a single value in (possibly nested) axes or lists; otherwise the type itself.
  const FieldType& innermost() const noexcept {
    return has_elements() ? members.front().innermost() : *this;
  }
  /// True for the bytes after those that the message describes.
  bool is_tail() const noexcept { return info == &tail_field; }
};

}  // namespace sbgc
