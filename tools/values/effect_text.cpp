#include "values/effect_text.hpp"

#include <array>

namespace sbgc::tools {

namespace {

struct EffectText {
  Effect effect;
  const char* word;
  const char* sentence;
};

constexpr std::array effect_texts{
    EffectText{Effect::reads, "reads", "It changes nothing."},
    EffectText{Effect::sets, "sets", "What it changes is lost when the board restarts."},
    EffectText{Effect::stores, "stores",
               "It writes the memory of the board: the change survives a restart."},
    EffectText{Effect::moves, "moves",
               "The camera can move, or its motors gain or lose power. What it sets in motion goes "
               "on after this command has ended: a speed until another request stops it."},
    EffectText{Effect::restarts, "restarts",
               "The board restarts; its motors have no power until it is up again."},
    EffectText{Effect::erases, "erases", "It deletes stored data."},
    EffectText{Effect::disconnects, "disconnects",
               "The line no longer carries the protocol, and how to end that is not known."},
    EffectText{Effect::unknown, "unknown",
               "The specification does not say what it does, so it can do anything."},
};

}  // namespace

std::string effect_text(Effects effects) {
  std::string result;
  for (const EffectText& text : effect_texts) {
    // With some values, a request only reads; with others, it changes something.
    const bool is_denied = text.effect == Effect::reads && effects != Effects(Effect::reads);
    if (effects.has(text.effect) && !is_denied) {
      result += (result.empty() ? "" : " ") + std::string(text.sentence);
    }
  }
  return result;
}

std::string effect_words(Effects effects) {
  std::string result;
  for (const EffectText& text : effect_texts) {
    if (effects.has(text.effect)) result += (result.empty() ? "" : ", ") + std::string(text.word);
  }
  return result;
}

std::optional<Effect> effect_of_word(std::string_view word) {
  for (const EffectText& text : effect_texts) {
    if (text.word == word) return text.effect;
  }
  return std::nullopt;
}

std::vector<std::string> known_effect_words() {
  std::vector<std::string> words;
  words.reserve(effect_texts.size());
  for (const EffectText& text : effect_texts) words.emplace_back(text.word);
  return words;
}

}  // namespace sbgc::tools
