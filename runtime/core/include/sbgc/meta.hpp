/// What is known about messages and their fields at run time: names, limits, meanings.
/// The tables themselves are generated: include <sbgc/meta/all.hpp> or one family of it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include <sbgc/codec.hpp>
#include <sbgc/enums.hpp>
#include <sbgc/flags.hpp>
#include <sbgc/type_list.hpp>

namespace sbgc {

/// A value with a meaning outside the ordinary range.
struct Special {
  std::int64_t value{};
  const char* meaning = "";
};

/// One named value of an enum, or one named flag of a set.
struct ValueInfo {
  const char* name = "";
  std::int64_t value{};
  const char* summary = "";
  Availability since{};
};

/// An enum or a flag set.
struct EnumInfo {
  const char* name = "";
  std::span<const ValueInfo> values{};
  bool is_flags{};
};

/// A part of a packed integer: ((raw & mask) >> shift) / divide % modulo, where 0 is no modulo.
struct PartInfo {
  const char* name = "";
  std::uint32_t mask{};
  std::uint8_t shift{};
  std::uint16_t divide = 1;
  std::uint16_t modulo{};
  const EnumInfo* values{};
};

/// A packed integer; `display` has {part} for each part, or is empty.
struct PackedInfo {
  const char* name = "";
  const char* display = "";
  const EnumInfo* names{};
  std::span<const PartInfo> parts{};
};

/// Lowest and highest raw value.
struct Range {
  double lowest{};
  double highest{};
};

/// What a raw value stands for.
struct UnitInfo {
  const char* name = "";  ///< "deg"; "" for a number without a unit
  double numerator = 1;
  double denominator = 1;
  double offset{};

  /// The value in the unit.
  constexpr double real(double raw) const noexcept {
    return raw * numerator / denominator + offset;
  }
  /// Whether the raw value says as much.
  constexpr bool is_plain() const noexcept {
    return *name == '\0' && numerator == denominator && offset == 0;
  }
};

/// Another unit of the same raw value, in force when the field `of` of the message has the bits
/// `mask`. If that field has an index (an axis), the index of the value applies to it.
struct AlternativeUnit {
  const char* of = "";
  std::uint32_t mask{};
  const UnitInfo* unit{};
};

/// An adjustable variable. Its values are integers.
struct VariableInfo {
  msg::VariableId id{};
  const char* name = "";
  const char* summary = "";
  Range range{};
  UnitInfo unit{};
};

/// What a field is among the settings that a message holds.
enum class FieldRole : std::uint8_t {
  setting,  ///< one of them, or no field of settings at all
  general,  ///< one of the whole board, the same in all copies of the settings
  copy,     ///< says which of several copies of the settings these are, from 0 on
  state,    ///< the state of the board, no setting: written back as it was read
};

/// One member of a message or struct.
struct FieldInfo {
  const char* name = "";
  const char* spec_name = "";  ///< the protocol's own; {AXIS} stands for the index
  const char* summary = "";
  const UnitInfo* unit{};  ///< of a quantity
  const Range* range{};
  std::span<const Special> special{};
  std::uint16_t min_count{};  ///< of a list
  std::uint16_t max_count{};  ///< of a list; 0: what fits
  std::uint16_t align = 1;    ///< the value, or the length of a list of bytes, is a multiple of it
  FieldRole role{};
  bool is_variable_value{};  ///< of the adjustable variable whose VariableId stands before it
  bool reserved{};
  bool optional{};  ///< may be left out of JSON
  Availability since{};
  const AlternativeUnit* alternative{};
};

/// What a request does to the board. A request can have several effects, some of them only with
/// certain values in its fields.
enum class Effect : std::uint8_t {
  reads = 0x01,     ///< it changes nothing
  sets = 0x02,      ///< what it changes is lost when the board restarts
  stores = 0x04,    ///< what it changes lasts
  moves = 0x08,     ///< the camera can move, or the motors gain or lose power
  restarts = 0x10,  ///< the board, whose motors have no power until it is up again
  erases = 0x20,    ///< what is stored
  unknown = 0x40,   ///< the specification only names the command
};
using Effects = Flags<Effect>;

/// One body layout of a command.
struct MessageInfo {
  const char* name = "";
  const char* command = "";
  const char* summary = "";
  std::uint8_t id{};
  Direction direction{};
  std::size_t min_size{};
  std::size_t max_size{};
  Availability since{};
  Availability until{};  ///< these versions and later ones no longer take it; 0: all do
  /// Names of the messages that answer it; what else is known of that, response_policy() knows.
  std::span<const char* const> answers{};
  const char* stores = "";  ///< the message whose settings it writes, or ""
  Effects effects{};        ///< none of a message from the board
};

/// The number of elements of a list, where the protocol has a field for it. It is not stored in
/// the message: the list knows its size.
struct Counter {
  std::size_t count{};
};

/// The `tail` member of messages that later firmware may lengthen.
inline constexpr FieldInfo tail_field{
    .name = "tail", .summary = "What later firmware appends.", .optional = true};

/// The tables of one message or struct: `fields`, `visit(message, visitor)`, and for messages
/// `info`. Generated.
template <class T>
struct Meta;

template <class T>
struct Meta<Axes<T>> {
  static constexpr FieldInfo fields[] = {{.name = "roll"}, {.name = "pitch"}, {.name = "yaw"}};

  template <class A, class Visitor>
  static constexpr void visit(A& axes, Visitor&& visitor) {
    visitor(fields[0], axes.roll);
    visitor(fields[1], axes.pitch);
    visitor(fields[2], axes.yaw);
  }
};

template <class T>
struct Meta<Xyz<T>> {
  static constexpr FieldInfo fields[] = {{.name = "x"}, {.name = "y"}, {.name = "z"}};

  template <class X, class Visitor>
  static constexpr void visit(X& xyz, Visitor&& visitor) {
    visitor(fields[0], xyz.x);
    visitor(fields[1], xyz.y);
    visitor(fields[2], xyz.z);
  }
};

/// The unit of a quantity. Generated.
template <class Q>
struct UnitMeta;

/// The names of an enum or flag enum. Generated.
template <class E>
struct EnumMeta;

/// The parts of a packed integer. Generated.
template <class P>
struct PackedMeta;

namespace detail {

template <class T>
constexpr void learn(const T& from, T& to) noexcept {
  to = from;
}
template <class T>
constexpr void learn(const Optional<T>& from, T& to) noexcept {
  if (from) to = *from;
}

}  // namespace detail

}  // namespace sbgc
