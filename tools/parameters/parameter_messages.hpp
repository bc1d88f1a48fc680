/// The parameters of a board by name and as values.
#pragma once

#include <string_view>
#include <vector>

#include "parameters/parameter_blocks.hpp"
#include "parameters/shown_parameters.hpp"
#include "values/field_lookup.hpp"
#include "values/search_words.hpp"

namespace sbgc::tools {

/// The parameters that a name means: fields of one message.
struct FoundParameters {
  const ParameterMessage* message = nullptr;
  std::vector<FoundField> fields{};
};

/// Finds parameters by path, by the end of a path, or by the name in the specification; with the
/// name of the message in front if several have it. Throws ValueError, with suggestions.
FoundParameters find_parameters(std::string_view name);

/// Returns the first message with a parameter that has all the words, or null.
const ParameterMessage* find_parameter_message(const Query& query);

/// End the command, because the board does not have the field, or none of the message. Throw
/// CommandError.
[[noreturn]] void fail_lacking(const FoundField& field);
[[noreturn]] void fail_lacking(const ParameterMessage& message);

/// True if the field is the same in all profiles.
bool is_general(const FoundField& field);

/// True if the value is the index of a profile. The specification gives such fields one name.
bool is_profile_index(const FieldInfo& field);

}  // namespace sbgc::tools
