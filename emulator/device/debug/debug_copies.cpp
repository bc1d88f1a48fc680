#include "device/debug/debug_copies.hpp"

#include <cstdint>
#include <string_view>

#include <sbgc/messages/debug.hpp>
#include <sbgc/meta/enums.hpp>

#include "device/ports.hpp"

namespace sbgc::emulator {
namespace {

/// The flag of a command is the one with its name; other commands have none.
bool is_filtered(msg::DebugPortCommands filter, std::uint8_t command, bool is_to_host) {
  const auto name_of = [command](const EnumInfo& info) {
    for (const ValueInfo& value : info.values) {
      if (value.value == command) return std::string_view(value.name);
    }
    return std::string_view();
  };
  std::string_view name = is_to_host ? name_of(EnumMeta<msg::CommandFromBoard>::info)
                                     : name_of(EnumMeta<msg::CommandToBoard>::info);
  constexpr std::string_view prefix = "CMD_";
  if (name.starts_with(prefix)) name.remove_prefix(prefix.size());
  for (const ValueInfo& flag : EnumMeta<msg::DebugPortCommand>::info.values) {
    if (name == flag.name) return filter.has(static_cast<msg::DebugPortCommand>(flag.value));
  }
  return false;
}

}  // namespace

void DebugCopies::copy(Ports& ports, msg::MillisecondClock time, std::size_t port,
                       const Frame& frame, bool is_to_host) {
  // Copies of copies would never end.
  if (frame.id == static_cast<std::uint8_t>(msg::SetDebugPort::command) && is_to_host) return;
  for (std::size_t to = 0; to < filters_.size(); ++to) {
    if (to == port || !filters_[to] || is_filtered(*filters_[to], frame.id, is_to_host)) continue;
    msg::SetDebugPort copy;
    copy.time_ms = time;
    static_cast<void>(copy.port_and_dir.set_port(static_cast<std::uint8_t>(port)));
    copy.port_and_dir.set_direction(is_to_host);
    copy.cmd_id = frame.id;
    // The longest bodies do not fit and are cut off.
    for (const std::uint8_t byte : frame.body) {
      if (!copy.payload.push_back(byte)) break;
    }
    static_cast<void>(ports.offer(to, copy));
  }
}

}  // namespace sbgc::emulator
