/// Parses untrusted JSON text within limits.
///
/// Json::parse() of nlohmann_json copies the members of an object when it grows, keeps the first of
/// two equal keys, stops at a NUL byte, and builds values so deep that copying one overflows the
/// stack. parse_json() accepts the same text as from_json(), in linear time, and returns a value
/// that is safe to copy, compare and print.
#pragma once

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <sbgc/json/problem.hpp>
#include <sbgc/json/text_source.hpp>
#include <sbgc/json/tokens.hpp>
#include <sbgc/json_dom.hpp>

namespace sbgc {

/// The limits of JSON text.
struct JsonLimits {
  std::size_t size = std::size_t{16} << 20U;  ///< in bytes: 16 MiB
  std::size_t depth = 64;                     ///< nested objects and lists
};

/// A value, or the problem that prevented parsing one.
struct ParsedJson {
  Json value{};                          ///< the value, if there is no problem
  std::optional<JsonProblem> problem{};  ///< why and where the text is rejected

  /// True if the text is JSON.
  explicit operator bool() const noexcept { return !problem; }
};

namespace detail {

/// Builds a value bottom-up: each value is moved into place when it is complete. Does not recurse.
class JsonBuilder {
 public:
  JsonBuilder(std::string_view text, const JsonLimits& limits) : source_(text), limits_(limits) {}

  ParsedJson run() {
    bool more = value();
    while (more && !levels_.empty()) more = next();
    if (more && source_.finish()) return {std::move(result_), {}};
    if (!problem_) fail(source_.at(), source_.problem());
    return {{}, std::move(problem_)};
  }

 private:
  struct Member {
    std::string key;
    Json value;
    const char* at;  ///< the quote of its key
  };

  /// An incomplete object or list. The value of its last member may be missing.
  struct Level {
    bool is_object;
    JsonTextSource::Scope scope;
    std::vector<Member> members{};
    Json::array_t elements{};
  };

  // Each of these returns true to continue.

  bool value() {
    if (source_.is_object()) return open(true);
    if (source_.is_list()) return open(false);
    JsonInteger integer;
    if (source_.integer(integer)) return add(number(integer));
    double real{};
    if (source_.real(real)) return add(real);
    JsonString string;
    if (source_.string(string)) return add(to_string(string));
    if (source_.word("null")) return add(nullptr);
    if (source_.word("true")) return add(true);
    if (source_.word("false")) return add(false);
    return source_.refuse();
  }

  bool open(bool is_object) {
    if (levels_.size() == limits_.depth) {
      return fail(source_.at(), "nested deeper than " + std::to_string(limits_.depth) + " levels");
    }
    levels_.push_back({is_object, source_.enter()});
    return true;
  }

  /// Reads the next value of the innermost object or list, or closes it.
  bool next() {
    Level& level = levels_.back();
    JsonString key;
    if (level.is_object ? source_.next(level.scope, key) : source_.next(level.scope)) {
      if (level.is_object) level.members.push_back({to_string(key), {}, key.raw.data() - 1});
      return value();
    }
    return source_.problem() == nullptr && (level.is_object ? end_object() : end_list());
  }
  bool end_list() {
    Json::array_t elements = std::move(levels_.back().elements);
    levels_.pop_back();
    return add(std::move(elements));
  }
  bool end_object() {
    std::vector<Member> members = std::move(levels_.back().members);
    levels_.pop_back();
    if (const Member* const twice = repeated(members); twice != nullptr) {
      return fail(twice->at, "the key '" + shortened(twice->key) + "' occurs twice");
    }
    // Bypasses the object's own insertion, which compares each new key with all earlier ones.
    Json::object_t object;
    object.reserve(members.size());
    for (Member& member : members) {
      object.emplace_back(std::move(member.key), std::move(member.value));
    }
    return add(std::move(object));
  }

  bool add(Json value) {
    if (levels_.empty()) {
      result_ = std::move(value);
    } else if (levels_.back().is_object) {
      levels_.back().members.back().value = std::move(value);
    } else {
      levels_.back().elements.push_back(std::move(value));
    }
    return true;
  }

  /// Returns the integer, even if it exceeds the range of `value`.
  static Json number(const JsonInteger& integer) {
    if (integer.value < 0) return integer.value;
    std::uint64_t result = 0;  // also of "-0"
    std::from_chars(integer.text.data(), integer.text.data() + integer.text.size(), result);
    return result;
  }

  /// Returns the first member whose key repeats that of an earlier one; null if there is none.
  static const Member* repeated(const std::vector<Member>& members) {
    std::vector<const Member*> sorted(members.size());
    std::transform(members.begin(), members.end(), sorted.begin(),
                   [](const Member& member) { return &member; });
    std::stable_sort(sorted.begin(), sorted.end(),
                     [](const Member* a, const Member* b) { return a->key < b->key; });
    const Member* first = nullptr;
    for (std::size_t i = 1; i < sorted.size(); ++i) {
      if (sorted[i]->key != sorted[i - 1]->key) continue;
      if (first == nullptr || sorted[i] < first) first = sorted[i];
    }
    return first;
  }

  bool fail(const char* at, std::string reason) {
    problem_ = {source_.line(at), source_.column(at), std::move(reason), {}};
    return false;
  }

  JsonTextSource source_;
  JsonLimits limits_;
  std::vector<Level> levels_{};
  Json result_{};
  std::optional<JsonProblem> problem_{};
};

}  // namespace detail

/// Parses one JSON value, which must be all of `text`. Repeated keys in an object and text beyond
/// the limits are problems.
inline ParsedJson parse_json(std::string_view text, const JsonLimits& limits = {}) {
  if (text.size() > limits.size) {
    return {{}, {{1, 1, "longer than " + std::to_string(limits.size) + " bytes", {}}}};
  }
  return detail::JsonBuilder(text, limits).run();
}

}  // namespace sbgc
