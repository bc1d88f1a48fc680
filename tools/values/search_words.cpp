#include "values/search_words.hpp"

#include <algorithm>
#include <iterator>
#include <span>
#include <utility>

#include <sbgc/internal/words.hpp>

namespace sbgc::tools {

namespace {

bool has_word(std::span<const char* const> words, std::string_view word) {
  return std::any_of(words.begin(), words.end(),
                     [&](const char* one) { return detail::is_same_word(one, word); });
}

constexpr bool is_in_word(char c) {
  const char lower = detail::lower_case(c);
  return (lower >= 'a' && lower <= 'z') || (c >= '0' && c <= '9');
}

/// True if a word of the text, which may be a plural, means the same.
bool occurs(std::string_view text, std::string_view word) {
  for (std::size_t at = 0; at < text.size();) {
    std::size_t size = 0;
    while (at + size < text.size() && is_in_word(text[at + size])) ++size;
    const std::string_view one = text.substr(at, size);
    if (means_same(one, word)) return true;
    if (one.ends_with('s') && means_same(one.substr(0, size - 1), word)) return true;
    at += size + 1;
  }
  return false;
}

}  // namespace

bool means_same(std::string_view a, std::string_view b) {
  return detail::is_same_word(a, b) ||
         std::any_of(std::begin(synonyms), std::end(synonyms),
                     [&](const auto& group) { return has_word(group, a) && has_word(group, b); });
}

bool is_named(const TopicReference& topic, std::string_view word) {
  return detail::is_same_word(topic.name, word) || has_word(topic.words, word);
}

std::vector<const TopicReference*> topics_of(const FieldInfo& field) {
  std::vector<const TopicReference*> result;
  for (const TopicReference& topic : topic_references) {
    if (!field.reserved && has_word(topic.fields, field.spec_name)) result.push_back(&topic);
  }
  return result;
}

Query::Query(std::string_view text) {
  while (!(text = detail::trimmed(text)).empty()) {
    const std::size_t size = std::min(text.find(' '), text.size());
    std::string word = detail::lower_case(text.substr(0, size));
    if (std::find(words_.begin(), words_.end(), word) == words_.end())
      words_.push_back(std::move(word));
    text.remove_prefix(size);
  }
}

bool Query::fits(std::string_view name, std::string_view text,
                 const std::vector<const TopicReference*>& topics, bool any_part) const {
  return std::all_of(words_.begin(), words_.end(), [&](const std::string& word) {
    const auto is_topic = [&](const auto* topic) { return is_named(*topic, word); };
    return occurs(name, word) || occurs(text, word) ||
           std::any_of(topics.begin(), topics.end(), is_topic) ||
           (any_part && detail::lower_case(name).find(word) != std::string::npos);
  });
}

}  // namespace sbgc::tools
