#include <algorithm>
#include <span>
#include <string>

#include <fmt/format.h>

#include <sbgc/client/modules.hpp>
#include <sbgc/internal/crc32.hpp>
#include <sbgc/text.hpp>

#include "tasks/tools.hpp"

namespace sbgc {
namespace {

/// The size of a part; total sizes are multiples of it.
constexpr std::size_t flash_part = 128;
constexpr std::size_t flash_word = 4;

/// The maximum delay of a confirmation; until then, confirmations of parts are indistinguishable.
constexpr Duration flash_lateness = seconds(1);

/// Returns an error with a hint for the user after an interrupted update.
ClientError flash_error(std::size_t confirmed_parts, ClientError reason) {
  const std::string last = confirmed_parts == 0
                               ? std::string("no part was confirmed")
                               : fmt::format("part {} was confirmed last", confirmed_parts - 1);
  reason.message =
      fmt::format("{}; {}. The module has no complete firmware: load it again from the beginning",
                  reason.message, last);
  return reason;
}

}  // namespace

std::optional<ClientError> module_firmware_problem(std::size_t size) {
  if (size == 0) return ClientError{ErrorCode::invalid, "the firmware is empty"};
  if (size % flash_word != 0) {
    return ClientError{ErrorCode::invalid,
                       fmt::format("the firmware has {} bytes, not a multiple of 4", size)};
  }
  if (size > max_module_firmware) {
    return ClientError{ErrorCode::invalid,
                       fmt::format("the firmware has {} bytes; at most {} are possible", size,
                                   max_module_firmware)};
  }
  return std::nullopt;
}

namespace tasks {

Task<Result<void>> flash_module(msg::ModuleId module, std::vector<std::uint8_t> firmware,
                                ProgressHandler progress) {
  if (auto problem = module_firmware_problem(firmware.size())) co_return *std::move(problem);
  TaskMachine& task = co_await this_task();
  if (task.line_may_repeat()) {
    // Confirmations do not name their part: a duplicate would release the next part too early.
    co_return ClientError{ErrorCode::unsupported,
                          "no firmware is loaded over a line that may repeat packets"};
  }
  const Result<msg::ModuleList> list = co_await call(msg::ModuleListRequest{});
  if (!list) co_return list.error();
  const auto is_it = [&](const msg::ModuleInfo& one) { return one.id == module; };
  if (std::none_of(list->modules.begin(), list->modules.end(), is_it)) {
    co_return ClientError{ErrorCode::not_found,
                          fmt::format("the board has no module {}", to_string(module))};
  }
  constexpr const char* what = "loading the firmware of a module";
  const auto goes_on = [&](std::size_t done) {
    return !progress || progress({done, firmware.size(), what});
  };
  if (!goes_on(0)) co_return detail::cancelled_error(what);

  msg::ModuleFlashStart start;
  start.device_id = module;
  start.firmware_size =
      msg::WordCount(static_cast<msg::WordCount::raw_type>(firmware.size() / flash_word));
  const Result<void> started = co_await call(start);
  if (!started && started.error().code == ErrorCode::board_error) {
    co_return detail::during("starting; the module is as before", started.error());
  }
  if (!started) {
    static_cast<void>(co_await wait_until(task.now() + flash_lateness));
    co_return flash_error(0, detail::during("starting", started.error()));
  }

  std::size_t parts = 0;
  for (std::size_t at = 0; at < firmware.size(); at += flash_part, ++parts) {
    if (parts != 0 && !goes_on(at)) co_return flash_error(parts, detail::cancelled_error(what));
    const auto data = std::span<const std::uint8_t>(firmware).subspan(
        at, std::min(flash_part, firmware.size() - at));
    msg::ModuleFlashWrite part;
    part.device_id = module;
    part.packet_id = static_cast<std::uint8_t>(parts);
    part.address = static_cast<std::uint32_t>(at);
    part.data_crc32 = detail::crc32(data);
    static_cast<void>(part.data.resize(data.size()));  // a part fits
    std::copy(data.begin(), data.end(), part.data.begin());
    const Result<void> written = co_await call(part);
    if (!written) {
      static_cast<void>(co_await wait_until(task.now() + flash_lateness));
      co_return flash_error(parts,
                            detail::during(fmt::format("writing part {}", parts), written.error()));
    }
  }
  msg::ModuleFlashFinish finish;
  finish.device_id = module;
  finish.file_crc32 = detail::crc32(firmware);
  const Result<void> finished = co_await call(finish);
  if (!finished) {
    static_cast<void>(co_await wait_until(task.now() + flash_lateness));
    co_return flash_error(parts, detail::during("finishing", finished.error()));
  }
  goes_on(firmware.size());
  co_return Result<void>();
}

}  // namespace tasks
}  // namespace sbgc
