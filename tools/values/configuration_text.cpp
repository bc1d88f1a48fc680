#include "values/configuration_text.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <utility>

#include <fmt/format.h>
#include <toml++/toml.h>

#include <sbgc/internal/suggestions.hpp>

#include "command/command_error.hpp"
#include "command/option_values.hpp"

namespace sbgc::tools {

namespace {

constexpr std::size_t most_configuration_levels = 16;
// Names with dots are nested tables, each of which takes space on the stack in toml++.
constexpr std::ptrdiff_t most_dots_of_line = 1000;

ConfigurationPlace place_of(const toml::source_region& region) {
  return {region.begin.line, region.begin.column};
}

/// Returns a correction for common mistakes; "" for other errors of toml++.
std::string_view correction_of(std::string_view text, ConfigurationPlace place,
                               std::string_view error) {
  for (std::size_t line = 1; line < place.line; ++line) text.remove_prefix(text.find('\n') + 1);
  text = text.substr(0, text.find('\n'));
  const auto has = [&](std::string_view words) { return error.find(words) != error.npos; };
  if (text.substr(std::min(text.find_first_not_of(" \t"), text.size())).starts_with(';')) {
    return "; comments begin with '#'";
  }
  if (has("parsing value:") || has("integer:") || has("float:")) return "; texts need quotes";
  const bool is_name = has("table header: expected") || has("parsing key: expected");
  return is_name ? "; names with other characters than A-Z a-z 0-9 _ - need quotes" : "";
}

}  // namespace

class ConfigurationText::Parser {
 public:
  explicit Parser(ConfigurationText& into) : into_(into) {}

  void parse(std::string_view text) {
    check_lines(text);
    try {
      add(toml::parse(text), {}, {});
    } catch (const toml::parse_error& error) {
      const ConfigurationPlace place = place_of(error.source());
      const std::string_view reason = error.description();
      into_.reject(place, fmt::format("{}{}", reason, correction_of(text, place, reason)));
    }
    // toml++ sorts them by name.
    std::ranges::sort(into_.sections_, {}, [](const ConfigurationSection& section) {
      return std::pair(!section.path.empty(), section.place);
    });
    for (ConfigurationSection& section : into_.sections_) {
      std::ranges::sort(section.keys, {}, &ConfigurationKey::place);
    }
  }

 private:
  void check_lines(std::string_view text) const {
    for (std::size_t line = 1; !text.empty(); ++line) {
      const std::size_t size = std::min(text.find('\n'), text.size());
      if (std::ranges::count(text.substr(0, size), '.') > most_dots_of_line) {
        into_.reject({line, 1}, fmt::format("a line with more than {} dots", most_dots_of_line));
      }
      text.remove_prefix(std::min(size + 1, text.size()));
    }
  }

  void add(const toml::table& table, const std::vector<std::string>& path, ConfigurationPlace at) {
    if (path.size() > most_configuration_levels) {
      into_.reject(at, fmt::format("nested deeper than {} levels", most_configuration_levels));
    }
    ConfigurationSection section{path, at, {}};
    bool has_sections = false;
    for (const auto& [key, node] : table) {
      if (const toml::table* const inner = node.as_table()) {
        has_sections = true;
        std::vector<std::string> inner_path = path;
        inner_path.push_back(checked(std::string(key), place_of(key.source())));
        add(*inner, inner_path, place_of(inner->source()));
      } else {
        section.keys.push_back(key_of(key, node));
      }
    }
    // Names before the last dot of a section are not sections.
    if (path.empty() || !section.keys.empty() || !has_sections) {
      into_.sections_.push_back(std::move(section));
    }
  }

  ConfigurationKey key_of(const toml::key& key, const toml::node& node) const {
    const ConfigurationPlace place = place_of(key.source());
    ConfigurationKey result{checked(std::string(key), place), place, node.is_array(), {}};
    if (!node.is_array()) {
      result.values.push_back(value_of(node));
      return result;
    }
    for (const toml::node& value : *node.as_array()) result.values.push_back(value_of(value));
    return result;
  }

  ConfigurationValue value_of(const toml::node& node) const {
    using Kind = ConfigurationValue::Kind;
    const ConfigurationPlace place = place_of(node.source());
    if (const auto* const text = node.as_string()) {
      return {Kind::text, checked(text->get(), place), place};
    }
    if (const auto* const is = node.as_boolean()) {
      return {Kind::truth, is->get() ? "true" : "false", place};
    }
    if (const auto* const number = node.as_integer()) {
      return {Kind::number, fmt::format("{}", number->get()), place};
    }
    if (const auto* const number = node.as_floating_point()) {
      return {Kind::number, fmt::format("{}", number->get()), place};
    }
    into_.reject(place, "dates, lists in lists and tables in lists have no meaning here");
  }

  const std::string& checked(const std::string& text, ConfigurationPlace place) const {
    if (text.find('\0') != std::string::npos) into_.reject(place, "a text with a NUL");
    return text;
  }

  ConfigurationText& into_;
};

std::string ConfigurationSection::name() const {
  return path.empty() ? "the beginning" : fmt::format("[{}]", fmt::join(path, "."));
}

ConfigurationText::ConfigurationText(std::string_view text, std::string file)
    : file_(std::move(file)) {
  Parser(*this).parse(text);
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
