#include "values/configuration_text.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <map>
#include <set>
#include <utility>

#include <fmt/format.h>

#include <sbgc/internal/suggestions.hpp>

#include "command/command_error.hpp"
#include "command/duration.hpp"

namespace sbgc::tools {

namespace {

// The name of a section is handled for each of its keys.
constexpr std::size_t longest_configuration_name = 256;
// Errors, and the names of other programs, hold values.
constexpr std::size_t longest_configuration_value = 4096;
constexpr std::size_t most_configuration_levels = 16;

bool is_configuration_space(char c) { return c == ' ' || c == '\t'; }

/// Also what TOML wants in quotes, except what has a meaning.
bool belongs_to_bare_word(char c) {
  return static_cast<unsigned char>(c) > ' ' && c != '\x7f' &&
         std::string_view("=.,[]{}#\"'").find(c) == std::string_view::npos;
}

void append_utf8(std::string& text, std::uint32_t code) {
  const auto tail = [&](unsigned shift) {
    text += static_cast<char>(0x80U | ((code >> shift) & 0x3FU));
  };
  if (code < 0x80) {
    text += static_cast<char>(code);
  } else if (code < 0x800) {
    text += static_cast<char>(0xC0U | (code >> 6U));
    tail(0);
  } else if (code < 0x10000) {
    text += static_cast<char>(0xE0U | (code >> 12U));
    tail(6), tail(0);
  } else {
    text += static_cast<char>(0xF0U | (code >> 18U));
    tail(12), tail(6), tail(0);
  }
}

}  // namespace

class ConfigurationText::Parser {
 public:
  Parser(ConfigurationText& into, std::string_view text) : into_(into), text_(text) {}

  void parse() {
    begin_section({}, {});
    while (skip_to_something(true)) {
      if (peek() == '[') {
        parse_section();
      } else {
        parse_key();
      }
      skip_spaces();
      if (peek() == '#') skip_line();
      if (!is_at_end() && peek() != '\n') reject("here the line should end");
    }
  }

 private:
  using Place = ConfigurationPlace;

  bool is_at_end() const { return at_ == text_.size(); }
  /// The next character; at the end, and for '\r' before it, that of the end of a line.
  char peek() const {
    if (is_at_end()) return '\n';
    const bool is_line_end = text_[at_] == '\r' && at_ + 1 < text_.size() && text_[at_ + 1] == '\n';
    return is_line_end ? '\n' : text_[at_];
  }
  char take() {
    const char c = text_[at_++];
    if (c == '\n') {
      ++line_;
      line_start_ = at_;
    }
    return c;
  }
  Place place() const { return {line_, at_ - line_start_ + 1}; }
  [[noreturn]] void reject(const std::string& reason) const { into_.reject(place(), reason); }

  void skip_spaces() {
    while (!is_at_end() && is_configuration_space(text_[at_])) ++at_;
  }
  void skip_line() {
    while (!is_at_end() && peek() != '\n') ++at_;
  }
  /// Skips empty lines and comments. Returns false at the end.
  bool skip_to_something(bool is_at_line_start = false) {
    while (!is_at_end()) {
      skip_spaces();
      if (peek() == '#' || (is_at_line_start && peek() == ';')) skip_line();
      if (is_at_end()) return false;
      if (peek() != '\n') return true;
      take_line_end();
    }
    return false;
  }
  void take_line_end() {
    if (text_[at_] == '\r') ++at_;
    take();
  }
  void expect(char wanted, const char* what) {
    skip_spaces();
    if (is_at_end() || peek() != wanted) reject(fmt::format("here {} is missing", what));
    take();
  }

  std::string parse_bare_word() {
    const std::size_t start = at_;
    while (!is_at_end() && belongs_to_bare_word(text_[at_])) ++at_;
    return std::string(text_.substr(start, at_ - start));
  }

  std::string parse_name() {
    skip_spaces();
    const Place start = place();
    std::string name = peek() == '"' || peek() == '\'' ? parse_quoted() : parse_bare_word();
    if (name.empty()) {
      into_.reject(start, is_at_end() ? "here a name is missing"
                                      : fmt::format("here a name is missing, before '{}'",
                                                    text_.substr(start_of(start), 1)));
    }
    if (name.size() > longest_configuration_name) {
      into_.reject(start, fmt::format("a name longer than {} bytes", longest_configuration_name));
    }
    return name;
  }
  std::size_t start_of(Place place) const { return line_start_ + place.column - 1; }

  std::vector<std::string> parse_path() {
    std::vector<std::string> path{parse_name()};
    for (skip_spaces(); peek() == '.'; skip_spaces()) {
      take();
      if (path.size() == most_configuration_levels) {
        reject(fmt::format("nested deeper than {} levels", most_configuration_levels));
      }
      path.push_back(parse_name());
    }
    return path;
  }

  void parse_section() {
    const Place start = place();
    take();
    if (peek() == '[') reject("tables in lists, [[…]], have no meaning here");
    std::vector<std::string> path = parse_path();
    expect(']', "']'");
    if (const auto same = sections_.find(path); same != sections_.end()) {
      const ConfigurationSection& first = into_.sections_[same->second];
      into_.reject(start, fmt::format("{} begins for the second time, first in line {}",
                                      first.name(), first.place.line));
    }
    current_ = begin_section(std::move(path), start);
  }

  std::size_t begin_section(std::vector<std::string> path, Place at) {
    const std::size_t index = into_.sections_.size();
    sections_.emplace(path, index);
    into_.sections_.push_back({std::move(path), at, {}});
    return index;
  }

  void parse_key() {
    ConfigurationKey key{.place = place()};
    std::vector<std::string> path = parse_path();
    key.name = std::move(path.back());
    path.pop_back();
    expect('=', "'='");
    parse_values(key);
    const std::size_t section = section_below(path, key.place);
    if (!keys_.emplace(section, key.name).second) {
      into_.reject(key.place, fmt::format("'{}' is set for the second time", key.name));
    }
    into_.sections_[section].keys.push_back(std::move(key));
  }

  /// The section of a key: the current one, or for a key with dots, one below it.
  std::size_t section_below(const std::vector<std::string>& steps, Place at) {
    if (steps.empty()) return current_;
    std::vector<std::string> path = into_.sections_[current_].path;
    path.insert(path.end(), steps.begin(), steps.end());
    if (const auto same = sections_.find(path); same != sections_.end()) return same->second;
    return begin_section(std::move(path), at);
  }

  void parse_values(ConfigurationKey& key) {
    skip_spaces();
    if (peek() != '[') {
      key.values.push_back(parse_value());
      return;
    }
    take();
    key.is_list = true;
    while (true) {
      skip_to_something();
      if (is_at_end()) reject("here the ']' of the list is missing");
      if (peek() == ']') break;
      key.values.push_back(parse_value());
      skip_to_something();
      if (is_at_end() || (peek() != ',' && peek() != ']')) reject("here ',' or ']' is missing");
      if (peek() == ',') take();
    }
    take();
  }

  ConfigurationValue parse_value() {
    using Kind = ConfigurationValue::Kind;
    const Place start = place();
    if (peek() == '"' || peek() == '\'') return {Kind::text, parse_quoted(), start};
    if (peek() == '[' || peek() == '{') reject("lists in lists, and tables, have no meaning here");
    std::string word = parse_bare_word();
    while (!is_at_end() && peek() == '.') {
      take();
      word += '.' + parse_bare_word();
    }
    if (word == "true" || word == "false") return {Kind::truth, std::move(word), start};
    double ignored{};
    const char* const end = word.data() + word.size();
    const auto read = std::from_chars(word.data(), end, ignored);
    if (!word.empty() && read.ec == std::errc{} && read.ptr == end) {
      return {Kind::number, std::move(word), start};
    }
    into_.reject(start, word.empty() ? "here a value is missing"
                                     : fmt::format("texts stand in quotes: \"{}\"", word));
  }

  std::string parse_quoted() {
    const Place start = place();
    const char quote = take();
    std::string result;
    while (!is_at_end() && peek() != '\n' && peek() != quote) {
      const char c = take();
      if (c == '\\' && quote == '"') {
        parse_escape(result);
      } else {
        result += c;
      }
    }
    if (is_at_end() || peek() == '\n') into_.reject(start, "this text has no end");
    if (result.size() > longest_configuration_value) {
      into_.reject(start, fmt::format("a text longer than {} bytes", longest_configuration_value));
    }
    take();
    return result;
  }

  void parse_escape(std::string& result) {
    constexpr std::string_view letters = "btnfr\"\\";
    constexpr std::string_view meanings = "\b\t\n\f\r\"\\";
    const char letter = is_at_end() ? '\n' : take();
    if (const auto index = letters.find(letter); index != std::string_view::npos) {
      result += meanings[index];
      return;
    }
    const std::size_t digits = letter == 'u' ? 4 : letter == 'U' ? 8 : 0;
    const std::string_view hex = text_.substr(at_, digits);
    std::uint32_t code{};
    constexpr int base = 16;
    const auto read = std::from_chars(hex.data(), hex.data() + hex.size(), code, base);
    const bool is_code = digits != 0 && hex.size() == digits &&
                         read.ptr == hex.data() + hex.size() && code != 0 && code <= 0x10FFFF &&
                         (code < 0xD800 || code > 0xDFFF);
    if (!is_code) reject("no such escape; in '…', a backslash is a backslash");
    at_ += digits;
    append_utf8(result, code);
  }

  ConfigurationText& into_;
  std::string_view text_;
  std::size_t at_ = 0;
  std::size_t line_ = 1;
  std::size_t line_start_ = 0;
  // By their path and their name, so that the time does not grow with the square of their number.
  std::map<std::vector<std::string>, std::size_t> sections_;
  std::set<std::pair<std::size_t, std::string>> keys_;
  std::size_t current_ = 0;
};

std::string ConfigurationSection::name() const {
  return path.empty() ? "the beginning" : fmt::format("[{}]", fmt::join(path, "."));
}

ConfigurationText::ConfigurationText(std::string_view text, std::string file)
    : file_(std::move(file)) {
  Parser(*this, text).parse();
}

void reject_configuration(const std::string& file, ConfigurationPlace place,
                          const std::string& reason) {
  throw CommandError(fmt::format("{}:{}:{}: {}", file, place.line, place.column, reason));
}

void ConfigurationText::reject(ConfigurationPlace place, const std::string& reason) const {
  reject_configuration(file_, place, reason);
}

const ConfigurationKey* SectionReader::find(std::string_view key) {
  known_.emplace_back(key);
  const auto found = std::ranges::find(section_.keys, key, &ConfigurationKey::name);
  return found == section_.keys.end() ? nullptr : &*found;
}

const ConfigurationValue* SectionReader::one(std::string_view key) {
  const ConfigurationKey* const found = find(key);
  if (found == nullptr) return nullptr;
  if (found->is_list) {
    text_.reject(found->place, fmt::format("'{}' has one value, not a list", key));
  }
  return &found->values.front();
}

void SectionReader::reject_kind(const ConfigurationValue& value, std::string_view key,
                                const std::string& wanted) const {
  reject(value, fmt::format("'{}' is '{}'; it must be {}", key, value.text, wanted));
}

std::optional<std::string> SectionReader::text(std::string_view key) {
  const ConfigurationValue* const value = one(key);
  if (value == nullptr) return std::nullopt;
  if (value->kind != ConfigurationValue::Kind::text) {
    reject_kind(*value, key, "a text, in quotes");
  }
  return value->text;
}

std::string SectionReader::required_text(std::string_view key, std::string_view example) {
  std::string found = text(key).value_or("");
  if (found.empty()) lacks(key, example);
  return found;
}

void SectionReader::lacks(std::string_view key, std::string_view example) {
  if (!missing_.empty()) return;
  missing_ = fmt::format("{} has no {}; add {}", section_.name(), key, example);
}

const std::vector<ConfigurationValue>& SectionReader::required_texts(std::string_view key,
                                                                     std::string_view example) {
  static const std::vector<ConfigurationValue> none;
  const std::vector<ConfigurationValue>* const found = texts(key);
  if (found == nullptr || found->empty()) lacks(key, example);
  return found == nullptr ? none : *found;
}

std::optional<std::size_t> SectionReader::count(std::string_view key, std::size_t least,
                                                std::size_t most) {
  const ConfigurationValue* const value = one(key);
  if (value == nullptr) return std::nullopt;
  double result{};
  const auto read =
      std::from_chars(value->text.data(), value->text.data() + value->text.size(), result);
  const bool is_whole = value->kind == ConfigurationValue::Kind::number && read.ec == std::errc{} &&
                        std::floor(result) == result;
  if (!is_whole || result < static_cast<double>(least) || result > static_cast<double>(most)) {
    reject_kind(*value, key, fmt::format("a whole number from {} to {}", least, most));
  }
  return static_cast<std::size_t>(result);
}

std::optional<std::chrono::milliseconds> SectionReader::duration(std::string_view key) {
  const ConfigurationValue* const value = one(key);
  if (value == nullptr) return std::nullopt;
  const auto result = parse_duration(value->text);
  if (!result) reject_kind(*value, key, "a time, such as 5 or \"500ms\"");
  return result;
}

const std::vector<ConfigurationValue>* SectionReader::texts(std::string_view key) {
  const ConfigurationKey* const found = find(key);
  if (found == nullptr) return nullptr;
  for (const ConfigurationValue& value : found->values) {
    if (value.kind != ConfigurationValue::Kind::text) {
      reject_kind(value, key, "a text, in quotes, or a list of texts");
    }
  }
  return &found->values;
}

ConfigurationPlace SectionReader::place_of(std::string_view key) const {
  const auto found = std::ranges::find(section_.keys, key, &ConfigurationKey::name);
  if (found == section_.keys.end()) return section_.place;
  return found->values.empty() ? found->place : found->values.front().place;
}

void SectionReader::reject(std::string_view key, const std::string& reason) const {
  text_.reject(place_of(key), reason);
}

void SectionReader::reject(const ConfigurationValue& value, const std::string& reason) const {
  text_.reject(value.place, reason);
}

void SectionReader::finish() const {
  for (const ConfigurationKey& key : section_.keys) {
    if (std::ranges::find(known_, key.name) != known_.end()) continue;
    const std::string all = "its keys are " + detail::alternatives(known_, false, "and");
    text_.reject(key.place,
                 fmt::format("unknown key '{}' of {}{}", key.name, section_.name(),
                             detail::did_you_mean(detail::nearest(key.name, known_), all)));
  }
  // Last, because its name may be misspelt.
  if (!missing_.empty()) text_.reject(section_.place, missing_);
}

}  // namespace sbgc::tools
