/// Finds the values of a message that the limits of their fields do not allow.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>

#include <sbgc/detail/named_values.hpp>
#include <sbgc/internal/table_access.hpp>
#include <sbgc/meta/variables.hpp>
#include <sbgc/violation.hpp>

namespace sbgc::detail {

/// Reports every violation. Check is faster for finding out whether there are any.
class Violations {
 public:
  using Report = void (*)(void* user, const Violation& violation);

  Violations(const Availability& versions, Report report, void* user) noexcept
      : versions_(versions),
        least_(lacks_nothing(versions) ? Limited::always : Limited::on_some_boards),
        report_(report),
        user_(user) {}

  bool are_none() const noexcept { return !has_found_; }

  void members(const StructTable& table, const void* object, const FieldPath* parent = nullptr) {
    UsedMembers used;
    if (table.find_used != nullptr) table.find_used(object, used);
    const VariableInfo* variable = nullptr;  // the one that the last VariableId names, or null
    for (std::size_t index = 0; index < table.slots.size(); ++index) {
      if (table.limits[index] < least_) continue;
      const Slot& slot = table.slots[index];
      const FieldInfo& field = table.fields[index];
      const void* const at = moved(object, slot.offset);
      const FieldPath path{parent, field.name};
      if (slot.type->is_variable_id) variable = find_variable(load<msg::VariableId>(at));
      if (table.find_used != nullptr && !used.is_whole(index)) {
        axes(field, *slot.type, at, path, used.elements(index));
      } else if (field.is_variable_value && variable != nullptr && is_plain_integer(*slot.type)) {
        this->variable(*variable, load_integer(slot.type->raw, at), {field, path});
      } else {
        value(field, *slot.type, at, path);
      }
    }
    for (const OrderRule& rule : table.rules) order(table, rule, object, parent);
    // A tail may have any content.
  }

 private:
  struct Place {
    const FieldInfo& field;
    const FieldPath& path;
  };
  /// A violation without its position.
  struct Breach {
    double value{};
    double limit{};
    Rule rule{};
    const UnitInfo* unit{};  ///< if it is not that of the field
    const ValueInfo* named{};
    const FieldInfo* other{};
  };

  void value(const FieldInfo& field, const ValueType& type, const void* at, const FieldPath& path) {
    switch (type.kind) {
      case Kind::scalar: return scalar(type, at, {field, path});
      case Kind::axes: return axes(field, type, at, path, ~0U);
      case Kind::group: return members(*type.group, at, &path);
      case Kind::list: counted(size_at(type, at), {field, path}); [[fallthrough]];
      case Kind::array: return elements(field, type, at, path);
      case Kind::bytes:
        if (!type.is_bounded) return;
        counted(size_at(type, at), {field, path});
        return aligned(static_cast<double>(size_at(type, at)), {field, path}, size_at(type, at));
      case Kind::counter: {
        const auto count = static_cast<std::int64_t>(detail::counted(type, at));
        return limited(static_cast<double>(count), {field, path}, count);
      }
      case Kind::optional:
        if (!is_present(type, at)) return;
        // Its mere presence changes the body, whatever the value.
        exists(field.since, 0, {field, path});
        if (is_available(field.since, versions_)) value(field, *type.element, at, path);
        return;
      case Kind::text:
      case Kind::number: return;
    }
  }
  void scalar(const ValueType& type, const void* at, const Place& place) {
    if (is_real(type.raw)) return limited(load_real(type.raw, at), place);
    const std::int64_t raw = load_integer(type.raw, at);
    const auto bits = static_cast<std::uint64_t>(raw);
    const bool is_u64 = type.raw == RawType::u64;
    limited(is_u64 ? static_cast<double>(bits) : static_cast<double>(raw), place, raw);
    if (!type.has_versions) return;
    const auto use = [&](const ValueInfo& known, std::int64_t of) {
      exists(known.since, static_cast<double>(of), place, &known);
    };
    if (type.meaning.names != nullptr) for_each_name(*type.meaning.names, bits, use);
    if (type.meaning.packed != nullptr) for_each_name(*type.meaning.packed, bits, use);
  }
  void variable(const VariableInfo& variable, std::int64_t raw, const Place& place) {
    const UnitInfo unit = variable.unit_in(known_versions());
    in_range(static_cast<double>(raw), variable.range, place, &unit);
  }
  /// Checks the axes whose bit is set in `which`.
  void axes(const FieldInfo& field, const ValueType& type, const void* at, const FieldPath& path,
            unsigned which) {
    for (std::size_t i = 0; i < type.count; ++i) {
      if ((which >> i & 1U) == 0) continue;
      value(field, *type.element, element_at(type, at, i),
            FieldPath{&path, type.group->fields[i].name, i});
    }
  }
  void elements(const FieldInfo& field, const ValueType& type, const void* at,
                const FieldPath& path) {
    const std::size_t size = size_at(type, at);
    for (std::size_t i = 0; i < size; ++i) {
      value(field, *type.element, element_at(type, at, i), FieldPath{&path, "", i});
    }
  }

  void order(const StructTable& table, const OrderRule& rule, const void* object,
             const FieldPath* parent) {
    const Slot& low = table.slots[rule.low];
    const FieldInfo& field = table.fields[rule.low];
    compare(*low.type, moved(object, low.offset), moved(object, table.slots[rule.high].offset),
            {field, FieldPath{parent, field.name}}, table.fields[rule.high], rule.is_strict);
  }
  void compare(const ValueType& type, const void* low, const void* high, const Place& place,
               const FieldInfo& other, bool is_strict) {
    if (type.kind == Kind::scalar) {
      const double a = number_at(type, low);
      const double b = number_at(type, high);
      return require(is_strict ? a < b : a <= b, place,
                     {.value = a, .limit = b, .rule = Rule::order, .other = &other});
    }
    for (std::size_t i = 0; i < type.count; ++i) {
      const char* const name = type.kind == Kind::axes ? type.group->fields[i].name : "";
      compare(*type.element, element_at(type, low, i), element_at(type, high, i),
              {place.field, FieldPath{&place.path, name, i}}, other, is_strict);
    }
  }
  static double number_at(const ValueType& type, const void* at) {
    return is_real(type.raw) ? load_real(type.raw, at)
                             : static_cast<double>(load_integer(type.raw, at));
  }

  void require(bool holds, const Place& place, const Breach& breach) {
    if (!holds) fail(place, breach);
  }
  SBGC_NOINLINE void fail(const Place& place, const Breach& breach) {
    has_found_ = true;
    const FieldInfo& field = place.field;
    const bool has_unit = field.alternative == nullptr && breach.rule != Rule::count;
    const LaterMeaning* const later = meaning_in(field.later, known_versions());
    const UnitInfo* const unit = !has_unit ? nullptr : later != nullptr ? later->unit : field.unit;
    report_(user_,
            Violation{place.path, field, breach.value, breach.limit, breach.rule,
                      breach.unit != nullptr ? breach.unit : unit, breach.named, breach.other});
  }

  void exists(const Availability& since, double value, const Place& place,
              const ValueInfo* named = nullptr) {
    if (!is_available(since, versions_)) lack(since, value, place, named);
  }
  SBGC_NOINLINE void lack(const Availability& since, double value, const Place& place,
                          const ValueInfo* named) {
    require(since.firmware <= versions_.firmware, place,
            {value, static_cast<double>(since.firmware), Rule::firmware, nullptr, named});
    require(since.board <= versions_.board, place,
            {value, static_cast<double>(since.board), Rule::board, nullptr, named});
    require((since.features & versions_.features) == 0, place,
            {value, static_cast<double>(since.features), Rule::feature, nullptr, named});
  }
  void counted(std::size_t size, const Place& place) {
    const auto value = static_cast<double>(size);
    const std::uint16_t least = place.field.min_count;
    const std::uint16_t most = place.field.max_count;
    require(size >= least, place, {value, static_cast<double>(least), Rule::count});
    require(most == 0 || size <= most, place, {value, static_cast<double>(most), Rule::count});
  }
  void aligned(double value, const Place& place, std::uint64_t raw) {
    const std::uint16_t align = place.field.align;
    if (align == 1 || raw % align == 0 || is_special(value, place.field)) return;
    fail(place, {value, static_cast<double>(align), Rule::alignment});
  }
  void in_range(double value, const Range& range, const Place& place,
                const UnitInfo* unit = nullptr) {
    const bool is_low = !(value >= range.lowest);  // also NaN
    if ((!is_low && value <= range.highest) || is_special(value, place.field)) return;
    const double limit = is_low ? range.lowest : range.highest;
    fail(place, {value, limit, is_low ? Rule::minimum : Rule::maximum, unit});
  }
  void limited(double value, const Place& place, std::int64_t raw = 0) {
    const FieldInfo& field = place.field;
    if (value != 0) exists(field.since, value, place);
    aligned(value, place, static_cast<std::uint64_t>(raw));
    const Range* range = field.range;
    if (!field.later.empty()) {
      const LaterMeaning* const later = meaning_in(field.later, versions_);
      if (later != nullptr && later->range != nullptr) range = later->range;
    }
    if (range != nullptr) in_range(value, *range, place);
  }
  static bool is_special(double value, const FieldInfo& field) noexcept {
    for (const Special& special : field.special) {
      if (value == static_cast<double>(special.value)) return true;
    }
    return false;
  }

  static bool lacks_nothing(const Availability& versions) noexcept {
    return versions.firmware == std::numeric_limits<std::uint16_t>::max() &&
           versions.board == std::numeric_limits<std::uint8_t>::max() && versions.features == 0;
  }
  /// The versions of the board; empty for any board, whose values are in their usual units.
  Availability known_versions() const noexcept {
    return versions_.firmware == std::numeric_limits<std::uint16_t>::max() ? Availability{}
                                                                           : versions_;
  }

  Availability versions_;
  Limited least_;  // of the members to check
  Report report_;
  void* user_;
  bool has_found_ = false;
};

/// Returns true if there are none.
inline bool report_violations(const StructTable& table, const void* message,
                              const Availability& versions, Violations::Report report, void* user) {
  Violations found(versions, report, user);
  found.members(table, message);
  return found.are_none();
}

template <class Report>
void call_report(void* report, const Violation& violation) {
  (*static_cast<Report*>(report))(violation);
}

}  // namespace sbgc::detail
