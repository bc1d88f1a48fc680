#include <algorithm>
#include <optional>
#include <string>

#include <fmt/format.h>

#include <sbgc/client/client.hpp>
#include <sbgc/client/memory.hpp>
#include <sbgc/client/parameters.hpp>
#include <sbgc/detail/meta_limits.hpp>
#include <sbgc/meta/storage.hpp>

#include "pages.hpp"
#include "task.hpp"

namespace sbgc {
namespace {

using ByteVector = std::vector<std::uint8_t>;

constexpr std::size_t eeprom_page = detail::field_info<msg::EepromWrite>("addr").align;
constexpr std::size_t eeprom_most_read = detail::highest<msg::EepromReadRequest>("size");
constexpr std::size_t eeprom_most_written = detail::field_info<msg::EepromWrite>("data").max_count;
constexpr std::size_t file_page = static_cast<std::size_t>(msg::Pages(1).bytes());
constexpr std::size_t file_most_read = detail::highest<msg::ReadFileRequest>("max_data_size");
constexpr std::size_t file_most_written = detail::field_info<msg::WriteFile>("data").max_count;
constexpr std::size_t file_largest = std::numeric_limits<msg::ByteCount::raw_type>::max();

/// "0x1F40".
std::string hex(std::uint64_t address) { return fmt::format("{:#x}", address); }

/// Whether the bytes lie inside of the EEPROM, as far as its size is known.
Result<void> check_place(const Client& client, std::uint64_t address, std::size_t size) {
  constexpr std::uint64_t addressable = std::uint64_t{1} << 32U;
  const auto& details = client.board().details;
  const std::uint64_t told = details ? roles::eeprom_size(*details).raw() : 0;
  const std::uint64_t limit = told != 0 ? told : addressable;
  if (size <= limit && address <= limit - size) return {};
  return ClientError{ErrorCode::invalid,
                     fmt::format("{} bytes at {} lie outside of the EEPROM, which has {} bytes",
                                 size, hex(address), limit)};
}

/// Reads whole pages.
Result<ByteVector> read_pages(Client& client, const detail::PageRun& run,
                              const Deadline& deadline) {
  msg::EepromReadRequest request;
  request.addr = static_cast<std::uint32_t>(run.address);
  request.size = msg::ByteCount(static_cast<msg::ByteCount::raw_type>(run.size));
  const Result<msg::EepromRead> answer = client.call(request, detail::options_within(deadline));
  if (!answer) return detail::during("reading the EEPROM at " + hex(run.address), answer.error());
  if (answer->addr != request.addr || answer->data.size() != run.size) {
    return ClientError{
        ErrorCode::mismatch,
        fmt::format("{} bytes of the EEPROM at {} were asked for, {} bytes at {} came back",
                    run.size, hex(run.address), answer->data.size(), hex(answer->addr))};
  }
  return ByteVector(answer->data.begin(), answer->data.end());
}

/// The first byte from which on two blocks differ; nothing if they are equal.
std::optional<std::size_t> difference(std::span<const std::uint8_t> a,
                                      std::span<const std::uint8_t> b) {
  const auto [at, other] = std::ranges::mismatch(a, b);
  if (at == a.end() && other == b.end()) return std::nullopt;
  return static_cast<std::size_t>(at - a.begin());
}

/// A file error of the board as a sentence.
ClientError file_error(std::uint16_t file, ClientError error) {
  if (error.code == ErrorCode::board_error) {
    for (const ValueInfo& known : EnumMeta<msg::FileError>::info.values) {
      // The same number may be an error of another kind; its name tells.
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

/// Part of a file, from a page on.
Result<msg::ReadFile> read_part(Client& client, std::uint16_t file, std::size_t offset,
                                std::size_t size, const CallOptions& options) {
  msg::ReadFileRequest request;
  request.file_id = file;
  request.page_offset = msg::Pages(static_cast<msg::Pages::raw_type>(offset / file_page));
  request.max_data_size = msg::ByteCount(static_cast<msg::ByteCount::raw_type>(size));
  Result<msg::ReadFile> answer = client.call(request, options);
  if (!answer) return file_error(file, answer.error());
  const std::size_t whole = answer->file_size.raw();
  const std::size_t expected = std::min(size, whole - std::min(whole, offset));
  if (answer->page_offset != request.page_offset || answer->data.size() != expected) {
    return ClientError{
        ErrorCode::mismatch,
        fmt::format("file {}: {} bytes at {} were expected, {} bytes at {} came", file, expected,
                    offset, answer->data.size(), answer->page_offset.bytes())};
  }
  return answer;
}

}  // namespace

Result<std::vector<std::uint8_t>> read_eeprom(Client& client, std::uint32_t address,
                                              std::size_t size, const TransferOptions& options) {
  if (auto fits = check_place(client, address, size); !fits) return fits.error();
  const std::string task = fmt::format("reading {} bytes of the EEPROM", size);
  const Deadline deadline(options.clock, options.timeout);
  ByteVector pages;
  std::size_t skipped = address % eeprom_page;
  const auto done = [&] { return std::min(size, pages.size() - std::min(pages.size(), skipped)); };
  for (const auto& run : detail::page_runs(address, size, eeprom_page, eeprom_most_read)) {
    auto going = detail::go_on(task, options.progress, {done(), size, task}, deadline);
    if (!going) return going.error();
    const Result<ByteVector> block = read_pages(client, run, deadline);
    if (!block) return block.error();
    pages.insert(pages.end(), block->begin(), block->end());
  }
  auto end = detail::go_on(task, options.progress, {size, size, task}, deadline);
  if (!end) return end.error();
  skipped = std::min(skipped, pages.size());
  pages.erase(pages.begin(), pages.begin() + static_cast<std::ptrdiff_t>(skipped));
  pages.resize(size);
  return pages;
}

Result<void> write_eeprom(Client& client, std::uint32_t address, std::span<const std::uint8_t> data,
                          const TransferOptions& options) {
  if (auto fits = check_place(client, address, data.size()); !fits) return fits;
  const std::string task = fmt::format("writing {} bytes to the EEPROM", data.size());
  const Deadline deadline(options.clock, options.timeout);
  const std::uint64_t end = std::uint64_t{address} + data.size();
  std::uint64_t written = address;
  const auto fail = [&](ClientError error) {
    const std::string place = written == address
                                  ? std::string("nothing has been written for certain")
                                  : fmt::format("the data stand there up to {}", hex(written));
    error.message = fmt::format("{}; {}", error.message, place);
    return error;
  };
  const std::size_t most = std::min(eeprom_most_read, eeprom_most_written);
  for (const auto& run : detail::page_runs(address, data.size(), eeprom_page, most)) {
    auto going =
        detail::go_on(task, options.progress,
                      {static_cast<std::size_t>(written - address), data.size(), task}, deadline);
    if (!going) return fail(going.error());
    const std::uint64_t first = std::max<std::uint64_t>(run.address, address);
    const std::uint64_t last = std::min(run.address + run.size, end);
    ByteVector block(run.size);
    if (last - first != run.size) {  // pages that belong to others in part
      Result<ByteVector> present = read_pages(client, run, deadline);
      if (!present) return fail(present.error());
      block = *std::move(present);
    }
    std::ranges::copy(data.subspan(first - address, last - first),
                      block.begin() + static_cast<std::ptrdiff_t>(first - run.address));
    msg::EepromWrite request;
    request.addr = static_cast<std::uint32_t>(run.address);
    static_cast<void>(request.data.resize(block.size()));  // page_runs() has kept to what fits
    std::ranges::copy(block, request.data.begin());
    const Result<void> sent = client.call(request, detail::options_within(deadline));
    if (!sent) return fail(detail::during("writing at " + hex(run.address), sent.error()));
    if (options.verify) {
      const Result<ByteVector> present = read_pages(client, run, deadline);
      if (!present) return fail(present.error());
      if (const auto at = difference(block, *present)) {
        return fail({ErrorCode::mismatch, fmt::format("{} was written, but the EEPROM has {:#04x} "
                                                      "at {}",
                                                      fmt::format("{:#04x}", block[*at]),
                                                      (*present)[*at], hex(run.address + *at))});
      }
    }
    written = last;
  }
  auto ended = detail::go_on(task, options.progress, {data.size(), data.size(), task}, deadline);
  return ended ? Result<void>() : fail(ended.error());
}

Result<std::size_t> file_size(Client& client, std::uint16_t file) {
  const Result<msg::ReadFile> part = read_part(client, file, 0, 1, {});
  if (!part) return part.error();
  return std::size_t{part->file_size.raw()};
}

Result<std::vector<std::uint8_t>> read_file(Client& client, std::uint16_t file,
                                            const TransferOptions& options) {
  const std::string task = fmt::format("reading file {}", file);
  const Deadline deadline(options.clock, options.timeout);
  const std::size_t step = file_most_read / file_page * file_page;
  ByteVector content;
  std::optional<std::size_t> size;
  while (!size || content.size() < *size) {
    // The size is known from the first part on; before, there is at least something to do.
    const Progress progress{content.size(), size.value_or(1), task};
    if (auto going = detail::go_on(task, options.progress, progress, deadline); !going) {
      return going.error();
    }
    const Result<msg::ReadFile> part =
        read_part(client, file, content.size(), step, detail::options_within(deadline));
    if (!part) return part.error();
    if (size && *size != part->file_size.raw()) {
      return ClientError{ErrorCode::mismatch,
                         fmt::format("file {} has changed its size while it was read", file)};
    }
    size = part->file_size.raw();
    content.insert(content.end(), part->data.begin(), part->data.end());
  }
  auto end = detail::go_on(task, options.progress, {*size, *size, task}, deadline);
  if (!end) return end.error();
  return content;
}

Result<void> write_file(Client& client, std::uint16_t file, std::span<const std::uint8_t> data,
                        const TransferOptions& options) {
  if (data.empty()) {
    return ClientError{ErrorCode::invalid, "a file can not be empty; it can be deleted"};
  }
  if (data.size() > file_largest) {
    return ClientError{ErrorCode::invalid, fmt::format("a file has at most {} bytes, not {}",
                                                       file_largest, data.size())};
  }
  const std::string task = fmt::format("writing file {}", file);
  const Deadline deadline(options.clock, options.timeout);
  for (const auto& run : detail::page_runs(0, data.size(), file_page, file_most_written)) {
    const Progress progress{static_cast<std::size_t>(run.address), data.size(), task};
    if (auto going = detail::go_on(task, options.progress, progress, deadline); !going) {
      return detail::during(fmt::format("after {} bytes", run.address), going.error());
    }
    const auto part = data.subspan(run.address, std::min(run.size, data.size() - run.address));
    msg::WriteFile request;
    request.file_id = file;
    request.file_size = msg::ByteCount(static_cast<msg::ByteCount::raw_type>(data.size()));
    request.page_offset = msg::Pages(static_cast<msg::Pages::raw_type>(run.address / file_page));
    static_cast<void>(request.data.resize(part.size()));  // page_runs() has kept to what fits
    std::ranges::copy(part, request.data.begin());
    const Result<void> sent = client.call(request, detail::options_within(deadline));
    if (!sent) {
      return detail::during(fmt::format("after {} bytes", run.address),
                            file_error(file, sent.error()));
    }
  }
  if (options.verify) {
    TransferOptions reading{.timeout = deadline.left(), .clock = options.clock};
    const Result<ByteVector> present = read_file(client, file, reading);
    if (!present) return detail::during("reading it back", present.error());
    if (const auto at = difference(data, *present)) {
      return ClientError{ErrorCode::mismatch,
                         fmt::format("file {} read back differs from what was written, from byte "
                                     "{} on",
                                     file, *at)};
    }
  }
  if (options.progress) options.progress({data.size(), data.size(), task});
  return {};
}

Result<void> delete_file(Client& client, std::uint16_t file) {
  msg::WriteFile request;
  request.file_id = file;
  const Result<void> done = client.call(request);
  return done ? done : file_error(file, done.error());
}

Result<void> delete_all_files(Client& client) { return client.call(msg::FsClearAll{}); }

Result<std::vector<std::uint8_t>> read_external_data(Client& client) {
  const Result<msg::ReadExternalData> answer = client.call(msg::ReadExternalDataRequest{});
  if (!answer) return answer.error();
  return ByteVector(answer->data.begin(), answer->data.end());
}

Result<void> write_external_data(Client& client, std::size_t offset,
                                 std::span<const std::uint8_t> data) {
  if (data.size() > external_data_size || offset > external_data_size - data.size()) {
    return ClientError{ErrorCode::invalid,
                       fmt::format("{} bytes at {} do not fit into the {} bytes of the user's data",
                                   data.size(), offset, external_data_size)};
  }
  Result<msg::ReadExternalData> present = client.call(msg::ReadExternalDataRequest{});
  if (!present) return present.error();
  std::ranges::copy(data, present->data.begin() + static_cast<std::ptrdiff_t>(offset));
  ParameterSet wanted;
  if (Result<void> put = wanted.set(*present); !put) return put;
  return write_parameters(client, wanted).outcome;
}

}  // namespace sbgc
