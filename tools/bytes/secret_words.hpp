/// Secrets in command lines, which others on the machine can see.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace sbgc::tools {

/// Throws CommandError: the value of this field must come from a file, or from a prompt.
[[noreturn]] void refuse_secret(std::string_view name);

/// Throws CommandError if one of the words assigns a value to a secret field of any message.
void refuse_secrets(std::span<const std::string> words);

}  // namespace sbgc::tools
