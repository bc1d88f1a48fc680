#include "bytes/secret_words.hpp"

#include <algorithm>

#include <fmt/format.h>

#include <sbgc/any.hpp>

#include "command/command_error.hpp"
#include "values/field_lookup.hpp"

namespace sbgc::tools {
namespace {

/// True if a message has a secret field of this name.
bool names_secret(std::string_view name) {
  return std::ranges::any_of(message_types(), [&](const MessageType* type) {
    const auto found = find_fields(type->fields(), name);
    return !found.empty() && found.front().type->info != nullptr &&
           found.front().type->info->secret;
  });
}

}  // namespace

void refuse_secret(std::string_view name) {
  throw CommandError(
      fmt::format("{0} is secret, but others on this machine see the command line: write "
                  "{0}=@FILE, with a file of mode 0600, or {0}=@- to be asked",
                  name),
      wrong_usage);
}

void refuse_secrets(std::span<const std::string> words) {
  for (const std::string& word : words) {
    const std::size_t at = word.find('=');
    if (at == std::string::npos || at + 1 == word.size() || word[at + 1] == '@') continue;
    const std::string_view name = std::string_view(word).substr(0, at);
    if (!name.starts_with('-') && names_secret(name)) refuse_secret(name);
  }
}

}  // namespace sbgc::tools
