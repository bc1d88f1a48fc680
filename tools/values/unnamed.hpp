/// Enum values without a name.
#pragma once

#include <string>

#include <sbgc/text.hpp>

namespace sbgc::tools {

/// Returns what to say of an enum value that has no name: "has no name; the nearest are
/// CMD_REALTIME_DATA_3 (23) and CMD_REALTIME_DATA_4 (25)"; "" for any other value. It is no error:
/// other firmware may know it.
///
/// A 0 without a name is none of the values, which is usual in what a board sends or stores; unless
/// `takes_zero`, there is something to say about it.
std::string unnamed_text(const Leaf& leaf, bool takes_zero = true);

/// Calls `use(path, sentence)` for the values of a request that have no name: "24 has no name; the
/// nearest ...".
template <class Message, class Use>
void for_each_unnamed(const Message& message, const Use& use) {
  const bool is_stored = *message.type().info->stores != '\0';
  message.for_each_leaf([&](const Leaf& leaf) {
    const std::string text = unnamed_text(leaf, is_stored);
    if (!text.empty()) use(to_string(leaf.path), raw_text(leaf) + ' ' + text);
  });
}

}  // namespace sbgc::tools
