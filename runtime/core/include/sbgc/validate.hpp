/// Validates the values of a message against the specification.
///
/// Decoding never rejects a value for its range; validate() does, and reports every violation.
/// Include the tables of the messages to validate: <sbgc/meta/control.hpp>, for example, or
/// <sbgc/meta/all.hpp>.
#pragma once

#include <cstddef>
#include <cstdint>
#include <type_traits>

#include <sbgc/detail/named_values.hpp>
#include <sbgc/detail/plainly_valid.hpp>
#include <sbgc/field_path.hpp>
#include <sbgc/meta.hpp>
#include <sbgc/meta/variables.hpp>

namespace sbgc {

/// The rule that a value violates.
enum class Rule : std::uint8_t {
  minimum,    ///< below `limit`
  maximum,    ///< above `limit`
  alignment,  ///< not a multiple of `limit`
  count,      ///< fewer or more than `limit` elements
  order,      ///< above the field `other`, which is `limit`, or equal to it
  firmware,   ///< exists only since firmware version `limit`, such as 2590
  board,      ///< exists only since board version `limit`, such as 30
};

/// Returns the name of a rule, e.g. "minimum".
constexpr const char* name(Rule rule) noexcept {
  switch (rule) {
    case Rule::minimum: return "minimum";
    case Rule::maximum: return "maximum";
    case Rule::alignment: return "alignment";
    case Rule::count: return "count";
    case Rule::order: return "order";
    case Rule::firmware: return "firmware";
    case Rule::board: return "board";
  }
  return "unknown_rule";
}

/// A value that the specification does not allow. `path` is valid only during the report.
/// to_string() of <sbgc/text.hpp> formats it as a sentence.
struct Violation {
  const FieldPath& path;
  const FieldInfo& field;
  double value{};  ///< raw, as on the wire
  double limit{};
  Rule rule{};
  const UnitInfo* unit{};    ///< of `value`; null if it has none or if it depends on a flag
  const ValueInfo* named{};  ///< the enum value or flag that does not exist yet, or null
  const FieldInfo* other{};  ///< the field that the value must not exceed, or null
};

namespace detail {

/// Visits a value and reports violations of the limits of its field.
template <class Report>
class Validator {
 public:
  constexpr Validator(const Availability& versions, Report& report) noexcept
      : versions_(versions), report_(report) {}

  constexpr bool valid() const noexcept { return valid_; }

  template <class T>
  constexpr void members(const T& value, const FieldPath* parent) {
    Meta<T>::visit(value, Members{*this, parent});
    if constexpr (requires { Meta<T>::rules(value, Order{*this, parent}); }) {
      Meta<T>::rules(value, Order{*this, parent});
    }
  }

 private:
  /// Validates the members of a struct. Not a lambda: that would be a distinct type for each T.
  struct Members {
    Validator& validator;
    const FieldPath* parent = nullptr;       ///< the path of the struct itself
    const VariableInfo* variable = nullptr;  ///< the one that the last VariableId names, or null

    template <class Member>
    constexpr void operator()(const FieldInfo& field, const Member& member) {
      const FieldPath path{parent, field.name};
      if constexpr (std::is_same_v<Member, msg::VariableId>) variable = find_variable(member);
      if constexpr (std::is_integral_v<Member>) {
        if (field.is_variable_value && variable != nullptr) {
          return validator.limits(static_cast<double>(member), variable->range, field, path,
                                  &variable->unit);
        }
      }
      validator.value(member, field, path);
    }
  };

  /// Checks rules across fields.
  struct Order {
    Validator& validator;
    const FieldPath* parent = nullptr;

    template <class T>
    constexpr void operator()(const FieldInfo& field, const T& low, const FieldInfo& other,
                              const T& high, bool is_strict) {
      compare(field, FieldPath{parent, field.name}, low, other, high, is_strict);
    }

   private:
    template <class T>
    constexpr void compare(const FieldInfo& field, const FieldPath& path, const T& low,
                           const FieldInfo& other, const T& high, bool is_strict) {
      if constexpr (RawValue<T>) {
        compare(field, path, low.raw(), other, high.raw(), is_strict);
      } else if constexpr (std::is_arithmetic_v<T>) {
        if (low < high || (low == high && !is_strict)) return;
        validator.valid_ = false;
        const UnitInfo* const unit = field.alternative == nullptr ? field.unit : nullptr;
        validator.report_(Violation{path, field, static_cast<double>(low),
                                    static_cast<double>(high), Rule::order, unit, nullptr, &other});
      } else if constexpr (requires { Meta<T>::fields; }) {  // one for each axis
        for (std::size_t i = 0; i < low.size(); ++i) {
          compare(field, FieldPath{&path, Meta<T>::fields[i].name}, low[i], other, high[i],
                  is_strict);
        }
      } else {
        for (std::size_t i = 0; i < low.size(); ++i) {
          compare(field, FieldPath{&path, "", i}, low[i], other, high[i], is_strict);
        }
      }
    }
  };

  template <class T>
  constexpr void value(const T& value, const FieldInfo& field, const FieldPath& path) {
    if constexpr (std::is_enum_v<T>) {
      number(static_cast<std::underlying_type_t<T>>(value), field, path);
      names(value, field, path);
    } else if constexpr (std::is_arithmetic_v<T>) {
      number(value, field, path);
    } else if constexpr (RawValue<T>) {
      number(value.raw(), field, path);
      constexpr bool is_flag_set = requires { typename T::flag_type; };
      if constexpr (is_flag_set || requires { PackedMeta<T>::info; }) names(value, field, path);
    } else if constexpr (requires { Meta<T>::fields; }) {
      members(value, &path);
    }
  }

  constexpr void value(Counter counter, const FieldInfo& field, const FieldPath& path) {
    number(counter.count, field, path);
  }

  template <class T>
  constexpr void value(const Axes<T>& axes, const FieldInfo& field, const FieldPath& path) {
    value(axes.roll, field, FieldPath{&path, "roll"});
    value(axes.pitch, field, FieldPath{&path, "pitch"});
    value(axes.yaw, field, FieldPath{&path, "yaw"});
  }
  template <class T>
  constexpr void value(const Xyz<T>& xyz, const FieldInfo& field, const FieldPath& path) {
    value(xyz.x, field, FieldPath{&path, "x"});
    value(xyz.y, field, FieldPath{&path, "y"});
    value(xyz.z, field, FieldPath{&path, "z"});
  }
  template <class T, std::size_t n>
  constexpr void value(const std::array<T, n>& array, const FieldInfo& field,
                       const FieldPath& path) {
    for (std::size_t i = 0; i < n; ++i) value(array[i], field, FieldPath{&path, "", i});
  }
  template <std::size_t n>
  constexpr void value(const Bytes<n>&, const FieldInfo&, const FieldPath&) {}
  template <class T, std::size_t n>
  constexpr void value(const BoundedArray<T, n>& array, const FieldInfo& field,
                       const FieldPath& path) {
    count(array.size(), field, path);
    for (std::size_t i = 0; i < array.size(); ++i) value(array[i], field, FieldPath{&path, "", i});
  }
  template <std::size_t n>
  constexpr void value(const BoundedBytes<n>& bytes, const FieldInfo& field,
                       const FieldPath& path) {
    count(bytes.size(), field, path);
    if (field.align != 1 && bytes.size() % field.align != 0) {
      fail(field, path, static_cast<double>(bytes.size()), field.align, Rule::alignment);
    }
  }
  template <class T>
  constexpr void value(const Optional<T>& optional, const FieldInfo& field, const FieldPath& path) {
    if (!optional) return;
    // Its presence alone changes the body, whatever the value.
    if (!is_available(field.since, versions_)) return existence(field.since, 0, field, path);
    value(*optional, field, path);
  }

  constexpr void count(std::size_t size, const FieldInfo& field, const FieldPath& path) {
    if (size < field.min_count) {
      fail(field, path, static_cast<double>(size), field.min_count, Rule::count);
    }
    if (field.max_count != 0 && size > field.max_count) {
      fail(field, path, static_cast<double>(size), field.max_count, Rule::count);
    }
  }

  template <class T>
  constexpr void number(T raw, const FieldInfo& field, const FieldPath& path) {
    const auto value = static_cast<double>(raw);
    if (value != 0) existence(field.since, value, field, path);
    for (const Special& special : field.special) {
      if (value == static_cast<double>(special.value)) return;
    }
    if constexpr (std::is_integral_v<T>) {
      if (field.align != 1 && static_cast<std::uint64_t>(raw) % field.align != 0) {
        fail(field, path, value, field.align, Rule::alignment);
      }
    }
    if (field.range != nullptr) limits(value, *field.range, field, path);
  }

  constexpr void limits(double value, const Range& range, const FieldInfo& field,
                        const FieldPath& path, const UnitInfo* variable_unit = nullptr) {
    // Written so that NaN is a violation.
    if (!(value >= range.lowest)) {
      fail(field, path, value, range.lowest, Rule::minimum, variable_unit);
    } else if (value > range.highest) {
      fail(field, path, value, range.highest, Rule::maximum, variable_unit);
    }
  }

  /// Reports the named values that a later version introduced.
  template <class T>
  constexpr void names(const T& value, const FieldInfo& field, const FieldPath& path) {
    if (is_available(has_all_values_of<T>, versions_)) return;
    for_each_name(value, [&](const ValueInfo& known, std::int64_t raw) {
      existence(known.since, static_cast<double>(raw), field, path, &known);
    });
  }
  constexpr void existence(const Availability& since, double value, const FieldInfo& field,
                           const FieldPath& path, const ValueInfo* named = nullptr) {
    if (since.firmware > versions_.firmware) {
      fail(field, path, value, since.firmware, Rule::firmware, nullptr, named);
    }
    if (since.board > versions_.board) {
      fail(field, path, value, since.board, Rule::board, nullptr, named);
    }
  }

  constexpr void fail(const FieldInfo& field, const FieldPath& path, double value, double limit,
                      Rule rule, const UnitInfo* variable_unit = nullptr,
                      const ValueInfo* named = nullptr) {
    valid_ = false;
    const bool has_unit = field.alternative == nullptr && rule != Rule::count;
    const UnitInfo* unit = has_unit ? field.unit : nullptr;
    if (variable_unit != nullptr) unit = variable_unit;
    report_(Violation{path, field, value, limit, rule, unit, named});
  }

  Availability versions_;
  Report& report_;
  bool valid_ = true;
};

}  // namespace detail

/// Versions that support everything.
inline constexpr Availability newest{0xFFFF, 0xFF};

/// Calls `report(const Violation&)` for every value in `message` that the specification does not
/// allow on a board with these versions (see versions_of()). Returns true if there is none.
///
/// Sentinels are allowed. Reserved bytes, unknown flags and unknown enum values are not checked,
/// because later firmware gives them a meaning. A value that a later version introduced is reported
/// if it is not 0, and an optional field whenever it is present. To check the message as a whole,
/// use is_supported().
template <class M, class Report>
constexpr bool validate(const M& message, const Availability& versions, Report&& report) {
  if (detail::is_plainly_valid(message, versions)) return true;
  detail::Validator<std::remove_reference_t<Report>> validator(versions, report);
  validator.members(message, nullptr);
  return validator.valid();
}

/// As above, for the newest board.
template <class M, class Report>
constexpr bool validate(const M& message, Report&& report) {
  return validate(message, newest, report);
}

/// True if the specification allows every value of `message`.
template <class M>
constexpr bool is_valid(const M& message) {
  return detail::is_plainly_valid(message, newest);
}

}  // namespace sbgc
