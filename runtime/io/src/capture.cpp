#include <algorithm>
#include <array>
#include <cerrno>
#include <climits>
#include <utility>

#include <fcntl.h>
#include <poll.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <sbgc/detail/crc32.hpp>
#include <sbgc/io/capture.hpp>
#include <sbgc/wire.hpp>

namespace sbgc::io {

namespace {

using Reason = CaptureDamage::Reason;

constexpr std::array<std::uint8_t, capture_magic_size> magic{0x89, 'S',  'B',  'G',
                                                             'C',  0x0D, 0x0A, 0x1A};
constexpr std::uint16_t version = 1;
constexpr std::size_t header_size = 24;
constexpr std::uint8_t record_mark = 0xA5;
constexpr std::size_t record_head_size = 12;
constexpr std::size_t checksum_size = 4;
constexpr std::size_t max_bytes = 65535;

std::uint64_t load64(const std::uint8_t* bytes) {
  return wire::load<std::uint32_t>(bytes) | std::uint64_t{wire::load<std::uint32_t>(bytes + 4)}
                                                << 32;
}

void store64(std::uint8_t* bytes, std::uint64_t value) {
  wire::store(bytes, static_cast<std::uint32_t>(value));
  wire::store(bytes + 4, static_cast<std::uint32_t>(value >> 32));
}

/// Loads a time. The sign bit is cleared, so that damaged times are not negative.
std::chrono::microseconds load_time(const std::uint8_t* bytes) {
  return std::chrono::microseconds(static_cast<std::int64_t>(load64(bytes) & ~(1ULL << 63)));
}

/// Returns true if the checksum at the end of these bytes is correct.
bool is_sound(std::span<const std::uint8_t> bytes) {
  const std::size_t size = bytes.size() - checksum_size;
  return sbgc::detail::crc32(bytes.first(size)) == wire::load<std::uint32_t>(bytes.data() + size);
}

void append_checksum(std::vector<std::uint8_t>& bytes) {
  const std::uint32_t sum = sbgc::detail::crc32(bytes);
  bytes.resize(bytes.size() + checksum_size);
  wire::store(bytes.data() + bytes.size() - checksum_size, sum);
}

/// Returns the position of the magic in `bytes`, or of a prefix of it at their end; their size if
/// there is neither. If `or_record`, returns the first mark of a record before it, too.
std::size_t find_start(std::span<const std::uint8_t> bytes, bool or_record) {
  for (std::size_t at = 0; at < bytes.size(); ++at) {
    if (or_record && bytes[at] == record_mark) return at;
    const std::size_t size = std::min(magic.size(), bytes.size() - at);
    if (std::equal(magic.begin(), magic.begin() + static_cast<std::ptrdiff_t>(size),
                   bytes.begin() + static_cast<std::ptrdiff_t>(at))) {
      return at;
    }
  }
  return bytes.size();
}

/// Returns the size of the session header or record that begins with these bytes; nullopt if there
/// are too few of them.
std::optional<std::size_t> size_of_item(std::span<const std::uint8_t> begin) {
  if (begin.empty()) return std::nullopt;
  if (begin[0] != record_mark) return header_size;
  if (begin.size() < record_head_size) return std::nullopt;
  return record_head_size + wire::load<std::uint16_t>(begin.data() + 2) + checksum_size;
}

}  // namespace

std::string to_string(const CaptureDamage& damage) {
  const std::string place = std::to_string(damage.size) + (damage.size == 1 ? " byte" : " bytes") +
                            " from offset " + std::to_string(damage.offset);
  switch (damage.reason) {
    case Reason::not_a_capture: return "This is not a capture.";
    case Reason::newer_version:
      return place + " have a newer capture version than this program supports.";
    case Reason::torn: return "The last " + place + " on were not completely written.";
    case Reason::damaged: return place + " are damaged.";
  }
  return place + " cannot be read.";
}

bool is_capture(std::span<const std::uint8_t> begin) noexcept {
  return begin.size() >= magic.size() && std::equal(magic.begin(), magic.end(), begin.begin());
}

bool may_become_capture(std::span<const std::uint8_t> begin) noexcept {
  return begin.size() < magic.size() && std::equal(begin.begin(), begin.end(), magic.begin());
}

void CaptureParser::feed(std::span<const std::uint8_t> bytes) {
  buffer_.erase(buffer_.begin(), buffer_.begin() + static_cast<std::ptrdiff_t>(position_));
  position_ = 0;
  buffer_.insert(buffer_.end(), bytes.begin(), bytes.end());
}

std::optional<CaptureItem> CaptureParser::next() {
  for (;;) {
    if (damage_) {
      if (auto item = find_item()) return item;
      return std::nullopt;
    }
    if (rest().empty()) return std::nullopt;
    const bool is_header = offset_ == 0 || rest()[0] == magic[0];
    const auto item = is_header ? session() : record();
    if (item || !damage_) return item;
  }
}

std::optional<CaptureItem> CaptureParser::session() {
  const auto bytes = rest();
  const std::size_t known = std::min(bytes.size(), magic.size());
  if (!std::equal(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(known),
                  magic.begin())) {
    begin_damage(offset_ == 0 ? Reason::not_a_capture : Reason::damaged);
    return std::nullopt;
  }
  if (bytes.size() < header_size) return incomplete();
  const auto header = bytes.first(header_size);
  has_session_ = false;
  if (!is_sound(header)) {
    begin_damage(Reason::damaged);
    return std::nullopt;
  }
  if (wire::load<std::uint16_t>(header.data() + 8) != version) {
    begin_damage(Reason::newer_version);
    return std::nullopt;
  }
  const CaptureSession result{
      std::chrono::sys_time<std::chrono::microseconds>(load_time(header.data() + 12)), offset_};
  advance(header_size);
  has_session_ = true;
  time_ = {};
  return result;
}

std::optional<CaptureItem> CaptureParser::record() {
  const auto bytes = rest();
  if (bytes[0] != record_mark) {
    begin_damage(Reason::damaged);
    return std::nullopt;
  }
  const auto size = size_of_item(bytes);
  if (!size || bytes.size() < *size) return incomplete();
  if (!is_sound(bytes.first(*size))) {
    begin_damage(Reason::damaged);
    return std::nullopt;
  }
  const std::size_t content = *size - record_head_size - checksum_size;
  const CaptureRecord result{static_cast<CaptureKind>(bytes[1]), load_time(bytes.data() + 4),
                             bytes.subspan(record_head_size, content), offset_};
  time_ = result.time;
  advance(*size);
  return result;
}

std::optional<CaptureItem> CaptureParser::incomplete() {
  if (finished_) begin_damage(Reason::torn);
  return std::nullopt;
}

void CaptureParser::begin_damage(CaptureDamage::Reason reason) {
  damage_ = CaptureDamage{reason, offset_, 0};
  // A file that does not begin as a capture has no sessions.
  advance(reason == Reason::not_a_capture ? rest().size() : 1);
}

std::optional<CaptureItem> CaptureParser::find_item() {
  const bool hopeless = damage_->reason == Reason::not_a_capture;
  for (;;) {
    advance(hopeless ? rest().size() : find_start(rest(), has_session_));
    const auto bytes = rest();
    const auto size = size_of_item(bytes);
    if (size && bytes.size() >= *size) {
      if (is_sound(bytes.first(*size)) && continues(bytes)) break;
    } else if (!finished_) {
      return std::nullopt;
    }
    if (bytes.empty()) break;
    advance(1);
  }
  // An incomplete item before others is damaged, not torn.
  if (damage_->reason == Reason::torn && !rest().empty()) damage_->reason = Reason::damaged;
  damage_->size = offset_ - damage_->offset;
  return *std::exchange(damage_, std::nullopt);
}

bool CaptureParser::continues(std::span<const std::uint8_t> item) noexcept {
  if (item[0] != record_mark) return true;
  // Threads may write their records slightly out of order.
  constexpr CaptureTime tolerance = std::chrono::seconds(1);
  has_session_ = load_time(item.data() + 4) + tolerance >= time_;
  return has_session_;
}

CaptureWriter::CaptureWriter(CaptureWriter&& other) noexcept { *this = std::move(other); }

CaptureWriter& CaptureWriter::operator=(CaptureWriter&& other) noexcept {
  std::swap(fd_, other.fd_);
  std::swap(may_wait_, other.may_wait_);
  std::swap(path_, other.path_);
  std::swap(start_, other.start_);
  std::swap(buffer_, other.buffer_);
  std::swap(error_, other.error_);
  return *this;
}

CaptureWriter::~CaptureWriter() {
  if (fd_ >= 0) ::close(fd_);
}

Error CaptureWriter::open(const std::string& path, Clock::time_point now) {
  *this = CaptureWriter();
  path_ = path;
  start_ = now;
  // Non-blocking, so that a pipe without a reader does not block the program.
  fd_ = ::open(path.c_str(), O_RDWR | O_APPEND | O_CREAT | O_CLOEXEC | O_NONBLOCK, 0666);
  if (fd_ < 0) return fail(errno);
  if (flock(fd_, LOCK_EX | LOCK_NB) != 0) {
    return error_ = {Errc::busy, "Another program is writing to the capture " + path + "."};
  }
  struct stat status {};
  if (fstat(fd_, &status) != 0) return fail(errno);
  std::array<std::uint8_t, capture_magic_size> begin{};
  if (status.st_size != 0 &&
      (pread(fd_, begin.data(), begin.size(), 0) < 0 || !is_capture(begin))) {
    return error_ = {Errc::not_a_capture,
                     path + " exists and is not a capture; it was not changed."};
  }
  begin_session();
  return error_;
}

Error CaptureWriter::open(int descriptor, const std::string& name, Clock::time_point now) {
  *this = CaptureWriter();
  path_ = name;
  start_ = now;
  may_wait_ = true;
  fd_ = ::fcntl(descriptor, F_DUPFD_CLOEXEC, 0);
  if (fd_ < 0) return fail(errno);
  begin_session();
  return error_;
}

void CaptureWriter::begin_session() {
  buffer_.assign(magic.begin(), magic.end());
  buffer_.resize(header_size - checksum_size);
  wire::store(buffer_.data() + 8, version);
  const auto wall = std::chrono::floor<std::chrono::microseconds>(std::chrono::system_clock::now());
  store64(buffer_.data() + 12, static_cast<std::uint64_t>(wall.time_since_epoch().count()));
  append_checksum(buffer_);
  put(buffer_);
}

const Error& CaptureWriter::write(CaptureKind kind, std::span<const std::uint8_t> bytes,
                                  Clock::time_point now) {
  const auto time = std::chrono::floor<CaptureTime>(std::max(now, start_) - start_);
  do {
    const auto part = bytes.first(std::min(bytes.size(), max_bytes));
    bytes = bytes.subspan(part.size());
    buffer_.resize(record_head_size);
    buffer_[0] = record_mark;
    buffer_[1] = static_cast<std::uint8_t>(kind);
    wire::store(buffer_.data() + 2, static_cast<std::uint16_t>(part.size()));
    store64(buffer_.data() + 4, static_cast<std::uint64_t>(time.count()));
    buffer_.insert(buffer_.end(), part.begin(), part.end());
    append_checksum(buffer_);
  } while (put(buffer_) && !bytes.empty());
  return error_;
}

const Error& CaptureWriter::write_note(std::string_view text, Clock::time_point now) {
  const std::vector<std::uint8_t> bytes(text.begin(), text.end());
  return write(CaptureKind::note, bytes, now);
}

bool CaptureWriter::put(std::span<const std::uint8_t> bytes) {
  if (!error_ && fd_ < 0) fail(EBADF);
  if (error_) return false;
  while (!bytes.empty()) {
    if (may_wait_ && !wait_for_reader()) return false;
    // A write that a pipe has room for does not block, so only wait_for_reader() waits.
    const std::size_t most = may_wait_ ? PIPE_BUF : bytes.size();
    const ssize_t size = ::write(fd_, bytes.data(), std::min(bytes.size(), most));
    if (size < 0 && errno == EINTR) continue;
    if (size < 0) {
      fail(errno);
      return false;
    }
    // After a short write, writing the rest reports the reason.
    bytes = bytes.subspan(static_cast<std::size_t>(size));
  }
  return true;
}

bool CaptureWriter::wait_for_reader() {
  pollfd waiting{fd_, POLLOUT, 0};
  constexpr int forever = -1;
  if (::poll(&waiting, 1, forever) >= 0) return true;  // write() reports errors of the other side
  fail(errno);
  return false;
}

Error CaptureWriter::fail(int reason) {
  const std::error_code code(reason, std::generic_category());
  return error_ = {code, "The capture " + path_ + " cannot be written: " + code.message() + "."};
}

}  // namespace sbgc::io
