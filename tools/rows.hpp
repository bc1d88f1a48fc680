/// Messages as rows of path, raw value and meaning.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <sbgc/meta/all.hpp>
#include <sbgc/to_json.hpp>
#include <sbgc/validate.hpp>

#include "decoded_frame.hpp"

namespace sbgc::tools {

namespace rows_detail {

/// "NAME", or "" if the value has none.
std::string value_name(const EnumInfo& info, std::int64_t value);
/// "NAME | NAME | 0x40", "" for no bits.
std::string flag_names(const EnumInfo& info, std::uint32_t bits);
/// "3.1", or "mode RC_MODE_ANGLE, inverted 0".
std::string packed_text(const PackedInfo& info, std::uint32_t raw);
/// A text in quotes, with nothing in it that a terminal would take for a command.
std::string quoted(std::string_view bytes);
/// "-30.0 deg".
std::string physical(double value, const char* unit);

/// The value of an adjustable variable in its unit, "" if it has none.
std::string variable_text(const VariableInfo& variable, std::int64_t raw);

/// Collects the rows of one message. Built so that the compiler makes a function for each type of
/// member, not for each member of each message: the reference site downloads this code.
class RowCollector {
 public:
  template <class T>
  void members(const T& value) {
    Meta<T>::visit(value, Members{*this});
  }

  std::vector<Row> take() { return std::move(rows_); }

 private:
  /// Visits the members of one struct.
  struct Members {
    RowCollector& rows;
    const VariableInfo* variable = nullptr;

    template <class T>
    void operator()(const FieldInfo& field, const T& member) {
      const std::size_t outer = rows.enter(field.name);
      rows.value(member, field);
      rows.leave(outer);
      if constexpr (std::is_same_v<T, msg::VariableId>) variable = find_variable(member);
      if constexpr (std::is_integral_v<T>) rows.variable_value(variable, member, field);
    }
  };

  template <class T>
  void value(const T& value, const FieldInfo& field) {
    if constexpr (std::is_enum_v<T>) {
      const auto raw = static_cast<std::underlying_type_t<T>>(value);
      number(raw, field, value_name(EnumMeta<T>::info, raw), wire_size<T>);
    } else if constexpr (std::is_same_v<T, float>) {
      add(fmt::format("{}", value), "", wire_size<T>);
    } else if constexpr (std::is_arithmetic_v<T>) {
      number(value, field, "", wire_size<T>);
    } else if constexpr (requires { T::unit; }) {
      number(value.raw(), field, quantity(value, field), wire_size<T>);
    } else if constexpr (requires { typename T::flag_type; }) {
      number(value.raw(), field, flag_names(EnumMeta<typename T::flag_type>::info, value.raw()),
             wire_size<T>);
    } else if constexpr (requires { PackedMeta<T>::info; }) {
      number(value.raw(), field, packed_text(PackedMeta<T>::info, value.raw()), wire_size<T>);
    } else {
      members(value);
    }
  }
  void value(Counter counter, const FieldInfo& field) {
    number(static_cast<std::int64_t>(counter.count), field, "", wire_size<std::uint8_t>);
  }
  void value(const Number& number, const FieldInfo&) {
    add(fmt::format("{}", number.value()), name(number.type), size_of(number.type));
  }
  template <class T>
  void value(const Optional<T>& optional, const FieldInfo& field) {
    if (optional) value(*optional, field);
  }
  template <class T>
  void value(const Axes<T>& axes, const FieldInfo& field) {
    element(axes.roll, field, ".roll");
    element(axes.pitch, field, ".pitch");
    element(axes.yaw, field, ".yaw");
  }
  template <class T>
  void value(const Xyz<T>& xyz, const FieldInfo& field) {
    element(xyz.x, field, ".x");
    element(xyz.y, field, ".y");
    element(xyz.z, field, ".z");
  }
  template <std::size_t n>
  void value(const Bytes<n>& bytes, const FieldInfo& field) {
    this->bytes(bytes, field);
  }
  template <std::size_t n>
  void value(const BoundedBytes<n>& bytes, const FieldInfo& field) {
    this->bytes({bytes.data(), bytes.size()}, field);
  }
  template <std::size_t n>
  void value(const Text<n>& text, const FieldInfo&) {
    add(quoted({text.data(), text.size()}), "", n);
  }
  template <std::size_t n>
  void value(const BoundedText<n>& text, const FieldInfo&) {
    add(quoted({text.data(), text.size()}), "", 1 + text.size());
  }
  template <class T, std::size_t n>
  void value(const std::array<T, n>& array, const FieldInfo& field) {
    list(array.data(), n, field);
  }
  template <class T, std::size_t n>
  void value(const BoundedArray<T, n>& array, const FieldInfo& field) {
    list(array.data(), array.size(), field);
  }
  template <class T>
  void list(const T* elements, std::size_t size, const FieldInfo& field) {
    for (std::size_t i = 0; i < size; ++i) element(elements[i], field, index(i));
  }
  template <class T>
  void element(const T& element, const FieldInfo& field, std::string_view name) {
    const std::size_t outer = path_.size();
    path_ += name;
    value(element, field);
    path_.resize(outer);
  }

  /// Reserved bytes are shown only if there is something in them.
  void bytes(std::span<const std::uint8_t> bytes, const FieldInfo& field);
  void number(std::int64_t raw, const FieldInfo& field, std::string meaning, std::size_t size);
  /// Takes the next `size` bytes of the body for a row.
  void add(std::string raw, std::string meaning, std::size_t size);
  /// Gives the last row the meaning of a value of `variable`, if it is one.
  void variable_value(const VariableInfo* variable, std::int64_t raw, const FieldInfo& field);
  /// Whether the alternative unit of the current value is in force.
  bool is_alternative(const FieldInfo& field) const;

  /// Goes on to a member of the current value. Returns what leave() needs.
  std::size_t enter(std::string_view name);
  void leave(std::size_t outer) { path_.resize(outer); }
  static std::string index(std::size_t i) { return fmt::format("[{}]", i); }

  template <class Q>
  std::string quantity(Q value, const FieldInfo& field) const {
    if (!is_alternative(field)) return physical(value.real(), Q::unit);
    const AlternativeUnit& other = *field.alternative;
    return physical(value.raw() * other.numerator / other.denominator, other.unit);
  }

  std::string path_;  // of the current value
  std::vector<Row> rows_;
  std::vector<std::pair<std::size_t, std::int64_t>> numbers_;  // which row, and its raw value
  std::size_t offset_ = 0;                                     // in the body
};

/// Notes beside the rows what the specification does not allow.
struct Marker {
  std::vector<Row>& rows;
  void operator()(const Violation& violation) const;
};

}  // namespace rows_detail

/// The values of a message in wire order.
template <class M>
std::vector<Row> rows(const M& message) {
  rows_detail::RowCollector collector;
  collector.members(message);
  std::vector<Row> result = collector.take();
  validate(message, rows_detail::Marker{result});
  return result;
}

}  // namespace sbgc::tools
