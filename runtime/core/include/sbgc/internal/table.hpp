/// Tables of the message types: the position of each member in memory, and its properties. Code
/// that is not compiled for each message uses them to access messages; see table_access.hpp.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <new>
#include <span>
#include <type_traits>
#include <utility>

#include <sbgc/detail/kind.hpp>
#include <sbgc/internal/compiler.hpp>
#include <sbgc/meta.hpp>
#include <sbgc/wire_size.hpp>

namespace sbgc::detail {

/// The numbers of the wire. A signed one follows the unsigned one of its size.
enum class RawType : std::uint8_t { u8, i8, u16, i16, u24, i24, u32, i32, u64, i64, f32, f64 };

/// The tables that describe the meaning of a scalar's number. At most one of these is set.
struct ScalarInfo {
  const UnitInfo* unit{};
  const EnumInfo* names{};
  const PackedInfo* packed{};
};

struct StructTable;

/// A type of values. Which members are set depends on its kind.
struct ValueType {
  Kind kind{};
  RawType raw{};               ///< of a scalar
  bool is_bounded{};           ///< the number of bytes or elements varies; the first byte has it
  bool is_variable_id{};       ///< of an adjustable variable
  bool is_gimbal{};            ///< the axes are those of the gimbal
  bool has_versions{};         ///< not all firmware has each of its names
  std::uint16_t memory{};      ///< the size in memory
  std::uint16_t wire{};        ///< the size on the wire; 0 if it varies
  std::uint16_t count{};       ///< of bytes, characters or elements: the size, or the capacity
  std::uint16_t begin{};       ///< where these are; of an Optional, where the flag is
  std::uint8_t counted_as{};   ///< how much a counter counts for each element
  std::uint8_t uncounted{};    ///< the first elements, which a counter does not count
  ScalarInfo meaning{};        ///< of a scalar
  const ValueType* element{};  ///< of axes, an array, a list or an Optional
  const StructTable* group{};  ///< of a group or of axes
  void (*construct)(void*){};  ///< makes a new element of a list
};

/// The place of a member. The place of a counter is that of its list.
struct Slot {
  std::size_t offset{};
  const ValueType* type{};
};

/// Tells whether a value can violate the specification: never, on boards that lack something, or on
/// every board.
enum class Limited : std::uint8_t { never, on_some_boards, always };

/// A rule across fields, by their indices: one must not be above the other.
struct OrderRule {
  std::uint8_t low{};
  std::uint8_t high{};
  bool is_strict{};
};

/// The members of a message that a board uses, given the values of the others.
class UsedMembers {
 public:
  void add(std::size_t member) noexcept { whole_ |= std::uint64_t{1} << member; }
  void add_element(std::size_t member, std::size_t element) noexcept {
    elements_[element] |= std::uint64_t{1} << member;
  }

  bool is_whole(std::size_t member) const noexcept { return (whole_ >> member & 1U) != 0; }
  /// Returns a bit for each element of axes.
  unsigned elements(std::size_t member) const noexcept {
    unsigned bits = 0;
    for (std::size_t i = 0; i < elements_.size(); ++i) {
      bits |= static_cast<unsigned>(elements_[i] >> member & 1U) << i;
    }
    return bits;
  }

 private:
  std::uint64_t whole_{};
  std::array<std::uint64_t, 3> elements_{};
};

/// A message or struct: its members in wire order.
struct StructTable {
  std::span<const Slot> slots{};
  const FieldInfo* fields{};  ///< as many
  Slot tail{};  ///< of bytes that later firmware appends; without a type if there is none
  std::span<const OrderRule> rules{};
  void (*find_used)(const void* object, UsedMembers& used){};  ///< null: the board uses all
  const Limited* limits{};  ///< for each member, whether its value can violate the specification
};

template <class T>
consteval StructTable struct_table() noexcept;

template <class T>
struct TableOf {
  static constexpr StructTable table = struct_table<T>();
};

/// Returns the table of a message or struct.
template <class T>
constexpr const StructTable& table_of() noexcept {
  return TableOf<T>::table;
}

template <Scalar T>
constexpr RawType raw_type() noexcept {
  using Raw = RawOf<T>;
  if constexpr (std::is_floating_point_v<Raw>) {
    return sizeof(Raw) == 4 ? RawType::f32 : RawType::f64;
  } else {
    constexpr unsigned step = is_integer24<T>    ? 2
                              : sizeof(Raw) == 1 ? 0
                              : sizeof(Raw) == 2 ? 1
                              : sizeof(Raw) == 4 ? 3
                                                 : 4;
    return static_cast<RawType>(2 * step + (std::is_signed_v<Raw> ? 1 : 0));
  }
}

template <Scalar T>
constexpr ScalarInfo scalar_info() noexcept {
  if constexpr (std::is_enum_v<T>) {
    return {.names = &EnumMeta<T>::info};
  } else if constexpr (requires { typename T::flag_type; }) {
    return {.names = &EnumMeta<typename T::flag_type>::info};
  } else if constexpr (requires { PackedMeta<T>::info; }) {
    return {.packed = &PackedMeta<T>::info};
  } else if constexpr (requires { UnitMeta<T>::info; }) {
    return {.unit = &UnitMeta<T>::info};
  } else {
    return {};
  }
}

constexpr bool is_in_all(const Availability& since) noexcept {
  return since.firmware == 0 && since.board == 0 && since.features == 0;
}
constexpr bool has_versions(const EnumInfo& names) noexcept {
  for (const ValueInfo& value : names.values) {
    if (!is_in_all(value.since)) return true;
  }
  return false;
}
constexpr bool has_versions(const ScalarInfo& meaning) noexcept {
  if (meaning.names != nullptr) return has_versions(*meaning.names);
  if (meaning.packed == nullptr) return false;
  for (const PartInfo& part : meaning.packed->parts) {
    if (part.values != nullptr && has_versions(*part.values)) return true;
  }
  return false;
}

/// Returns a size or an offset, which must fit.
consteval std::uint16_t small(std::size_t size) noexcept {
  if (size > 0xFFFF) trap();
  return static_cast<std::uint16_t>(size);
}

template <class T>
void construct(void* place) {
  new (place) T{};
}

template <class T>
consteval ValueType value_type_of() noexcept;

template <class T>
inline constexpr ValueType value_type = value_type_of<T>();

/// The type of the counter of a list.
template <class List>
inline constexpr ValueType counter_type{
    .kind = Kind::counter, .wire = 1, .counted_as = 1, .element = &value_type<List>};
template <class List, Counting counting>
inline constexpr ValueType special_counter_type{
    .kind = Kind::counter,
    .wire = 1,
    .counted_as = counting == Counting::bytes ? wire_size<typename List::value_type> : 1,
    .uncounted = counting == Counting::minus_1 ? 1 : 0,
    .element = &value_type<List>};

template <class T>
consteval ValueType value_type_of() noexcept {
  constexpr Kind kind = kind_of<T>;
  ValueType type{.kind = kind, .is_bounded = is_bounded<T>, .memory = small(sizeof(T))};
  if constexpr (kind == Kind::scalar) {
    type.raw = raw_type<T>();
    type.is_variable_id = std::is_same_v<T, msg::VariableId>;
    type.meaning = scalar_info<T>();
    type.has_versions = has_versions(type.meaning);
  } else if constexpr (kind == Kind::optional) {
    type.begin = small(Places::of_flag<T>());
    type.element = &value_type<typename T::value_type>;
  } else if constexpr (kind == Kind::list) {
    type.count = small(T::capacity());
    type.begin = small(Places::of_elements<T>());
    type.element = &value_type<typename T::value_type>;
    type.construct = construct<typename T::value_type>;
  } else if constexpr (kind == Kind::axes || kind == Kind::array) {
    type.element = &value_type<ElementOf<T>>;
    type.count = small(sizeof(T) / sizeof(ElementOf<T>));
    type.is_gimbal = requires(T & axes) { axes.roll; };
  } else if constexpr (kind == Kind::bytes || kind == Kind::text) {
    type.count = small(sizeof(T) - (is_bounded<T> ? 1 : 0));
    type.begin = is_bounded<T> ? 1 : 0;
  }
  if constexpr (kind == Kind::group || kind == Kind::axes) type.group = &table_of<T>();
  if constexpr (kind != Kind::optional && kind != Kind::number && kind != Kind::list) {
    type.wire = small(wire_size<T>);
  }
  return type;
}

template <class T, std::size_t size = sizeof(ElementOf<T>)>
inline constexpr Slot axes_slots[] = {{0, &value_type<ElementOf<T>>},
                                      {size, &value_type<ElementOf<T>>},
                                      {2 * size, &value_type<ElementOf<T>>}};

/// The rules across the fields of a T.
template <class T>
inline constexpr auto rules_of = [] {
  std::array<OrderRule, 8> rules{};
  std::size_t count = 0;
  Meta<T>::rules(T{}, [&](const FieldInfo& low, auto&, const FieldInfo& high, auto&, bool strict) {
    const auto index = [](const FieldInfo& field) {
      return static_cast<std::uint8_t>(&field - Meta<T>::fields);
    };
    rules[count++] = {index(low), index(high), strict};
  });
  return std::pair{rules, count};
}();

/// A visitor of Meta<T>::visit_used().
template <class T>
struct UsedMembersFinder {
  UsedMembers& used;

  void operator()(const FieldInfo& field, const auto&) { used.add(index(field)); }
  void element(const FieldInfo& field, const auto&, std::size_t i) {
    used.add_element(index(field), i);
  }
  static std::size_t index(const FieldInfo& field) {
    static_assert(std::size(Meta<T>::fields) <= 64, "each has a bit of UsedMembers");
    return static_cast<std::size_t>(&field - Meta<T>::fields);
  }
};
template <class T>
void find_used(const void* object, UsedMembers& used) {
  Meta<T>::visit_used(*static_cast<const T*>(object), UsedMembersFinder<T>{used});
}

constexpr Limited greater(Limited a, Limited b) noexcept { return a < b ? b : a; }
/// Returns true if the wire can carry numbers outside the range.
constexpr bool can_leave(const Range& range, const ValueType& type) noexcept {
  if (type.kind == Kind::axes || type.kind == Kind::array) return can_leave(range, *type.element);
  if (type.kind != Kind::scalar || type.raw >= RawType::u64) return true;
  const bool is_signed = (static_cast<unsigned>(type.raw) & 1U) != 0;
  const auto numbers = static_cast<double>(std::uint64_t{1} << (8U * type.wire));
  const double lowest = is_signed ? -numbers / 2 : 0;
  return range.lowest > lowest || range.highest < lowest + numbers - 1;
}
constexpr Limited limited(const FieldInfo& field, const ValueType& type) noexcept {
  if (field.align != 1 || field.is_variable_value) return Limited::always;
  if (field.range != nullptr && can_leave(*field.range, type)) return Limited::always;
  for (const LaterMeaning& later : field.later) {
    if (later.range != nullptr && can_leave(*later.range, type)) return Limited::always;
  }
  return is_in_all(field.since) ? Limited::never : Limited::on_some_boards;
}
constexpr Limited limited(const StructTable& table) noexcept {
  if (!table.rules.empty() || table.limits == nullptr) return Limited::always;
  Limited most = Limited::never;
  for (std::size_t i = 0; i < table.slots.size(); ++i) most = greater(most, table.limits[i]);
  return most;
}
/// The same for any field. The number of elements is limited, too.
constexpr Limited limited(const ValueType& type) noexcept {
  switch (type.kind) {
    case Kind::scalar:
      if (type.is_variable_id) return Limited::always;  // its value has the limits of the variable
      return type.has_versions ? Limited::on_some_boards : Limited::never;
    case Kind::axes:
    case Kind::array: return limited(*type.element);
    case Kind::group: return limited(*type.group);
    case Kind::bytes: return type.is_bounded ? Limited::always : Limited::never;
    case Kind::text:
    case Kind::number: return Limited::never;
    default: return Limited::always;
  }
}

template <class T, class Members>
inline constexpr auto limited_members = [] {
  std::array<Limited, std::size(Meta<T>::fields)> limits{};
  const Slot* slot = Meta<T>::template slots<Members>;
  for (std::size_t i = 0; i < limits.size(); ++i, ++slot) {
    limits[i] = greater(limited(Meta<T>::fields[i], *slot->type), limited(*slot->type));
  }
  return limits;
}();

/// The struct with all members of a T, except perhaps the tail.
template <class T>
struct WithoutTail {
  using Type = T;
};

// These compilers accept that WithSurplus has its own members.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Winvalid-offsetof"

template <class T>
consteval StructTable struct_table() noexcept {
  using Members = typename WithoutTail<T>::Type;
  static_assert(
      requires { sizeof(Meta<Members>); }, "include <sbgc/meta/all.hpp>, or its family");
  StructTable table;
  if constexpr (kind_of<T> == Kind::axes) {
    table.slots = axes_slots<T>;
    table.fields = Meta<T>::fields;
  } else if constexpr (requires { Meta<T>::template slots<Members>; }) {
    table.slots = Meta<T>::template slots<Members>;
    table.fields = Meta<T>::fields;
    table.limits = limited_members<T, Members>.data();
  }
  if constexpr (requires(const Members& value) { Meta<Members>::rules(value, [](auto&&...) {}); }) {
    table.rules = {rules_of<Members>.first.data(), rules_of<Members>.second};
  }
  if constexpr (requires(const Members& v, UsedMembersFinder<Members> finder) {
                  Meta<Members>::visit_used(v, finder);
                }) {
    table.find_used = find_used<Members>;
  }
  if constexpr (requires(const T& value) { value.tail; }) {
    table.tail = {offsetof(T, tail), &value_type<decltype(T::tail)>};
  }
  return table;
}

#pragma GCC diagnostic pop

}  // namespace sbgc::detail
