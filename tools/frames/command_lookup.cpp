#include "frames/command_lookup.hpp"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include <sbgc/meta/enums.hpp>

namespace sbgc::tools {

namespace {

constexpr std::array directions{Direction::to_board, Direction::from_board};

/// The messages of an id in one direction.
struct Command {
  const char* name = nullptr;  ///< null if unknown; if need be, the one of the other direction
  std::vector<const MessageType*> forms{};
};
using Commands = std::array<std::array<Command, 256>, directions.size()>;

std::size_t index(Direction direction) { return direction == Direction::to_board ? 0 : 1; }

Commands all_commands() {
  Commands commands{};
  for (const MessageType* const type : message_types()) {
    for (const Direction direction : directions) {
      if (!type->info->travels(direction)) continue;
      Command& command = commands[index(direction)][type->info->id];
      command.name = type->info->command;
      command.forms.push_back(type);
    }
  }
  const auto add = [&](std::span<const ValueInfo> values) {
    for (const ValueInfo& value : values) {
      for (auto& of_direction : commands) {
        const char*& name = of_direction[static_cast<std::uint8_t>(value.value)].name;
        if (name == nullptr) name = value.name;
      }
    }
  };
  add(EnumMeta<msg::CommandFromBoard>::values);
  add(EnumMeta<msg::CommandToBoard>::values);
  return commands;
}

const Command& command(Direction direction, std::uint8_t id) {
  static const Commands commands = all_commands();
  return commands[index(direction)][id];
}

/// True if later firmware may append to a message.
bool can_grow(const MessageType& type) {
  return type.operations->table->tail.type != nullptr && !type.operations->takes_surplus;
}

}  // namespace

int body_fit(Direction direction, std::uint8_t id, std::size_t size) {
  const MessageType* const type = find_message(direction, id, size);
  if (type == nullptr) return 0;
  const auto [least, most] = std::pair(type->info->min_size, type->info->max_size);
  const bool documented = size >= least && size <= most;
  if (documented && least == most) return 4;  // the only valid size
  if (documented && most < max_body_size) return 3;
  if (size > most && can_grow(*type)) return 2;  // grown by later firmware
  return documented ? 1 : 0;                     // accepts almost any size
}

bool has_command(Direction direction, std::uint8_t id) { return !forms(direction, id).empty(); }

std::size_t misfit(Direction direction, std::uint8_t id, std::size_t size) {
  std::size_t least = max_body_size + 1;
  for (const MessageType* const form : forms(direction, id)) {
    const std::size_t missing = form->info->min_size - std::min(form->info->min_size, size);
    const std::size_t surplus = size - std::min(form->info->max_size, size);
    least = std::min(least, missing + surplus);
  }
  return least;
}

std::string body_sizes(Direction direction, std::uint8_t id) {
  std::string result;
  for (const MessageType* const form : forms(direction, id)) {
    const MessageInfo& info = *form->info;
    result += (result.empty() ? "" : ", ") + std::to_string(info.min_size);
    if (info.max_size != info.min_size) result += " to " + std::to_string(info.max_size);
  }
  return result;
}

const char* command_name(std::uint8_t id, Direction direction) {
  const char* const name = command(direction, id).name;
  return name == nullptr ? "" : name;
}

std::span<const MessageType* const> forms(Direction direction, std::uint8_t id) {
  return command(direction, id).forms;
}

}  // namespace sbgc::tools
