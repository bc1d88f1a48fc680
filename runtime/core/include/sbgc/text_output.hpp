/// Text output to a string, to a function, or to any other place.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>

#include <sbgc/detail/digits.hpp>
#include <sbgc/internal/compiler.hpp>

namespace sbgc {

/// A destination of text. A derived class provides memory for it.
class TextOutput {
 public:
  TextOutput(const TextOutput&) = delete;
  TextOutput& operator=(const TextOutput&) = delete;

  /// Appends a character, text, or a character several times.
  void put(char c) {
    if (at_ == end_) make_room();
    *at_++ = c;
  }
  void put(std::string_view text) {
    if (text.size() > free()) return put_in_parts(text);
    std::memcpy(at_, text.data(), text.size());
    at_ += text.size();
  }
  void put(const char* text) { put(std::string_view(text)); }
  void put(char c, std::size_t count) {
    while (count > free()) {
      count -= free();
      std::memset(at_, c, free());
      at_ = end_;
      make_room();
    }
    std::memset(at_, c, count);
    at_ += count;
  }

  /// Writes an integer in decimal.
  template <class T>
    requires(std::is_integral_v<T> && !std::is_same_v<T, char> && !std::is_same_v<T, bool>)
  void put(T number) {
    const bool is_negative = std::is_signed_v<T> && number < 0;
    const auto bits = static_cast<std::uint64_t>(number);
    put_integer(is_negative, is_negative ? 0 - bits : bits);
  }

  /// Writes bytes as lowercase hex, two digits per byte.
  void put_hex(std::span<const std::uint8_t> bytes) {
    constexpr const char* digits = "0123456789abcdef";
    for (const std::uint8_t byte : bytes) {
      char* const start = room(2);
      start[0] = digits[byte >> 4];
      start[1] = digits[byte & 15];
      advance(start + 2);
    }
  }

  /// Returns memory for `size` characters, at most most_room; afterwards, pass the end of the
  /// written characters to advance().
  char* room(std::size_t size) {
    if (free() < size) make_room();
    return at_;
  }
  /// Accepts the characters written up to `end`.
  void advance(char* end) { at_ = end; }

  /// The maximum number of characters that room() can provide.
  static constexpr std::size_t most_room = 512;
  static constexpr std::size_t longest_number = 32;  ///< enough space for any number

 protected:
  TextOutput() = default;
  ~TextOutput() = default;

  /// Takes the text up to end_of_text(), and provides free memory for at least most_room
  /// characters.
  virtual void make_room() = 0;
  void provide(char* begin, char* end) {
    at_ = begin;
    end_ = end;
  }
  char* end_of_text() const { return at_; }

 private:
  // Not inlined, to reduce compile time.
  SBGC_NOINLINE void put_integer(bool is_negative, std::uint64_t size) {
    char* const start = room(longest_number);
    *start = '-';
    advance(detail::write_digits(start + (is_negative ? 1 : 0), size));
  }
  SBGC_NOINLINE void put_in_parts(std::string_view text) {
    while (text.size() > free()) {
      const std::size_t some = free();
      put(text.substr(0, some));
      text.remove_prefix(some);
      make_room();
    }
    put(text);
  }

  std::size_t free() const { return static_cast<std::size_t>(end_ - at_); }

  char* at_ = nullptr;
  char* end_ = nullptr;
};

/// Calls `take(std::string_view)` with pieces of the text.
template <class Take>
class PiecewiseOutput final : public TextOutput {
 public:
  /// Passes full pieces to `take`.
  explicit PiecewiseOutput(Take& take) : take_(take) { provide_buffer(); }

  /// Passes the rest on. Must be called at the end.
  void finish() {
    const auto size = static_cast<std::size_t>(end_of_text() - buffer_.data());
    if (size != 0) take_(std::string_view(buffer_.data(), size));
    provide_buffer();
  }

 private:
  void make_room() override { finish(); }
  void provide_buffer() { provide(buffer_.data(), buffer_.data() + buffer_.size()); }

  Take& take_;
  std::array<char, most_room> buffer_{};
};

/// Appends the text to a string.
class StringOutput final : public TextOutput {
 public:
  /// Appends to `text`.
  explicit StringOutput(std::string& text) : text_(text) { grow(text.size()); }

  /// Must be called at the end, before the string is used.
  void finish() { text_.resize(size()); }

  /// Returns the size of the string so far.
  std::size_t size() const { return static_cast<std::size_t>(end_of_text() - text_.data()); }

 private:
  void make_room() override { grow(size()); }
  void grow(std::size_t size) {
    text_.resize(2 * size + 1024);
    provide(text_.data() + size, text_.data() + text_.size());
  }

  std::string& text_;
};

}  // namespace sbgc
