#include "values/search_words.hpp"

#include <algorithm>
#include <array>
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

/// Stop words, including the names of the product.
constexpr std::array common_words{
    "a",     "about",   "after", "alexmos", "an",      "and",     "any",    "are",       "as",
    "at",    "basecam", "be",    "been",    "before",  "board",   "by",     "can",       "cannot",
    "do",    "does",    "for",   "from",    "get",     "gimbal",  "give",   "has",       "have",
    "help",  "how",     "i",     "if",      "in",      "into",    "is",     "it",        "its",
    "know",  "make",    "me",    "my",      "need",    "no",      "not",    "of",        "on",
    "or",    "our",     "over",  "please",  "problem", "sbgc",    "should", "simplebgc", "so",
    "that",  "the",     "their", "them",    "there",   "this",    "to",     "too",       "use",
    "using", "via",     "want",  "was",     "we",      "what",    "when",   "where",     "which",
    "while", "who",     "why",   "will",    "with",    "without", "work",   "works",     "you",
    "your"};

/// Words that name only the kind of a thing.
constexpr std::array filler_words{"cmd", "command", "commands", "id", "message"};

/// The words of a text. `is_part(c)` is true for the characters of words.
template <class IsPart>
std::vector<std::string> words_of(std::string_view text, const IsPart& is_part) {
  std::vector<std::string> result;
  std::string word;
  for (const char c : text) {
    if (is_part(c)) {
      word += c;
    } else if (!word.empty()) {
      result.push_back(std::exchange(word, {}));
    }
  }
  if (!word.empty()) result.push_back(std::move(word));
  return result;
}

/// True if a word of the text means the same; both may be plurals.
bool occurs(std::string_view text, std::string_view word) {
  if (word.size() > 3 && word.ends_with('s') && occurs(text, word.substr(0, word.size() - 1))) {
    return true;
  }
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

std::vector<std::string> significant_words(std::string_view question) {
  const auto is_part = [](char c) {
    return is_in_word(c) || static_cast<unsigned char>(c) >= 0x80;
  };
  const bool is_all_loud = question == detail::upper_case(question);
  std::vector<std::string> words;
  std::vector<std::string> significant;
  for (const std::string& typed : words_of(question, is_part)) {
    const std::string& word = words.emplace_back(detail::lower_case(typed));
    // The bus CAN is none of the common words.
    const bool is_loud = !is_all_loud && word.size() > 1 && typed == detail::upper_case(typed);
    if ((is_loud || !has_word(common_words, word)) && !has_word(filler_words, word)) {
      significant.push_back(word);
    }
  }
  return significant.empty() ? words : significant;
}

std::string without_fillers(std::string_view text) {
  constexpr std::string_view signs = " \t?!,;:'\"()";
  std::string result;
  for (const std::string& word :
       words_of(detail::lower_case(text), [&](char c) { return signs.find(c) == signs.npos; })) {
    if (has_word(filler_words, word)) continue;
    if (!result.empty()) result += ' ';
    result += word;
  }
  return result;
}

std::vector<WordPlace> Query::places(std::string_view name, std::string_view text,
                                     const std::vector<const TopicReference*>& topics) const {
  std::vector<WordPlace> result;
  for (const std::string& word : words_) {
    const auto is_topic = [&](const auto* topic) { return is_named(*topic, word); };
    const bool is_in_text =
        occurs(text, word) || std::any_of(topics.begin(), topics.end(), is_topic);
    result.push_back(occurs(name, word) ? WordPlace::name
                     : is_in_text       ? WordPlace::text
                                        : WordPlace::nowhere);
  }
  return result;
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
