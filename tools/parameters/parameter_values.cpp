#include "parameters/parameter_values.hpp"

#include <stdexcept>
#include <string>
#include <variant>

#include <fmt/format.h>

#include "command/command_error.hpp"
#include "command/wording.hpp"

namespace sbgc::tools {

namespace {

/// True if what is written has another meaning on later boards.
bool depends_on_firmware(const FieldValue& value) {
  const FieldInfo* const info = value.field.type->innermost().info;
  return info != nullptr && !info->later.empty();
}

/// True if what is written depends on the present value.
bool changes_present(const FieldValue& value) { return value.change != Change::set; }

/// Returns the values that the block with this id gets: general ones in every profile.
std::vector<FieldValue> values_in(const MessageValues& one, const ParametersId& id,
                                  std::uint8_t profile) {
  if (one.message->copies == 1 || id.copy == profile) return one.values;
  std::vector<FieldValue> general;
  for (const FieldValue& value : one.values) {
    if (is_general(value.field)) general.push_back(value);
  }
  return general;
}

}  // namespace

std::vector<MessageValues> values_of(const std::vector<Assignment>& assignments, bool no_validate) {
  std::vector<MessageValues> result;
  for (const Assignment& assignment : assignments) {
    const FoundParameters found = find_parameters(assignment.name);
    auto at = std::ranges::find(result, found.message, &MessageValues::message);
    if (at == result.end()) at = result.insert(at, {found.message, {}});
    for (FieldValue& value : values_for(found.fields, assignment)) {
      add_value(at->values, std::move(value));
    }
  }
  for (const MessageValues& one : result) {
    AnyMessage message = one.message->type->make();
    std::vector<FieldValue> certain = one.values;
    std::erase_if(certain, depends_on_firmware);
    std::erase_if(certain, changes_present);
    set_values(message, certain);
    if (!no_validate) check_ranges(message, certain);
  }
  return result;
}

bool concerns(const MessageValues& one, const ParametersId& id, std::uint8_t profile) {
  if (id.message != one.message->type->info->name) return false;
  return one.message->copies == 1 || id.copy == profile || one.has_general();
}

ParameterSet with_values(const ParameterSet& present, const std::vector<MessageValues>& values,
                         std::uint8_t profile, const Availability& versions) {
  ParameterSet wanted;
  for (const MessageValues& one : values) {
    const char* const name = one.message->type->info->name;
    bool is_present = false;
    for (const Parameters& block : present.all()) {
      if (block.id.message != name) continue;
      is_present = true;
      AnyMessage message = message_in(block);
      std::vector<FieldValue> here = values_in(one, block.id, profile);
      for (const FieldValue& value : here) {
        if (!message.has(std::get<std::string>(value.field.steps.front()))) {
          fail_lacking(value.field);
        }
      }
      try {
        for (FieldValue& value : here) {
          if (changes_present(value)) value = changed_value(message, value, versions);
        }
        set_values(message, here, versions);
        if (Result<void> put = put_message(wanted, block.id, message); !put) {
          throw CommandError(put.error().message);
        }
      } catch (const CommandError&) {
        throw;
      } catch (const std::runtime_error& error) {
        throw CommandError(clipped(error.what()), wrong_usage);
      }
    }
    if (!is_present) throw CommandError(fmt::format("this board does not have {}", name));
  }
  return wanted;
}

}  // namespace sbgc::tools
