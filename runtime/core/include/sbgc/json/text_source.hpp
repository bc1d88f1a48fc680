/// JSON text, read value by value.
#pragma once

#include <array>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string_view>

#include <sbgc/internal/parse_real.hpp>
#include <sbgc/json/problem.hpp>
#include <sbgc/json/tokens.hpp>
#include <sbgc/json/values.hpp>

namespace sbgc::detail {

/// A source of JsonReader: text. It reads the values that the reader requests, and stops at the
/// first character that is not JSON.
class JsonTextSource {
 public:
  explicit JsonTextSource(std::string_view text)
      : begin_(text.data()), at_(begin_), end_(begin_ + text.size()) {
    if (text.starts_with("\xEF\xBB\xBF")) at_ += 3;  // a byte order mark
  }

  /// The position in an object or list.
  struct Scope {
    bool is_first = true;
  };

  bool is_object() { return starts_with('{'); }
  bool is_list() { return starts_with('['); }

  Scope enter() {
    ++at_;
    return {};
  }
  /// Advances to the value of the next member. Returns false at the end, or if it is not JSON.
  bool next(Scope& scope, JsonString& key) {
    if (!advance(scope, '}')) return false;
    if (!starts_with('"') || !scan_string(key)) return refuse();
    if (!starts_with(':')) return refuse();
    ++at_;
    return true;
  }
  /// Advances to the next element. Returns false at the end, or if it is not JSON.
  bool next(Scope& scope) { return advance(scope, ']'); }

  // Each of these returns false and reads nothing if the value has another type.

  bool integer(JsonInteger& out) {
    Number number;
    if (!scan_number(number) || !number.is_integer) return false;
    // A number that does not fit into 64 bits is a real number.
    const auto error = number.is_negative ? from_text<std::int64_t>(number.text, out.value)
                                          : from_text<std::uint64_t>(number.text, out.value);
    if (error != std::errc{}) return false;
    out.text = number.text;
    at_ = number.text.data() + number.text.size();
    return true;
  }
  bool real(double& out) {
    Number number;
    if (!scan_number(number)) return false;
    const char* const end = number.text.data() + number.text.size();
    if (parse_real(number.text.data(), end, out).ec == std::errc::result_out_of_range) {
      if (!is_tiny(number.text)) {
        return refuse("a number that is too large for JSON");
      }
      out = number.is_negative ? -0.0 : 0.0;
    }
    at_ = end;
    return true;
  }
  bool string(JsonString& out) {
    if (!starts_with('"')) return false;
    return scan_string(out) || refuse();
  }

  /// Reads one of the words null, true and false.
  bool word(std::string_view text) {
    skip_space();
    if (!rest().starts_with(text)) return false;
    at_ += text.size();
    return true;
  }

  /// Must be called after the value. Returns false if more text follows.
  bool finish() {
    skip_space();
    return at_ == end_ || refuse();
  }

  /// Returns the error in the text; null if it is valid JSON so far.
  const char* problem() const { return problem_; }

  /// Stops reading: the text at the position is not JSON.
  bool refuse() {
    return refuse(at_ == end_ ? "this is not JSON, or only its beginning" : "this is not JSON");
  }

  /// The position, for line() and column().
  const char* at() const { return at_; }
  std::size_t line(const char* at) const {
    std::size_t result = 1;
    for (const char* read = begin_; read != at; ++read) result += *read == '\n' ? 1 : 0;
    return result;
  }
  std::size_t column(const char* at) const {
    const char* start = at;
    while (start != begin_ && start[-1] != '\n') --start;
    return 1 + static_cast<std::size_t>(at - start);
  }

 private:
  struct Number {
    std::string_view text{};
    bool is_integer{};
    bool is_negative{};
  };

  void skip_space() {
    while (at_ != end_ && (*at_ == ' ' || *at_ == '\n' || *at_ == '\t' || *at_ == '\r')) ++at_;
  }
  bool starts_with(char c) {
    skip_space();
    return at_ != end_ && *at_ == c;
  }

  bool refuse(const char* problem) {
    if (problem_ == nullptr) problem_ = problem;
    return false;
  }

  bool advance(Scope& scope, char close) {
    if (problem_ != nullptr) return false;
    skip_space();
    if (at_ == end_) return refuse();
    if (*at_ == close) {
      ++at_;
      return false;
    }
    if (!scope.is_first) {
      if (*at_ != ',') return refuse();
      ++at_;
      skip_space();
    }
    scope.is_first = false;
    return true;
  }

  /// Reads the string whose opening quote is at the position.
  bool scan_string(JsonString& out) {
    const char* const start = ++at_;
    out.has_escapes = false;
    for (skip_plain(); at_ != end_ && *at_ != '"'; skip_plain()) {
      const auto byte = static_cast<std::uint8_t>(*at_);
      if (byte == '\\') {
        out.has_escapes = true;
        if (!scan_escape()) return false;
      } else if (byte >= 0x80) {
        const std::size_t size = utf8_length(rest());
        if (size == 0) return false;
        at_ += size;
      } else {
        return false;
      }
    }
    if (at_ == end_) return false;
    out.raw = {start, static_cast<std::size_t>(at_ - start)};
    ++at_;
    return true;
  }
  /// Skips ordinary characters of a string: nearly all.
  void skip_plain() {
    static constexpr auto plain = [] {
      std::array<bool, 256> result{};
      for (std::size_t c = ' '; c < 0x80; ++c) result[c] = c != '"' && c != '\\';
      return result;
    }();
    const char* at = at_;
    while (at != end_ && plain[static_cast<std::uint8_t>(*at)]) ++at;
    at_ = at;
  }
  bool scan_escape() {
    ++at_;
    if (at_ == end_) return false;
    if (*at_ != 'u') {
      if (std::string_view("\"\\/bfnrt").find(*at_) == std::string_view::npos) return false;
      ++at_;
      return true;
    }
    const std::int32_t first = hex4(rest().substr(1));
    if (first < 0 || (first >= 0xDC00 && first < 0xE000)) return false;
    at_ += 5;
    if (first < 0xD800 || first >= 0xE000) return true;
    if (!rest().starts_with("\\u")) return false;
    const std::int32_t second = hex4(rest().substr(2));
    if (second < 0xDC00 || second >= 0xE000) return false;
    at_ += 6;
    return true;
  }

  /// Finds the end of the number at the position. Returns false if there is none.
  bool scan_number(Number& out) {
    skip_space();
    const char* at = at_;
    const auto is_digit = [&] { return at != end_ && *at >= '0' && *at <= '9'; };
    out.is_negative = at != end_ && *at == '-';
    if (out.is_negative) ++at;
    if (!is_digit()) return false;
    if (*at++ != '0') {
      while (is_digit()) ++at;
    }
    out.is_integer = true;
    if (at != end_ && *at == '.') {
      out.is_integer = false;
      ++at;
      if (!is_digit()) return false;
      while (is_digit()) ++at;
    }
    if (at != end_ && (*at == 'e' || *at == 'E')) {
      out.is_integer = false;
      ++at;
      if (at != end_ && (*at == '+' || *at == '-')) ++at;
      if (!is_digit()) return false;
      while (is_digit()) ++at;
    }
    out.text = {at_, static_cast<std::size_t>(at - at_)};
    return true;
  }

  template <class T>
  static std::errc from_text(std::string_view text, std::int64_t& out) {
    T number{};
    const auto error = std::from_chars(text.data(), text.data() + text.size(), number).ec;
    constexpr auto most = std::numeric_limits<std::int64_t>::max();
    out = number > static_cast<T>(most) ? most : static_cast<std::int64_t>(number);
    return error;
  }

  /// True for a number that is out of range because it is too close to 0.
  static bool is_tiny(std::string_view number) {
    const std::size_t mark = number.find_first_of("eE");
    const std::string_view digits = number.substr(0, mark);
    const std::size_t first = digits.find_first_of("123456789");
    if (first == std::string_view::npos) return true;
    std::int64_t exponent = 0;
    if (mark != std::string_view::npos) {
      std::string_view text = number.substr(mark + 1);
      const bool is_small = text.front() == '-';
      if (is_small || text.front() == '+') text.remove_prefix(1);
      constexpr std::int64_t huge = std::int64_t{1} << 40;
      const auto error = std::from_chars(text.data(), text.data() + text.size(), exponent).ec;
      if (error != std::errc{} || exponent > huge) exponent = huge;
      if (is_small) exponent = -exponent;
    }
    const std::size_t point = digits.substr(0, digits.find('.')).size();
    return exponent + static_cast<std::int64_t>(point) - static_cast<std::int64_t>(first) < 0;
  }

  std::string_view rest() const { return {at_, static_cast<std::size_t>(end_ - at_)}; }

  const char* begin_;
  const char* at_;
  const char* end_;
  const char* problem_ = nullptr;
};

}  // namespace sbgc::detail
