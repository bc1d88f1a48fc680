/// Converts messages to JSON with nlohmann_json. Throws no exceptions of its own and compiles
/// without them.
///
/// The JSON is nested like the C++ struct. Integers are raw values, bytes are lowercase hex, texts
/// are strings, missing optional members are omitted. The conversion is lossless:
/// from_json(to_json(m)) (see json.hpp) encodes to the same bytes.
#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>

#include <nlohmann/json.hpp>

#include <sbgc/json_text.hpp>
#include <sbgc/meta.hpp>

namespace sbgc {

/// JSON with its keys in wire order.
using Json = nlohmann::ordered_json;

namespace detail {

class JsonWriter {
 public:
  template <class T>
  static Json members(const T& value) {
    Json result = Json::object();
    Meta<T>::visit(value, Adder{result});
    return result;
  }

 private:
  // Not a lambda: that would be a distinct type for each T.
  struct Adder {
    Json& object;

    template <class T>
    void operator()(const FieldInfo& field, const T& member) const {
      add(object, field.name, member);
    }
  };

  template <class T>
  static void add(Json& object, const char* name, const T& member) {
    object[name] = value(member);
  }
  template <class T>
  static void add(Json& object, const char* name, const Optional<T>& member) {
    if (member) object[name] = value(*member);
  }
  template <std::size_t n>
  static void add(Json& object, const char* name, const BoundedBytes<n>& member) {
    // Tails are rare; an empty one is omitted.
    if (std::string_view(name) == tail_field.name && member.empty()) return;
    object[name] = value(member);
  }

  template <class T>
  static Json value(const T& value) {
    if constexpr (std::is_floating_point_v<T>) {
      return float_to_json<Json>(value);
    } else if constexpr (std::is_enum_v<T>) {
      return static_cast<std::underlying_type_t<T>>(value);
    } else if constexpr (std::is_arithmetic_v<T> && sizeof(T) == 8) {
      return std::to_string(value);  // as text, because many readers of JSON round it
    } else if constexpr (std::is_arithmetic_v<T>) {
      return value;
    } else if constexpr (RawValue<T>) {
      return JsonWriter::value(value.raw());
    } else {
      return members(value);
    }
  }
  static Json value(Counter counter) { return counter.count; }
  static Json value(const Number& number) {
    const bool real = number.type == NumberType::f32;
    return {
        {name(number.type), real ? float_to_json<Json>(number.real()) : Json(number.integer())}};
  }
  template <std::size_t n>
  static Json value(const Bytes<n>& bytes) {
    return to_hex(bytes);
  }
  template <std::size_t n>
  static Json value(const BoundedBytes<n>& bytes) {
    return to_hex(std::span(bytes.data(), bytes.size()));
  }
  template <std::size_t n>
  static Json value(const Text<n>& text) {
    return to_utf8({text.data(), text.size()});
  }
  template <std::size_t n>
  static Json value(const BoundedText<n>& text) {
    return to_utf8({text.data(), text.size()});
  }
  template <class T, std::size_t n>
  static Json value(const std::array<T, n>& array) {
    return list(array);
  }
  template <class T, std::size_t n>
  static Json value(const BoundedArray<T, n>& array) {
    return list(array);
  }

  template <class List>
  static Json list(const List& elements) {
    Json result = Json::array();
    for (const auto& element : elements) result.push_back(value(element));
    return result;
  }
};

}  // namespace detail

/// Returns a JSON object with the fields of a message.
template <class M>
Json to_json(const M& message) {
  return detail::JsonWriter::members(message);
}

}  // namespace sbgc
