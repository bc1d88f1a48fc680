/// Messages as rows of path, raw value and meaning.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include <sbgc/json.hpp>
#include <sbgc/meta/all.hpp>
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

/// Collects the rows of one message.
class RowCollector {
 public:
  template <class T>
  void members(const T& value, const std::string& path) {
    [[maybe_unused]] const VariableInfo* variable = nullptr;
    Meta<T>::visit(value, [&](const FieldInfo& field, const auto& member) {
      this->value(member, field, path.empty() ? field.name : path + "." + field.name);
      using Member = std::remove_cvref_t<decltype(member)>;
      if constexpr (std::is_same_v<Member, VariableId>) variable = find_variable(member);
      if constexpr (std::is_integral_v<Member>) {
        if (field.is_variable_value && variable != nullptr) {
          rows_.back().meaning = variable_text(*variable, member);
        }
      }
    });
  }

  std::vector<Row> take() { return std::move(rows_); }

 private:
  template <class T>
  void value(const T& value, const FieldInfo& field, const std::string& path) {
    if constexpr (std::is_same_v<T, CommandId>) {
      // What is confirmed, refused or asked for is a command of the host.
      const auto raw = static_cast<std::uint8_t>(value);
      number(raw, field, path, command_name(raw, Direction::to_board));
    } else if constexpr (std::is_enum_v<T>) {
      const auto raw = static_cast<std::underlying_type_t<T>>(value);
      number(raw, field, path, value_name(EnumMeta<T>::info, raw));
    } else if constexpr (std::is_same_v<T, float>) {
      add(path, fmt::format("{}", value), "");
    } else if constexpr (std::is_arithmetic_v<T>) {
      number(value, field, path, "");
    } else if constexpr (requires { T::unit; }) {
      number(value.raw(), field, path, quantity(value, field, path));
    } else if constexpr (requires { typename T::flag_type; }) {
      number(value.raw(), field, path,
             flag_names(EnumMeta<typename T::flag_type>::info, value.raw()));
    } else if constexpr (requires { PackedMeta<T>::info; }) {
      number(value.raw(), field, path, packed_text(PackedMeta<T>::info, value.raw()));
    } else {
      members(value, path);
    }
  }
  void value(Counter counter, const FieldInfo& field, const std::string& path) {
    number(static_cast<std::int64_t>(counter.count), field, path, "");
  }
  void value(const Number& number, const FieldInfo&, const std::string& path) {
    add(path, fmt::format("{}", number.value()), name(number.type));
  }
  template <class T>
  void value(const Optional<T>& optional, const FieldInfo& field, const std::string& path) {
    if (optional) value(*optional, field, path);
  }
  template <class T>
  void value(const Axes<T>& axes, const FieldInfo& field, const std::string& path) {
    value(axes.roll, field, path + ".roll");
    value(axes.pitch, field, path + ".pitch");
    value(axes.yaw, field, path + ".yaw");
  }
  template <class T>
  void value(const Xyz<T>& xyz, const FieldInfo& field, const std::string& path) {
    value(xyz.x, field, path + ".x");
    value(xyz.y, field, path + ".y");
    value(xyz.z, field, path + ".z");
  }
  template <std::size_t n>
  void value(const Bytes<n>& bytes, const FieldInfo& field, const std::string& path) {
    this->bytes(bytes, field, path);
  }
  template <std::size_t n>
  void value(const BoundedBytes<n>& bytes, const FieldInfo& field, const std::string& path) {
    this->bytes({bytes.data(), bytes.size()}, field, path);
  }
  template <std::size_t n>
  void value(const Text<n>& text, const FieldInfo&, const std::string& path) {
    add(path, quoted({text.data(), text.size()}), "");
  }
  template <std::size_t n>
  void value(const BoundedText<n>& text, const FieldInfo&, const std::string& path) {
    add(path, quoted({text.data(), text.size()}), "");
  }
  template <class T, std::size_t n>
  void value(const std::array<T, n>& array, const FieldInfo& field, const std::string& path) {
    for (std::size_t i = 0; i < n; ++i) value(array[i], field, fmt::format("{}[{}]", path, i));
  }
  template <class T, std::size_t n>
  void value(const BoundedArray<T, n>& array, const FieldInfo& field, const std::string& path) {
    for (std::size_t i = 0; i < array.size(); ++i) {
      value(array[i], field, fmt::format("{}[{}]", path, i));
    }
  }

  /// Reserved bytes are shown only if there is something in them.
  void bytes(std::span<const std::uint8_t> bytes, const FieldInfo& field, const std::string& path);
  void number(std::int64_t raw, const FieldInfo& field, const std::string& path,
              std::string meaning);
  void add(std::string path, std::string raw, std::string meaning);
  /// Whether the alternative unit of the value at `path` is in force.
  bool is_alternative(const FieldInfo& field, const std::string& path) const;

  template <class Q>
  std::string quantity(Q value, const FieldInfo& field, const std::string& path) const {
    if (!is_alternative(field, path)) return physical(value.real(), Q::unit);
    const AlternativeUnit& other = *field.alternative;
    return physical(value.raw() * other.numerator / other.denominator, other.unit);
  }

  std::vector<Row> rows_;
  std::map<std::string, std::int64_t> raw_;
};

/// Notes beside the rows what the specification does not allow.
void mark(std::vector<Row>& rows, const Violation& violation);

}  // namespace rows_detail

/// The values of a message in wire order.
template <class M>
std::vector<Row> rows(const M& message) {
  rows_detail::RowCollector collector;
  collector.members(message, {});
  std::vector<Row> result = collector.take();
  validate(message, [&](const Violation& violation) { rows_detail::mark(result, violation); });
  return result;
}

}  // namespace sbgc::tools
