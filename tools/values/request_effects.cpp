#include "values/request_effects.hpp"

#include <algorithm>
#include <string_view>

#include <sbgc/meta/all.hpp>
#include <sbgc/roles.hpp>
#include <sbgc/text.hpp>

#include "values/message_names.hpp"

namespace sbgc::tools {

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

}  // namespace sbgc::tools
