#include "device/scripting/scripts.hpp"

#include <algorithm>
#include <limits>
#include <string_view>

#include <sbgc/messages/scripting.hpp>

#include "device/ports.hpp"

namespace sbgc::emulator {
namespace {

/// Assumption: the duration of a command.
constexpr Duration command_time = milliseconds(100);

/// Counts lines with a command: neither empty nor a comment (assumption: comments start with '#' or
/// "//").
std::uint16_t count_commands(std::string_view text) {
  unsigned count = 0;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    constexpr std::string_view blanks(" \t\r\0", 4);
    const std::size_t begin = line.find_first_not_of(blanks);
    if (begin == std::string_view::npos) continue;
    const std::string_view command = line.substr(begin);
    if (!command.starts_with('#') && !command.starts_with("//")) ++count;
  }
  constexpr unsigned most = std::numeric_limits<std::uint16_t>::max();  // no file has more
  return static_cast<std::uint16_t>(std::min(count, most));
}

}  // namespace

bool Scripts::are_supported(const BoardOptions& options) {
  return options.features.has(msg::BoardFeature::scripting);
}

std::optional<msg::BoardErrorCode> Scripts::start(const FileSystem& files, std::uint8_t slot,
                                                  std::optional<std::size_t> port, Instant now) {
  if (slot >= slots) return msg::BoardErrorCode::wrong_params;
  const std::uint16_t size = files.size(slot);
  if (size == 0) return msg::BoardErrorCode::operation_failed;
  const FileSystem::Part file = files.read(slot, 0, size);
  if (file.error != msg::FileError::no_error) return msg::BoardErrorCode::operation_failed;
  Run run{.slot = slot, .port = port};
  run.commands = count_commands(
      // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): bytes of a text
      {reinterpret_cast<const char*>(file.data.data()), file.data.size()});
  run.due = now;  // after the response
  run_ = run;
  return {};
}

std::optional<std::uint8_t> Scripts::running() const {
  return run_ ? std::optional(run_->slot) : std::nullopt;
}

Instant Scripts::next() const { return run_ ? run_->due : Instant::never; }

void Scripts::advance(Instant now, const FileSystem& files, Ports& ports) {
  while (run_ && run_->due <= now) {
    // The board reads the script while it runs, so the file can disappear.
    const bool is_gone = files.size(run_->slot) == 0;
    if (is_gone || run_->command >= run_->commands) {
      report(ports, is_gone ? msg::FileError::file_not_found : msg::FileError::no_error);
      run_.reset();
      return;
    }
    ++run_->command;
    run_->due = run_->due + command_time;
    report(ports, msg::FileError::no_error);
  }
}

void Scripts::drop_port(std::size_t port) {
  if (run_ && run_->port == port) run_->port.reset();
}

void Scripts::report(Ports& ports, msg::FileError error) const {
  if (run_->port) {
    msg::ScriptDebug state;
    state.cmd_count = run_->command;
    state.err_code = error;
    ports.send(*run_->port, state);
  }
}

}  // namespace sbgc::emulator
