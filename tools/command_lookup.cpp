#include "command_lookup.hpp"

#include <span>

#include <sbgc/dispatch.hpp>
#include <sbgc/meta/all.hpp>

namespace sbgc::tools {

namespace {

bool travels(const MessageInfo& info, Direction direction) {
  return info.direction == direction || info.direction == Direction::both;
}

}  // namespace

int body_fit(Direction direction, std::uint8_t id, std::size_t size) {
  int result = 0;
  select(direction, id, size, [&]<class M>(Type<M>) {
    const bool documented = size >= M::min_size && size <= M::max_size;
    if (documented && M::min_size == M::max_size) {
      result = 4;  // the only valid size
    } else if (documented && M::max_size < max_body_size) {
      result = 3;
    } else if (size > M::max_size && requires(const M& message) { message.tail; }) {
      result = 2;  // grown by later firmware
    } else if (documented) {
      result = 1;  // accepts almost any size
    }
  });
  return result;
}

bool has_command(Direction direction, std::uint8_t id) {
  return select(direction, id, 0, [](auto) {}) != Code::unknown_command;
}

std::string command_name(std::uint8_t id, Direction direction) {
  std::string result;
  AllMessages::for_each([&]<class M>(Type<M>) {
    const MessageInfo& info = Meta<M>::info;
    if (info.id == id && travels(info, direction)) result = info.command;
  });
  // Otherwise, the name of the id in the other direction.
  const auto look_in = [&](std::span<const ValueInfo> commands) {
    for (const ValueInfo& command : commands) {
      if (result.empty() && command.value == id) result = command.name;
    }
  };
  look_in(EnumMeta<msg::CommandFromBoard>::values);
  look_in(EnumMeta<msg::CommandToBoard>::values);
  return result;
}

}  // namespace sbgc::tools
