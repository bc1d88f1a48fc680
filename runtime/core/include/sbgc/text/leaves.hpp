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
#include <sbgc/meta.hpp>
#include <sbgc/meta/enums.hpp>
#include <sbgc/meta/units.hpp>
#include <sbgc/meta/variables.hpp>
#include <sbgc/text/values.hpp>

namespace sbgc {

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
  // The position in the body.
  std::size_t offset{};
  std::size_t size{};
};

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

/// Writes the meaning of the raw value: "-30 deg", "MODE_ANGLE", "2.43b9", "use the current
/// profile"; nothing if the number itself is the meaning.
inline void put_meaning(TextOutput& out, const Leaf& leaf) {
  if (const char* const special = special_meaning(leaf)) return out.put(special);
  if (leaf.unit != nullptr) {
    if (leaf.unit->is_plain()) return;
    const double raw = leaf.kind == LeafKind::real ? leaf.real : static_cast<double>(leaf.integer);
    detail::put_in_unit(out, leaf.unit->real(raw), *leaf.unit);
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

  LeafWalk(Use use, void* user) : use_(use), user_(user) {}

  template <class T>
  void members(const T& value, const FieldPath* parent) {
    Meta<T>::visit(value, Members{*this, parent});
  }

 private:
  struct Members {
    LeafWalk& walk;
    const FieldPath* parent = nullptr;       ///< the path of the struct itself
    const VariableInfo* variable = nullptr;  ///< the one that the last VariableId names, or null

    template <class T>
    void operator()(const FieldInfo& field, const T& member) {
      const FieldPath path{parent, field.name};
      if constexpr (std::is_same_v<T, msg::VariableId>) variable = find_variable(member);
      if constexpr (std::is_integral_v<T>) {
        if (field.is_variable_value && variable != nullptr) {
          return walk.integer(member, field, path, wire_size<T>, {.unit = &variable->unit});
        }
      }
      walk.value(member, field, path);
    }
  };

  /// The meaning of an integer.
  struct Meaning {
    const UnitInfo* unit = nullptr;
    const EnumInfo* names = nullptr;
    const PackedInfo* packed = nullptr;
    bool is_u64 = false;
  };

  template <class T>
  void value(const T& value, const FieldInfo& field, const FieldPath& path) {
    if constexpr (std::is_enum_v<T>) {
      integer(static_cast<std::underlying_type_t<T>>(value), field, path, wire_size<T>,
              {.names = &EnumMeta<T>::info});
    } else if constexpr (std::is_floating_point_v<T>) {
      real(static_cast<double>(value), field, path, nullptr, wire_size<T>);
    } else if constexpr (std::is_arithmetic_v<T>) {
      integer(static_cast<std::int64_t>(value), field, path, wire_size<T>,
              {.is_u64 = std::is_same_v<T, std::uint64_t>});
    } else if constexpr (requires { UnitMeta<T>::info; }) {
      quantity(value, field, path);
    } else if constexpr (requires { typename T::flag_type; }) {
      integer(value.raw(), field, path, wire_size<T>,
              {.names = &EnumMeta<typename T::flag_type>::info});
    } else if constexpr (requires { PackedMeta<T>::info; }) {
      integer(static_cast<std::int64_t>(value.raw()), field, path, wire_size<T>,
              {.packed = &PackedMeta<T>::info,
               .is_u64 = std::is_same_v<typename T::raw_type, std::uint64_t>});
    } else if constexpr (RawValue<T>) {
      integer(value.raw(), field, path, wire_size<T>, {});
    } else {
      members(value, &path);
    }
  }
  void value(Counter counter, const FieldInfo& field, const FieldPath& path) {
    add({.path = path,
         .field = field,
         .kind = LeafKind::counter,
         .integer = static_cast<std::int64_t>(counter.count),
         .size = wire_size<std::uint8_t>});
  }
  void value(const Number& number, const FieldInfo& field, const FieldPath& path) {
    const bool is_real = number.type == NumberType::f32;
    add({.path = path,
         .field = field,
         .kind = is_real ? LeafKind::real : LeafKind::integer,
         .integer = is_real ? 0 : number.integer(),
         .real = is_real ? static_cast<double>(number.real()) : 0,
         .announced = number.type,
         .size = size_of(number.type)});
  }
  template <class T>
  void value(const Optional<T>& optional, const FieldInfo& field, const FieldPath& path) {
    if (optional) value(*optional, field, path);
  }
  template <class T>
  void value(const Axes<T>& axes, const FieldInfo& field, const FieldPath& path) {
    for (std::size_t i = 0; i < axes.size(); ++i) {
      value(axes[i], field, {&path, Meta<Axes<T>>::fields[i].name});
    }
  }
  template <class T>
  void value(const Xyz<T>& xyz, const FieldInfo& field, const FieldPath& path) {
    for (std::size_t i = 0; i < xyz.size(); ++i) {
      value(xyz[i], field, {&path, Meta<Xyz<T>>::fields[i].name});
    }
  }
  template <std::size_t n>
  void value(const Bytes<n>& bytes, const FieldInfo& field, const FieldPath& path) {
    this->bytes(bytes, field, path);
  }
  template <std::size_t n>
  void value(const BoundedBytes<n>& bytes, const FieldInfo& field, const FieldPath& path) {
    if (&field != &tail_field || !bytes.empty()) {
      this->bytes({bytes.data(), bytes.size()}, field, path);
    }
  }
  template <std::size_t n>
  void value(const Text<n>& text, const FieldInfo& field, const FieldPath& path) {
    this->text({text.data(), text.size()}, n, field, path);
  }
  template <std::size_t n>
  void value(const BoundedText<n>& text, const FieldInfo& field, const FieldPath& path) {
    this->text({text.data(), text.size()}, 1 + text.size(), field, path);
  }
  template <class T, std::size_t n>
  void value(const std::array<T, n>& array, const FieldInfo& field, const FieldPath& path) {
    list(array.data(), n, field, path);
  }
  template <class T, std::size_t n>
  void value(const BoundedArray<T, n>& array, const FieldInfo& field, const FieldPath& path) {
    list(array.data(), array.size(), field, path);
  }
  template <class T>
  void list(const T* elements, std::size_t size, const FieldInfo& field, const FieldPath& path) {
    for (std::size_t i = 0; i < size; ++i) value(elements[i], field, {&path, "", i});
  }

  template <class Q>
  void quantity(Q value, const FieldInfo& field, const FieldPath& path) {
    const UnitInfo* const unit = unit_in_force(UnitMeta<Q>::info, field, path);
    if constexpr (std::is_floating_point_v<typename Q::raw_type>) {
      real(static_cast<double>(value.raw()), field, path, unit, wire_size<Q>);
    } else {
      integer(value.raw(), field, path, wire_size<Q>, {.unit = unit});
    }
  }

  void integer(std::int64_t raw, const FieldInfo& field, const FieldPath& path, std::size_t size,
               const Meaning& meaning) {
    // Only a flag set or a packed value can select the unit of a later value.
    if (meaning.names != nullptr || meaning.packed != nullptr) remember(raw, path);
    add({.path = path,
         .field = field,
         .kind = LeafKind::integer,
         .integer = raw,
         .is_u64 = meaning.is_u64,
         .unit = meaning.unit,
         .names = meaning.names,
         .packed = meaning.packed,
         .size = size});
  }
  void real(double raw, const FieldInfo& field, const FieldPath& path, const UnitInfo* unit,
            std::size_t size) {
    add({.path = path,
         .field = field,
         .kind = LeafKind::real,
         .real = raw,
         .unit = unit,
         .size = size});
  }
  void bytes(std::span<const std::uint8_t> bytes, const FieldInfo& field, const FieldPath& path) {
    add({.path = path,
         .field = field,
         .kind = LeafKind::bytes,
         .bytes = bytes,
         .size = bytes.size()});
  }
  void text(std::string_view text, std::size_t size, const FieldInfo& field,
            const FieldPath& path) {
    add({.path = path, .field = field, .kind = LeafKind::text, .text = text, .size = size});
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
    if (path.parent != nullptr && path.parent->parent == nullptr) {
      numbers_.push_back({path.parent->name, path.name, raw});
    }
  }

  const UnitInfo* unit_in_force(const UnitInfo& usual, const FieldInfo& field,
                                const FieldPath& path) const {
    return field.alternative == nullptr ? &usual : selected_unit(usual, field, path);
  }
  const UnitInfo* selected_unit(const UnitInfo& usual, const FieldInfo& field,
                                const FieldPath& path) const {
    for (const UnitSource& number : numbers_) {
      if (number.name != std::string_view(field.alternative->of)) continue;
      if (*number.axis != '\0' && !leads_through(path, number.axis)) continue;
      if ((number.raw & field.alternative->mask) != 0) return field.alternative->unit;
    }
    return &usual;
  }

  static bool leads_through(const FieldPath& path, std::string_view name) {
    return path.name == name || (path.parent != nullptr && leads_through(*path.parent, name));
  }

  Use use_;
  void* user_;
  std::vector<UnitSource> numbers_;
  std::size_t offset_ = 0;  // in the body
};

template <class User>
void call_user(void* user, const Leaf& leaf) {
  (*static_cast<User*>(user))(leaf);
}

}  // namespace detail

/// Calls `use(const Leaf&)` for every value of a message or struct, in wire order. Skips missing
/// members and an empty tail.
template <class T, class User>
void for_each_leaf(const T& message, User&& use) {
  detail::LeafWalk walk(detail::call_user<std::remove_reference_t<User>>, &use);
  walk.members(message, nullptr);
}

}  // namespace sbgc
