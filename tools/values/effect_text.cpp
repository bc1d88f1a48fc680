#include "values/effect_text.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include <sbgc/meta/all.hpp>
#include <sbgc/roles.hpp>
#include <sbgc/text.hpp>

#include "values/message_names.hpp"

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

Effects effects_of(const AnyMessage& message) {
  Effects effects = message.type().info->effects;
  for (const MessageType* const other :
       messages_named(message.type().info->command, Direction::to_board)) {
    message.for_each_leaf([&](const Leaf& leaf) {
      const FieldPath* member = &leaf.path;
      while (member->parent != nullptr) member = member->parent;
      const bool is_shared = std::ranges::any_of(other->fields(), [&](const FieldType& field) {
        return std::string_view(field.name) == member->name;
      });
      const bool is_zero = leaf.path.parent == nullptr && raw_text(leaf) == "0";
      if (is_shared && !is_zero) effects = effects | other->info->effects;
    });
  }
  return effects;
}

bool needs_arming(const MessageInfo& info, Effects effects) {
  // A data stream ends with the connection, and changes nothing else.
  const bool is_stream = &info == &Meta<roles::StreamRequest>::info;
  return effects.has(Effect::stores) || effects.has(Effect::moves) ||
         effects.has(Effect::restarts) || effects.has(Effect::erases) ||
         effects.has(Effect::disconnects) || effects.has(Effect::unknown) ||
         (effects.has(Effect::sets) && !is_stream);
}

std::string effect_text(Effects effects) {
  std::string result;
  for (const EffectText& text : effect_texts) {
    // Some values of a request can read and others change something.
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
