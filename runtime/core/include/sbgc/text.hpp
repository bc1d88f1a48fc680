/// Human-readable text of protocol values: `to_string(value)`.
///
///     Angle14, Milliseconds …    "-30 deg", "500 ms"
///     enum values                "MODE_ANGLE"; "200" without a name
///     flag sets                  "CONNECTION_USB | 0x40"; "0" without flags
///     packed values              "2.43b9", "RC_MODE_ANGLE, inverted 1"
///     messages                   "GetAngles{axes.roll.imu_angle = -30 deg, …}"
///     statuses, violations       "params: The body ends before this field does",
///                                "rc.pitch.rc_max_angle: 800 deg is above 720 deg"
///
/// The text of a message lists all values in wire order, except reserved bytes that are 0 and the
/// counts of lists. A secret, such as a password, is "(hidden)". Include the tables of the messages
/// to print: <sbgc/meta/control.hpp>, for example, or <sbgc/meta/all.hpp>. <sbgc/fmt.hpp> and
/// <sbgc/ostream.hpp> print the same text.
#pragma once

#include <string>
#include <type_traits>

#include <sbgc/printable.hpp>
#include <sbgc/text/leaves.hpp>
#include <sbgc/text/status.hpp>
#include <sbgc/text/values.hpp>
#include <sbgc/validate.hpp>

namespace sbgc {

namespace detail {

template <class T>
concept NamedEnum = std::is_enum_v<T> && requires {
  EnumMeta<T>::info;
};
template <class T>
concept NamedFlags = requires {
  EnumMeta<typename T::flag_type>::info;
};
template <class T>
concept NamedPacked = requires {
  PackedMeta<T>::info;
};
template <class T>
concept AnyQuantity = requires {
  UnitMeta<T>::info;
};
template <class T>
concept AnyStruct = requires(const T& value) {
  Meta<T>::visit(value, [](auto&&...) {});
};

inline std::string or_number(std::string text, std::int64_t raw) {
  if (text.empty()) return std::to_string(raw);
  return text;
}

/// Lists the values of a message: "{params = 3, …".
struct LeafList {
  void operator()(const Leaf& leaf) {
    if (leaf.kind == LeafKind::counter || is_unused(leaf)) return;
    text += is_empty ? "{" : ", ";
    is_empty = false;
    text += to_string(leaf.path) + " = " + value_text(leaf);
  }

  std::string text{};
  bool is_empty = true;
};

inline std::string leaves_text(const char* name, const StructTable& table, const void* message) {
  LeafList list{name};
  LeafWalk(call_user<LeafList>, &list).members(table, message);
  return list.text + (list.is_empty ? "{}" : "}");
}

/// Writes a raw value or limit in its unit.
inline void put_limit(TextOutput& out, double raw, const UnitInfo* unit) {
  if (unit == nullptr || unit->is_plain()) return put_number(out, raw);
  put_in_unit(out, unit->real(raw), *unit);
}

}  // namespace detail

template <class T>
  requires detail::NamedEnum<T> || detail::NamedFlags<T> || detail::NamedPacked<T> ||
      detail::AnyQuantity<T> || detail::AnyStruct<T>
inline constexpr bool is_printable<T> = true;
template <>
inline constexpr bool is_printable<Rule> = true;
template <>
inline constexpr bool is_printable<FieldPath> = true;
template <>
inline constexpr bool is_printable<Violation> = true;

/// Returns the name of a value, the names of flags, the parts of a packed value, or a number with
/// its unit. Unnamed values become numbers.
template <detail::NamedEnum E>
std::string to_string(E value) {
  const auto raw = static_cast<std::underlying_type_t<E>>(value);
  return detail::or_number(std::string(detail::value_name(EnumMeta<E>::info, raw)), raw);
}

template <detail::NamedFlags F>
std::string to_string(F flags) {
  const auto raw = flags.raw();
  return detail::or_number(detail::flag_names(EnumMeta<typename F::flag_type>::info, raw), raw);
}

template <detail::NamedPacked P>
std::string to_string(P packed) {
  const auto raw = packed.raw();
  return detail::or_number(detail::packed_text(PackedMeta<P>::info, raw), raw);
}

template <detail::AnyQuantity Q>
std::string to_string(Q quantity) {
  return detail::unit_text(UnitMeta<Q>::info.real(static_cast<double>(quantity.raw())),
                           UnitMeta<Q>::info);
}

/// Returns the text of a message or of a struct in it. Only a message begins with its name.
template <detail::AnyStruct T>
std::string to_string(const T& message) {
  const char* name = "";
  if constexpr (requires { Meta<T>::info; }) name = Meta<T>::info.name;
  return detail::leaves_text(name, detail::table_of<T>(), &message);
}

/// Returns the name of the rule.
inline std::string to_string(Rule rule) { return name(rule); }

namespace detail {

/// Writes a version in the notation of the protocol, if it has one.
template <class Version>
inline void put_version(TextOutput& out, double version) {
  if constexpr (std::is_integral_v<Version>) {
    put_limit(out, version, nullptr);
  } else {
    out.put(to_string(Version(static_cast<typename Version::raw_type>(version))));
  }
}

}  // namespace detail

/// Returns the names of features in an Availability: "EXT_MOTORS".
inline std::string feature_names(std::uint64_t mask) {
  std::string result;
  for (const FeatureInfo& feature : features) {
    if (feature.mask == 0 || (mask & feature.mask) != feature.mask) continue;
    result += (result.empty() ? "" : ", ") + std::string(feature.name);
  }
  return result;
}

/// Writes the predicate of a sentence about the value: "is above 720 deg".
inline void put_violation(TextOutput& out, const Violation& violation) {
  const bool is_below = violation.value < violation.limit;
  const auto put = [&](const char* verb) {
    out.put(verb);
    detail::put_limit(out, violation.limit, violation.unit);
  };
  switch (violation.rule) {
    case Rule::minimum: return is_below ? put("is below ") : out.put("is not a number");
    case Rule::maximum: return put("is above ");
    case Rule::alignment: return put("is not a multiple of ");
    case Rule::count:
      out.put(violation.value == 1 ? "is " : "are ");
      return put(is_below ? "fewer than " : "more than ");
    case Rule::order:
      put(violation.value > violation.limit ? "is above " : "is not below ");
      out.put(" of ");
      return out.put(violation.other->name);
    case Rule::firmware:
      out.put("needs firmware ");
      return detail::put_version<VersionTypes::Firmware>(out, violation.limit);
    case Rule::board:
      out.put("needs board ");
      return detail::put_version<VersionTypes::Board>(out, violation.limit);
    case Rule::feature:
      out.put("needs ");
      return out.put(feature_names(static_cast<std::uint64_t>(violation.limit)));
  }
}
/// Returns the text that put_violation() writes.
inline std::string violation_text(const Violation& violation) {
  return detail::text_of([&](TextOutput& out) { put_violation(out, violation); });
}

/// "rc.pitch.rc_max_angle: 800 deg is above 720 deg".
inline std::string to_string(const Violation& violation) {
  std::string value = detail::text_of(
      [&](TextOutput& out) { detail::put_limit(out, violation.value, violation.unit); });
  if (violation.named != nullptr) value = violation.named->name;
  if (violation.rule == Rule::count) value += violation.value == 1 ? " element" : " elements";
  const bool is_of_version = violation.rule == Rule::firmware || violation.rule == Rule::board ||
                             violation.rule == Rule::feature;
  if (is_of_version && violation.named == nullptr && violation.value == 0) {
    return to_string(violation.path) + ": " + violation_text(violation);  // its presence
  }
  return to_string(violation.path) + ": " + value + ' ' + violation_text(violation);
}

namespace msg {
// NOLINTNEXTLINE(misc-unused-using-decls): for argument-dependent lookup
using sbgc::to_string;
}  // namespace msg

}  // namespace sbgc
