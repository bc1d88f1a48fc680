/// Conversion between messages and JSON with nlohmann_json: from_json(), and to_json(), which has
/// its own header for programs without exceptions.
#pragma once

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <sbgc/to_json.hpp>

namespace sbgc {

/// Thrown if JSON does not describe the expected message; what() names the field and the reason.
class JsonError : public std::runtime_error {
 public:
  JsonError(std::string field, const std::string& reason)
      : std::runtime_error(field.empty() ? reason : field + ": " + reason),
        field_(std::move(field)) {}

  /// The path of the field, such as "axes.roll.angle"; empty for the whole message.
  const std::string& field() const noexcept { return field_; }

 private:
  std::string field_;
};

namespace detail {

class JsonReader {
 public:
  template <class T>
  static void members(const Json& json, T& out, const std::string& path) {
    if (!json.is_object()) throw JsonError(path, "an object is needed");
    Members members{json, path};
    Meta<T>::visit(out, members);
    members.refuse_unknown();
  }

 private:
  /// Reads the members of an object. To reduce compile time, one type serves all objects, and its
  /// operator() is not inlined: it is compiled once per member type.
  struct Members {
    const Json& json;
    const std::string& path;
    std::vector<const char*> names{};
    std::size_t known = 0;

    template <class Member>
    [[gnu::noinline]] void operator()(const FieldInfo& field, Member&& member) {
      const Json* const found = find(field, may_be_missing(field, member));
      if (found != nullptr) value(*found, member, join(path, field.name));
    }

    /// Returns the value of a field; null if the field is missing and may be. Throws if it may not.
    const Json* find(const FieldInfo& field, bool may_be_missing) {
      names.push_back(field.name);
      const auto found = json.find(field.name);
      if (found != json.end()) {
        ++known;
        return &*found;
      }
      if (!may_be_missing) throw JsonError(join(path, field.name), "it is missing");
      return nullptr;
    }

    void refuse_unknown() const {
      if (known == json.size()) return;
      for (const auto& item : json.items()) {
        if (std::find(names.begin(), names.end(), item.key()) != names.end()) continue;
        throw JsonError(join(path, item.key()), "unknown");
      }
    }
  };

  static std::string join(const std::string& path, const std::string& name) {
    return path.empty() ? name : path + "." + name;
  }

  static std::string element(const std::string& path, std::size_t index) {
    return path + "[" + std::to_string(index) + "]";
  }

  // Counters are implied by their lists, and tails are rare. Everything else is required: a
  // parameter omitted by mistake would be overwritten with 0.
  template <class T>
  static bool may_be_missing(const FieldInfo&, const Optional<T>&) {
    return true;
  }
  static bool may_be_missing(const FieldInfo&, const Counter&) { return true; }
  template <class T>
  static bool may_be_missing(const FieldInfo& field, const T&) {
    return field.optional;
  }

  template <class T>
  static void value(const Json& json, T& out, const std::string& path) {
    if constexpr (std::is_floating_point_v<T>) {
      const auto number = float_from_json<T>(json);
      if (!number) throw JsonError(path, "a number is needed");
      out = *number;
    } else if constexpr (std::is_enum_v<T>) {
      out = static_cast<T>(integer<std::underlying_type_t<T>>(json, path));
    } else if constexpr (std::is_arithmetic_v<T>) {
      out = integer<T>(json, path);
    } else if constexpr (RawValue<T>) {
      typename T::raw_type raw{};
      value(json, raw, path);
      if constexpr (requires { T::highest; }) check(json, raw, T::lowest, T::highest, path);
      out = T(raw);
    } else {
      members(json, out, path);
    }
  }
  static void value(const Json& json, Counter&, const std::string& path) {
    // A list comes after its counter, so they are compared once the whole message has been read.
    static_cast<void>(integer<std::uint8_t>(json, path));
  }
  static void value(const Json& json, Number& out, const std::string& path) {
    const auto as = [&]<class T>(NumberType type, T number) {
      if (!json.is_object() || json.size() != 1 || !json.contains(name(type))) return false;
      value(json.front(), number, path + "." + name(type));
      out = {type, 0};
      if constexpr (std::is_same_v<T, float>) {
        out.bits = std::bit_cast<std::uint32_t>(number);
      } else {
        out.bits = static_cast<std::make_unsigned_t<T>>(number);
      }
      return true;
    };
    const bool known = as(NumberType::u8, std::uint8_t{}) || as(NumberType::i8, std::int8_t{}) ||
                       as(NumberType::u16, std::uint16_t{}) ||
                       as(NumberType::i16, std::int16_t{}) ||
                       as(NumberType::u32, std::uint32_t{}) ||
                       as(NumberType::i32, std::int32_t{}) || as(NumberType::f32, float{});
    if (!known) throw JsonError(path, "an object with the type, such as {\"i16\": -5}, is needed");
  }
  template <class T>
  static void value(const Json& json, Optional<T>& out, const std::string& path) {
    value(json, out.emplace(), path);
  }
  template <std::size_t n>
  static void value(const Json& json, Bytes<n>& out, const std::string& path) {
    const std::vector<std::uint8_t> bytes = hex(json, path);
    if (bytes.size() != n) throw JsonError(path, std::to_string(n) + " bytes of hex are needed");
    std::copy(bytes.begin(), bytes.end(), out.begin());
  }
  template <std::size_t n>
  static void value(const Json& json, BoundedBytes<n>& out, const std::string& path) {
    const std::vector<std::uint8_t> bytes = hex(json, path);
    if (!out.resize(bytes.size())) throw JsonError(path, too_many(bytes.size(), n, "bytes"));
    std::copy(bytes.begin(), bytes.end(), out.begin());
  }
  template <std::size_t n>
  static void value(const Json& json, Text<n>& out, const std::string& path) {
    text(json, out, path);
  }
  template <std::size_t n>
  static void value(const Json& json, BoundedText<n>& out, const std::string& path) {
    text(json, out, path);
  }
  template <class T, std::size_t n>
  static void value(const Json& json, std::array<T, n>& out, const std::string& path) {
    if (!json.is_array() || json.size() != n) {
      throw JsonError(path, "a list of " + std::to_string(n) + " is needed");
    }
    elements(json, out, path);
  }
  template <class T, std::size_t n>
  static void value(const Json& json, BoundedArray<T, n>& out, const std::string& path) {
    if (!json.is_array()) throw JsonError(path, "a list is needed");
    if (!out.resize(json.size())) throw JsonError(path, too_many(json.size(), n, "elements"));
    elements(json, out, path);
  }

  template <class List>
  static void elements(const Json& json, List& out, const std::string& path) {
    for (std::size_t i = 0; i < json.size(); ++i) {
      value(json[i], out[i], element(path, i));
    }
  }

  template <class T>
  static T integer(const Json& json, const std::string& path) {
    using Limits = std::numeric_limits<T>;
    if constexpr (sizeof(T) == 8) {
      return decimal<T>(json, path);
    } else {
      return static_cast<T>(integer(json, Limits::min(), Limits::max(), path));
    }
  }
  /// Reads an integer of 64 bits, which is text.
  template <class T>
  static T decimal(const Json& json, const std::string& path) {
    if (json.is_string()) {
      const auto& text = json.get_ref<const std::string&>();
      T number{};
      const char* const all = text.data() + text.size();
      const auto [end, error] = std::from_chars(text.data(), all, number);
      if (error == std::errc{} && end == all) return number;
    }
    throw JsonError(path, "a string with an integer of 64 bits is needed");
  }
  static void check(const Json& json, std::int64_t number, std::int64_t lowest,
                    std::int64_t highest, const std::string& path) {
    if (number >= lowest && number <= highest) return;
    throw JsonError(path, json.dump() + " does not fit: " + std::to_string(lowest) + " to " +
                              std::to_string(highest));
  }
  static std::int64_t integer(const Json& json, std::int64_t lowest, std::int64_t highest,
                              const std::string& path) {
    if (!json.is_number_integer()) throw JsonError(path, "an integer is needed");
    const bool huge = json.is_number_unsigned() &&
                      json.get<std::uint64_t>() > std::numeric_limits<std::uint32_t>::max();
    const std::int64_t number =
        huge ? std::numeric_limits<std::int64_t>::max() : json.get<std::int64_t>();
    check(json, number, lowest, highest, path);
    return number;
  }

  static std::vector<std::uint8_t> hex(const Json& json, const std::string& path) {
    auto bytes = json.is_string() ? from_hex(json.get_ref<const std::string&>()) : std::nullopt;
    if (!bytes) throw JsonError(path, "a string of hex digits, two a byte, is needed");
    return *std::move(bytes);
  }

  template <class T>
  static void text(const Json& json, T& out, const std::string& path) {
    if (!json.is_string()) throw JsonError(path, "a string is needed");
    const std::string bytes = from_utf8(json.get_ref<const std::string&>());
    if (!out.assign(bytes)) throw JsonError(path, too_many(bytes.size(), T::capacity(), "bytes"));
  }

  static std::string too_many(std::size_t size, std::size_t limit, const char* what) {
    return std::to_string(size) + " " + what + " do not fit: at most " + std::to_string(limit);
  }
};

/// Compares the counters in the JSON with the sizes of their lists.
struct CounterCheck {
  const Json& json;

  template <class Member>
  void operator()(const FieldInfo&, const Member&) const {}
  void operator()(const FieldInfo& field, const Counter& counter) const {
    const auto found = json.find(field.name);
    if (found == json.end() || *found == counter.count) return;
    throw JsonError(field.name, found->dump() + " is announced, but there are " +
                                    std::to_string(counter.count));
  }
};

}  // namespace detail

/// Reads `message` from `json`. Throws JsonError if `json` does not describe an M.
///
/// Every field is required, except optional ones, counters of lists and the tail. A counter that is
/// present must match its list.
template <class M>
void from_json(const Json& json, M& message) {
  M result{};
  detail::JsonReader::members(json, result, {});
  Meta<M>::visit(std::as_const(result), detail::CounterCheck{json});
  message = result;
}

}  // namespace sbgc
