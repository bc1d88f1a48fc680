/// Reads configuration files in TOML, and keeps the positions of all items. Values are texts,
/// numbers, true and false, and lists of these.
#pragma once

#include <chrono>
#include <compare>
#include <cstddef>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace sbgc::tools {

/// Both count from 1; columns count characters.
struct ConfigurationPlace {
  std::size_t line = 1;
  std::size_t column = 1;

  auto operator<=>(const ConfigurationPlace&) const = default;
};

/// Throws CommandError with "file:line:column: reason".
[[noreturn]] void reject_configuration(const std::string& file, ConfigurationPlace place,
                                       const std::string& reason);

struct ConfigurationValue {
  enum class Kind : unsigned char { text, number, truth };

  Kind kind{};
  std::string text{};
  ConfigurationPlace place{};
};

struct ConfigurationKey {
  std::string name{};
  ConfigurationPlace place{};
  bool is_list{};
  std::vector<ConfigurationValue> values{};
};

struct ConfigurationSection {
  std::vector<std::string> path{};
  ConfigurationPlace place{};
  std::vector<ConfigurationKey> keys{};

  /// For example "[gimbal.front]".
  std::string name() const;
};

/// The sections of a file, in order; the first one has no name. Errors are CommandErrors that begin
/// with "file:line:column: ".
class ConfigurationText {
 public:
  /// Parses the text. Throws CommandError.
  ConfigurationText(std::string_view text, std::string file);

  const std::vector<ConfigurationSection>& sections() const { return sections_; }

  [[noreturn]] void reject(ConfigurationPlace place, const std::string& reason) const;

 private:
  class Parser;

  std::string file_;
  std::vector<ConfigurationSection> sections_;
};

/// Reads the keys of a section. The requested keys are the allowed ones: finish() rejects all
/// others. All functions throw CommandError if a value has the wrong type.
class SectionReader {
 public:
  SectionReader(const ConfigurationText& text, const ConfigurationSection& section)
      : text_(text), section_(section) {}

  std::optional<std::string> text(std::string_view key);
  /// The same, but finish() rejects a section without it. `example` completes the hint, such as
  /// "port = \"/dev/ttyS0\"".
  std::string required_text(std::string_view key, std::string_view example);
  std::optional<std::size_t> count(std::string_view key, std::size_t least, std::size_t most);
  std::optional<std::chrono::milliseconds> duration(std::string_view key);
  /// A list of texts, or one text. Null if there is none.
  const std::vector<ConfigurationValue>* texts(std::string_view key);

  /// The same, but finish() rejects a section without it.
  const std::vector<ConfigurationValue>& required_texts(std::string_view key,
                                                        std::string_view example);

  /// Returns the position of a key's value, or without the key, of its section.
  ConfigurationPlace place_of(std::string_view key) const;
  /// Rejects the value of a key, or without it the section, for this reason.
  [[noreturn]] void reject(std::string_view key, const std::string& reason) const;
  [[noreturn]] void reject(const ConfigurationValue& value, const std::string& reason) const;

  /// Throws CommandError, with suggestions, if the section has keys that were not requested, or
  /// lacks a required one.
  void finish() const;

 private:
  void lacks(std::string_view key, std::string_view example);
  const ConfigurationKey* find(std::string_view key);
  const ConfigurationValue* one(std::string_view key);
  [[noreturn]] void reject_kind(const ConfigurationValue& value, std::string_view key,
                                const std::string& wanted) const;

  const ConfigurationText& text_;
  const ConfigurationSection& section_;
  std::vector<std::string> known_;
  std::string missing_;
};

}  // namespace sbgc::tools
