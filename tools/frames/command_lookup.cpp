#include "frames/command_lookup.hpp"

#include <algorithm>
#include <array>
#include <span>

#include <sbgc/dispatch.hpp>
#include <sbgc/meta/all.hpp>

namespace sbgc::tools {

namespace {

constexpr std::array directions{Direction::to_board, Direction::from_board};

/// The names of all ids, by direction; null for an unknown one.
using CommandNames = std::array<std::array<const char*, 256>, directions.size()>;

std::size_t index(Direction direction) { return direction == Direction::to_board ? 0 : 1; }

CommandNames all_names() {
  CommandNames names{};
  AllMessages::for_each([&]<class M>(Type<M>) {
    const MessageInfo& info = Meta<M>::info;
    for (const Direction direction : directions) {
      if (info.travels(direction)) names[index(direction)][info.id] = info.command;
    }
  });
  // Otherwise, the name of the id in the other direction.
  const auto add = [&](std::span<const ValueInfo> commands) {
    for (const ValueInfo& command : commands) {
      for (auto& of_direction : names) {
        const char*& name = of_direction[static_cast<std::uint8_t>(command.value)];
        if (name == nullptr) name = command.name;
      }
    }
  };
  add(EnumMeta<msg::CommandFromBoard>::values);
  add(EnumMeta<msg::CommandToBoard>::values);
  return names;
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

std::size_t misfit(Direction direction, std::uint8_t id, std::size_t size) {
  std::size_t least = max_body_size + 1;
  AllMessages::for_each([&]<class M>(Type<M>) {
    if (Meta<M>::info.id != id || !Meta<M>::info.travels(direction)) return;
    const std::size_t missing = M::min_size - std::min(M::min_size, size);
    const std::size_t surplus = size - std::min(M::max_size, size);
    least = std::min(least, missing + surplus);
  });
  return least;
}

std::string body_sizes(Direction direction, std::uint8_t id) {
  std::string result;
  AllMessages::for_each([&]<class M>(Type<M>) {
    if (Meta<M>::info.id != id || !Meta<M>::info.travels(direction)) return;
    result += (result.empty() ? "" : ", ") + std::to_string(M::min_size);
    if (M::max_size != M::min_size) result += " to " + std::to_string(M::max_size);
  });
  return result;
}

const char* command_name(std::uint8_t id, Direction direction) {
  static const CommandNames names = all_names();
  const char* const name = names[index(direction)][id];
  return name == nullptr ? "" : name;
}

}  // namespace sbgc::tools
