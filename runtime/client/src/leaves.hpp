/// The single values of a message as text: path, raw value, meaning.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <sbgc/json.hpp>
#include <sbgc/meta/all.hpp>

namespace sbgc::detail {

/// One value.
struct Leaf {
  std::string path;
  std::string raw;
  std::string meaning;  ///< "-30 deg", "FOLLOW_MODE_FC", or ""
};

/// "12.5 deg", with at most six digits.
std::string physical_text(double value, const char* unit);
/// "NAME", or "" for an unknown value.
std::string value_text(const EnumInfo& info, std::int64_t value);
/// "NAME | 0x40", or "" for no bits.
std::string flags_text(const EnumInfo& info, std::uint32_t bits);
/// "RC_MODE_ANGLE, inverted 1".
std::string packed_text(const PackedInfo& info, std::uint32_t raw);

/// Collects the values of a message in wire order; bytes without a meaning one by one.
class LeafCollector {
 public:
  template <class T>
  void members(const T& value, const std::string& path) {
    Meta<T>::visit(value, [&](const FieldInfo& field, const auto& member) {
      if (field.role == FieldRole::copy || field.role == FieldRole::state) return;
      this->value(member, field, path.empty() ? field.name : path + "." + field.name);
    });
  }

  std::vector<Leaf> take() { return std::move(leaves_); }

 private:
  template <class T>
  void value(const T& value, const FieldInfo& field, const std::string& path) {
    if constexpr (std::is_enum_v<T>) {
      const auto raw = static_cast<std::underlying_type_t<T>>(value);
      number(raw, field, path, value_text(EnumMeta<T>::info, raw));
    } else if constexpr (std::is_floating_point_v<T>) {
      leaves_.push_back({path, std::to_string(value), ""});
    } else if constexpr (std::is_arithmetic_v<T>) {
      number(value, field, path, "");
    } else if constexpr (requires { T::unit; }) {
      number(value.raw(), field, path, physical_text(value.real(), T::unit));
    } else if constexpr (requires { typename T::flag_type; }) {
      number(value.raw(), field, path,
             flags_text(EnumMeta<typename T::flag_type>::info, value.raw()));
    } else if constexpr (requires { PackedMeta<T>::info; }) {
      number(value.raw(), field, path, packed_text(PackedMeta<T>::info, value.raw()));
    } else {
      members(value, path);
    }
  }
  void value(Counter, const FieldInfo&, const std::string&) {}
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
  void value(const Text<n>& text, const FieldInfo&, const std::string& path) {
    leaves_.push_back({path, Json(to_utf8({text.data(), text.size()})).dump(), ""});
  }
  template <std::size_t n>
  void value(const Bytes<n>& bytes, const FieldInfo& field, const std::string& path) {
    list(bytes, field, path);
  }
  template <class T, std::size_t n>
  void value(const std::array<T, n>& array, const FieldInfo& field, const std::string& path) {
    list(array, field, path);
  }
  template <class T, std::size_t n>
  void value(const BoundedArray<T, n>& array, const FieldInfo& field, const std::string& path) {
    list(array, field, path);
  }
  template <std::size_t n>
  void value(const BoundedBytes<n>& bytes, const FieldInfo& field, const std::string& path) {
    list(bytes, field, path);
  }

  template <class List>
  void list(const List& elements, const FieldInfo& field, const std::string& path) {
    std::size_t index = 0;
    for (const auto& element : elements) {
      value(element, field, path + "[" + std::to_string(index++) + "]");
    }
  }

  void number(std::int64_t raw, const FieldInfo& field, const std::string& path,
              std::string meaning);

  std::vector<Leaf> leaves_;
};

/// The values of a message that are parameters.
template <class M>
std::vector<Leaf> leaves(const M& message) {
  LeafCollector collector;
  collector.members(message, {});
  return collector.take();
}

}  // namespace sbgc::detail
