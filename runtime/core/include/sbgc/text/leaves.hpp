/// Iterates over the values of a message, each with its metadata. Requires a hosted standard
/// library.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include <sbgc/field_path.hpp>
#include <sbgc/internal/table_access.hpp>
#include <sbgc/meta.hpp>
#include <sbgc/meta/variables.hpp>
#include <sbgc/text/values.hpp>

namespace sbgc {

/// The storage of the raw value of a leaf.
enum class LeafKind : std::uint8_t { integer, real, bytes, text, counter };

/// One value of a message. All views are valid only during the call.
struct Leaf {
  const FieldPath& path;
  const FieldInfo& field;
  LeafKind kind{};
  std::int64_t integer{};                 ///< of an integer or a counter, as on the wire
  bool is_u64{};                          ///< `integer` holds the bits of an unsigned number
  double real{};                          ///< of a real number
  std::span<const std::uint8_t> bytes{};  ///< of bytes without a meaning as numbers
  std::string_view text{};                ///< of a text
  // The meaning of the value; at most one of these is set.
  const UnitInfo* unit{};      ///< the unit in effect, which a flag or a variable may select
  const EnumInfo* names{};     ///< of enum values or flags
  const PackedInfo* packed{};  ///< of a packed value
  NumberType announced{};      ///< of a number whose type another message has announced
  /// Set if the firmware is not known: the meaning assumed is the one before this.
  const LaterMeaning* assumed_before{};
  // The position in the body.
  std::size_t offset{};  ///< 0 if only this value is searched for
  std::size_t size{};    ///< of bytes and text
  Secrets secrets{};     ///< whether the texts below show the value if it is secret

  /// Returns the number on the wire; a double may not hold all of its digits.
  constexpr double number() const noexcept {
    if (kind == LeafKind::real) return real;
    return is_u64 ? static_cast<double>(static_cast<std::uint64_t>(integer))
                  : static_cast<double>(integer);
  }
};

/// Returns true if the value is secret and not empty.
inline bool holds_secret(const Leaf& leaf) {
  return leaf.field.secret && !(leaf.text.empty() && leaf.bytes.empty());
}

/// Returns true if texts hide the value.
inline bool is_hidden(const Leaf& leaf) {
  return holds_secret(leaf) && leaf.secrets == Secrets::hidden;
}

/// Returns true if the leaf is reserved and 0, as required.
inline bool is_unused(const Leaf& leaf) {
  if (!leaf.field.reserved) return false;
  for (const std::uint8_t byte : leaf.bytes) {
    if (byte != 0) return false;
  }
  return leaf.integer == 0;
}

namespace detail {

inline void put_raw_other(TextOutput& out, const Leaf& leaf) {
  if (is_hidden(leaf)) return out.put(hidden_text);
  switch (leaf.kind) {
    case LeafKind::integer:
    case LeafKind::counter: return;
    case LeafKind::real: return out.put(real_text(leaf.real, leaf.size));
    case LeafKind::bytes: return out.put_hex(leaf.bytes);
    case LeafKind::text: return put_quoted(out, leaf.text);
  }
}

}  // namespace detail

/// Writes the raw value: "-1365", "0.5", "00ff", "\"Drone\"".
inline void put_raw(TextOutput& out, const Leaf& leaf) {
  // Most values are integers, which are handled first for speed.
  if (leaf.kind != LeafKind::integer && leaf.kind != LeafKind::counter) {
    return detail::put_raw_other(out, leaf);
  }
  if (leaf.is_u64) return out.put(static_cast<std::uint64_t>(leaf.integer));
  out.put(leaf.integer);
}
/// Returns the text that put_raw() writes.
inline std::string raw_text(const Leaf& leaf) {
  return detail::text_of([&](TextOutput& out) { put_raw(out, leaf); });
}

/// Returns the meaning of a sentinel; null for any other value.
inline const char* special_meaning(const Leaf& leaf) {
  if (leaf.kind != LeafKind::integer) return nullptr;
  for (const Special& special : leaf.field.special) {
    if (special.value == leaf.integer) return special.meaning;
  }
  return nullptr;
}

namespace detail {

SBGC_NOINLINE inline void put_packed(TextOutput& out, const Leaf& leaf) {
  const auto raw = static_cast<std::uint64_t>(leaf.integer);
  out.put(packed_text(*leaf.packed, low_bits(raw, leaf.size)));
}

inline void put_certain_meaning(TextOutput& out, const Leaf& leaf) {
  if (leaf.unit != nullptr) {
    if (leaf.unit->is_plain()) return;
    detail::put_in_unit(out, leaf.unit->real(leaf.number()), *leaf.unit);
  } else if (leaf.names != nullptr) {
    if (!leaf.names->is_flags) return out.put(detail::value_name(*leaf.names, leaf.integer));
    detail::put_flags(out, *leaf.names, static_cast<std::uint32_t>(leaf.integer));
  } else if (leaf.packed != nullptr) {
    put_packed(out, leaf);
  } else if (leaf.announced != NumberType::none) {
    out.put(name(leaf.announced));
  }
}

}  // namespace detail

namespace detail {

/// Returns a version in the notation of the protocol, if it has one.
template <class Version>
std::string version_text(std::uint16_t version) {
  if constexpr (std::is_integral_v<Version>) {
    return std::to_string(version);
  } else {
    return packed_text(PackedMeta<Version>::info, version);
  }
}

}  // namespace detail

/// Returns the assumption about the board: "before firmware 2.73.1"; "" if there is none.
inline std::string assumption_text(const Leaf& leaf) {
  if (leaf.assumed_before == nullptr) return "";
  return "before firmware " +
         detail::version_text<VersionTypes::Firmware>(leaf.assumed_before->since.firmware);
}

namespace detail {

SBGC_NOINLINE inline void put_assumed_meaning(TextOutput& out, const Leaf& leaf) {
  const std::string meaning = text_of([&](TextOutput& text) { put_certain_meaning(text, leaf); });
  out.put(meaning.empty() ? raw_text(leaf) : meaning);
  out.put(" (");
  out.put(assumption_text(leaf));
  out.put(')');
}

}  // namespace detail

/// Writes the meaning of the raw value: "-30 deg", "MODE_ANGLE", "2.43b9", "use the current
/// profile"; nothing if the number itself is the meaning. If the meaning depends on the firmware
/// and that is not known, the assumption follows: "0.12 (before firmware 2.73.1)".
inline void put_meaning(TextOutput& out, const Leaf& leaf) {
  if (const char* const special = special_meaning(leaf)) return out.put(special);
  if (leaf.assumed_before != nullptr) return detail::put_assumed_meaning(out, leaf);
  detail::put_certain_meaning(out, leaf);
}
/// Returns the text that put_meaning() writes.
inline std::string meaning_text(const Leaf& leaf) {
  return detail::text_of([&](TextOutput& out) { put_meaning(out, leaf); });
}

/// Returns the meaning of the value if it has one, else the raw value. A sentinel is followed by
/// its meaning in parentheses: "21000 (pause)".
inline std::string value_text(const Leaf& leaf) {
  std::string meaning = meaning_text(leaf);
  if (meaning.empty() || leaf.announced != NumberType::none) return raw_text(leaf);
  if (special_meaning(leaf) != nullptr) return raw_text(leaf) + " (" + meaning + ')';
  return meaning.find(", ") == std::string::npos ? meaning : '(' + meaning + ')';
}

/// Writes the path of a value, such as "params[3].param_id".
inline void put_path(TextOutput& out, const FieldPath& path) {
  char buffer[128];
  out.put(std::string_view(buffer, path.write(buffer, sizeof buffer)));
}
/// Returns the path as text: "axes.pitch.angle".
inline std::string to_string(const FieldPath& path) {
  return detail::text_of([&](TextOutput& out) { put_path(out, path); });
}

namespace detail {

/// Iterates over the values in wire order.
class LeafWalk {
 public:
  using Use = void (*)(void* user, const Leaf& leaf);

  LeafWalk(Use use, void* user, const Availability& versions = {})
      : use_(use), user_(user), versions_(versions) {}

  void members(const StructTable& table, const void* object, const FieldPath* parent = nullptr) {
    const VariableInfo* variable = nullptr;  // the one that the last VariableId names, or null
    const FieldInfo* field = table.fields;
    for (const Slot& slot : table.slots) {
      const void* const at = moved(object, slot.offset);
      const FieldPath path{parent, field->name};
      if (slot.type->is_variable_id) variable = find_variable(load<msg::VariableId>(at));
      if (field->is_variable_value && variable != nullptr && is_plain_integer(*slot.type)) {
        scalar(*field, *slot.type, at, path, {.unit = &variable->unit}, variable->later);
      } else {
        value(*field, *slot.type, at, path);
      }
      ++field;
    }
    if (table.tail.type == nullptr) return;
    const void* const tail = moved(object, table.tail.offset);
    if (size_at(*table.tail.type, tail) == 0) return;
    value(tail_field, *table.tail.type, tail, FieldPath{parent, tail_field.name});
  }

 protected:
  SBGC_ALWAYS_INLINE void value(const FieldInfo& field, const ValueType& type, const void* at,
                                const FieldPath& path) {
    // Most values are numbers, which are handled first for speed.
    if (type.kind != Kind::scalar) return other(field, type, at, path);
    if (is_real(type.raw) || field.alternative != nullptr || !field.later.empty()) {
      return scalar(field, type, at, path, type.meaning, field.later);
    }
    integer(field, type, at, path, type.meaning, nullptr);
  }
  SBGC_NOINLINE void other(const FieldInfo& field, const ValueType& type, const void* at,
                           const FieldPath& path) {
    switch (type.kind) {
      case Kind::scalar: return;
      case Kind::axes: return axes(field, type, at, path);
      case Kind::group: return members(*type.group, at, &path);
      case Kind::array:
      case Kind::list: return list(field, type, at, path);
      case Kind::bytes:
      case Kind::text: return chars(field, type, at, path);
      case Kind::counter:
        return add({.path = path,
                    .field = field,
                    .kind = LeafKind::counter,
                    .integer = static_cast<std::int64_t>(counted(type, at)),
                    .size = type.wire});
      case Kind::number: return number(field, load<Number>(at), path);
      case Kind::optional:
        if (is_present(type, at)) value(field, *type.element, at, path);
        return;
    }
  }
  /// Walks over all values without using them, for values that select the unit of another one.
  void skip(const StructTable& table, const void* object) {
    const Use use = std::exchange(use_, [](void*, const Leaf&) {});
    members(table, object);
    use_ = use;
    offset_ = 0;
  }
  void axes(const FieldInfo& field, const ValueType& type, const void* at, const FieldPath& path) {
    for (std::size_t i = 0; i < type.count; ++i) {
      value(field, *type.element, element_at(type, at, i),
            FieldPath{&path, type.group->fields[i].name, i});
    }
  }
  void list(const FieldInfo& field, const ValueType& type, const void* at, const FieldPath& path) {
    const std::size_t size = size_at(type, at);
    for (std::size_t i = 0; i < size; ++i) {
      value(field, *type.element, element_at(type, at, i), FieldPath{&path, "", i});
    }
  }
  /// Handles any scalar; its meaning may differ from that of its type.
  void scalar(const FieldInfo& field, const ValueType& type, const void* at, const FieldPath& path,
              ScalarInfo info, const std::span<const LaterMeaning>& later) {
    const LaterMeaning* const assumed = later.empty() ? nullptr : change(info, later);
    if (info.unit != nullptr && field.alternative != nullptr) {
      info.unit = selected_unit(*info.unit, *field.alternative, path);
    }
    if (is_real(type.raw)) {
      return add({.path = path,
                  .field = field,
                  .kind = LeafKind::real,
                  .real = load_real(type.raw, at),
                  .unit = info.unit,
                  .assumed_before = assumed,
                  .size = type.wire});
    }
    integer(field, type, at, path, info, assumed);
  }
  void integer(const FieldInfo& field, const ValueType& type, const void* at, const FieldPath& path,
               const ScalarInfo& info, const LaterMeaning* assumed) {
    const std::int64_t raw = load_integer(type.raw, at);
    // Only a flag set or a packed value can select the unit of a later value.
    if (info.names != nullptr || info.packed != nullptr) remember(raw, path);
    add({.path = path,
         .field = field,
         .kind = LeafKind::integer,
         .integer = raw,
         .is_u64 = type.raw == RawType::u64,
         .unit = info.unit,
         .names = info.names,
         .packed = info.packed,
         .assumed_before = assumed,
         .size = type.wire});
  }
  void number(const FieldInfo& field, const Number& number, const FieldPath& path) {
    const bool is_real = number.type == NumberType::f32;
    add({.path = path,
         .field = field,
         .kind = is_real ? LeafKind::real : LeafKind::integer,
         .integer = is_real ? 0 : number.integer(),
         .real = is_real ? static_cast<double>(number.real()) : 0,
         .announced = number.type,
         .size = size_of(number.type)});
  }
  void chars(const FieldInfo& field, const ValueType& type, const void* at, const FieldPath& path) {
    const std::size_t size = size_at(type, at);
    const void* const begin = moved(at, type.begin);
    if (type.kind == Kind::bytes) {
      return add({.path = path,
                  .field = field,
                  .kind = LeafKind::bytes,
                  .bytes = {static_cast<const std::uint8_t*>(begin), size},
                  .size = size});
    }
    add({.path = path,
         .field = field,
         .kind = LeafKind::text,
         .text = {static_cast<const char*>(begin), size},
         .size = type.is_bounded ? 1 + size : type.count});
  }
  /// Changes the meaning of a value to the one that applies to the board. If the firmware is not
  /// known, returns the later meaning that was ignored.
  SBGC_NOINLINE const LaterMeaning* change(ScalarInfo& info,
                                           std::span<const LaterMeaning> later) const {
    if (versions_.firmware == 0) return &later.front();
    if (const LaterMeaning* const found = meaning_in(later, versions_)) {
      info = {found->unit, found->names, found->packed};
    }
    return nullptr;
  }
  void add(Leaf&& leaf) {
    leaf.offset = offset_;
    offset_ += leaf.size;
    use_(user_, leaf);
  }

  /// A number of the message that may select the unit of a later one.
  struct UnitSource {
    const char* name;
    const char* axis;  ///< "" if it has none
    std::int64_t raw;
  };

  void remember(std::int64_t raw, const FieldPath& path) {
    if (numbers_.empty()) numbers_.reserve(16);
    if (path.parent == nullptr) numbers_.push_back({path.name, "", raw});
    if (path.parent == nullptr) return;
    const FieldPath& above = *path.parent;
    if (above.parent == nullptr) numbers_.push_back({above.name, path.name, raw});
    // A member of a group that exists for each axis.
    if (above.parent != nullptr && above.parent->parent == nullptr) {
      numbers_.push_back({path.name, above.name, raw});
    }
  }

  const UnitInfo* selected_unit(const UnitInfo& usual, const AlternativeUnit& other,
                                const FieldPath& path) const {
    for (const UnitSource& number : numbers_) {
      if (number.name != std::string_view(other.of)) continue;
      if (*number.axis != '\0' && !leads_through(path, number.axis)) continue;
      if ((number.raw & other.mask) != 0) return other.unit;
    }
    return &usual;
  }

  static bool leads_through(const FieldPath& path, std::string_view name) {
    return path.name == name || (path.parent != nullptr && leads_through(*path.parent, name));
  }

 private:
  Use use_;
  void* user_;
  Availability versions_;
  std::vector<UnitSource> numbers_;
  std::size_t offset_ = 0;  // in the body
};

template <class User>
void call_user(void* user, const Leaf& leaf) {
  (*static_cast<User*>(user))(leaf);
}

}  // namespace detail

/// Calls `use(const Leaf&)` for every value of a message or struct, in wire order. Skips missing
/// members and an empty tail. Values are interpreted as on a board with these versions; without
/// versions in the usual way, and Leaf::assumed_before says where later firmware differs.
template <class T, class User>
void for_each_leaf(const T& message, User&& use, const Availability& versions = {}) {
  detail::LeafWalk walk(detail::call_user<std::remove_reference_t<User>>, &use, versions);
  walk.members(detail::table_of<T>(), &message);
}

}  // namespace sbgc
