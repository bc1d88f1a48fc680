/// Writing what has no fixed place on the wire.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>

#include <sbgc/detail/fixed.hpp>
#include <sbgc/number.hpp>
#include <sbgc/status.hpp>
#include <sbgc/types.hpp>
#include <sbgc/wire_size.hpp>

namespace sbgc::detail {

/// Writes members in the order of the wire; see Reader.
class Writer {
 public:
  /// Starts at `at` of a buffer that has at least as many bytes.
  constexpr Writer(std::span<std::uint8_t> out, std::size_t at) noexcept : out_(out), at_(at) {}

  template <class T>
  constexpr void value(const T& in, const char* field) noexcept {
    if constexpr (wire_size<T> == 0) {
      T::varying_members(in, *this);
    } else if (take(wire_size<T>, field)) {
      Fixed::put(out_.data() + at_ - wire_size<T>, in);
    }
  }

  template <std::size_t n>
  constexpr void value(const BoundedText<n>& in, const char* field) noexcept {
    value(static_cast<std::uint8_t>(in.size()), field);
    for (std::size_t i = 0; i < in.size() && status_; ++i) {
      value(static_cast<std::uint8_t>(in.data()[i]), field);
    }
  }

  // Several values whose size varies.
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

  /// A value that must be there if, and only if, `condition` holds. Otherwise a reader would take
  /// the bytes for something else.
  template <class T>
  constexpr void when(bool condition, const Optional<T>& in, const char* field) noexcept {
    if (status_ && in.has_value() != condition) return fail(Code::presence_mismatch, field);
    if (in) value(*in, field);
  }
  /// The same, but the body may also end before it.
  template <class T>
  constexpr void when_or_missing(bool condition, const Optional<T>& in,
                                 const char* field) noexcept {
    if (in) {
      when(condition, in, field);
    } else if (condition && at_ + wire_size<T> < missing_end_) {
      missing_at_ = at_;
      missing_end_ = at_ + wire_size<T>;
      missing_field_ = field;
    }
  }
  /// A value that is there if the context says so, which only a reader knows.
  template <class T>
  constexpr void when_context(bool /*condition*/, const Optional<T>& in,
                              const char* field) noexcept {
    if (in) value(*in, field);
  }

  /// The number of elements of a list, in a field of type T.
  template <class T, class List>
  constexpr void count(T /*unused*/, const List& list, const char* field) noexcept {
    value(static_cast<T>(list.size()), field);
  }
  /// A list whose elements have been counted before.
  template <class T, std::size_t n>
  constexpr void counted(const BoundedArray<T, n>& in, std::size_t /*count*/, const char* field,
                         std::size_t least = 0) noexcept {
    rest(in, field, least);
  }
  template <class T, std::size_t n>
  constexpr void rest(const BoundedArray<T, n>& in, const char* field,
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
  constexpr void numbers(const BoundedArray<Number, n>& in, const NumberTypes& /*types*/,
                         const char* field) noexcept {
    for (const Number& number : in) {
      const std::size_t size = size_of(number.type);
      if (size == 0) return fail(Code::value_out_of_range, field);
      if (!take(size, field)) return;
      for (std::size_t i = 0; i < size; ++i) {
        out_[at_ - size + i] = static_cast<std::uint8_t>(number.bits >> (8 * i));
      }
    }
  }

  /// Goes to a tagged union, for which the buffer has room.
  constexpr void enter(std::size_t at, std::size_t size) noexcept {
    if (!status_) return;
    out_ = {out_.data(), at + size};
    at_ = at;
  }
  /// Fills what is left of it with zeros.
  constexpr void leave() noexcept {
    while (status_ && at_ < out_.size()) out_[at_++] = 0;
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

}  // namespace sbgc::detail
