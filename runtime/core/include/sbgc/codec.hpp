/// What generated codecs are made of: fixed pieces by offset, and cursors for what varies.
#pragma once

#include <array>
#include <bit>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>

#include <sbgc/checksum.hpp>
#include <sbgc/flags.hpp>
#include <sbgc/number.hpp>
#include <sbgc/protocol.hpp>
#include <sbgc/quantity.hpp>
#include <sbgc/status.hpp>
#include <sbgc/types.hpp>
#include <sbgc/wire.hpp>

// Not standard, but what all compilers call it.
#define SBGC_RESTRICT __restrict

namespace sbgc {

/// Generated code and runtime belong together; generated headers check this number.
inline constexpr int codec_version = 1;

/// Who sends a message. `both` is said of messages that travel either way, never of a frame.
enum class Direction : std::uint8_t { to_board, from_board, both };

/// The versions since which something exists, as VersionTypes have them; 0: always.
struct Availability {
  std::uint16_t firmware{};
  std::uint8_t board{};
};

/// A type over one integer of the wire: quantities, flag sets, packed integers.
template <class T>
concept RawValue = requires(const T value) {
  typename T::raw_type;
  { value.raw() } -> std::same_as<typename T::raw_type>;
  T(value.raw());
};

/// Bytes that a type takes on the wire; 0 if that varies.
template <class T>
inline constexpr std::size_t wire_size = [] {
  if constexpr (requires { T::wire_size; }) {
    return T::wire_size;
  } else {
    return std::size_t{0};
  }
}();
template <class T>
  requires(wire::Number<T> || std::is_enum_v<T>)
inline constexpr std::size_t wire_size<T> = sizeof(T);
template <RawValue T>
inline constexpr std::size_t wire_size<T> = sizeof(typename T::raw_type);
template <class T>
inline constexpr std::size_t wire_size<Axes<T>> = 3 * wire_size<T>;
template <class T>
inline constexpr std::size_t wire_size<Xyz<T>> = 3 * wire_size<T>;
template <class T, std::size_t n>
inline constexpr std::size_t wire_size<std::array<T, n>> = n* wire_size<T>;
template <std::size_t n>
inline constexpr std::size_t wire_size<Bytes<n>> = n;
template <std::size_t n>
inline constexpr std::size_t wire_size<Text<n>> = n;
template <>
inline constexpr std::size_t wire_size<char> = 1;

namespace detail {

constexpr void copy(const std::uint8_t* from, std::uint8_t* to, std::size_t size) noexcept {
  if (std::is_constant_evaluated()) {
    for (std::size_t i = 0; i < size; ++i) to[i] = from[i];
  } else if (size != 0) {
    __builtin_memcpy(to, from, size);
  }
}

}  // namespace detail

// get() reads a value from its place in a body, put() writes it there. The caller has checked that
// the bytes are there. Generated structs add overloads of their own.

template <wire::Number T>
constexpr void get(const std::uint8_t* from, T& value) noexcept {
  value = wire::load<T>(from);
}
template <wire::Number T>
constexpr void put(std::uint8_t* to, T value) noexcept {
  wire::store(to, value);
}

constexpr void get(const std::uint8_t* from, char& value) noexcept {
  value = static_cast<char>(*from);
}
constexpr void put(std::uint8_t* to, char value) noexcept {
  *to = static_cast<std::uint8_t>(value);
}

template <class T>
  requires std::is_enum_v<T>
constexpr void get(const std::uint8_t* from, T& value) noexcept {
  value = static_cast<T>(wire::load<std::underlying_type_t<T>>(from));
}
template <class T>
  requires std::is_enum_v<T>
constexpr void put(std::uint8_t* to, T value) noexcept {
  wire::store(to, static_cast<std::underlying_type_t<T>>(value));
}

template <RawValue T>
constexpr void get(const std::uint8_t* from, T& value) noexcept {
  value = T(wire::load<typename T::raw_type>(from));
}
template <RawValue T>
constexpr void put(std::uint8_t* to, T value) noexcept {
  wire::store(to, value.raw());
}

template <class T>
constexpr void get(const std::uint8_t* from, Axes<T>& value) noexcept {
  get(from, value.roll);
  get(from + wire_size<T>, value.pitch);
  get(from + 2 * wire_size<T>, value.yaw);
}
template <class T>
constexpr void put(std::uint8_t* to, const Axes<T>& value) noexcept {
  put(to, value.roll);
  put(to + wire_size<T>, value.pitch);
  put(to + 2 * wire_size<T>, value.yaw);
}

template <class T>
constexpr void get(const std::uint8_t* from, Xyz<T>& value) noexcept {
  get(from, value.x);
  get(from + wire_size<T>, value.y);
  get(from + 2 * wire_size<T>, value.z);
}
template <class T>
constexpr void put(std::uint8_t* to, const Xyz<T>& value) noexcept {
  put(to, value.x);
  put(to + wire_size<T>, value.y);
  put(to + 2 * wire_size<T>, value.z);
}

template <class T, std::size_t n>
constexpr void get(const std::uint8_t* from, std::array<T, n>& value) noexcept {
  for (std::size_t i = 0; i < n; ++i) get(from + i * wire_size<T>, value[i]);
}
template <class T, std::size_t n>
constexpr void put(std::uint8_t* to, const std::array<T, n>& value) noexcept {
  for (std::size_t i = 0; i < n; ++i) put(to + i * wire_size<T>, value[i]);
}

template <std::size_t n>
constexpr void get(const std::uint8_t* from, Bytes<n>& value) noexcept {
  detail::copy(from, value.data(), n);
}
template <std::size_t n>
constexpr void put(std::uint8_t* to, const Bytes<n>& value) noexcept {
  detail::copy(value.data(), to, n);
}

template <std::size_t n>
constexpr void get(const std::uint8_t* from, Text<n>& value) noexcept {
  get(from, value.bytes);
}
template <std::size_t n>
constexpr void put(std::uint8_t* to, const Text<n>& value) noexcept {
  put(to, value.bytes);
}

namespace detail {

// Members that stand in memory as on the wire are copied in blocks, which a compiler seldom sees by
// itself. The members between the two have no gap in memory if there is none between the ends.

/// Whether a run of members stands in memory as on the wire: `distance` is that on the wire.
constexpr bool in_parallel(std::size_t first, std::size_t last, std::size_t distance) noexcept {
  return std::endian::native == std::endian::little && last - first == distance;
}

/// Fills the `size` bytes of members that begin `at` bytes into `out`.
template <class T>
inline void get_block(const std::uint8_t* from, T& out, std::size_t at, std::size_t size) noexcept {
  static_assert(std::is_standard_layout_v<T> && std::is_trivially_copyable_v<T>);
  __builtin_memcpy(reinterpret_cast<unsigned char*>(&out) + at, from, size);
}
template <class T>
inline void put_block(std::uint8_t* to, const T& in, std::size_t at, std::size_t size) noexcept {
  static_assert(std::is_standard_layout_v<T> && std::is_trivially_copyable_v<T>);
  __builtin_memcpy(to, reinterpret_cast<const unsigned char*>(&in) + at, size);
}
/// Adds up the `size` bytes of members that begin `at` bytes into `in`.
template <class T>
[[gnu::always_inline]] inline void add_block(ByteSum& sum, const T& in, std::size_t at,
                                             std::size_t size) noexcept {
  sum.add(reinterpret_cast<const std::uint8_t*>(&in) + at, size);
}

/// The error for a body of the wrong size.
constexpr Status wrong_size(std::size_t size, std::size_t wanted) noexcept {
  return {size < wanted ? Code::too_short : Code::too_long,
          static_cast<std::uint16_t>(size < wanted ? size : wanted)};
}

/// Keeps what follows the `size` bytes that are known; true unless it does not fit.
template <std::size_t n>
constexpr Status get_tail(std::span<const std::uint8_t> body, std::size_t size,
                          BoundedBytes<n>& tail) noexcept {
  tail.clear();
  if (body.size() == size) return {};
  if (!tail.resize(body.size() - size)) return {Code::too_long, max_body_size};
  copy(body.data() + size, tail.data(), tail.size());
  return {};
}

/// Writes back what get_tail() kept.
template <std::size_t n>
constexpr void put_tail(std::uint8_t* to, const BoundedBytes<n>& tail) noexcept {
  copy(tail.data(), to, tail.size());
}

/// Gives a wider integer, or what is made of one, the value of a narrower one.
template <class From, class To>
constexpr void widen(const From& from, To& to) noexcept {
  const auto raw = [&] {
    if constexpr (RawValue<From>) {
      return from.raw();
    } else if constexpr (std::is_enum_v<From>) {
      return static_cast<std::underlying_type_t<From>>(from);
    } else {
      return from;
    }
  }();
  if constexpr (RawValue<To>) {
    to = To(static_cast<typename To::raw_type>(raw));
  } else {
    to = static_cast<To>(raw);
  }
}

/// Whether a conditional value must stand where its condition holds.
enum Need : bool { required, may_be_missing };

/// Reads what varies, in order, and remembers the first failure; later calls then do nothing.
class Reader {
 public:
  /// Goes on at `at` of a body of which at least that many bytes are there.
  constexpr Reader(std::span<const std::uint8_t> body, std::size_t at) noexcept
      : body_(body), at_(at) {}

  template <class T>
  constexpr void value(T& out, const char* field) noexcept {
    if constexpr (wire_size<T> == 0) {
      read(*this, out);  // of a generated struct that varies
    } else if (take(wire_size<T>, field)) {
      get(body_.data() + at_ - wire_size<T>, out);
    }
  }

  template <std::size_t n>
  constexpr void value(BoundedText<n>& out, const char* field) noexcept {
    std::uint8_t length = 0;
    value(length, field);
    if (!take(length, field)) return;
    out.clear();
    for (std::size_t i = at_ - length; i < at_; ++i) {
      if (!out.push_back(static_cast<char>(body_[i]))) return fail(Code::text_too_long, field);
    }
  }

  // Values whose size varies, one behind the other.
  template <class T>
    requires(wire_size<T> == 0)
  constexpr void value(Axes<T>& out, const char* field) noexcept {
    for (std::size_t i = 0; i < out.size(); ++i) value(out[i], field);
  }
  template <class T>
    requires(wire_size<T> == 0)
  constexpr void value(Xyz<T>& out, const char* field) noexcept {
    for (std::size_t i = 0; i < out.size(); ++i) value(out[i], field);
  }
  template <class T, std::size_t n>
    requires(wire_size<T> == 0)
  constexpr void value(std::array<T, n>& out, const char* field) noexcept {
    for (T& element : out) value(element, field);
  }

  /// A value that is there if `condition` holds, or, where it may be missing, if it also fits.
  template <class T>
  constexpr void when(bool condition, Need need, Optional<T>& out, const char* field) noexcept {
    out.reset();
    if (!condition || !status_) return;
    if (need == may_be_missing && body_.size() - at_ < wire_size<T>) return;
    value(out.emplace(), field);
    if (!status_) out.reset();
  }

  template <class T, std::size_t n>
  constexpr void array(BoundedArray<T, n>& out, std::size_t count, const char* field) noexcept {
    out.clear();
    if (!status_) return;
    if (!out.resize(count)) return fail(Code::too_short, field);
    if constexpr (std::is_same_v<T, std::uint8_t>) {
      if (take(count, field)) detail::copy(body_.data() + at_ - count, out.data(), count);
    } else {
      for (std::size_t i = 0; i < count && status_; ++i) value(out[i], field);
    }
    if (!status_) out.clear();
  }

  /// Numbers of announced types, as many as there are bytes for.
  template <std::size_t n>
  constexpr void numbers(BoundedArray<Number, n>& out, const NumberTypes& types) noexcept {
    out.clear();
    for (const NumberType type : types) {
      const std::size_t size = size_of(type);
      if (!status_ || body_.size() - at_ < size) return;
      Number number{type};
      for (std::size_t i = 0; i < size; ++i) {
        number.bits |= static_cast<std::uint32_t>(body_[at_ + i]) << (8 * i);
      }
      if (!out.push_back(number)) return;
      at_ += size;
    }
  }

  /// Everything up to the end of the body, which must be a whole number of elements, of which there
  /// must be `least`.
  template <class T, std::size_t n>
  constexpr void rest(BoundedArray<T, n>& out, const char* field, std::size_t least = 0) noexcept {
    constexpr std::size_t element = wire_size<T>;
    const std::size_t left = body_.size() - at_;
    if (status_ && (left % element != 0 || left / element < least)) {
      at_ = body_.size();
      fail(Code::too_short, field);
    }
    const std::size_t count = status_ ? left / element : 0;
    if (count > n) fail(Code::too_long, field);
    array(out, count, field);
  }

  /// The status of the whole body, of which nothing may be left.
  constexpr Status end() noexcept {
    if (status_ && at_ != body_.size()) fail(Code::too_long, "");
    return status_;
  }

  /// The status of the whole body; what is left goes to `tail`.
  template <std::size_t n>
  constexpr Status end(BoundedBytes<n>& tail) noexcept {
    rest(tail, "tail");
    return status_;
  }

  constexpr std::size_t at() const noexcept { return at_; }

 private:
  constexpr bool take(std::size_t size, const char* field) noexcept {
    if (!status_) return false;
    if (body_.size() - at_ < size) {
      at_ = body_.size();
      fail(Code::too_short, field);
      return false;
    }
    at_ += size;
    return true;
  }
  constexpr void fail(Code code, const char* field) noexcept {
    status_ = {code, static_cast<std::uint16_t>(at_), field};
  }

  std::span<const std::uint8_t> body_;
  std::size_t at_;
  Status status_{};
};

/// Writes what varies, in order, and remembers the first failure; later calls then do nothing.
class Writer {
 public:
  /// Goes on at `at` of a buffer that has at least that many bytes.
  constexpr Writer(std::span<std::uint8_t> out, std::size_t at) noexcept : out_(out), at_(at) {}

  template <class T>
  constexpr void value(const T& in, const char* field) noexcept {
    if constexpr (wire_size<T> == 0) {
      write(*this, in);  // of a generated struct that varies
    } else if (take(wire_size<T>, field)) {
      put(out_.data() + at_ - wire_size<T>, in);
    }
  }

  template <std::size_t n>
  constexpr void value(const BoundedText<n>& in, const char* field) noexcept {
    value(static_cast<std::uint8_t>(in.size()), field);
    for (std::size_t i = 0; i < in.size() && status_; ++i) {
      value(static_cast<std::uint8_t>(in.data()[i]), field);
    }
  }

  // Values whose size varies, one behind the other.
  template <class T>
    requires(wire_size<T> == 0)
  constexpr void value(const Axes<T>& in, const char* field) noexcept {
    for (std::size_t i = 0; i < in.size(); ++i) value(in[i], field);
  }
  template <class T>
    requires(wire_size<T> == 0)
  constexpr void value(const Xyz<T>& in, const char* field) noexcept {
    for (std::size_t i = 0; i < in.size(); ++i) value(in[i], field);
  }
  template <class T, std::size_t n>
    requires(wire_size<T> == 0)
  constexpr void value(const std::array<T, n>& in, const char* field) noexcept {
    for (const T& element : in) value(element, field);
  }

  /// A conditional value: it may stand only where `condition` holds, and must stand there unless
  /// it may be missing. Otherwise a reader would take the bytes for something else.
  template <class T>
  constexpr void when(bool condition, Need need, const Optional<T>& in,
                      const char* field) noexcept {
    const bool present = in.has_value();
    if (status_ && present != condition && (present || need == required)) {
      return fail(Code::presence_mismatch, field);
    }
    if (present) {
      value(*in, field);
    } else if (condition && at_ + wire_size<T> < missing_end_) {
      missing_at_ = at_;
      missing_end_ = at_ + wire_size<T>;
      missing_field_ = field;
    }
  }

  template <class T, std::size_t n>
  constexpr void array(const BoundedArray<T, n>& in, const char* field,
                       std::size_t least = 0) noexcept {
    if (status_ && in.size() < least) return fail(Code::count_mismatch, field);
    if constexpr (std::is_same_v<T, std::uint8_t>) {
      if (take(in.size(), field)) {
        detail::copy(in.data(), out_.data() + at_ - in.size(), in.size());
      }
    } else {
      for (std::size_t i = 0; i < in.size() && status_; ++i) value(in[i], field);
    }
  }

  template <std::size_t n>
  constexpr void numbers(const BoundedArray<Number, n>& in, const char* field) noexcept {
    for (const Number& number : in) {
      const std::size_t size = size_of(number.type);
      if (size == 0) return fail(Code::value_out_of_range, field);
      if (!take(size, field)) return;
      for (std::size_t i = 0; i < size; ++i) {
        out_[at_ - size + i] = static_cast<std::uint8_t>(number.bits >> (8 * i));
      }
    }
  }

  /// The size of the body. A value that is missing, followed by so much that a reader would take
  /// that for it, is a failure.
  constexpr WriteResult end() noexcept {
    if (status_ && at_ >= missing_end_) {
      at_ = missing_at_;
      fail(Code::presence_mismatch, missing_field_);
    }
    return {status_ ? at_ : 0, status_};
  }

  /// Fills what is left of the buffer, a region that begins at `base` of the body, with zeros.
  constexpr Status fill(std::size_t base) noexcept {
    if (!status_) return {status_.code, static_cast<std::uint16_t>(base + at_), status_.field};
    while (at_ < out_.size()) out_[at_++] = 0;
    return {};
  }

 private:
  constexpr bool take(std::size_t size, const char* field) noexcept {
    if (!status_) return false;
    if (out_.size() - at_ < size) {
      fail(Code::buffer_too_small, field);
      return false;
    }
    at_ += size;
    return true;
  }
  constexpr void fail(Code code, const char* field) noexcept {
    status_ = {code, static_cast<std::uint16_t>(at_), field};
  }

  std::span<std::uint8_t> out_;
  std::size_t at_;
  std::size_t missing_at_{};
  std::size_t missing_end_ = static_cast<std::size_t>(-1);
  const char* missing_field_ = "";
  Status status_{};
};

}  // namespace detail
}  // namespace sbgc
