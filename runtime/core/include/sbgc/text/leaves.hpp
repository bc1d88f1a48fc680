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

#include <sbgc/detail/walk_members.hpp>
#include <sbgc/field_path.hpp>
#include <sbgc/internal/scalar_info.hpp>
#include <sbgc/meta.hpp>
#include <sbgc/text/values.hpp>

namespace sbgc {

/// How the raw value of a leaf is stored.
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
  /// Set if the firmware is not known: the meaning is that before this one.
  const LaterMeaning* assumed_before{};
  // The position in the body.
  std::size_t offset{};
  std::size_t size{};
  Secrets secrets{};  ///< whether the texts below show the value if it is secret

  /// Returns the number on the wire, of which a double may not hold all digits.
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

/// Returns true if the leaf is reserved and 0, as it should be.
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
  // Most values are integers, which should not pay for the rest.
  if (leaf.kind != LeafKind::integer && leaf.kind != LeafKind::counter) {
    return detail::put_raw_other(out, leaf);
  }
  if (leaf.is_u64) return out.put(static_cast<std::uint64_t>(leaf.integer));
  out.put(leaf.integer);
}
/// Returns what put_raw() writes.
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

inline void put_certain_meaning(TextOutput& out, const Leaf& leaf) {
  if (leaf.unit != nullptr) {
    if (leaf.unit->is_plain()) return;
    detail::put_in_unit(out, leaf.unit->real(leaf.number()), *leaf.unit);
  } else if (leaf.names != nullptr) {
    if (!leaf.names->is_flags) return out.put(detail::value_name(*leaf.names, leaf.integer));
    detail::put_flags(out, *leaf.names, static_cast<std::uint32_t>(leaf.integer));
  } else if (leaf.packed != nullptr) {
    out.put(detail::packed_text(
        *leaf.packed, detail::low_bits(static_cast<std::uint64_t>(leaf.integer), leaf.size)));
  } else if (leaf.announced != NumberType::none) {
    out.put(name(leaf.announced));
  }
}

}  // namespace detail

namespace detail {

/// Returns a version in the notation of the protocol, if that has one.
template <class Version>
std::string version_text(std::uint16_t version) {
  if constexpr (std::is_integral_v<Version>) {
    return std::to_string(version);
  } else {
    return packed_text(PackedMeta<Version>::info, version);
  }
}

}  // namespace detail

/// Returns what the meaning assumes about the board: "before firmware 2.73.1"; "" if nothing.
inline std::string assumption_text(const Leaf& leaf) {
  if (leaf.assumed_before == nullptr) return "";
  return "before firmware " +
         detail::version_text<VersionTypes::Firmware>(leaf.assumed_before->since.firmware);
}

/// Writes the meaning of the raw value: "-30 deg", "MODE_ANGLE", "2.43b9", "use the current
/// profile"; nothing if the number itself is the meaning. A meaning that depends on the firmware,
/// if that is not known, is followed by what it assumes: "0.12 (before firmware 2.73.1)".
inline void put_meaning(TextOutput& out, const Leaf& leaf) {
  if (const char* const special = special_meaning(leaf)) return out.put(special);
  if (leaf.assumed_before == nullptr) return detail::put_certain_meaning(out, leaf);
  Leaf certain = leaf;
  certain.assumed_before = nullptr;
  const std::string meaning =
      detail::text_of([&](TextOutput& text) { detail::put_certain_meaning(text, certain); });
  out.put(meaning.empty() ? raw_text(leaf) : meaning);
  out.put(" (");
  out.put(assumption_text(leaf));
  out.put(')');
}
/// Returns what put_meaning() writes.
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

/// Iterates over the values in wire order. Instantiates functions per type of member, not per
/// member of each message or per use, because code size matters: the reference site downloads this
/// code.
class LeafWalk {
 public:
  using Use = void (*)(void* user, const Leaf& leaf);
  using Place = PathPlace;
  static constexpr bool is_inlined = false;

  LeafWalk(Use use, void* user, const Availability& versions = {})
      : use_(use), user_(user), versions_(versions) {}

  template <class T>
  SBGC_NOINLINE void members(const T& value, const FieldPath* parent) {
    walk_members(value, parent, *this);
  }

  // The handlers of the walk.

  template <class T>
  SBGC_NOINLINE void scalar(const T& value, const Place& place) {
    using Raw = RawOf<T>;
    ScalarInfo info = scalar_info<T>();
    const LaterMeaning* assumed = nullptr;
    if (!place.field.later.empty()) assumed = change(info, place.field.later);
    if (info.unit != nullptr) info.unit = unit_in_force(*info.unit, place);
    if constexpr (std::is_floating_point_v<Raw>) {
      add({.path = place.path,
           .field = place.field,
           .kind = LeafKind::real,
           .real = static_cast<double>(raw_of(value)),
           .unit = info.unit,
           .assumed_before = assumed,
           .size = wire_size<T>});
    } else {
      integer(static_cast<std::int64_t>(raw_of(value)), place, wire_size<T>, info,
              std::is_same_v<Raw, std::uint64_t>, assumed);
    }
  }
  template <class T>
  void variable(T value, const VariableInfo& variable, const Place& place) {
    ScalarInfo info{.unit = &variable.unit};
    const LaterMeaning* assumed = nullptr;
    if (!variable.later.empty()) assumed = change(info, variable.later);
    integer(static_cast<std::int64_t>(value), place, wire_size<T>, info, false, assumed);
  }
  void counter(const Counter& counter, const Place& place) {
    add({.path = place.path,
         .field = place.field,
         .kind = LeafKind::counter,
         .integer = static_cast<std::int64_t>(counter.count),
         .size = wire_size<std::uint8_t>});
  }
  void number(const Number& number, const Place& place) {
    const bool is_real = number.type == NumberType::f32;
    add({.path = place.path,
         .field = place.field,
         .kind = is_real ? LeafKind::real : LeafKind::integer,
         .integer = is_real ? 0 : number.integer(),
         .real = is_real ? static_cast<double>(number.real()) : 0,
         .announced = number.type,
         .size = size_of(number.type)});
  }
  template <class T>
  void bytes(const T& bytes, const Place& place) {
    if (&place.field == &tail_field && bytes.size() == 0) return;
    add({.path = place.path,
         .field = place.field,
         .kind = LeafKind::bytes,
         .bytes = {bytes.data(), bytes.size()},
         .size = bytes.size()});
  }
  template <class T>
  void text(const T& text, const Place& place) {
    add({.path = place.path,
         .field = place.field,
         .kind = LeafKind::text,
         .text = {text.data(), text.size()},
         .size = is_bounded<T> ? 1 + text.size() : T::capacity()});
  }
  template <class T>
  SBGC_NOINLINE void list(const T& list, const Place& place) {
    walk_list(list, place, *this);
  }
  template <class T>
  SBGC_NOINLINE void array(const T& array, const Place& place) {
    walk_list(array, place, *this);
  }
  template <class T>
  SBGC_NOINLINE void axes(const T& axes, const Place& place) {
    walk_axes(axes, place, *this);
  }
  template <class T>
  void optional(const T& optional, const Place& place) {
    if (optional) walk(*optional, place, *this);
  }
  template <class T>
  void group(const T& value, const Place& place) {
    members(value, place.parent());
  }

 private:
  void integer(std::int64_t raw, const Place& place, std::size_t size, const ScalarInfo& info,
               bool is_u64, const LaterMeaning* assumed_before) {
    // Only a flag set or a packed value can select the unit of a later value.
    if (info.names != nullptr || info.packed != nullptr) remember(raw, place.path);
    add({.path = place.path,
         .field = place.field,
         .kind = LeafKind::integer,
         .integer = raw,
         .is_u64 = is_u64,
         .unit = info.unit,
         .names = info.names,
         .packed = info.packed,
         .assumed_before = assumed_before,
         .size = size});
  }
  /// Changes what a value means to what it does on the board. Returns the meaning before which that
  /// is, if the firmware is not known.
  SBGC_NOINLINE const LaterMeaning* change(ScalarInfo& info,
                                           std::span<const LaterMeaning> later) const {
    if (versions_.firmware == 0) return &later.front();
    if (const LaterMeaning* const found = meaning_in(later, versions_)) {
      info = {found->unit, found->names, found->packed};
    }
    return nullptr;
  }
  void add(Leaf leaf) {
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
    // A member of a group for each axis.
    if (above.parent != nullptr && above.parent->parent == nullptr) {
      numbers_.push_back({path.name, above.name, raw});
    }
  }

  const UnitInfo* unit_in_force(const UnitInfo& usual, const Place& place) const {
    return place.field.alternative == nullptr ? &usual : selected_unit(usual, place);
  }
  const UnitInfo* selected_unit(const UnitInfo& usual, const Place& place) const {
    const AlternativeUnit& other = *place.field.alternative;
    for (const UnitSource& number : numbers_) {
      if (number.name != std::string_view(other.of)) continue;
      if (*number.axis != '\0' && !leads_through(place.path, number.axis)) continue;
      if ((number.raw & other.mask) != 0) return other.unit;
    }
    return &usual;
  }

  static bool leads_through(const FieldPath& path, std::string_view name) {
    return path.name == name || (path.parent != nullptr && leads_through(*path.parent, name));
  }

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
/// members and an empty tail. Values mean what they do on a board with these versions; without them
/// the usual, and Leaf::assumed_before says where later firmware differs.
template <class T, class User>
void for_each_leaf(const T& message, User&& use, const Availability& versions = {}) {
  detail::LeafWalk walk(detail::call_user<std::remove_reference_t<User>>, &use, versions);
  walk.members(message, nullptr);
}

}  // namespace sbgc
