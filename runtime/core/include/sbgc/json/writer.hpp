/// The JSON of a message, written to a sink: text, or values of a library.
///
/// The JSON is nested like the C++ struct. Integers are raw values, bytes are lowercase hex, texts
/// are strings, missing optional members are omitted.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <type_traits>

#include <sbgc/json/values.hpp>
#include <sbgc/meta.hpp>

namespace sbgc::detail {

/// Writes a message to a sink, which has these functions: begin_object(), key(name), end_object(),
/// begin_list(), element(), end_list(), and for values integer(number), real(number), hex(bytes),
/// text(bytes), word(text) and decimal(number).
template <class Sink>
class JsonWriter {
 public:
  explicit JsonWriter(Sink& sink) : sink_(sink) {}

  template <class T>
  void members(const T& value) {
    sink_.begin_object();
    Meta<T>::visit(value, Adder{*this});
    sink_.end_object();
  }

 private:
  // Not a lambda: that would be a distinct type for each T.
  struct Adder {
    JsonWriter& writer;

    template <class T>
    void operator()(const FieldInfo& field, const T& member) const {
      writer.add(field.name, member);
    }
  };

  template <class T>
  void add(const char* name, const T& member) {
    sink_.key(name);
    value(member);
  }
  template <class T>
  void add(const char* name, const Optional<T>& member) {
    if (member) add(name, *member);
  }
  template <std::size_t n>
  void add(const char* name, const BoundedBytes<n>& member) {
    // Tails are rare; an empty one is omitted.
    if (member.empty() && std::string_view(name) == tail_field.name) return;
    sink_.key(name);
    value(member);
  }

  template <class T>
  void value(const T& value) {
    if constexpr (std::is_floating_point_v<T>) {
      real(value);
    } else if constexpr (std::is_enum_v<T>) {
      sink_.integer(static_cast<std::underlying_type_t<T>>(value));
    } else if constexpr (std::is_arithmetic_v<T> && sizeof(T) == 8) {
      sink_.decimal(value);  // as text, because many readers of JSON round it
    } else if constexpr (std::is_arithmetic_v<T>) {
      sink_.integer(value);
    } else if constexpr (RawValue<T>) {
      this->value(value.raw());
    } else {
      members(value);
    }
  }
  void value(Counter counter) { sink_.integer(static_cast<std::uint32_t>(counter.count)); }
  void value(const Number& number) {
    sink_.begin_object();
    sink_.key(name(number.type));
    if (number.type == NumberType::f32) {
      real(number.real());
    } else {
      sink_.integer(number.integer());
    }
    sink_.end_object();
  }
  template <std::size_t n>
  void value(const Bytes<n>& bytes) {
    sink_.hex(bytes);
  }
  template <std::size_t n>
  void value(const BoundedBytes<n>& bytes) {
    sink_.hex(std::span(bytes.data(), bytes.size()));
  }
  template <std::size_t n>
  void value(const Text<n>& text) {
    sink_.text({text.data(), text.size()});
  }
  template <std::size_t n>
  void value(const BoundedText<n>& text) {
    sink_.text({text.data(), text.size()});
  }
  template <class T, std::size_t n>
  void value(const std::array<T, n>& array) {
    list(array);
  }
  template <class T, std::size_t n>
  void value(const BoundedArray<T, n>& array) {
    list(array);
  }

  template <class List>
  void list(const List& elements) {
    sink_.begin_list();
    for (const auto& element : elements) {
      sink_.element();
      value(element);
    }
    sink_.end_list();
  }

  /// JSON has no infinities and NaN; they are words.
  template <class Float>
  void real(Float value) {
    if (is_finite(value)) return sink_.real(static_cast<double>(value));
    sink_.word(FloatName(value).text());
  }

  Sink& sink_;
};

}  // namespace sbgc::detail
