/// A value or an error.
#pragma once

#include <cassert>
#include <utility>
#include <variant>

#include <sbgc/error.hpp>

namespace sbgc {

/// The result of an operation that can fail. True in a condition if it holds a value:
///     if (auto angles = client.get_angles()) use(*angles); else report(angles.error().message);
/// Reading the value of a failure, or the error of a success, is undefined behavior.
template <class T>
class [[nodiscard]] Result {
  // NOLINTNEXTLINE(bugprone-sizeof-expression): checks that T is complete, also if it is a pointer
  static_assert(sizeof(T) != 0,
                "include the message's header, such as <sbgc/messages/control.hpp>");

 public:
  /// The type of the value.
  using value_type = T;

  // NOLINTNEXTLINE(google-explicit-constructor): `return value;`
  Result(T value) : content_(std::in_place_index<0>, std::move(value)) {}
  // NOLINTNEXTLINE(google-explicit-constructor): `return error;`
  Result(ClientError error) : content_(std::in_place_index<1>, std::move(error)) {}

  /// True if it holds a value.
  explicit operator bool() const noexcept { return content_.index() == 0; }

  /// The value. Precondition: it holds one.
  T& operator*() & noexcept {
    assert(*this);
    return *std::get_if<0>(&content_);
  }
  const T& operator*() const& noexcept {
    assert(*this);
    return *std::get_if<0>(&content_);
  }
  T&& operator*() && noexcept { return std::move(**this); }
  /// A member of the value. Precondition: it holds one.
  T* operator->() noexcept { return &**this; }
  const T* operator->() const noexcept { return &**this; }

  /// The error. Precondition: it holds no value.
  const ClientError& error() const& noexcept {
    assert(!*this);
    return *std::get_if<1>(&content_);
  }
  ClientError&& error() && noexcept {
    assert(!*this);
    return std::move(*std::get_if<1>(&content_));
  }

 private:
  std::variant<T, ClientError> content_;
};

/// The result of an operation without a value: `return {};` on success.
template <>
class [[nodiscard]] Result<void> {
 public:
  using value_type = void;

  Result() noexcept = default;
  // NOLINTNEXTLINE(google-explicit-constructor): `return error;`
  Result(ClientError error) : error_(std::move(error)), failed_(true) {}

  explicit operator bool() const noexcept { return !failed_; }

  const ClientError& error() const& noexcept {
    assert(failed_);
    return error_;
  }
  ClientError&& error() && noexcept {
    assert(failed_);
    return std::move(error_);
  }

 private:
  ClientError error_{};
  bool failed_ = false;
};

}  // namespace sbgc
