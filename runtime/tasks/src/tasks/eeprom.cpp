// EEPROM tasks: transfers of whole pages.

#include <algorithm>
#include <string>

#include <fmt/format.h>

#include <sbgc/client/memory.hpp>
#include <sbgc/internal/meta_limits.hpp>
#include <sbgc/meta/storage.hpp>

#include "tasks/agreement.hpp"
#include "tasks/bytes.hpp"
#include "tasks/pages.hpp"
#include "tasks/tools.hpp"

namespace sbgc::tasks {
namespace {

constexpr std::size_t eeprom_page = detail::field_info<msg::EepromWrite>("addr").align;
constexpr std::size_t eeprom_most_read = detail::highest<msg::EepromReadRequest>("size");
constexpr std::size_t eeprom_most_written = detail::field_info<msg::EepromWrite>("data").max_count;

/// For example "0x1f40".
std::string hex(std::uint64_t address) { return fmt::format("{:#x}", address); }

/// Checks that the bytes are inside the EEPROM, if its size is known.
Result<void> check_place(const BoardIdentity& board, std::uint64_t address, std::size_t size) {
  constexpr std::uint64_t addressable = std::uint64_t{1} << 32U;
  const auto& details = board.details;
  const std::uint64_t reported = details ? roles::eeprom_size(*details).raw() : 0;
  const std::uint64_t limit = reported != 0 ? reported : addressable;
  if (size <= limit && address <= limit - size) return {};
  return ClientError{ErrorCode::invalid,
                     fmt::format("{} bytes at {} exceed the EEPROM, which has {} bytes", size,
                                 hex(address), limit)};
}

/// Reads whole pages.
Task<Result<Bytes>> read_pages(detail::PageRun run, const detail::Deadline& deadline) {
  msg::EepromReadRequest request;
  request.addr = static_cast<std::uint32_t>(run.address);
  request.size = msg::ByteCount(static_cast<msg::ByteCount::raw_type>(run.size));
  const Result<msg::EepromRead> answer = co_await call(request, detail::options_within(deadline));
  if (!answer)
    co_return detail::during("reading the EEPROM at " + hex(run.address), answer.error());
  if (answer->addr != request.addr || answer->data.size() != run.size) {
    co_return ClientError{
        ErrorCode::mismatch,
        fmt::format("requested {} bytes of the EEPROM at {}, but received {} bytes at {}", run.size,
                    hex(run.address), answer->data.size(), hex(answer->addr))};
  }
  co_return Bytes(answer->data.begin(), answer->data.end());
}

/// The same, but bytes that an undetected error of the line has changed are not accepted.
Task<Result<Bytes>> read_pages_verified(detail::PageRun run, const detail::Deadline& deadline) {
  const auto read = [&] { return read_pages(run, deadline); };
  co_return co_await detail::read_until_two_agree<Bytes>(
      read, "reading the EEPROM at " + hex(run.address));
}

}  // namespace

Task<Result<Bytes>> download_eeprom(std::uint32_t address, std::size_t size,
                                    TransferOptions options) {
  if (auto fits = check_place((co_await this_task()).identity(), address, size); !fits)
    co_return fits.error();
  const std::string task = fmt::format("reading {} bytes of the EEPROM", size);
  const detail::Deadline deadline(co_await this_task(), options.timeout);
  Bytes pages;
  std::size_t skipped = address % eeprom_page;
  const auto done = [&] { return std::min(size, pages.size() - std::min(pages.size(), skipped)); };
  for (const auto& run : detail::page_runs(address, size, eeprom_page, eeprom_most_read)) {
    auto going = detail::go_on(task, options.progress, {done(), size, task}, deadline);
    if (!going) co_return going.error();
    const Result<Bytes> block = co_await read_pages_verified(run, deadline);
    if (!block) co_return block.error();
    pages.insert(pages.end(), block->begin(), block->end());
  }
  auto end = detail::go_on(task, options.progress, {size, size, task}, deadline);
  if (!end) co_return end.error();
  skipped = std::min(skipped, pages.size());
  pages.erase(pages.begin(), pages.begin() + static_cast<std::ptrdiff_t>(skipped));
  pages.resize(size);
  co_return pages;
}

Task<Result<void>> upload_eeprom(std::uint32_t address, Bytes data, TransferOptions options) {
  if (auto fits = check_place((co_await this_task()).identity(), address, data.size()); !fits)
    co_return fits;
  const std::string task = fmt::format("writing {} bytes to the EEPROM", data.size());
  const detail::Deadline deadline(co_await this_task(), options.timeout);
  const std::uint64_t end = std::uint64_t{address} + data.size();
  std::uint64_t written = address;
  const auto fail = [&](ClientError error) {
    const std::string place = written == address
                                  ? std::string("nothing was verifiably written")
                                  : fmt::format("the data are written up to {}", hex(written));
    error.message = fmt::format("{}; {}", error.message, place);
    return error;
  };
  const std::size_t most = std::min(eeprom_most_read, eeprom_most_written);
  for (const auto& run : detail::page_runs(address, data.size(), eeprom_page, most)) {
    auto going =
        detail::go_on(task, options.progress,
                      {static_cast<std::size_t>(written - address), data.size(), task}, deadline);
    if (!going) co_return fail(going.error());
    const std::uint64_t first = std::max<std::uint64_t>(run.address, address);
    const std::uint64_t last = std::min(run.address + run.size, end);
    Bytes block(run.size);
    if (last - first != run.size) {  // other bytes of these pages must be kept
      Result<Bytes> present = co_await read_pages_verified(run, deadline);
      if (!present) co_return fail(present.error());
      block = *std::move(present);
    }
    const auto part = std::span(data).subspan(static_cast<std::size_t>(first - address),
                                              static_cast<std::size_t>(last - first));
    std::copy(part.begin(), part.end(),
              block.begin() + static_cast<std::ptrdiff_t>(first - run.address));
    msg::EepromWrite request;
    request.addr = static_cast<std::uint32_t>(run.address);
    static_cast<void>(request.data.resize(block.size()));  // page_runs() limits the size
    std::copy(block.begin(), block.end(), request.data.begin());
    const Result<void> sent = co_await call(request, detail::options_within(deadline));
    if (!sent) co_return fail(detail::during("writing at " + hex(run.address), sent.error()));
    if (options.verify) {
      const Result<Bytes> present = co_await read_pages(run, deadline);
      if (!present) co_return fail(present.error());
      if (const auto at = detail::difference(block, *present)) {
        co_return fail({ErrorCode::mismatch, fmt::format("wrote {}, but read back {:#04x} at {}",
                                                         fmt::format("{:#04x}", block[*at]),
                                                         (*present)[*at], hex(run.address + *at))});
      }
    }
    written = last;
  }
  auto ended = detail::go_on(task, options.progress, {data.size(), data.size(), task}, deadline);
  co_return ended ? Result<void>() : fail(ended.error());
}

}  // namespace sbgc::tasks
