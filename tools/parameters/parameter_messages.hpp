/// The parameters of a board by name, as raw and as readable values.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <sbgc/availability.hpp>
#include <sbgc/client/parameters.hpp>
#include <sbgc/json_dom.hpp>
#include <sbgc/reference.hpp>

#include "parameters/parameter_blocks.hpp"
#include "values/assignments.hpp"
#include "values/field_lookup.hpp"
#include "values/search_words.hpp"

namespace sbgc::tools {

/// One value for the user.
struct ShownParameter {
  std::string message{};
  std::string path{};
  std::string spec_name{};
  std::string raw{};
  std::string meaning{};
  std::optional<double> value{};  ///< of a number, in its unit
  std::string unit{};
  std::size_t bytes{};  ///< of bytes without a meaning as numbers; 0 for others
  bool is_special{};    ///< the raw value has a special meaning
  bool is_general{};
  std::string summary{};
  std::vector<const TopicReference*> topics{};  ///< its own first
  std::string other_default{};  ///< the text of the factory default, if it is known and differs

  /// Returns, for example, "-30 deg", "FOLLOW_MODE_FC" or "12".
  std::string text() const;
  /// The same, truncated for many bytes: "00ff12… (128 bytes)".
  std::string short_text() const;
};

/// Returns the parameters in a block, without reserved ones.
std::vector<ShownParameter> shown_parameters(const Parameters& block, const Availability& versions);

Json to_json(const ShownParameter& parameter);

/// The parameters that a name denotes: fields of one message.
struct FoundParameters {
  const ParameterMessage* message = nullptr;
  std::vector<FoundField> fields{};
};

/// Finds parameters by path, by the end of a path, or by the name in the specification; preceded by
/// the name of the message if several have it. Throws ValueError, with suggestions.
FoundParameters find_parameters(std::string_view name);

/// Returns the first message with a parameter that has all the words, or null.
const ParameterMessage* find_parameter_message(const Query& query);

/// End the command, because the board lacks the field, or all fields of the message. Throw
/// CommandError.
[[noreturn]] void fail_lacking(const FoundField& field);
[[noreturn]] void fail_lacking(const ParameterMessage& message);

/// True if the field is the same in all profiles.
bool is_general(const FoundField& field);

/// True if the value is the index of a profile. The specification gives such fields one name.
bool is_profile_index(const FieldInfo& field);

/// The values to set in one message.
struct MessageValues {
  const ParameterMessage* message = nullptr;
  std::vector<FieldValue> values{};

  bool has_general() const {
    return std::ranges::any_of(values, [](const auto& value) { return is_general(value.field); });
  }
};

/// Returns the values by message. Parses each for a new message first, so that most mistakes are
/// found without a board. Throws ValueError.
std::vector<MessageValues> values_of(const std::vector<Assignment>& assignments, bool no_validate);

/// True if some of the values are for the block with this id.
bool concerns(const MessageValues& one, const ParametersId& id, std::uint8_t profile);

/// Returns the blocks of `present` with the values. Throws CommandError if the board lacks one of
/// them, or the value does not fit.
ParameterSet with_values(const ParameterSet& present, const std::vector<MessageValues>& values,
                         std::uint8_t profile, const Availability& versions);

}  // namespace sbgc::tools
