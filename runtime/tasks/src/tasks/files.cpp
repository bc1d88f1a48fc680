// File tasks.

#include <algorithm>
#include <limits>
#include <optional>
#include <span>
#include <string>

#include <fmt/format.h>

#include <sbgc/client/memory.hpp>
#include <sbgc/internal/meta_limits.hpp>
#include <sbgc/meta/storage.hpp>

#include "tasks/bytes.hpp"
#include "tasks/pages.hpp"
#include "tasks/tools.hpp"

namespace sbgc::tasks {
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

}  // namespace sbgc::tasks
