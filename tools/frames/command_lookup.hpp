/// Lookup of commands by id.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include <sbgc/any.hpp>

namespace sbgc::tools {

/// Returns the name of the command with this id; "" if there is none. Some ids have two names,
/// distinguished by direction.
const char* command_name(std::uint8_t id, Direction direction);

/// Returns the messages of the command with this id in this direction.
std::span<const MessageType* const> forms(Direction direction, std::uint8_t id);

/// True if there is a command with this id in this direction.
bool has_command(Direction direction, std::uint8_t id);

/// Rates how well a body of this size fits the command in this direction; 0 means not at all.
int body_fit(Direction direction, std::uint8_t id, std::size_t size);

/// Returns the number of bytes by which a body of this size differs from the nearest form of the
/// command in this direction; more than any body has if there is no such command.
std::size_t misfit(Direction direction, std::uint8_t id, std::size_t size);

/// Returns the body sizes that the forms of the command have: "13, 15", "6 to 60".
std::string body_sizes(Direction direction, std::uint8_t id);

}  // namespace sbgc::tools
