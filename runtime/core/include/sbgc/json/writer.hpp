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

#include <sbgc/internal/walk.hpp>
#include <sbgc/json/values.hpp>
#include <sbgc/meta.hpp>
#include <sbgc/number.hpp>

namespace sbgc::detail {

/// Writes a message to a sink, which has these functions: begin_object(), key(name), end_object(),
/// begin_list(), element(), end_list(), and for values integer(number), real(number), hex(bytes),
/// text(bytes), word(text) and decimal(number). Secrets are `hidden_text`, unless they are to be
/// shown.
template <class Sink>
class JsonWriter {
 public:
  using Place = FieldPlace;

  explicit JsonWriter(Sink& sink, Secrets secrets) : sink_(sink), secrets_(secrets) {}

  template <class T>
  void members(const T& value) {
    sink_.begin_object();
    Meta<T>::visit(value, Adder{*this});
    sink_.end_object();
  }

  // The handlers of the walk.

  template <class T>
  void scalar(const T& value, const Place&) {
    const auto raw = raw_of(value);
    if constexpr (std::is_floating_point_v<RawOf<T>>) {
      real(raw);
    } else if constexpr (sizeof raw == 8) {
      sink_.decimal(raw);  // as text, because many readers of JSON round it
    } else {
      sink_.integer(raw);
    }
  }
  void counter(const Counter& counter, const Place&) {
    sink_.integer(static_cast<std::uint32_t>(counter.count));
  }
  void number(const Number& number, const Place&) {
    sink_.begin_object();
    sink_.key(name(number.type));
    if (number.type == NumberType::f32) {
      real(number.real());
    } else {
      sink_.integer(number.integer());
    }
    sink_.end_object();
  }
  template <class T>
  void bytes(const T& bytes, const Place& place) {
    if (hides(place.field, bytes.size())) return sink_.word(hidden_text);
    sink_.hex(std::span(bytes.data(), bytes.size()));
  }
  template <class T>
  void text(const T& text, const Place& place) {
    if (hides(place.field, text.size())) return sink_.word(hidden_text);
    sink_.text({text.data(), text.size()});
  }
  template <class T>
  void list(const T& list, const Place& place) {
    sink_.begin_list();
    for (const auto& element : list) {
      sink_.element();
      walk(element, place, *this);
    }
    sink_.end_list();
  }
  template <class T>
  void array(const T& array, const Place& place) {
    list(array, place);
  }
  template <class T>
  void axes(const T& axes, const Place&) {
    members(axes);
  }
  template <class T>
  void optional(const T& optional, const Place& place) {
    walk(*optional, place, *this);
  }
  template <class T>
  void group(const T& value, const Place&) {
    members(value);
  }

 private:
  // Not a lambda: that would be a distinct type for each T.
  struct Adder {
    JsonWriter& writer;

    template <class T>
    void operator()(const FieldInfo& field, const T& member) const {
      // Missing members and an empty tail are omitted.
      if constexpr (kind_of<T> == Kind::optional) {
        if (!member) return;
      }
      if constexpr (kind_of<T> == Kind::bytes) {
        if (&field == &tail_field && member.size() == 0) return;
      }
      writer.sink_.key(field.name);
      walk(member, Place(field, {}), writer);
    }
  };

  bool hides(const FieldInfo& field, std::size_t size) const {
    return field.secret && size != 0 && secrets_ == Secrets::hidden;
  }

  /// JSON has no infinities and NaN; they are words.
  template <class Float>
  void real(Float value) {
    if (is_finite(value)) return sink_.real(static_cast<double>(value));
    sink_.word(FloatName(value).text());
  }

  Sink& sink_;
  Secrets secrets_;
};

}  // namespace sbgc::detail
