/// Parses untrusted JSON text within limits.
///
/// Json::parse() of nlohmann_json copies the members of an object when it grows, keeps the first of
/// two equal keys, stops at a NUL byte, and builds values so deep that copying one overflows the
/// stack. parse_json() parses untrusted text in linear time, into a value that is safe to copy,
/// compare and print.
#pragma once

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <sbgc/json/problem.hpp>
#include <sbgc/json_dom.hpp>

namespace sbgc {

/// The limits of JSON text.
struct JsonLimits {
  std::size_t size = std::size_t{16} << 20U;  ///< in bytes: 16 MiB
  std::size_t depth = 64;                     ///< nested objects and lists
};

/// A value, or the problem that prevented parsing one.
struct ParsedJson {
  Json value{};
  std::optional<JsonProblem> problem{};

  explicit operator bool() const noexcept { return !problem; }
};

namespace detail {

/// An iterator over text that stores its position in `place` when it advances.
class TrackingIterator {
 public:
  using iterator_category = std::input_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;    // NOLINT(readability-identifier-naming): of the standard
  using reference = const char&;  // NOLINT(readability-identifier-naming): of the standard

  TrackingIterator(const char* at, const char** place) : at_(at), place_(place) {}

  reference operator*() const { return *at_; }
  TrackingIterator& operator++() {
    *place_ = ++at_;
    return *this;
  }
  TrackingIterator operator++(int) {
    TrackingIterator before = *this;
    ++*this;
    return before;
  }
  bool operator==(const TrackingIterator& other) const { return at_ == other.at_; }

 private:
  const char* at_;
  const char** place_;
};

/// Builds a value bottom-up from the events of nlohmann_json's parser: each value is moved into
/// place when it is complete. The parser itself does not recurse.
class JsonBuilder {
 public:
  JsonBuilder(std::string_view text, const JsonLimits& limits)
      : text_(text), limits_(limits), read_(text.data()) {}

  ParsedJson run() {
    if (text_.size() > limits_.size) {
      return {{}, {{1, 1, "longer than " + std::to_string(limits_.size) + " bytes", {}}}};
    }
    const char* const end = text_.data() + text_.size();
    const bool complete =
        Json::sax_parse(TrackingIterator(read_, &read_), TrackingIterator(end, &read_), this);
    // The parser treats a NUL byte as the end.
    const std::size_t zero = text_.find('\0');
    if (complete && zero != std::string_view::npos) fail(zero, not_json);
    if (problem_) return {{}, std::move(problem_)};
    return {std::move(result_), {}};
  }

  // The events. Each returns true to continue.

  bool null() { return add(Json()); }
  bool boolean(bool value) { return add(Json(value)); }
  bool number_integer(Json::number_integer_t value) { return add(Json(value)); }
  bool number_unsigned(Json::number_unsigned_t value) { return add(Json(value)); }
  bool number_float(Json::number_float_t value, const std::string&) { return add(Json(value)); }
  bool string(std::string& value) { return add(Json(std::move(value))); }
  bool binary(Json::binary_t&) { return false; }  // never occurs in text

  bool start_object(std::size_t) { return open(true); }
  bool start_array(std::size_t) { return open(false); }
  bool key(std::string& key) {
    levels_.back().members.push_back({std::move(key), {}, offset()});
    return true;
  }
  bool end_array() {
    Json::array_t elements = std::move(levels_.back().elements);
    levels_.pop_back();
    return add(Json(std::move(elements)));
  }
  bool end_object() {
    std::vector<Member> members = std::move(levels_.back().members);
    levels_.pop_back();
    if (const Member* const twice = repeated(members); twice != nullptr) {
      return fail(key_start(twice->key_end),
                  "the key '" + shortened(twice->key) + "' occurs twice");
    }
    // Bypasses the object's own insertion, which compares each new key with all earlier ones.
    Json::object_t object;
    object.reserve(members.size());
    for (Member& member : members) {
      object.emplace_back(std::move(member.key), std::move(member.value));
    }
    return add(Json(std::move(object)));
  }

  template <class Exception>
  bool parse_error(std::size_t position, const std::string&, const Exception& error) {
    constexpr int out_of_range = 400;  // and the codes above it
    const std::size_t at = std::max<std::size_t>(position, 1) - 1;
    if (error.id > out_of_range) return fail(at, "a number that is too large for JSON");
    if (position > text_.size())
      return fail(text_.size(), "this is not JSON, or only its beginning");
    return fail(at, not_json);
  }

 private:
  static constexpr const char* not_json = "this is not JSON";

  struct Member {
    std::string key;
    Json value;
    std::size_t key_end;  ///< the offset after its closing quote
  };

  /// An incomplete object or list. The value of its last member may be missing.
  struct Level {
    bool is_object;
    std::vector<Member> members{};
    Json::array_t elements{};
  };

  /// Returns the number of bytes read.
  std::size_t offset() const { return static_cast<std::size_t>(read_ - text_.data()); }

  bool open(bool is_object) {
    if (levels_.size() == limits_.depth) {
      return fail(offset() - 1, "nested deeper than " + std::to_string(limits_.depth) + " levels");
    }
    levels_.push_back({is_object});
    return true;
  }

  bool add(Json&& value) {
    if (levels_.empty()) {
      result_ = std::move(value);
    } else if (levels_.back().is_object) {
      levels_.back().members.back().value = std::move(value);
    } else {
      levels_.back().elements.push_back(std::move(value));
    }
    return true;
  }

  /// Returns the first member whose key repeats that of an earlier one; null if there is none.
  static const Member* repeated(const std::vector<Member>& members) {
    std::vector<const Member*> sorted(members.size());
    std::transform(members.begin(), members.end(), sorted.begin(),
                   [](const Member& member) { return &member; });
    std::sort(sorted.begin(), sorted.end(), [](const Member* a, const Member* b) {
      const int order = a->key.compare(b->key);
      return order != 0 ? order < 0 : a < b;
    });
    const Member* first = nullptr;
    for (std::size_t i = 1; i < sorted.size(); ++i) {
      if (sorted[i]->key != sorted[i - 1]->key) continue;
      if (first == nullptr || sorted[i] < first) first = sorted[i];
    }
    return first;
  }

  /// Returns the start of the key that ends before `end`: the nearest earlier quote that is not
  /// escaped.
  std::size_t key_start(std::size_t end) const {
    for (std::size_t at = end - 2;; --at) {
      if (text_[at] != '"') continue;
      const std::size_t last_other = text_.find_last_not_of('\\', at - 1);
      if ((at - 1 - last_other) % 2 == 0) return at;
    }
  }

  bool fail(std::size_t at, std::string reason) {
    const std::string_view before = text_.substr(0, at);
    const auto lines = static_cast<std::size_t>(std::count(before.begin(), before.end(), '\n'));
    const std::size_t line_start = before.rfind('\n') + 1;  // npos + 1 is 0
    problem_ = {lines + 1, at - line_start + 1, std::move(reason), {}};
    return false;
  }

  std::string_view text_;
  JsonLimits limits_;
  const char* read_;  // the end of the bytes read
  std::vector<Level> levels_{};
  Json result_{};
  std::optional<JsonProblem> problem_{};
};

}  // namespace detail

/// Parses one JSON value, which must be all of `text`. Repeated keys in an object and text beyond
/// the limits are problems.
inline ParsedJson parse_json(std::string_view text, const JsonLimits& limits = {}) {
  return detail::JsonBuilder(text, limits).run();
}

}  // namespace sbgc
