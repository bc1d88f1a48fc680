/// Writes members whose wire offset varies.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>

#include <sbgc/internal/fixed.hpp>
#include <sbgc/number.hpp>
#include <sbgc/status.hpp>
#include <sbgc/types.hpp>
#include <sbgc/wire_size.hpp>

namespace sbgc::detail {

/// Writes members in wire order; see Reader.
class Writer {
 public:
  /// Starts at offset `at` of the buffer. Precondition: at <= out.size().
  constexpr Writer(std::span<std::uint8_t> out, std::size_t at) noexcept : out_(out), at_(at) {}

  template <class T>
  constexpr void value(const T& in, const char* field) noexcept {
    constexpr Kind kind = kind_of<T>;
    if constexpr (wire_size<T> != 0) {
      if (take(wire_size<T>, field)) Fixed::put(out_.data() + at_ - wire_size<T>, in);
    } else if constexpr (kind == Kind::text) {
      value(static_cast<std::uint8_t>(in.size()), field);
      for (std::size_t i = 0; i < in.size() && status_; ++i) value(in.data()[i], field);
    } else if constexpr (kind == Kind::axes) {
      value(in[0], field);
      value(in[1], field);
      value(in[2], field);
    } else if constexpr (kind == Kind::array) {
      for (const auto& element : in) value(element, field);
    } else {
      T::varying_members(in, *this);
    }
  }

  /// Writes a value that must be present if and only if `condition` holds. Otherwise a reader would
  /// misinterpret the bytes.
  template <class T>
  constexpr void when(bool condition, const Optional<T>& in, const char* field) noexcept {
    if (status_ && in.has_value() != condition) return fail(Code::presence_mismatch, field);
    if (in) value(*in, field);
  }
  /// The same, but the body may end before the value.
  template <class T>
  constexpr void when_or_missing(bool condition, const Optional<T>& in,
                                 const char* field) noexcept {
    if (in) {
      when(condition, in, field);
    } else if (condition) {
      miss(wire_size<T>, field);
    }
  }
  /// Writes a value before which the body may end. Nothing can follow a missing value.
  template <class T>
  constexpr void appended(const Optional<T>& in, const char* field) noexcept {
    if (in) {
      value(*in, field);
    } else {
      miss(1, field);
    }
  }
  /// Writes a value that may be absent.
  template <class T>
  constexpr void if_fits(const Optional<T>& in, const char* field) noexcept {
    when_context(true, in, field);
  }
  /// Writes a text that may be absent. A reader recognizes it only if it is evident, and nothing
  /// follows.
  template <std::size_t n>
  constexpr void if_fits(const Optional<BoundedText<n>>& in, const char* field) noexcept {
    if (!in) return;
    if (status_ && !is_evident_text(in->data(), in->size())) {
      return fail(Code::presence_mismatch, field);
    }
    value(*in, field);
    miss(1, field);
  }
  /// Writes a value whose presence depends on the context, which only a reader knows.
  template <class T>
  constexpr void when_context(bool /*condition*/, const Optional<T>& in,
                              const char* field) noexcept {
    if (in) value(*in, field);
  }

  /// Like when(), for a value that the caller writes if the result is true.
  template <class T>
  constexpr bool present(bool condition, const Optional<T>& in, const char* field) noexcept {
    if (status_ && in.has_value() != condition) fail(Code::presence_mismatch, field);
    return status_ && in.has_value();
  }

  /// Writes the element count of a list as a T.
  template <class T, class List>
  constexpr void count(T /*unused*/, const List& list, const char* field) noexcept {
    value(static_cast<T>(list.size()), field);
  }
  /// Writes a list whose element count has already been written.
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
    } else if constexpr (GrownElement<T>) {
      grown(in, field);
    } else {
      for (std::size_t i = 0; i < in.size() && status_; ++i) value(in[i], field);
    }
  }

  /// Writes a list whose element count is in another member.
  template <class T, std::size_t n>
  constexpr void counted_by(const BoundedArray<T, n>& in, std::size_t count,
                            const char* field) noexcept {
    if (status_ && in.size() != count) return fail(Code::count_mismatch, field);
    rest(in, field);
  }
  /// Like count() and counted(), for a counter that does not hold the number of elements.
  template <Counting counting, class T, class List>
  constexpr void count_as(T /*unused*/, const List& list, const char* field) noexcept {
    if (counting == Counting::minus_1 && status_ && list.empty()) {
      return fail(Code::count_mismatch, field);
    }
    value(static_cast<T>(counter_of<counting>(list)), field);
  }
  template <Counting, class T, std::size_t n>
  constexpr void counted_as(const BoundedArray<T, n>& in, std::size_t /*count*/, const char* field,
                            std::size_t least = 0) noexcept {
    rest(in, field, least);
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

  /// Restricts writing to the tagged union of `size` bytes at `at`. Precondition: the buffer
  /// contains all of them.
  constexpr void enter(std::size_t at, std::size_t size) noexcept {
    if (!status_) return;
    out_ = {out_.data(), at + size};
    at_ = at;
  }
  /// Fills the rest of the tagged union with zeros.
  constexpr void leave() noexcept {
    while (status_ && at_ < out_.size()) out_[at_++] = 0;
  }

  /// Returns the size of the body. Fails if a missing value is followed by enough bytes for a
  /// reader to mistake them for it.
  constexpr WriteResult end() noexcept {
    if (status_ && at_ >= missing_end_) {
      at_ = missing_at_;
      fail(Code::presence_mismatch, missing_field_);
    }
    return {status_ ? at_ : 0, status_};
  }

 private:
  /// Writes elements that all have the size of the same firmware.
  template <class T, std::size_t n>
  constexpr void grown(const BoundedArray<T, n>& in, const char* field) noexcept {
    std::size_t size = 0;
    for (std::size_t i = 0; i < in.size() && status_; ++i) {
      Writer element(out_, at_);
      element.value(in[i], field);
      const WriteResult end = element.end();
      if (!end) {
        at_ = element.at_;
        status_ = end.status;
        return;
      }
      if (i == 0) size = end.size - at_;
      if (end.size - at_ != size || !is_element_size<T>(size)) {
        return fail(Code::presence_mismatch, field);
      }
      at_ = end.size;
    }
  }
  /// Records a missing value, for which `size` following bytes would be mistaken.
  constexpr void miss(std::size_t size, const char* field) noexcept {
    if (at_ + size >= missing_end_) return;
    missing_at_ = at_;
    missing_end_ = at_ + size;
    missing_field_ = field;
  }
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
