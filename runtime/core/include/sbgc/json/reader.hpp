/// Reads a message from a source of JSON: text, or values of a library.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include <sbgc/field_path.hpp>
#include <sbgc/internal/compiler.hpp>
#include <sbgc/internal/table_access.hpp>
#include <sbgc/json/problem.hpp>
#include <sbgc/json/tokens.hpp>
#include <sbgc/json/values.hpp>
#include <sbgc/meta.hpp>
#include <sbgc/number.hpp>
#include <sbgc/text_output.hpp>

namespace sbgc::detail {

/// Reads a message value by value from a source, such as JsonTextSource, in the order of the
/// source. Stops at the first error.
///
/// Every field is required, except optional ones, counters of lists and the tail. A counter that is
/// present must match its list.
template <class Source>
class JsonReader {
 public:
  using Scope = typename Source::Scope;

  explicit JsonReader(Source& source) : source_(source) {}

  /// Returns false if the source does not describe an M.
  template <class M>
  bool message(M& out) {
    return message(table_of<M>(), &out);
  }
  /// The same for a message with this table.
  bool message(const StructTable& table, void* out) {
    object(nullptr, table, out);
    if (ok() && counters_ != 0) check_counters(table, out);
    return ok();
  }

  const std::string& field() const { return field_; }
  const std::string& reason() const { return reason_; }

 private:
  void value(const FieldInfo& field, const ValueType& type, void* out, const FieldPath& path) {
    switch (type.kind) {
      case Kind::scalar:
        if (type.raw > RawType::i32) return other(type.raw, out, path);
        return store_number(type.raw, out, integer(limits_of(type.raw), path));
      case Kind::axes:
      case Kind::group: return object(&path, *type.group, out);
      case Kind::array:
      case Kind::list: return list(field, type, out, path);
      case Kind::bytes: return bytes(type, out, path);
      case Kind::text: return text(field, type, out, path);
      case Kind::optional:
        set_present(type, out, true);
        return value(field, *type.element, out, path);
      case Kind::counter:
        // A list comes after its counter, so they are compared once the whole message has been
        // read.
        announced_ = integer(limits_of(RawType::u8), path);
        if (path.parent == nullptr) announce(field.name);
        return;
      case Kind::number: return number(out, path);
    }
  }
  /// Reads a number that is not an integer of at most 32 bits.
  void other(RawType type, void* out, const FieldPath& path) {
    switch (type) {
      case RawType::u64: return store(out, decimal<std::uint64_t>(path));
      case RawType::i64: return store(out, decimal<std::int64_t>(path));
      case RawType::f32: return store(out, real<float>(path));
      default: return store(out, real<double>(path));
    }
  }
  void number(void* out, const FieldPath& path) {
    constexpr const char* needed = "an object with the type, such as {\"i16\": -5}, is needed";
    if (!source_.is_object()) return fail(path, needed);
    Scope scope = source_.enter();
    JsonString key;
    if (!source_.next(scope, key)) return fail(path, needed);
    Number number;
    for (const NumberType type : {NumberType::u8, NumberType::i8, NumberType::u16, NumberType::i16,
                                  NumberType::u32, NumberType::i32, NumberType::f32}) {
      if (key == name(type)) number.type = type;
    }
    const bool known = number.type != NumberType::none;
    const FieldPath inner{&path, name(number.type)};
    if (number.type == NumberType::f32) {
      number.bits = std::bit_cast<std::uint32_t>(real<float>(inner));
    } else if (known) {
      const std::uint64_t mask = ~std::uint64_t{0} >> (64 - 8 * size_of(number.type));
      const std::int64_t value = integer(limits_of(raw_of_number(number.type)), inner);
      number.bits = static_cast<std::uint32_t>(static_cast<std::uint64_t>(value) & mask);
    }
    store(out, number);
    if (ok() && (!known || source_.next(scope, key))) fail(path, needed);
  }
  void bytes(const ValueType& type, void* out, const FieldPath& path) {
    auto* const begin = static_cast<std::uint8_t*>(moved(out, type.begin));
    const std::size_t size = hex({begin, type.count}, path);
    if (resize(type, out, size)) return;
    if (type.is_bounded) return fail_size(path, size, " bytes", type.count);
    fail(path, type.count, " bytes of hex are needed");
  }
  void text(const FieldInfo& field, const ValueType& type, void* out, const FieldPath& path) {
    auto* const begin = static_cast<char*>(moved(out, type.begin));
    const std::size_t size = characters({begin, type.count}, path);
    if (size > type.count) return fail_size(path, size, " bytes", type.count);
    if (field.secret && std::string_view(begin, size) == hidden_text) {
      return fail(path, "it is hidden; the secret itself is needed");
    }
    if (type.is_bounded) return static_cast<void>(resize(type, out, size));
    std::fill(begin + size, begin + type.count, '\0');
  }
  void list(const FieldInfo& field, const ValueType& type, void* out, const FieldPath& path) {
    if (!source_.is_list()) return fail(path, "a list is needed");
    std::size_t size = 0;
    Scope scope = source_.enter();
    for (; ok() && source_.next(scope); ++size) {
      // Elements that exceed the capacity are checked, too, in the last place.
      const std::size_t place = std::min<std::size_t>(size, type.count - 1U);
      if (type.is_bounded) resize(type, out, place + 1);
      value(field, *type.element, element_at(type, out, place), FieldPath{&path, "", size});
    }
    if (type.is_bounded && size > type.count) fail_size(path, size, " elements", type.count);
    if (!type.is_bounded && size != type.count) {
      fail(path, "a list of ", type.count, " is needed");
    }
  }

  /// Reads the members of an object. Each pass over the members reads those that are in the same
  /// order in the source. Text in wire order needs one pass.
  struct Members {
    const FieldPath* parent = nullptr;
    Scope scope{};
    JsonString key{};
    bool has_key = false;                 // of a member that is not read yet
    bool has_read = false;                // a member in this pass
    bool has_unread = false;              // a member without a value, passed while there was a key
    std::array<std::uint64_t, 4> read{};  // a bit for each member
  };

  void member(Members& members, std::size_t index, const FieldInfo& field, const ValueType& type,
              void* out) {
    std::uint64_t& word = members.read[index / 64];
    const std::uint64_t bit = std::uint64_t{1} << index % 64;
    const bool is_known = (word & bit) != 0;
    const FieldPath path{members.parent, field.name};
    if (members.has_key && members.key == field.name) {
      if (is_known) return fail(path, "occurs twice");
      word |= bit;
      members.has_read = true;
      value(field, type, out, path);
      if (ok()) members.has_key = source_.next(members.scope, members.key);
      return;
    }
    if (is_known) return;
    members.has_unread = members.has_unread || members.has_key;
    // Counters are implied by their lists, and tails are rare. Everything else is required: a
    // parameter omitted by mistake would be overwritten with 0.
    const bool may_be_missing =
        type.kind == Kind::optional || type.kind == Kind::counter || field.optional;
    if (!members.has_key && !may_be_missing) fail(path, "it is missing");
  }

  void object(const FieldPath* path, const StructTable& table, void* out) {
    constexpr const char* needed = "an object is needed";
    if (!source_.is_object()) return path != nullptr ? fail(*path, needed) : fail_at_all(needed);
    Members members{path, source_.enter()};
    members.has_key = source_.next(members.scope, members.key);
    do {
      members.has_read = false;
      members.has_unread = false;
      std::size_t index = 0;
      for (const Slot& slot : table.slots) {
        member(members, index, table.fields[index], *slot.type, moved(out, slot.offset));
        if (!ok()) return;
        ++index;
      }
      if (table.tail.type != nullptr) {
        member(members, index, tail_field, *table.tail.type, moved(out, table.tail.offset));
      }
      if (!ok()) return;
      if (members.has_key && !members.has_read) {
        const std::string key = shortened(to_string(members.key));
        return fail(FieldPath{path, key.empty() ? "''" : key.c_str()}, "unknown");
      }
    } while (members.has_key || members.has_unread);
  }

  /// Returns an integer in a range; 0 after an error.
  std::int64_t integer(const RawLimits& limits, const FieldPath& path) {
    JsonInteger number;
    if (!source_.integer(number)) {
      fail(path, "an integer is needed");
    } else if (number.value < limits.lowest || number.value > limits.highest) {
      fail(path, number.text, " does not fit: ", limits.lowest, " to ", limits.highest);
    } else {
      return number.value;
    }
    return 0;
  }
  /// Reads an integer of 64 bits, which is text.
  template <class T>
  T decimal(const FieldPath& path) {
    T out{};
    const ShortText text = short_text();
    const auto [end, error] = std::from_chars(text.begin(), text.end(), out);
    if (!text.is_text || error != std::errc{} || end != text.end()) {
      fail(path, "a string with an integer of 64 bits is needed");
    }
    return out;
  }
  template <class Float>
  Float real(const FieldPath& path) {
    double number = 0;
    if (source_.real(number)) {
      const auto out = static_cast<Float>(number);
      if (is_finite(out)) return out;
    } else if (const auto named = float_of_name<Float>(short_text().view())) {
      return *named;
    }
    fail(path, "a number is needed");
    return 0;
  }

  /// A string; "" if the value is not a string, or is too long for a number.
  struct ShortText {
    std::array<char, 24> chars{};
    std::size_t size = 0;
    bool is_text = false;

    const char* begin() const { return chars.data(); }
    const char* end() const { return chars.data() + size; }
    std::string_view view() const { return {chars.data(), size}; }
  };
  ShortText short_text() {
    ShortText result;
    JsonString string;
    if (!source_.string(string)) return result;
    result.is_text = true;
    JsonBytes bytes(string);
    for (int byte = bytes.next(); byte != JsonBytes::end; byte = bytes.next()) {
      if (result.size == result.chars.size()) return {};
      result.chars[result.size++] = static_cast<char>(byte);
    }
    return result;
  }

  /// Reads as much hex as fits into `out`. Returns the total number of bytes; after an error,
  /// out.size().
  std::size_t hex(std::span<std::uint8_t> out, const FieldPath& path) {
    JsonString string;
    bool is_hex = source_.string(string);
    std::size_t size = 0;
    for (JsonBytes bytes(string); is_hex; ++size) {
      const int high = bytes.next();
      if (high == JsonBytes::end) return size;
      const int value = hex_digit(high) << 4 | hex_digit(bytes.next());
      is_hex = value >= 0;
      if (size < out.size()) out[size] = static_cast<std::uint8_t>(value);
    }
    fail(path, "a string of hex digits, two a byte, is needed");
    return out.size();
  }
  /// Returns the value of a digit in upper or lower case; negative for anything else.
  static int hex_digit(int byte) {
    if (byte >= '0' && byte <= '9') return byte - '0';
    if (byte >= 'a' && byte <= 'f') return byte - 'a' + 10;
    if (byte >= 'A' && byte <= 'F') return byte - 'A' + 10;
    return -1;
  }

  /// Reads as much of a string as fits into `bytes`. Returns its total size.
  std::size_t characters(std::span<char> bytes, const FieldPath& path) {
    JsonString string;
    if (!source_.string(string)) fail(path, "a string is needed");
    std::size_t size = 0;
    JsonBytes utf8(string);
    std::array<int, 2> before{};
    for (int byte = utf8.next(); byte != JsonBytes::end; byte = utf8.next()) {
      if (before[0] == 0xEF && (before[1] == 0x9E || before[1] == 0x9F)) {  // see is_escape()
        size -= 2;
        byte = (before[1] & 0x03) << 6 | (byte & 0x3F);
        before = {};
      } else {
        before = {before[1], byte};
      }
      if (size < bytes.size()) bytes[size] = static_cast<char>(byte);
      ++size;
    }
    return size;
  }

  /// Stores the value of the message's counter that was just read.
  void announce(const char* name) {
    if (counters_ < counted_.size()) counted_[counters_++] = {name, announced_};
  }
  /// Compares the announced counters with the sizes of their lists.
  void check_counters(const StructTable& table, const void* message) {
    const FieldInfo* field = table.fields;
    for (const Slot& slot : table.slots) {
      const FieldPath path{nullptr, (field++)->name};
      if (slot.type->kind != Kind::counter) continue;
      const std::size_t count = counted(*slot.type, moved(message, slot.offset));
      for (const Announced& announced : counted_) {
        if (announced.name != path.name) continue;
        if (announced.count == static_cast<std::int64_t>(count)) continue;
        fail(path, announced.count, " is announced, but there are ", count);
      }
    }
  }

  bool ok() const { return !has_failed_ && source_.problem() == nullptr; }

  void fail_size(const FieldPath& path, std::size_t size, const char* what, std::size_t limit) {
    fail(path, size, what, " do not fit: at most ", limit);
  }
  template <class... Part>
  SBGC_NOINLINE void fail(const FieldPath& path, Part... reason) {
    if (!ok()) return;
    std::array<char, 256> text{};
    field_.assign(text.data(), path.write(text.data(), text.size()));
    fail_at_all(reason...);
  }
  /// Reports a problem of the whole message.
  template <class... Part>
  void fail_at_all(Part... reason) {
    has_failed_ = true;
    StringOutput out(reason_);
    (out.put(reason), ...);
    out.finish();
  }

  struct Announced {
    std::string_view name{};
    std::int64_t count{};
  };

  Source& source_;
  std::int64_t announced_ = 0;
  std::array<Announced, 4> counted_{};  // more than any message has
  std::size_t counters_ = 0;
  bool has_failed_ = false;
  std::string field_{};
  std::string reason_{};
};

}  // namespace sbgc::detail
