/// Captures: files of recorded traffic with times and directions.
///
/// A capture is a sequence of sessions, each a header followed by records. It is append-only: a
/// record is one write at the end of the file, and continuing an existing file adds a session. If
/// the writing program is killed, only the last record can be lost. A torn record is detected and
/// does not affect a later session. The concatenation of two captures is a capture.
///
/// All numbers are little-endian, all checksums CRC-32 (as in zip and PNG).
///
///     session header, 24 bytes (also in later versions)
///       0   8  89 53 42 47 43 0D 0A 1A  (which a transfer as text would damage)
///       8   2  version, 1
///       10  2  0
///       12  8  start time: microseconds since 1970-01-01 UTC
///       20  4  checksum of bytes 0 to 19
///
///     record, 16 + n bytes
///       0   1  A5
///       1   1  kind: 1 from the board, 2 to the board, 3 note; skip others
///       2   2  n
///       4   8  time: microseconds since the start of the session, by a monotonic clock
///       12  n  the bytes of one read or write; UTF-8 in a note
///       12+n 4 checksum of bytes 0 to 11+n
///
/// Times have 62 bits; a reader ignores the other two. Anything that is neither a header nor a
/// record is damage. The reader skips it up to the next intact record or session header; only up to
/// a header if the header of the session is damaged, too, which shows at the latest in a time
/// before that of the last record.
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

#include <sbgc/io/detail/range_crc32.hpp>
#include <sbgc/io/error.hpp>

namespace sbgc::io {

/// The kinds of records in a capture.
enum class CaptureKind : std::uint8_t { from_board = 1, to_board = 2, note = 3 };

/// Time since the start of the session.
using CaptureTime = std::chrono::microseconds;

/// The start of a session.
struct CaptureSession {
  std::chrono::sys_time<std::chrono::microseconds> start{};  ///< by the clock of the host
  std::uint64_t offset{};                                    ///< of the header in the file

  bool operator==(const CaptureSession&) const = default;
};

/// Bytes of one direction, or a note, with a timestamp.
struct CaptureRecord {
  CaptureKind kind{};                     ///< may have unnamed values
  CaptureTime time{};                     ///< since the start of the session
  std::span<const std::uint8_t> bytes{};  ///< valid until the next call
  std::uint64_t offset{};                 ///< of the record in the file
};

/// Bytes of the file that are neither a session header nor a record.
struct CaptureDamage {
  /// The reason why bytes of the file are not a record.
  enum class Reason : std::uint8_t {
    not_a_capture,  ///< the file does not begin as a capture; it is the only item
    newer_version,  ///< a session of a newer version than this program supports
    torn,           ///< the file ends within a record or header
    damaged,        ///< a checksum is wrong, or the bytes are something else
  };

  Reason reason{};
  std::uint64_t offset{};  ///< of the damage, from the beginning of the file
  std::uint64_t size{};    ///< of the damage, in bytes

  bool operator==(const CaptureDamage&) const = default;
};

/// Returns a sentence: "7 bytes from offset 24 are damaged."
std::string to_string(const CaptureDamage& damage);

/// The result of CaptureParser::next().
using CaptureItem = std::variant<CaptureSession, CaptureRecord, CaptureDamage>;

/// The number of bytes that distinguish a capture from other files.
inline constexpr std::size_t capture_magic_size = 8;

/// Returns true if a file that begins with these bytes is a capture. Needs at least
/// capture_magic_size bytes to return true.
bool is_capture(std::span<const std::uint8_t> begin) noexcept;
/// Returns true if these bytes are a proper prefix of a capture's magic, so that more are needed.
bool may_become_capture(std::span<const std::uint8_t> begin) noexcept;

/// An incremental parser of captures. Buffers at most one record and the bytes passed last, and
/// reads every byte a bounded number of times.
class CaptureParser {
 public:
  /// Adds the next bytes of the file.
  void feed(std::span<const std::uint8_t> bytes);
  /// Marks the end of the file.
  void finish() noexcept { finished_ = true; }
  /// Returns the next item; nullopt if more bytes are needed or at the end. Its bytes are valid
  /// until the next call of any member.
  std::optional<CaptureItem> next();

 private:
  std::optional<CaptureItem> session();
  std::optional<CaptureItem> record();
  std::optional<CaptureItem> incomplete();
  void begin_damage(CaptureDamage::Reason reason);
  std::optional<CaptureItem> find_item();
  /// Returns true if an item of this size is next, with the right checksum. Takes constant time,
  /// because damage may look like the beginning of an item at each byte.
  bool is_sound_next(std::size_t size) const noexcept;
  /// Returns true if a sound item after damage is a session header, or a record of the same
  /// session. Otherwise, the header of its session was damaged.
  bool continues(std::span<const std::uint8_t> item) noexcept;

  std::span<const std::uint8_t> rest() const noexcept {
    return std::span(buffer_).subspan(position_);
  }
  void advance(std::size_t size) noexcept {
    position_ += size;
    offset_ += size;
  }

  std::vector<std::uint8_t> buffer_;
  std::size_t position_ = 0;  // of the next byte in the buffer
  std::uint64_t offset_ = 0;  // of the next byte in the file
  bool finished_ = false;
  bool has_session_ = false;             // if true, records belong to a known session
  CaptureTime time_{};                   // of the last record
  std::optional<CaptureDamage> damage_;  // set while searching for the next item
  detail::RangeCrc32 checksums_;         // of the buffer's first bytes, at least while searching
};

/// The format that CaptureWriter writes.
enum class CaptureFormat : std::uint8_t {
  sbgc,    ///< see above
  pcapng,  ///< for Wireshark (see pcapng.hpp); a note is a comment of the next packet
};

/// Writes a capture.
class CaptureWriter {
 public:
  /// The clock of the timestamps.
  using Clock = std::chrono::steady_clock;

  CaptureWriter() = default;
  /// Once the descriptor `end` is readable, writing fails if the reader of a pipe has not read for
  /// a second; otherwise, it waits for the reader. The caller keeps ownership.
  explicit CaptureWriter(CaptureFormat format, int end = -1) : format_(format), end_(end) {}
  CaptureWriter(CaptureWriter&& other) noexcept;
  /// Closes its own file, and takes over the other one.
  CaptureWriter& operator=(CaptureWriter&& other) noexcept;
  CaptureWriter(const CaptureWriter&) = delete;
  CaptureWriter& operator=(const CaptureWriter&) = delete;
  ~CaptureWriter();

  /// Begins a session at time `now`, in a new file or at the end of a capture. Returns Errc::busy
  /// if another program is writing it, Errc::not_a_capture if the file has other content, or the
  /// error of the system.
  Error open(const std::string& path, Clock::time_point now = Clock::now());

  /// Begins a session on a descriptor that is open for writing, such as standard output; the caller
  /// keeps ownership. Error messages contain `name`. Without an `end`, a write that waits for a
  /// reader fails if a signal interrupts it.
  Error open(int descriptor, const std::string& name, Clock::time_point now = Clock::now());

  /// Adds the bytes read or written at `now`; more than 65535 bytes become several records. After
  /// the first failure, writes nothing and returns that error.
  const Error& write(CaptureKind kind, std::span<const std::uint8_t> bytes, Clock::time_point now);
  /// Adds a note for people, otherwise like write().
  const Error& write_note(std::string_view text, Clock::time_point now);

  /// Returns the first failure, if there was one.
  const Error& error() const noexcept { return error_; }

 private:
  void begin_session();
  bool is_own(std::span<const std::uint8_t> begin) const noexcept;
  bool may_become_own(std::span<const std::uint8_t> begin) const noexcept;
  void append_record(CaptureKind kind, std::span<const std::uint8_t> bytes, CaptureTime time);
  void append_packet(CaptureKind kind, std::span<const std::uint8_t> bytes, CaptureTime time);
  bool put(std::span<const std::uint8_t> bytes);
  bool wait_for_reader();
  Error fail(int reason);
  Error open_pipe();

  int fd_ = -1;
  bool may_wait_ = false;  // for a reader
  std::string path_;
  CaptureFormat format_ = CaptureFormat::sbgc;
  int end_ = -1;
  Clock::time_point start_{};
  std::chrono::sys_time<std::chrono::microseconds> wall_start_{};
  std::vector<std::string> comments_;  // of the next packet
  std::vector<std::uint8_t> buffer_;
  Error error_;
};

}  // namespace sbgc::io
