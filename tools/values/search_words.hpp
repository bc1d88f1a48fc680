/// Search words: topics of parameters and synonyms.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <sbgc/meta.hpp>
#include <sbgc/reference.hpp>

namespace sbgc::tools {

/// True for the same word and for synonyms, such as "tilt" and "pitch".
bool means_same(std::string_view a, std::string_view b);

/// True if the word is a name of the topic.
bool is_named(const TopicReference& topic, std::string_view word);

/// The topics of a parameter, its own first. Empty for other fields.
std::vector<const TopicReference*> topics_of(const FieldInfo& field);

/// Returns the words of a question without stop words, in lower case: "How do I set the P gain?"
/// gives "set", "p", "gain". The parts of a name are words. If only stop words are there, all are
/// returned.
std::vector<std::string> significant_words(std::string_view question);

/// Returns the text without words such as "command", and without punctuation.
std::string without_fillers(std::string_view text);

/// The place of a search word in an entry.
enum class WordPlace : std::uint8_t { nowhere, text, name };

/// The words of a search.
class Query {
 public:
  explicit Query(std::string_view text);

  /// True if each word is in the name, the text or the topics, as a whole word or a synonym of it;
  /// with `any_part`, part of the name suffices.
  bool fits(std::string_view name, std::string_view text,
            const std::vector<const TopicReference*>& topics, bool any_part) const;

  /// Returns where each word is. Topics count as text.
  std::vector<WordPlace> places(std::string_view name, std::string_view text,
                                const std::vector<const TopicReference*>& topics) const;

 private:
  std::vector<std::string> words_{};  // in lower case
};

}  // namespace sbgc::tools
