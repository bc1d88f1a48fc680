/// Captures in tests: temporary files, and their contents as readable lines.
#pragma once

#include <csignal>
#include <variant>

#include <sys/resource.h>
#include <unistd.h>

#include <sbgc/io/capture.hpp>

#include "../client/temporary_folder.hpp"
#include "support.hpp"

namespace sbgc::io::test {

/// An arbitrary start time: only differences matter.
inline constexpr CaptureWriter::Clock::time_point begin{std::chrono::hours(1000)};

/// The name of a file that does not exist yet. The destructor removes the file.
class TemporaryFile {
 public:
  std::string name() const { return (folder_.path() / "capture").string(); }

  Bytes content() const {
    std::ifstream file(name(), std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }

  void write(const Bytes& bytes) const {
    std::ofstream(name(), std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()),
               static_cast<std::streamsize>(bytes.size()));
  }

 private:
  sbgc::test::TemporaryFolder folder_;
};

/// Limits the size of files written by this process, to simulate a full disk.
class FileSizeLimit {
 public:
  explicit FileSizeLimit(std::size_t size) : old_handler_(std::signal(SIGXFSZ, SIG_IGN)) {
    getrlimit(RLIMIT_FSIZE, &old_);
    const rlimit limit{size, old_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  FileSizeLimit(const FileSizeLimit&) = delete;
  FileSizeLimit& operator=(const FileSizeLimit&) = delete;
  ~FileSizeLimit() {
    setrlimit(RLIMIT_FSIZE, &old_);
    std::signal(SIGXFSZ, old_handler_);
  }

 private:
  rlimit old_{};
  void (*old_handler_)(int);
};

/// An item with a copy of a record's bytes.
struct Parsed {
  CaptureItem item;
  Bytes bytes;
};

/// Returns the items of a file fed in chunks of `piece` bytes.
inline std::vector<Parsed> parse(const Bytes& file, std::size_t piece = 1 << 20) {
  std::vector<Parsed> result;
  CaptureParser parser;
  const auto take = [&] {
    while (const auto item = parser.next()) {
      const auto* const record = std::get_if<CaptureRecord>(&*item);
      result.push_back(
          {*item, record == nullptr ? Bytes() : Bytes(record->bytes.begin(), record->bytes.end())});
    }
  };
  for (std::span<const std::uint8_t> rest = file; !rest.empty();) {
    // On the heap and of exactly this size, so that a sanitizer detects a read out of bounds.
    const auto next = rest.first(std::min(piece, rest.size()));
    parser.feed(Bytes(next.begin(), next.end()));
    rest = rest.subspan(next.size());
    take();
  }
  parser.finish();
  take();
  return result;
}

inline std::string text_of(const Bytes& bytes) { return {bytes.begin(), bytes.end()}; }

using Log = std::vector<std::string>;

/// Returns one line per item: "session", "KIND @MICROSECONDS: BYTES", "REASON: SIZE from OFFSET".
inline Log log_of(const Bytes& file, std::size_t piece = 1 << 20) {
  Log result;
  for (const Parsed& parsed : parse(file, piece)) {
    if (const auto* const record = std::get_if<CaptureRecord>(&parsed.item)) {
      result.push_back(std::to_string(static_cast<int>(record->kind)) + " @" +
                       std::to_string(record->time.count()) + ": " + text_of(parsed.bytes));
    } else if (const auto* const damage = std::get_if<CaptureDamage>(&parsed.item)) {
      const char* const names[] = {"not a capture", "newer version", "torn", "damaged"};
      result.push_back(std::string(names[static_cast<int>(damage->reason)]) + ": " +
                       std::to_string(damage->size) + " from " + std::to_string(damage->offset));
    } else {
      result.emplace_back("session");
    }
  }
  return result;
}

}  // namespace sbgc::io::test
