/// Captures: files that keep what was said on a line, by whom and when.
///
/// A capture is a sequence of sessions, each a header and then records. It only ever grows: a
/// record is one write at the end of the file, and who goes on with an existing file adds a
/// session. So a program that is killed leaves everything but possibly the last record; a torn
/// record is noticed, and does no harm to a session behind it. Two captures put together are a
/// capture.
///
/// All numbers are little-endian, all checksums CRC-32 (that of zip and PNG).
///
///     session header, 24 bytes (in later versions, too)
///       0   8  89 53 42 47 43 0D 0A 1A  (which a transfer as text would damage)
///       8   2  version, 1
///       10  2  0
///       12  8  when it began: microseconds since 1970-01-01 UTC
///       20  4  checksum of bytes 0 to 19
///
///     record, 16 + n bytes
///       0   1  A5
///       1   1  kind: 1 from the board, 2 to the board, 3 note; others are to be skipped
///       2   2  n
///       4   8  when: microseconds since the session began, by a clock that never jumps
///       12  n  the bytes as they were read or written in one go; of a note: UTF-8
///       12+n 4 checksum of bytes 0 to 11+n
///
/// What is not in a session is damaged, and skipped up to the next session header.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include <sbgc/io/error.hpp>

namespace sbgc::io {

enum class CaptureKind : std::uint8_t { from_board = 1, to_board = 2, note = 3 };

/// Time since the session began.
using CaptureTime = std::chrono::microseconds;

/// A session begins.
struct CaptureSession {
  std::chrono::sys_time<std::chrono::microseconds> start{};
  std::uint64_t offset{};  ///< of the header in the file

  bool operator==(const CaptureSession&) const = default;
};

struct CaptureRecord {
  CaptureKind kind{};  ///< may have other values than the named ones
  CaptureTime time{};
  std::span<const std::uint8_t> bytes{};
  std::uint64_t offset{};  ///< of the record in the file
};

/// Bytes of the file that are neither.
struct CaptureDamage {
  enum class Reason : std::uint8_t {
    not_a_capture,  ///< the file does not begin as a capture; nothing else follows
    newer_version,  ///< a session of a version that this program does not know
    torn,           ///< the file ends within a record or header
    damaged,        ///< a checksum is wrong, or there is something else
  };

  Reason reason{};
  std::uint64_t offset{};
  std::uint64_t size{};

  bool operator==(const CaptureDamage&) const = default;
};

/// "The last 7 bytes are a record that was not completely written."
std::string to_string(const CaptureDamage& damage);

using CaptureItem = std::variant<CaptureSession, CaptureRecord, CaptureDamage>;

inline constexpr std::size_t capture_magic_size = 8;

/// Whether a file that begins with these bytes, at least capture_magic_size, is a capture.
bool is_capture(std::span<const std::uint8_t> begin) noexcept;
/// Whether these bytes are too few to tell.
bool may_become_capture(std::span<const std::uint8_t> begin) noexcept;

/// Reads a capture that arrives in pieces. Keeps no more than one record and what was fed last;
/// every byte is looked at a bounded number of times.
class CaptureParser {
 public:
  /// Takes the next bytes of the file.
  void feed(std::span<const std::uint8_t> bytes);
  /// Says that there are no more.
  void finish() noexcept { finished_ = true; }
  /// The next item; nothing if more bytes are needed, or at the end. Its bytes are valid until the
  /// next call of anything.
  std::optional<CaptureItem> next();

 private:
  std::optional<CaptureItem> session();
  std::optional<CaptureItem> record();
  std::optional<CaptureItem> incomplete();
  void begin_damage(CaptureDamage::Reason reason);
  std::optional<CaptureItem> find_session();

  std::span<const std::uint8_t> rest() const noexcept {
    return std::span(buffer_).subspan(position_);
  }
  void advance(std::size_t size) noexcept {
    position_ += size;
    offset_ += size;
  }

  std::vector<std::uint8_t> buffer_;
  std::size_t position_ = 0;  // of what is next, in the buffer
  std::uint64_t offset_ = 0;  // and in the file
  bool finished_ = false;
  std::optional<CaptureDamage> damage_;  // while a session is looked for
};

/// Writes a capture.
class CaptureWriter {
 public:
  using Clock = std::chrono::steady_clock;

  CaptureWriter() = default;
  CaptureWriter(CaptureWriter&& other) noexcept;
  CaptureWriter& operator=(CaptureWriter&& other) noexcept;
  CaptureWriter(const CaptureWriter&) = delete;
  CaptureWriter& operator=(const CaptureWriter&) = delete;
  ~CaptureWriter();

  /// Begins a session at the time `now`, in a new file or at the end of a capture. Errc::busy if
  /// another program writes it, Errc::not_a_capture for a file with anything else in it, or the
  /// error of the system.
  Error open(const std::string& path, Clock::time_point now = Clock::now());

  /// Begins a session on a descriptor that is open for writing, such as the standard output; the
  /// caller keeps it. `name` is what errors call it. A write that waits for a reader fails when a
  /// signal interrupts it.
  Error open(int descriptor, const std::string& name, Clock::time_point now = Clock::now());

  /// Adds what was read or written at `now`; what is longer than 65535 bytes becomes several
  /// records. After the first failure nothing is written any more, and its error is returned.
  const Error& write(CaptureKind kind, std::span<const std::uint8_t> bytes, Clock::time_point now);
  const Error& write_note(std::string_view text, Clock::time_point now);

  /// The first failure, if there was one.
  const Error& error() const noexcept { return error_; }

 private:
  void begin_session();
  bool put(std::span<const std::uint8_t> bytes);
  bool wait_for_reader();
  Error fail(int reason);

  int fd_ = -1;
  bool may_wait_ = false;  // for a reader
  std::string path_;
  Clock::time_point start_{};
  std::vector<std::uint8_t> buffer_;
  Error error_;
};

}  // namespace sbgc::io
