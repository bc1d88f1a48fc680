/// Reads members whose wire offset varies.
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

/// Reads members in wire order. After the first failure, further calls do nothing. Writer has the
/// same interface, so that one varying_members() works with both.
class Reader {
 public:
  /// Starts at offset `at` of the body. Precondition: at <= body.size().
  constexpr Reader(std::span<const std::uint8_t> body, std::size_t at,
                   bool takes_fitting = false) noexcept
      : body_(body), at_(at), takes_fitting_(takes_fitting) {}

  template <class T>
  constexpr void value(T& out, const char* field) noexcept {
    constexpr Kind kind = kind_of<T>;
    if constexpr (wire_size<T> != 0) {
      if (take(wire_size<T>, field)) Fixed::get(body_.data() + at_ - wire_size<T>, out);
    } else if constexpr (kind == Kind::text) {
      text(out, field);
    } else if constexpr (kind == Kind::axes) {
      value(out[0], field);
      value(out[1], field);
      value(out[2], field);
    } else if constexpr (kind == Kind::array) {
      for (auto& element : out) value(element, field);
    } else {
      T::varying_members(out, *this);
    }
  }

  /// Reads a value that is present if `condition` holds.
  template <class T>
  constexpr void when(bool condition, Optional<T>& out, const char* field) noexcept {
    out.reset();
    if (!condition || !status_) return;
    value(out.emplace(), field);
    if (!status_) out.reset();
  }
  /// The same, but the body may end before the value.
  template <class T>
  constexpr void when_or_missing(bool condition, Optional<T>& out, const char* field) noexcept {
    when(condition && body_.size() - at_ >= wire_size<T>, out, field);
  }
  /// Reads a value that bodies of older firmware lack.
  template <class T>
  constexpr void appended(Optional<T>& out, const char* field) noexcept {
    when(at_ < body_.size(), out, field);
  }
  /// Reads a value that is present only if the body then fits exactly; see decode_body().
  template <class T>
  constexpr void if_fits(Optional<T>& out, const char* field) noexcept {
    when(takes_fitting_, out, field);
  }
  /// Reads a text that is present only if that is evident and it fills the rest of the body.
  template <std::size_t n>
  constexpr void if_fits(Optional<BoundedText<n>>& out, const char* field) noexcept {
    const std::size_t left = body_.size() - at_;
    const bool is_whole = left != 0 && left - 1 <= n && body_[at_] == left - 1;
    when(is_whole && is_evident_text(body_.data() + at_ + 1, left - 1), out, field);
  }
  /// Reads a value that is present if `condition`, taken from the context, holds.
  template <class T>
  constexpr void when_context(bool condition, Optional<T>& out, const char* field) noexcept {
    when(condition, out, field);
  }

  /// The same for a value that the caller reads if the result is true.
  template <class T>
  constexpr bool present(bool condition, Optional<T>& out, const char* /*field*/) noexcept {
    out.reset();
    if (!condition || !status_) return false;
    out.emplace();
    return true;
  }

  /// Reads the element count of a list that comes later in the body.
  template <class T, class List>
  constexpr void count(T& out, const List& /*list*/, const char* field) noexcept {
    value(out, field);
  }
  /// Reads a list of `count` elements.
  template <class T, std::size_t n>
  constexpr void counted(BoundedArray<T, n>& out, std::size_t count, const char* field,
                         std::size_t /*least*/ = 0) noexcept {
    out.clear();
    if (!status_) return;
    if (!out.resize_for_overwrite(count)) return fail(Code::too_short, field);
    if constexpr (std::is_same_v<T, std::uint8_t>) {
      if (take(count, field)) detail::copy(body_.data() + at_ - count, out.data(), count);
    } else if constexpr (GrownElement<T>) {
      grown(out, field);
    } else {
      for (std::size_t i = 0; i < count && status_; ++i) value(out[i], field);
    }
    if (!status_) out.clear();
  }

  /// Reads a list whose element count is in another member.
  template <class T, std::size_t n>
  constexpr void counted_by(BoundedArray<T, n>& out, std::size_t count,
                            const char* field) noexcept {
    counted(out, count, field);
  }
  /// Like count() and counted(), for a counter that does not hold the number of elements.
  template <Counting, class T, class List>
  constexpr void count_as(T& out, const List& list, const char* field) noexcept {
    count(out, list, field);
  }
  template <Counting counting, class T, std::size_t n>
  constexpr void counted_as(BoundedArray<T, n>& out, std::size_t count, const char* field,
                            std::size_t least = 0) noexcept {
    if constexpr (counting == Counting::bytes) {
      if (status_ && count % wire_size<T> != 0) fail(Code::count_mismatch, field);
      counted(out, count / wire_size<T>, field, least);
    } else {
      counted(out, count + 1, field, least);
    }
  }

  /// Reads numbers of the announced types, as many as the remaining bytes hold.
  template <std::size_t n>
  constexpr void numbers(BoundedArray<Number, n>& out, const NumberTypes& types,
                         const char* /*field*/) noexcept {
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

  /// Reads elements up to the end of the body. Fails if the remaining bytes are not a whole number
  /// of elements or hold fewer than `least`.
  template <class T, std::size_t n>
  constexpr void rest(BoundedArray<T, n>& out, const char* field, std::size_t least = 0) noexcept {
    if constexpr (wire_size<T> == 0 && !GrownElement<T>) {
      rest_that_ends(out, field, least);
    } else {
      const std::size_t element = element_size<T>();
      const std::size_t left = body_.size() - at_;
      if (status_ && (left % element != 0 || left / element < least)) {
        at_ = body_.size();
        fail(Code::too_short, field);
      }
      const std::size_t count = status_ ? left / element : 0;
      if (count > n) fail(Code::too_long, field);
      counted(out, count, field);
    }
  }

  /// Restricts reading to the tagged union of `size` bytes at `at`. Precondition: the body contains
  /// all of them.
  constexpr void enter(std::size_t at, std::size_t size) noexcept {
    body_ = {body_.data(), at + size};
    at_ = at;
  }
  constexpr void leave() noexcept {}

  /// Returns the number of bytes read so far; 0 after a failure.
  constexpr std::size_t size() const noexcept { return status_ ? at_ : 0; }

  /// Returns the status of the whole body; fails on trailing bytes.
  constexpr Status end() noexcept {
    if (status_ && at_ != body_.size()) fail(Code::too_long, "");
    return status_;
  }

  /// Returns the status of the whole body; stores trailing bytes in `tail`.
  template <std::size_t n>
  constexpr Status end(BoundedBytes<n>& tail) noexcept {
    rest(tail, "tail");
    return status_;
  }

 private:
  template <std::size_t n>
  constexpr void text(BoundedText<n>& out, const char* field) noexcept {
    std::uint8_t length = 0;
    value(length, field);
    if (!take(length, field)) return;
    out.clear();
    for (std::size_t i = at_ - length; i < at_; ++i) {
      if (!out.push_back(static_cast<char>(body_[i]))) return fail(Code::text_too_long, field);
    }
  }

  /// Returns the size of the elements that fill the rest of the body. At most one of several sizes
  /// fits, as lint ensures.
  template <class T>
  constexpr std::size_t element_size() const noexcept {
    if constexpr (GrownElement<T>) {
      for (const std::size_t size : T::element_sizes) {
        if ((body_.size() - at_) % size == 0) return size;
      }
      return T::element_sizes[0];
    } else {
      return wire_size<T>;
    }
  }

  /// Reads elements that fill the rest of the body, and whose size depends on the firmware.
  template <class T, std::size_t n>
  constexpr void grown(BoundedArray<T, n>& out, const char* field) noexcept {
    if (out.empty()) return;
    const auto body = body_;
    const std::size_t size = (body.size() - at_) / out.size();
    if (size * out.size() != body.size() - at_ || !is_element_size<T>(size)) {
      return fail(Code::count_mismatch, field);
    }
    for (T& element : out) {
      body_ = body.first(at_ + size);
      value(element, field);
    }
    body_ = body;
  }

  /// Reads elements whose size varies, up to the end of the body.
  template <class T, std::size_t n>
  constexpr void rest_that_ends(BoundedArray<T, n>& out, const char* field,
                                std::size_t least) noexcept {
    out.clear();
    while (status_ && at_ < body_.size()) {
      if (!out.resize(out.size() + 1)) return fail(Code::too_long, field);
      value(out[out.size() - 1], field);
    }
    if (status_ && out.size() < least) fail(Code::too_short, field);
    if (!status_) out.clear();
  }

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
  bool takes_fitting_;
  Status status_{};
};

}  // namespace sbgc::detail
