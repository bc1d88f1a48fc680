/// Reads a message from a source of JSON: text, or values of a library.
#pragma once

#include <array>
#include <bit>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

#include <sbgc/field_path.hpp>
#include <sbgc/internal/compiler.hpp>
#include <sbgc/internal/walk.hpp>
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
  using Place = PathPlace;
  using Scope = typename Source::Scope;

  explicit JsonReader(Source& source) : source_(source) {}

  /// Returns false if the source does not describe an M.
  template <class M>
  bool message(M& out) {
    members(out, nullptr);
    return ok();
  }

  const std::string& field() const { return field_; }
  const std::string& reason() const { return reason_; }

  // The handlers of the walk.

  template <class T>
  void scalar(T& out, const Place& place) {
    using Raw = RawOf<T>;
    using Limits = std::numeric_limits<Raw>;
    Raw raw{};
    if constexpr (std::is_floating_point_v<Raw>) {
      real(raw, place.path);
    } else if constexpr (is_integer24<T>) {
      raw = static_cast<Raw>(integer(Integer24<Raw>::lowest, Integer24<Raw>::highest, place.path));
    } else if constexpr (sizeof(Raw) == 8) {
      decimal(raw, place.path);
    } else {
      raw = static_cast<Raw>(integer(Limits::min(), Limits::max(), place.path));
    }
    out = static_cast<T>(raw);
  }
  void counter(Counter&, const Place& place) {
    // A list comes after its counter, so they are compared once the whole message has been read.
    announced_ = integer(0, std::numeric_limits<std::uint8_t>::max(), place.path);
  }
  void number(Number& out, const Place& place) {
    constexpr const char* needed = "an object with the type, such as {\"i16\": -5}, is needed";
    if (!source_.is_object()) return fail(place.path, needed);
    Scope scope = source_.enter();
    JsonString key;
    if (!source_.next(scope, key)) return fail(place.path, needed);
    const auto as = [&]<class T>(NumberType type, T number) {
      if (!(key == name(type))) return false;
      scalar(number, Place(place, name(type), 0));
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
    if (ok() && (!known || source_.next(scope, key))) fail(place.path, needed);
  }
  template <class T>
  void bytes(T& out, const Place& place) {
    if constexpr (is_bounded<T>) {
      out.resize(T::capacity());
      const std::size_t size = hex({out.data(), out.size()}, place.path);
      if (!out.resize(size)) fail_size(place.path, size, " bytes", T::capacity());
    } else {
      if (hex(out, place.path) != out.size()) {
        fail(place.path, out.size(), " bytes of hex are needed");
      }
    }
  }
  template <class T>
  void text(T& out, const Place& place) {
    std::array<char, T::capacity()> bytes{};
    const std::size_t size = characters(bytes, place.path);
    if (size > bytes.size()) return fail_size(place.path, size, " bytes", bytes.size());
    if (place.field.secret && std::string_view(bytes.data(), size) == hidden_text) {
      return fail(place.path, "it is hidden; the secret itself is needed");
    }
    out.assign(std::string_view(bytes.data(), size));
  }
  template <class T>
  void list(T& out, const Place& place) {
    const auto put = [&](std::size_t index) {
      return out.resize(index + 1) ? &out[index] : nullptr;
    };
    const std::size_t size = elements<typename T::value_type>(put, place);
    if (size > T::capacity()) fail_size(place.path, size, " elements", T::capacity());
  }
  template <class T>
  void array(T& out, const Place& place) {
    const std::size_t n = out.size();
    const auto put = [&](std::size_t index) { return index < n ? &out[index] : nullptr; };
    if (elements<ElementOf<T>>(put, place) != n) fail(place.path, "a list of ", n, " is needed");
  }
  template <class T>
  void axes(T& out, const Place& place) {
    members(out, &place.path);
  }
  template <class T>
  void optional(T& out, const Place& place) {
    walk(out.emplace(), place, *this);
  }
  template <class T>
  void group(T& out, const Place& place) {
    members(out, &place.path);
  }

 private:
  /// Reads the members of an object. Each pass over them reads those that follow each other in the
  /// source. Text in wire order needs one.
  ///
  /// What depends on the type of a member is as little as possible, because it is compiled for each
  /// of them.
  struct Members {
    JsonReader& reader;
    const FieldPath* parent = nullptr;
    Scope scope{};
    JsonString key{};
    bool has_key = false;      // of a member that is not read yet
    bool has_read = false;     // a member in this pass
    bool has_unread = false;   // a member without a value, passed while there was a key
    bool is_checking = false;  // only the counters
    std::size_t index = 0;
    std::array<std::uint64_t, 4> read{};  // a bit for each member

    void start_pass() {
      index = 0;
      has_read = false;
      has_unread = false;
    }
    void take_key() { has_key = reader.source_.next(scope, key); }

    template <class Member>
    SBGC_NOINLINE void operator()(const FieldInfo& field, Member&& member) {
      constexpr Kind kind = kind_of<std::remove_cvref_t<Member>>;
      if constexpr (kind == Kind::counter) {
        if (is_checking) reader.check(field, member);
      }
      if (is_checking) return;
      const Place place(field, parent);
      // Counters are implied by their lists, and tails are rare. Everything else is required: a
      // parameter omitted by mistake would be overwritten with 0.
      const bool may_be_missing = kind == Kind::optional || kind == Kind::counter || field.optional;
      if (!is_next(place.path, may_be_missing)) return;
      walk(member, place, reader);
      if constexpr (kind == Kind::counter) {
        if (parent == nullptr) reader.announce(field.name);
      }
      if (reader.ok()) take_key();
    }

    /// Returns true if the value of this member is next in the source.
    SBGC_NOINLINE bool is_next(const FieldPath& path, bool may_be_missing) {
      std::uint64_t& word = read[index / 64];
      const std::uint64_t bit = std::uint64_t{1} << index % 64;
      const bool is_known = (word & bit) != 0;
      ++index;
      if (!reader.ok()) return false;
      if (has_key && key == path.name) {
        if (is_known) reader.fail(path, "occurs twice");
        word |= bit;
        has_read = true;
        return !is_known;
      }
      if (is_known) return false;
      has_unread = has_unread || has_key;
      if (!has_key && !may_be_missing) reader.fail(path, "it is missing");
      return false;
    }
  };

  template <class T>
  void members(T& out, const FieldPath* path) {
    if constexpr (requires { Meta<T>::fields; }) {
      static_assert(std::size(Meta<T>::fields) < 8 * sizeof Members::read, "and a tail");
    }
    object(path, &out, visit_object<T>);
  }
  // Not a lambda: compilers make two functions of one that becomes a pointer.
  template <class T>
  static void visit_object(void* object, Members& members) {
    Meta<T>::visit(*static_cast<T*>(object), members);
  }
  SBGC_NOINLINE void object(const FieldPath* path, void* out,
                            void (*visit)(void* object, Members& members)) {
    constexpr const char* needed = "an object is needed";
    if (!source_.is_object()) return path != nullptr ? fail(*path, needed) : fail_at_all(needed);
    Members members{*this, path, source_.enter()};
    members.take_key();
    do {
      members.start_pass();
      visit(out, members);
      if (!ok()) return;
      if (members.has_key && !members.has_read) {
        const std::string key = shortened(to_string(members.key));
        return fail(FieldPath{path, key.empty() ? "''" : key.c_str()}, "unknown");
      }
    } while (members.has_key || members.has_unread);
    if (path != nullptr || counters_ == 0) return;
    members.is_checking = true;
    visit(out, members);
  }

  /// Reads elements to where `put(index)` says, and checks those for which there is no place.
  /// Returns their number.
  template <class T, class Put>
  std::size_t elements(const Put& put, const Place& place) {
    std::size_t size = 0;
    if (!source_.is_list()) {
      fail(place.path, "a list is needed");
      return size;
    }
    Scope scope = source_.enter();
    for (; ok() && source_.next(scope); ++size) {
      T extra{};
      T* const to = put(size);
      walk(to != nullptr ? *to : extra, Place(place, "", size), *this);
    }
    return size;
  }

  /// Returns an integer in a range; 0 after an error.
  SBGC_NOINLINE std::int64_t integer(std::int64_t lowest, std::int64_t highest,
                                     const FieldPath& path) {
    JsonInteger number;
    if (!source_.integer(number)) {
      fail(path, "an integer is needed");
    } else if (number.value < lowest || number.value > highest) {
      fail(path, number.text, " does not fit: ", lowest, " to ", highest);
    } else {
      return number.value;
    }
    return 0;
  }
  /// Reads an integer of 64 bits, which is text.
  template <class T>
  void decimal(T& out, const FieldPath& path) {
    const ShortText text = short_text();
    const auto [end, error] = std::from_chars(text.begin(), text.end(), out);
    if (!text.is_text || error != std::errc{} || end != text.end()) {
      fail(path, "a string with an integer of 64 bits is needed");
    }
  }
  template <class Float>
  void real(Float& out, const FieldPath& path) {
    double number = 0;
    if (source_.real(number)) {
      out = static_cast<Float>(number);
      if (is_finite(out)) return;
    } else if (const auto named = float_of_name<Float>(short_text().view())) {
      out = *named;
      return;
    }
    fail(path, "a number is needed");
  }

  /// A string; "" if the value is another one, or is too long for a number.
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

  /// Reads hex as far as it fits into `out`. Returns the number of bytes of all of it; after an
  /// error, out.size().
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

  /// Reads a string as far as it fits into `bytes`. Returns the size of all of it.
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

  /// Remembers the value just read of a counter of the message.
  void announce(const char* name) {
    if (counters_ < counted_.size()) counted_[counters_++] = {name, announced_};
  }
  /// Compares an announced counter with the size of its list.
  void check(const FieldInfo& field, const Counter& counter) {
    for (const Announced& announced : counted_) {
      if (announced.name != field.name) continue;
      if (announced.count == static_cast<std::int64_t>(counter.count)) continue;
      const FieldPath path{nullptr, field.name};
      fail(path, announced.count, " is announced, but there are ", counter.count);
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
  /// The problem is the whole message.
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
