/// Sets one value of a message by its path.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include <sbgc/internal/compiler.hpp>
#include <sbgc/internal/parse_number.hpp>
#include <sbgc/internal/walk.hpp>
#include <sbgc/meta.hpp>
#include <sbgc/value_text.hpp>

namespace sbgc::detail {

/// Walks along a path, adds what is missing on the way, and sets the value at its end; the value of
/// a list is its size. Instantiates functions per type of member, not per member of each message.
/// Without a value, it only adds what is missing, removes what is at the end, or finds it.
class FieldSetter {
 public:
  using Place = FieldPlace;

  enum class End : std::uint8_t { set, remove, find };

  FieldSetter(std::string_view path, const AnyValue* value, End end = End::set)
      : rest_(path), value_(value), end_(end) {}

  /// True if the message has the field, and the field takes the value.
  bool is_done() const { return is_done_; }

  template <class T>
  SBGC_NOINLINE void members(T& value) {
    if (!is_found()) Meta<T>::visit(value, Member{*this, take_name()});
  }

  // The handlers of the walk.

  template <class T>
  SBGC_NOINLINE void scalar(T& out, const Place&) {
    using Raw = RawOf<T>;
    using Value = std::conditional_t<std::is_floating_point_v<Raw>, double, std::int64_t>;
    if (const auto* const value = taken<Value>()) out = static_cast<T>(static_cast<Raw>(*value));
  }
  void counter(Counter&, const Place&) { is_found(); }  // follows from the list
  void number(Number& out, const Place&) {
    if (const auto* const value = taken<Number>()) out = *value;
  }
  template <class T>
  SBGC_NOINLINE void bytes(T& out, const Place&) {
    const auto* const value = taken<std::vector<std::uint8_t>>();
    if (value == nullptr) return;
    if constexpr (is_bounded<T>) {
      is_done_ = out.resize(value->size());
    } else {
      is_done_ = out.size() == value->size();
    }
    if (is_done_) std::copy(value->begin(), value->end(), out.begin());
  }
  template <class T>
  SBGC_NOINLINE void text(T& out, const Place&) {
    if (const auto* const value = taken<std::string>()) {
      is_done_ = out.assign(std::string_view(*value));
    }
  }
  template <class T>
  SBGC_NOINLINE void list(T& out, const Place& place) {
    if (rest_.empty()) {
      if (end_ == End::remove) {
        out.clear();
        is_done_ = true;
      } else if (const auto* const size = taken<std::int64_t>()) {
        is_done_ = out.resize(static_cast<std::size_t>(*size));
      }
      return;
    }
    const std::size_t index = take_index();
    if (index >= T::capacity()) return;
    if (index >= out.size() && (end_ == End::find || !out.resize(index + 1))) return;
    walk(out[index], place, *this);
  }
  template <class T>
  SBGC_NOINLINE void array(T& out, const Place& place) {
    if (is_found()) return;
    const std::size_t index = take_index();
    if (index < out.size()) walk(out[index], place, *this);
  }
  template <class T>
  void axes(T& out, const Place&) {
    members(out);
  }
  template <class T>
  void optional(T& out, const Place& place) {
    if (rest_.empty() && end_ == End::remove) {
      out.reset();
      is_done_ = true;
      return;
    }
    if (!out && end_ == End::find) return;
    if (!out) out.emplace();
    walk(*out, place, *this);
  }
  template <class T>
  void group(T& out, const Place&) {
    members(out);
  }

 private:
  struct Member {
    FieldSetter& setter;
    std::string_view name;

    template <class T>
    void operator()(const FieldInfo& field, T&& member) const {
      if (name == field.name) walk(member, Place(field, {}), setter);
    }
  };

  /// True if the path ends here, and nothing else is asked.
  bool is_found() {
    is_done_ = is_done_ || (rest_.empty() && end_ == End::find);
    return is_done_;
  }

  /// Returns the value if the path ends here, and it is a V.
  template <class V>
  const V* taken() {
    if (!rest_.empty() || end_ == End::remove) return nullptr;
    is_done_ = value_ == nullptr || std::holds_alternative<V>(*value_);
    return value_ != nullptr && is_done_ ? &std::get<V>(*value_) : nullptr;
  }

  std::string_view take_name() {
    if (rest_.starts_with('.')) rest_.remove_prefix(1);
    const std::string_view name =
        rest_.substr(0, std::min(rest_.find_first_of(".["), rest_.size()));
    rest_.remove_prefix(name.size());
    return name;
  }

  /// Returns the index at the beginning of the rest; a huge one if there is none.
  std::size_t take_index() {
    const std::size_t close = rest_.find(']');
    if (!rest_.starts_with('[') || close == std::string_view::npos) return ~std::size_t{0};
    const auto index = parse_number<std::size_t>(rest_.substr(1, close - 1));
    if (!index) return ~std::size_t{0};
    rest_.remove_prefix(close + 1);
    return *index;
  }

  std::string_view rest_;
  const AnyValue* value_;
  End end_;
  bool is_done_ = false;
};

}  // namespace sbgc::detail
