/// Run-time metadata of messages and their fields: names, limits, meanings.
/// The tables themselves are generated: include <sbgc/meta/all.hpp> or the header of one family.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include <sbgc/codec.hpp>
#include <sbgc/detail/exponential.hpp>
#include <sbgc/enums.hpp>
#include <sbgc/flags.hpp>
#include <sbgc/type_list.hpp>

namespace sbgc {

// NOLINTBEGIN(google-explicit-constructor)

/// The description of an error, which messages about it contain.
struct Explanation {
  const char* text = "";

  constexpr operator const char*() const noexcept { return text; }
};

/// A text about a part of the protocol, for people. A program that is entirely compiled with
/// SBGC_NO_DESCRIPTIONS is smaller: it has "" in place of these texts.
#if defined(SBGC_NO_DESCRIPTIONS)
struct Description {
  constexpr Description(const char* /*text*/) noexcept {}
  constexpr operator const char*() const noexcept { return ""; }
};
/// The same, but with the texts of explanations.
struct DescriptionOrExplanation : Explanation {
  constexpr DescriptionOrExplanation(const char* /*text*/) noexcept {}
  constexpr DescriptionOrExplanation(Explanation explanation) noexcept : Explanation(explanation) {}
};
#else
using Description = const char*;
/// A description, or the explanation of an error.
using DescriptionOrExplanation = const char*;
#endif

// NOLINTEND(google-explicit-constructor)

/// A sentinel: a raw value with a special meaning.
struct Special {
  std::int64_t value{};  ///< the raw value
  const char* meaning = "";
};

/// One named value of an enum, or one named flag of a set.
struct ValueInfo {
  const char* name = "";
  std::int64_t value{};  ///< as on the wire
  DescriptionOrExplanation summary = "";
  Availability since{};       ///< the versions that know it
  bool unconfirmed{};         ///< from a single source, or contradicted by another
  Description saved_as = "";  ///< the name of a flag in files of the vendor's program
};

/// Something that only some boards have: a flag of what they report, and its mask in an
/// Availability.
struct FeatureInfo {
  const char* name = "";
  std::uint64_t mask{};  ///< its bit in an Availability
};

/// An enum or a flag set.
struct EnumInfo {
  const char* name = "";
  std::span<const ValueInfo> values{};
  bool is_flags{};  ///< whether the values are bits that can be combined
};

struct UnitInfo;

/// A part of a packed value: ((raw & mask) >> shift) / divide % modulo, without % if modulo is 0.
struct PartInfo {
  const char* name = "";
  std::uint64_t mask{};       ///< of the part, before the shift
  std::uint8_t shift{};       ///< to the right, in bits
  std::uint16_t divide = 1;   ///< the divisor of the shifted part
  std::uint16_t modulo{};     ///< the modulus applied after that; 0: none
  std::uint64_t sign{};       ///< a bit that makes the number negative
  bool is_signed{};           ///< two's complement
  const EnumInfo* values{};   ///< the names of its values; null if it is a number
  const UnitInfo* unit{};     ///< of the number
  Description saved_as = "";  ///< its name in files of the vendor's program
};

/// A packed value; `display` contains {part} for each part, or is empty. Values from `later_from`
/// on have `later_display`, if it is not empty.
struct PackedInfo {
  const char* name = "";
  const char* display = "";  ///< how text shows the whole, such as a version
  const EnumInfo* names{};   ///< names of whole values; null if there are none
  std::span<const PartInfo> parts{};
  std::uint64_t later_from{};      ///< the smallest value that has the later form
  const char* later_display = "";  ///< how text shows the later form
};

/// The lowest and the highest raw value.
struct Range {
  double lowest{};
  double highest{};
};

/// The unit and scale of a raw value: real value = raw * numerator / denominator + offset. With a
/// `growth`, growth^raw takes the place of raw.
struct UnitInfo {
  const char* name = "";   ///< "deg"; "" for a number without a unit
  double numerator = 1;    ///< of the scale
  double denominator = 1;  ///< of the scale
  double offset{};         ///< in the unit, added after scaling
  double growth{};         ///< the base of an exponential scale; 0 for a linear one

  /// Returns the value in the unit.
  constexpr double real(double raw) const noexcept {
    const bool is_linear = growth == 0;
    const double steps = is_linear ? raw : detail::power(growth, static_cast<std::int64_t>(raw));
    return steps * numerator / denominator + offset;
  }
  /// Returns the raw value of a value in the unit: exactly, or with a `growth` the nearest integer.
  constexpr double raw(double real) const noexcept {
    const double steps = (real - offset) * denominator / numerator;
    if (growth == 0) return steps;
    return static_cast<double>(detail::nearest_exponent(growth, steps));
  }
  /// Returns true if the value equals the raw value and has no unit.
  constexpr bool is_plain() const noexcept {
    return *name == '\0' && numerator == denominator && offset == 0 && growth == 0;
  }
};

/// The meaning of a field since some firmware. At most one of unit, names and packed is set.
struct LaterMeaning {
  Availability since{};  ///< the first versions with this meaning
  const UnitInfo* unit{};
  const EnumInfo* names{};
  const PackedInfo* packed{};
  const Range* range{};  ///< null: that of the field
  Description summary = "";
};

/// Returns the meaning of a field on a board with these versions; null for its usual meaning, which
/// it has before the first of `later`.
constexpr const LaterMeaning* meaning_in(std::span<const LaterMeaning> later,
                                         const Availability& versions) noexcept {
  const LaterMeaning* found = nullptr;
  for (const LaterMeaning& one : later) {
    if (is_available(one.since, versions)) found = &one;
  }
  return found;
}

/// An alternative unit of a raw value, in effect if the field `of` of the message has the bits
/// `mask`. If that field has one element per axis, the one for the axis of the value counts.
struct AlternativeUnit {
  const char* of = "";  ///< the name of the field with the mask
  std::uint32_t mask{};
  const UnitInfo* unit{};
};

/// The sign convention of values; <sbgc/axis_directions.hpp> has the directions of the axes.
enum class Directed : std::uint8_t {
  no,       ///< no direction: a size, a mode, a time
  unknown,  ///< the sign convention is unknown
  roll,     ///< the direction of the axis
  pitch,
  yaw,
  by_axis,  ///< the direction of the element's axis; unknown if it belongs to no axis
};

/// An adjustable variable. Its values are integers.
struct VariableInfo {
  msg::VariableId id{};  ///< on the wire
  const char* name = "";
  Description summary = "";
  Range range{};  ///< in the unit
  UnitInfo unit{};
  Directed directed{};                    ///< the sign convention, if any
  std::span<const LaterMeaning> later{};  ///< the earliest first

  /// Returns the unit on a board with these versions.
  constexpr UnitInfo unit_in(const Availability& versions) const noexcept {
    const LaterMeaning* const found = meaning_in(later, versions);
    if (found == nullptr) return unit;
    return found->unit != nullptr ? *found->unit : UnitInfo{};
  }
};

/// The role of a field in a message that holds parameters.
enum class FieldRole : std::uint8_t {
  setting,  ///< a parameter, or any field of a message without parameters
  general,  ///< a parameter of the whole board, the same in all copies of the parameters
  copy,     ///< the index of the copy of the parameters, from 0
  state,    ///< state of the board, not a parameter; written back as it was read
};

/// The form in which files of the vendor's program hold the number of a quantity.
enum class SavedIn : std::uint8_t {
  automatic,  ///< as on the wire, if that is no coarser than the unit; otherwise that is not known
  raw,        ///< as on the wire
  unit,
};

/// Whether text and JSON show secrets, such as passwords, or replace them by `hidden_text`.
enum class Secrets : std::uint8_t { hidden, shown };

/// The replacement for a secret.
inline constexpr const char* hidden_text = "(hidden)";

/// One member of a message or struct.
struct FieldInfo {
  const char* name = "";
  Description spec_name = "";  ///< the name in the specification; {AXIS} stands for the index
  Description summary = "";
  const UnitInfo* unit{};              ///< of a quantity
  const Range* range{};                ///< of the raw value; null: any
  std::span<const Special> special{};  ///< values that mean something else than a number
  std::uint16_t min_count{};           ///< of a list
  std::uint16_t max_count{};           ///< of a list; 0: limited only by the body size
  std::uint16_t align = 1;   ///< the value, or the length of a list of bytes, is a multiple of it
  FieldRole role{};          ///< the way in which clients use it
  Directed directed{};       ///< the sign convention, if any
  bool is_variable_value{};  ///< of the adjustable variable that the last VariableId names
  bool reserved{};           ///< sent as 0, and ignored
  bool optional{};           ///< may be omitted in JSON
  bool secret{};             ///< such as a password: text and JSON hide it
  /// The name in files of the vendor's program; {n} stands for the number of the element. "": the
  /// letters and digits of `spec_name`; null: the name is not certain.
  Description saved_as = "";
  SavedIn saved_in{};                     ///< the unit in such a file
  Availability since{};                   ///< the versions that have it
  bool unconfirmed{};                     ///< from a single source, or contradicted by another
  const AlternativeUnit* alternative{};   ///< null if it has one unit
  std::span<const LaterMeaning> later{};  ///< the earliest first
};

/// The possible effects of a message on a board and its camera.
using Effects = Flags<Effect>;

/// One body layout of a command.
struct MessageInfo {
  const char* name = "";
  const char* command = "";  ///< such as "CMD_CONTROL"
  Description summary = "";
  std::uint8_t id{};
  Direction direction{};
  std::size_t min_size{};                   ///< of the body, in bytes
  std::size_t max_size{};                   ///< of the body, in bytes
  Availability since{};                     ///< the versions that know it
  bool unconfirmed{};                       ///< from a single source, or contradicted by another
  std::size_t secret_from = max_body_size;  ///< the first byte that may belong to a secret field
  Availability until{};  ///< these versions and later ones no longer accept it; 0: all do
  /// Names of the response messages. response_policy() returns the rest of the policy.
  std::span<const char* const> answers{};
  const char* stores = "";  ///< the message whose settings it writes, or ""
  Effects effects{};        ///< empty for a message from the board
  /// The preparation before the request is sent, such as how to hold the camera; "" if none.
  Description preparation = "";

  /// True if text and JSON hide part of the message, such as a password.
  constexpr bool has_secret() const noexcept { return secret_from != max_body_size; }
  /// True if it is sent in this direction.
  constexpr bool travels(Direction way) const noexcept {
    return direction == way || direction == Direction::both;
  }
};

/// The element count of a list, for which the protocol has a field. Messages do not store it: the
/// list knows its size.
struct Counter {
  std::size_t count{};
};

/// The `tail` member of messages that later firmware may extend.
inline constexpr FieldInfo tail_field{
    .name = "tail", .summary = "Bytes appended by later firmware.", .optional = true};

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

/// The parts of a packed value. Generated.
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
