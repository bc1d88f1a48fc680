// Tasks for the memory of the board: the EEPROM, in whole pages; files; user data.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>

#include <fmt/format.h>

#include <sbgc/client/memory.hpp>
#include <sbgc/client/parameters.hpp>
#include <sbgc/internal/meta_limits.hpp>
#include <sbgc/meta/storage.hpp>

#include "tasks/agreement.hpp"
#include "tasks/pages.hpp"
#include "tasks/tools.hpp"

namespace sbgc::detail {
namespace {

/// Returns the index of the first different byte; nothing if the blocks are equal.
std::optional<std::size_t> difference(std::span<const std::uint8_t> a,
                                      std::span<const std::uint8_t> b) {
  const auto [at, other] = std::mismatch(a.begin(), a.end(), b.begin(), b.end());
  if (at == a.end() && other == b.end()) return std::nullopt;
  return static_cast<std::size_t>(at - a.begin());
}

}  // namespace
}  // namespace sbgc::detail

namespace sbgc::tasks {
namespace {

constexpr std::size_t eeprom_page = detail::field_info<msg::EepromWrite>("addr").align;
constexpr std::size_t eeprom_most_read = detail::highest<msg::EepromReadRequest>("size");
constexpr std::size_t eeprom_most_written = detail::field_info<msg::EepromWrite>("data").max_count;

/// Returns, for example, "0x1f40".
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

/// The same, but bytes changed by an undetected line error are not accepted.
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

namespace {

constexpr std::size_t file_page = static_cast<std::size_t>(msg::Pages(1).bytes());
constexpr std::size_t file_most_read = detail::highest<msg::ReadFileRequest>("max_data_size");
constexpr std::size_t file_most_written = detail::field_info<msg::WriteFile>("data").max_count;
constexpr std::size_t file_largest = std::numeric_limits<msg::ByteCount::raw_type>::max();

/// Converts a file error of the board to a sentence.
ClientError file_error(std::uint16_t file, ClientError error) {
  if (error.code == ErrorCode::board_error) {
    for (const ValueInfo& known : EnumMeta<msg::FileError>::info.values) {
      // Other error types use the same numbers, so check the name as well.
      const bool is_it = error.message.find(known.name) != std::string::npos;
      if (known.value != error.detail || !is_it) continue;
      const bool missing =
          static_cast<msg::FileError>(error.detail) == msg::FileError::file_not_found;
      return {missing ? ErrorCode::not_found : error.code,
              fmt::format("file {}: {} ({})", file, known.summary, known.name), error.detail};
    }
  }
  return detail::during(fmt::format("file {}", file), std::move(error));
}

/// Reads part of a file, starting at a page.
Task<Result<msg::ReadFile>> read_part(std::uint16_t file, std::size_t offset, std::size_t size,
                                      CallOptions options) {
  msg::ReadFileRequest request;
  request.file_id = file;
  request.page_offset = msg::Pages(static_cast<msg::Pages::raw_type>(offset / file_page));
  request.max_data_size = msg::ByteCount(static_cast<msg::ByteCount::raw_type>(size));
  Result<msg::ReadFile> answer = co_await call(request, options);
  if (!answer) co_return file_error(file, answer.error());
  const std::size_t whole = answer->file_size.raw();
  const std::size_t expected = std::min(size, whole - std::min(whole, offset));
  if (answer->page_offset != request.page_offset || answer->data.size() != expected) {
    co_return ClientError{
        ErrorCode::mismatch,
        fmt::format("file {}: expected {} bytes at {}, but received {} bytes at {}", file, expected,
                    offset, answer->data.size(), answer->page_offset.bytes())};
  }
  co_return answer;
}

}  // namespace

Task<Result<std::size_t>> file_size(std::uint16_t file) {
  const Result<msg::ReadFile> part = co_await read_part(file, 0, 1, {});
  if (!part) co_return part.error();
  co_return std::size_t{part->file_size.raw()};
}

Task<Result<Bytes>> download_file(std::uint16_t file, TransferOptions options) {
  const std::string task = fmt::format("reading file {}", file);
  const detail::Deadline deadline(co_await this_task(), options.timeout);
  const std::size_t step = file_most_read / file_page * file_page;
  Bytes content;
  std::optional<std::size_t> size;
  while (!size || content.size() < *size) {
    // The first part reports the size. Until then, 1 means unfinished work.
    const Progress progress{content.size(), size.value_or(1), task};
    if (auto going = detail::go_on(task, options.progress, progress, deadline); !going) {
      co_return going.error();
    }
    const Result<msg::ReadFile> part =
        co_await read_part(file, content.size(), step, detail::options_within(deadline));
    if (!part) co_return part.error();
    if (size && *size != part->file_size.raw()) {
      co_return ClientError{ErrorCode::mismatch,
                            fmt::format("the size of file {} changed during the transfer", file)};
    }
    size = part->file_size.raw();
    content.insert(content.end(), part->data.begin(), part->data.end());
  }
  auto end = detail::go_on(task, options.progress, {*size, *size, task}, deadline);
  if (!end) co_return end.error();
  co_return content;
}

Task<Result<void>> upload_file(std::uint16_t file, Bytes data, TransferOptions options) {
  if (data.empty()) {
    co_return ClientError{ErrorCode::invalid, "a file cannot be empty; delete it instead"};
  }
  if (data.size() > file_largest) {
    co_return ClientError{ErrorCode::invalid, fmt::format("a file has at most {} bytes, not {}",
                                                          file_largest, data.size())};
  }
  const std::string task = fmt::format("writing file {}", file);
  const detail::Deadline deadline(co_await this_task(), options.timeout);
  const auto cut = [&](ClientError error, std::uint64_t confirmed) {
    error.message += fmt::format(
        "; file {} of the board is incomplete, with {} of {} bytes confirmed: write it again, or "
        "delete it",
        file, confirmed, data.size());
    return error;
  };
  for (const auto& run : detail::page_runs(0, data.size(), file_page, file_most_written)) {
    const Progress progress{static_cast<std::size_t>(run.address), data.size(), task};
    if (auto going = detail::go_on(task, options.progress, progress, deadline); !going) {
      if (run.address == 0) co_return detail::during("nothing was written", going.error());
      co_return cut(going.error(), run.address);
    }
    const auto at = static_cast<std::size_t>(run.address);
    const auto part = std::span(data).subspan(at, std::min(run.size, data.size() - at));
    msg::WriteFile request;
    request.file_id = file;
    request.file_size = msg::ByteCount(static_cast<msg::ByteCount::raw_type>(data.size()));
    request.page_offset = msg::Pages(static_cast<msg::Pages::raw_type>(run.address / file_page));
    static_cast<void>(request.data.resize(part.size()));  // page_runs() limits the size
    std::copy(part.begin(), part.end(), request.data.begin());
    const Result<void> sent = co_await call(request, detail::options_within(deadline));
    if (!sent) co_return cut(file_error(file, sent.error()), run.address);
  }
  if (options.verify) {
    const TransferOptions reading{.timeout = deadline.left()};
    const Result<Bytes> present = co_await download_file(file, reading);
    if (!present) co_return detail::during("reading it back", present.error());
    if (const auto at = detail::difference(data, *present)) {
      co_return ClientError{
          ErrorCode::mismatch,
          fmt::format("file {} differs from the written data, from byte {}: write it again, or "
                      "delete it",
                      file, *at)};
    }
  }
  if (options.progress) options.progress({data.size(), data.size(), task});
  co_return Result<void>();
}

Task<Result<void>> delete_file(std::uint16_t file) {
  msg::WriteFile request;
  request.file_id = file;
  const Result<void> done = co_await call(request);
  co_return done ? done : file_error(file, done.error());
}

Task<Result<void>> delete_all_files() { co_return co_await call(msg::FsClearAll{}); }

namespace {

Task<Result<msg::ReadExternalData>> read_user_data() {
  co_return co_await detail::call_verified(msg::ReadExternalDataRequest{}, "reading the user data");
}

}  // namespace

Task<Result<Bytes>> download_user_data() {
  const Result<msg::ReadExternalData> answer = co_await read_user_data();
  if (!answer) co_return answer.error();
  co_return Bytes(answer->data.begin(), answer->data.end());
}

Task<Result<void>> upload_user_data(std::size_t offset, Bytes data) {
  if (data.size() > user_data_size || offset > user_data_size - data.size()) {
    co_return ClientError{ErrorCode::invalid,
                          fmt::format("{} bytes at {} do not fit into the {} bytes of user data",
                                      data.size(), offset, user_data_size)};
  }
  Result<msg::ReadExternalData> present = co_await read_user_data();
  if (!present) co_return present.error();
  std::copy(data.begin(), data.end(), present->data.begin() + static_cast<std::ptrdiff_t>(offset));
  ParameterSet wanted;
  if (const Result<void> put = wanted.set(*present); !put) co_return put;
  const WriteReport report = co_await write_parameters(std::move(wanted));
  co_return report.outcome;
}

}  // namespace sbgc::tasks
