/// The JSON of a message, written to a sink: text, or values of a library.
///
/// The JSON is nested like the C++ struct. Integers are raw values, bytes are lowercase hex, texts
/// are strings, missing optional members are omitted.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include <sbgc/internal/compiler.hpp>
#include <sbgc/internal/table_access.hpp>
#include <sbgc/json/values.hpp>
#include <sbgc/meta.hpp>
#include <sbgc/number.hpp>

namespace sbgc::detail {

/// Writes a message to a sink, which has these functions: begin_object(), key(name), end_object(),
/// begin_list(), element(), end_list(), and for values integer(number), real(number), hex(bytes),
/// text(bytes), word(text) and decimal(number). Secrets are replaced by `hidden_text`, unless they
/// are shown.
template <class Sink>
class JsonWriter {
 public:
  explicit JsonWriter(Sink& sink, Secrets secrets) : sink_(sink), secrets_(secrets) {}

  template <class T>
  void message(const T& value) {
    members(table_of<T>(), &value);
  }
  /// The same for a message with this table.
  void members(const StructTable& table, const void* object) {
    sink_.begin_object();
    const FieldInfo* field = table.fields;
    for (const Slot& slot : table.slots) {
      member(*field++, *slot.type, moved(object, slot.offset));
    }
    if (table.tail.type != nullptr) {
      const void* const tail = moved(object, table.tail.offset);
      if (size_at(*table.tail.type, tail) != 0) member(tail_field, *table.tail.type, tail);
    }
    sink_.end_object();
  }

 private:
  SBGC_ALWAYS_INLINE void member(const FieldInfo& field, const ValueType& type, const void* at) {
    const bool is_optional = type.kind == Kind::optional;
    if (is_optional && !is_present(type, at)) return;
    sink_.key(field.name);
    value(field, is_optional ? *type.element : type, at);
  }

  SBGC_ALWAYS_INLINE void value(const FieldInfo& field, const ValueType& type, const void* at) {
    // Most values are integers, which are handled first for speed.
    if (type.kind != Kind::scalar || type.raw > RawType::i32) return other(field, type, at);
    const std::int64_t number = load_integer(type.raw, at);
    if (is_signed(type.raw)) return sink_.integer(number);
    sink_.integer(static_cast<std::uint64_t>(number));
  }
  SBGC_NOINLINE void other(const FieldInfo& field, const ValueType& type, const void* at) {
    switch (type.kind) {
      case Kind::scalar: return scalar(type.raw, at);
      case Kind::axes:
      case Kind::group: return members(*type.group, at);
      case Kind::array:
      case Kind::list: return list(field, type, at);
      case Kind::bytes:
      case Kind::text: return chars(field, type, at);
      case Kind::counter: return sink_.integer(static_cast<std::uint32_t>(counted(type, at)));
      case Kind::number: return number(load<Number>(at));
      case Kind::optional: return value(field, *type.element, at);
    }
  }
  void scalar(RawType type, const void* at) {
    switch (type) {
      // Many JSON readers round integers of 64 bits, so they are written as texts.
      case RawType::u64: return sink_.decimal(load<std::uint64_t>(at));
      case RawType::i64: return sink_.decimal(load<std::int64_t>(at));
      case RawType::f32: return real(load<float>(at));
      default: return real(load<double>(at));
    }
  }
  void number(const Number& number) {
    sink_.begin_object();
    sink_.key(name(number.type));
    if (number.type == NumberType::f32) {
      real(number.real());
    } else {
      sink_.integer(number.integer());
    }
    sink_.end_object();
  }
  void chars(const FieldInfo& field, const ValueType& type, const void* at) {
    const std::size_t size = size_at(type, at);
    const void* const begin = moved(at, type.begin);
    const bool is_hidden = field.secret && size != 0 && secrets_ == Secrets::hidden;
    if (is_hidden) return sink_.word(hidden_text);
    if (type.kind == Kind::text) return sink_.text({static_cast<const char*>(begin), size});
    sink_.hex(std::span(static_cast<const std::uint8_t*>(begin), size));
  }
  void list(const FieldInfo& field, const ValueType& type, const void* at) {
    sink_.begin_list();
    const std::size_t size = size_at(type, at);
    for (std::size_t i = 0; i < size; ++i) {
      sink_.element();
      value(field, *type.element, element_at(type, at, i));
    }
    sink_.end_list();
  }

  /// JSON has no infinities and NaN; they are written as words.
  template <class Float>
  void real(Float value) {
    if (is_finite(value)) return sink_.real(static_cast<double>(value));
    sink_.word(FloatName(value).text());
  }

  Sink& sink_;
  Secrets secrets_;
};

}  // namespace sbgc::detail
