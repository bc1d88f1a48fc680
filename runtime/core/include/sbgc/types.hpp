/// The value types of message members. They use no heap and no pointers and are usable at compile
/// time.
#pragma once

#include <array>
#include <compare>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include <sbgc/internal/compiler.hpp>

namespace sbgc {

/// One value for each axis of the gimbal, in wire order.
template <class T>
struct Axes {
  T roll{};
  T pitch{};
  T yaw{};

  static constexpr std::size_t size() noexcept { return 3; }

  /// 0 is roll, 1 pitch, 2 yaw.
  constexpr T& operator[](std::size_t axis) noexcept {
    return axis == 0 ? roll : axis == 1 ? pitch : yaw;
  }
  constexpr const T& operator[](std::size_t axis) const noexcept {
    return axis == 0 ? roll : axis == 1 ? pitch : yaw;
  }

  friend constexpr bool operator==(const Axes&, const Axes&) = default;
};

/// One value for each direction of space, in wire order.
template <class T>
struct Xyz {
  T x{};
  T y{};
  T z{};

  static constexpr std::size_t size() noexcept { return 3; }

  /// 0 is x, 1 is y, 2 is z.
  constexpr T& operator[](std::size_t index) noexcept {
    return index == 0 ? x : index == 1 ? y : z;
  }
  constexpr const T& operator[](std::size_t index) const noexcept {
    return index == 0 ? x : index == 1 ? y : z;
  }

  friend constexpr bool operator==(const Xyz&, const Xyz&) = default;
};

/// A 24-bit integer as on the wire.
template <class Raw>
class Integer24 {
 public:
  /// The integer that holds it in memory.
  using raw_type = Raw;
  static constexpr auto lowest = static_cast<Raw>(std::is_signed_v<Raw> ? -0x800000 : 0);
  static constexpr auto highest = static_cast<Raw>(std::is_signed_v<Raw> ? 0x7FFFFF : 0xFFFFFF);

  constexpr Integer24() = default;
  /// Traps if the number does not fit; in a constant expression, it does not compile.
  constexpr explicit Integer24(Raw raw) noexcept : raw_(raw) {
    if (raw < lowest || raw > highest) detail::trap();
  }
  /// Returns the integer.
  constexpr Raw raw() const noexcept { return raw_; }

  friend constexpr bool operator==(const Integer24&, const Integer24&) = default;
  // NOLINTNEXTLINE(modernize-use-nullptr): a false alarm of clang-tidy 14
  friend constexpr auto operator<=>(const Integer24&, const Integer24&) = default;

 private:
  Raw raw_{};
};
/// An unsigned integer of 24 bits.
using U24 = Integer24<std::uint32_t>;
/// A signed integer of 24 bits.
using I24 = Integer24<std::int32_t>;

/// A fixed number of opaque bytes.
template <std::size_t n>
struct Bytes : std::array<std::uint8_t, n> {
  friend constexpr bool operator==(const Bytes&, const Bytes&) = default;
};

namespace detail {

struct Places;

/// Returns true for a text that readers recognize although the bytes could be something else: it is
/// not empty, and has no control characters.
template <class Byte>
constexpr bool is_evident_text(const Byte* bytes, std::size_t size) noexcept {
  constexpr std::uint8_t space = 0x20;
  for (std::size_t i = 0; i < size; ++i) {
    if (static_cast<std::uint8_t>(bytes[i]) < space) return false;
  }
  return size != 0;
}

/// Storage for the elements of a list, not initialized at run time: lists are usually much shorter
/// than their capacity. A union, because copying one copies its bytes, initialized or not.
template <class T, std::size_t n>
union Room {
  struct Zeroed {};
  struct Uninitialized {};

  constexpr explicit Room(Zeroed) noexcept : items{} {}
  constexpr explicit Room(Uninitialized) noexcept {}

  std::array<T, n> items;
};

}  // namespace detail

/// Up to `n` elements, stored in place.
template <class T, std::size_t n>
class BoundedArray {
 public:
  using value_type = T;

  /// An empty list.
  constexpr BoundedArray() noexcept
      : room_(detail::is_constant_evaluated() ? Room(typename Room::Zeroed{})
                                              : Room(typename Room::Uninitialized{})) {}

  /// Returns the largest size.
  static constexpr std::size_t capacity() noexcept { return n; }
  [[nodiscard]] constexpr std::size_t size() const noexcept { return size_; }
  [[nodiscard]] constexpr bool empty() const noexcept { return size_ == 0; }
  constexpr T* data() noexcept { return room_.items.data(); }
  constexpr const T* data() const noexcept { return room_.items.data(); }
  constexpr T* begin() noexcept { return room_.items.data(); }
  constexpr T* end() noexcept { return room_.items.data() + size_; }
  constexpr const T* begin() const noexcept { return room_.items.data(); }
  constexpr const T* end() const noexcept { return room_.items.data() + size_; }

  /// Precondition: index < size().
  constexpr T& operator[](std::size_t index) noexcept { return room_.items[index]; }
  constexpr const T& operator[](std::size_t index) const noexcept { return room_.items[index]; }

  /// Removes all elements.
  constexpr void clear() noexcept { size_ = 0; }

  /// Returns false and changes nothing if it is full.
  constexpr bool push_back(const T& value) noexcept {
    if (size_ == n) return false;
    room_.items[size_++] = value;
    return true;
  }

  /// Sets the size. Elements added by it are value-initialized. Returns false and changes nothing
  /// if `size` exceeds the capacity.
  constexpr bool resize(std::size_t size) noexcept {
    if (size > n) return false;
    for (std::size_t i = size_; i < size; ++i) room_.items[i] = T{};
    size_ = static_cast<std::uint8_t>(size);
    return true;
  }

  /// The same for a caller that assigns the added elements before they are read. Elements of
  /// trivial types are not initialized.
  constexpr bool resize_for_overwrite(std::size_t size) noexcept {
    if constexpr (!std::is_trivially_default_constructible_v<T>) return resize(size);
    if (size > n) return false;
    size_ = static_cast<std::uint8_t>(size);
    return true;
  }

  /// Compares the elements in use only.
  friend constexpr bool operator==(const BoundedArray& a, const BoundedArray& b) noexcept {
    if (a.size_ != b.size_) return false;
    for (std::size_t i = 0; i < a.size_; ++i) {
      if (!(a.room_.items[i] == b.room_.items[i])) return false;
    }
    return true;
  }

 private:
  friend struct detail::Places;
  static_assert(n <= 255, "no body holds more");
  using Room = detail::Room<T, n>;

  std::uint8_t size_{};
  Room room_;
};

/// Up to `n` opaque bytes, stored in place.
template <std::size_t n>
class BoundedBytes : public BoundedArray<std::uint8_t, n> {
 public:
  friend constexpr bool operator==(const BoundedBytes&, const BoundedBytes&) = default;
};

/// UTF-8 text in a field of `n` bytes, padded with NUL. All `n` bytes are preserved.
template <std::size_t n>
struct Text {
  std::array<char, n> bytes{};  ///< with padding, as on the wire

  /// Returns the number of bytes before the padding.
  [[nodiscard]] constexpr std::size_t size() const noexcept {
    std::size_t length = n;
    while (length > 0 && bytes[length - 1] == '\0') --length;
    return length;
  }
  /// Returns the first byte; the text may lack a final NUL.
  constexpr const char* data() const noexcept { return bytes.data(); }
  /// Returns the size on the wire.
  static constexpr std::size_t capacity() noexcept { return n; }

  /// Assigns anything with data() and size(), such as std::string_view. Returns false and changes
  /// nothing if it is too long.
  template <class String>
  constexpr bool assign(const String& text) noexcept {
    if (text.size() > n) return false;
    bytes.fill('\0');
    for (std::size_t i = 0; i < text.size(); ++i) bytes[i] = text.data()[i];
    return true;
  }

  friend constexpr bool operator==(const Text&, const Text&) = default;
};

/// Text of up to `n` bytes, preceded by a length byte on the wire.
template <std::size_t n>
class BoundedText {
 public:
  [[nodiscard]] constexpr std::size_t size() const noexcept { return chars_.size(); }
  /// Returns the first byte; the text has no final NUL.
  constexpr const char* data() const noexcept { return chars_.data(); }
  /// Returns the largest size, in bytes.
  static constexpr std::size_t capacity() noexcept { return n; }

  /// Removes all characters.
  constexpr void clear() noexcept { chars_.clear(); }
  /// Returns false and changes nothing if it is full.
  constexpr bool push_back(char value) noexcept { return chars_.push_back(value); }

  /// See Text::assign().
  template <class String>
  constexpr bool assign(const String& text) noexcept {
    if (!chars_.resize_for_overwrite(text.size())) return false;
    for (std::size_t i = 0; i < text.size(); ++i) chars_[i] = text.data()[i];
    return true;
  }

  friend constexpr bool operator==(const BoundedText&, const BoundedText&) = default;

 private:
  BoundedArray<char, n> chars_{};
};

/// A value that may be missing. (std::optional is not freestanding in C++20.)
template <class T>
class Optional {
 public:
  using value_type = T;

  constexpr Optional() = default;
  /// Holds a value; implicit, as in {.pitch = value}.
  // NOLINTNEXTLINE(google-explicit-constructor): a value is an optional value
  constexpr Optional(const T& value) noexcept : value_(value), present_(true) {}
  /// Converts from anything that converts to T, such as the literal of a quantity. T itself rejects
  /// numbers that it does not accept.
  template <class U>
    requires(std::is_arithmetic_v<U> ? std::is_class_v<T> : std::convertible_to<const U&, T>)
  // NOLINTNEXTLINE(google-explicit-constructor): see above
  constexpr Optional(const U& value) noexcept : value_(converted(value)), present_(true) {}

  /// True if it holds a value.
  [[nodiscard]] constexpr bool has_value() const noexcept { return present_; }
  /// True if it holds a value.
  constexpr explicit operator bool() const noexcept { return present_; }

  /// Precondition of access to the value: has_value().
  constexpr T& operator*() noexcept { return value_; }
  constexpr const T& operator*() const noexcept { return value_; }
  /// A member of the value. Precondition: it holds one.
  constexpr T* operator->() noexcept { return &value_; }
  constexpr const T* operator->() const noexcept { return &value_; }

  /// Removes the value.
  constexpr void reset() noexcept { present_ = false; }
  /// Makes the value present and returns it; it keeps the last value held.
  constexpr T& emplace() noexcept {
    present_ = true;
    return value_;
  }

  friend constexpr bool operator==(const Optional& a, const Optional& b) noexcept {
    return a.present_ == b.present_ && (!a.present_ || a.value_ == b.value_);
  }

 private:
  template <class U>
  static constexpr T converted(const U& value) noexcept {
    return value;
  }

  friend struct detail::Places;

  T value_{};
  bool present_{};
};

namespace detail {

/// The offsets of the parts of these types in memory.
struct Places {
  template <class List>
  static consteval std::size_t of_elements() noexcept {
    static_assert(offsetof(List, size_) == 0);
    return offsetof(List, room_);
  }
  template <class Value>
  static consteval std::size_t of_flag() noexcept {
    static_assert(offsetof(Value, value_) == 0);
    return offsetof(Value, present_);
  }
};

}  // namespace detail

}  // namespace sbgc
