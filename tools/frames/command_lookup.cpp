#include "frames/command_lookup.hpp"

#include <array>
#include <span>

#include <sbgc/dispatch.hpp>
#include <sbgc/meta/all.hpp>

namespace sbgc::tools {

namespace {

bool travels(const MessageInfo& info, Direction direction) {
  return info.direction == direction || info.direction == Direction::both;
}

/// The names of all ids in both directions.
class CommandNames {
 public:
  CommandNames() {
    AllMessages::for_each([this]<class M>(Type<M>) {
      const MessageInfo& info = Meta<M>::info;
      for (const Direction direction : {Direction::to_board, Direction::from_board}) {
        if (travels(info, direction)) place(info.id, direction) = info.command;
      }
    });
    // Otherwise, the name of the id in the other direction.
    add(EnumMeta<msg::CommandFromBoard>::values);
    add(EnumMeta<msg::CommandToBoard>::values);
  }

  const char* of(std::uint8_t id, Direction direction) const {
    return names_[index(direction)][id];
  }

 private:
  using Names = std::array<const char*, 256>;

  static std::size_t index(Direction direction) { return direction == Direction::to_board ? 0 : 1; }
  static constexpr Names without_names() {
    Names names{};
    names.fill("");
    return names;
  }

  const char*& place(std::uint8_t id, Direction direction) { return names_[index(direction)][id]; }
  void add(std::span<const ValueInfo> commands) {
    for (const ValueInfo& command : commands) {
      for (Names& names : names_) {
        const char*& name = names[static_cast<std::uint8_t>(command.value)];
        if (*name == '\0') name = command.name;
      }
    }
  }

  std::array<Names, 2> names_{without_names(), without_names()};
};

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

std::string body_sizes(Direction direction, std::uint8_t id) {
  std::string result;
  AllMessages::for_each([&]<class M>(Type<M>) {
    if (Meta<M>::info.id != id || !travels(Meta<M>::info, direction)) return;
    result += (result.empty() ? "" : ", ") + std::to_string(M::min_size);
    if (M::max_size != M::min_size) result += " to " + std::to_string(M::max_size);
  });
  return result;
}

const char* command_name(std::uint8_t id, Direction direction) {
  static const CommandNames names;
  return names.of(id, direction);
}

}  // namespace sbgc::tools
