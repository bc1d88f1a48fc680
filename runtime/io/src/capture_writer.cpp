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

#include <sbgc/internal/crc32.hpp>
#include <sbgc/io/capture.hpp>
#include <sbgc/io/pcapng.hpp>
#include <sbgc/wire.hpp>

#include "capture_format.hpp"

namespace sbgc::io {

namespace {

using capture_format::checksum_size;
using capture_format::header_size;
using capture_format::magic;
using capture_format::max_bytes;
using capture_format::record_head_size;
using capture_format::record_mark;
using capture_format::start_offset;
using capture_format::time_offset;
using capture_format::version;

void store64(std::uint8_t* bytes, std::uint64_t value) {
  wire::store(bytes, static_cast<std::uint32_t>(value));
  wire::store(bytes + 4, static_cast<std::uint32_t>(value >> 32));
}

void append_checksum(std::vector<std::uint8_t>& bytes) {
  const std::uint32_t sum = sbgc::detail::crc32(bytes);
  bytes.resize(bytes.size() + checksum_size);
  wire::store(bytes.data() + bytes.size() - checksum_size, sum);
}

}  // namespace

CaptureWriter::CaptureWriter(CaptureWriter&& other) noexcept { *this = std::move(other); }

CaptureWriter& CaptureWriter::operator=(CaptureWriter&& other) noexcept {
  std::swap(fd_, other.fd_);
  std::swap(may_wait_, other.may_wait_);
  std::swap(path_, other.path_);
  std::swap(format_, other.format_);
  std::swap(end_, other.end_);
  std::swap(start_, other.start_);
  std::swap(wall_start_, other.wall_start_);
  std::swap(comments_, other.comments_);
  std::swap(buffer_, other.buffer_);
  std::swap(error_, other.error_);
  return *this;
}

CaptureWriter::~CaptureWriter() {
  if (fd_ >= 0) ::close(fd_);
}

Error CaptureWriter::open(const std::string& path, Clock::time_point now) {
  *this = CaptureWriter(format_, end_);
  path_ = path;
  start_ = now;
  struct stat present {};
  if (::stat(path.c_str(), &present) == 0 && S_ISFIFO(present.st_mode)) return open_pipe();
  // Non-blocking, so that a pipe that has just been created does not block the program.
  fd_ = ::open(path.c_str(), O_RDWR | O_APPEND | O_CREAT | O_CLOEXEC | O_NONBLOCK, 0666);
  if (fd_ < 0) return fail(errno);
  if (flock(fd_, LOCK_EX | LOCK_NB) != 0) {
    return error_ = {Errc::busy, "Another program is writing to the capture " + path + "."};
  }
  struct stat status {};
  if (fstat(fd_, &status) != 0) return fail(errno);
  std::array<std::uint8_t, capture_magic_size> begin{};
  const ssize_t size = status.st_size == 0 ? 0 : pread(fd_, begin.data(), begin.size(), 0);
  const std::span<const std::uint8_t> found(begin.data(),
                                            static_cast<std::size_t>(std::max<ssize_t>(size, 0)));
  if (size < 0 || !(is_own(found) || may_become_own(found))) {
    const char* const kind = format_ == CaptureFormat::sbgc ? "a capture" : "a pcapng file";
    return error_ = {Errc::not_a_capture,
                     path + " exists and is not " + kind + "; it was not changed."};
  }
  // A full disk can leave a partial first header, after which the file would not be a capture.
  if (size > 0 && may_become_own(found) && ftruncate(fd_, 0) != 0) {
    return fail(errno);
  }
  begin_session();
  return error_;
}

/// Opens a named pipe for writing only: this program must not count as its reader.
Error CaptureWriter::open_pipe() {
  fd_ = ::open(path_.c_str(), O_WRONLY | O_CLOEXEC | O_NONBLOCK);
  if (fd_ < 0 && errno == ENXIO) {
    return error_ = {std::error_code(ENXIO, std::generic_category()),
                     "No program reads the named pipe " + path_ + "."};
  }
  if (fd_ < 0) return fail(errno);
  may_wait_ = true;
  begin_session();
  return error_;
}

Error CaptureWriter::open(int descriptor, const std::string& name, Clock::time_point now) {
  *this = CaptureWriter(format_, end_);
  path_ = name;
  start_ = now;
  may_wait_ = true;
  fd_ = ::fcntl(descriptor, F_DUPFD_CLOEXEC, 0);
  if (fd_ < 0) return fail(errno);
  begin_session();
  return error_;
}

void CaptureWriter::begin_session() {
  wall_start_ = std::chrono::floor<std::chrono::microseconds>(std::chrono::system_clock::now());
  if (format_ == CaptureFormat::pcapng) {
    buffer_.clear();
    pcapng::append_section(buffer_);
    pcapng::append_packet(buffer_, wall_start_, CaptureKind::note, {});
  } else {
    buffer_.assign(magic.begin(), magic.end());
    buffer_.resize(header_size - checksum_size);
    wire::store(buffer_.data() + 8, version);
    store64(buffer_.data() + start_offset,
            static_cast<std::uint64_t>(wall_start_.time_since_epoch().count()));
    append_checksum(buffer_);
  }
  put(buffer_);
}

bool CaptureWriter::is_own(std::span<const std::uint8_t> begin) const noexcept {
  if (format_ == CaptureFormat::sbgc) return is_capture(begin);
  return begin.size() >= pcapng::magic.size() &&
         std::ranges::equal(pcapng::magic, begin.first(pcapng::magic.size()));
}

bool CaptureWriter::may_become_own(std::span<const std::uint8_t> begin) const noexcept {
  return format_ == CaptureFormat::sbgc ? may_become_capture(begin) : begin.empty();
}

const Error& CaptureWriter::write(CaptureKind kind, std::span<const std::uint8_t> bytes,
                                  Clock::time_point now) {
  const auto time = std::chrono::floor<CaptureTime>(std::max(now, start_) - start_);
  do {
    const auto part = bytes.first(std::min(bytes.size(), max_bytes));
    bytes = bytes.subspan(part.size());
    buffer_.clear();
    if (format_ == CaptureFormat::pcapng) {
      append_packet(kind, part, time);
    } else {
      append_record(kind, part, time);
    }
  } while (put(buffer_) && !bytes.empty());
  return error_;
}

void CaptureWriter::append_record(CaptureKind kind, std::span<const std::uint8_t> bytes,
                                  CaptureTime time) {
  buffer_.resize(record_head_size);
  buffer_[0] = record_mark;
  buffer_[1] = static_cast<std::uint8_t>(kind);
  wire::store(buffer_.data() + 2, static_cast<std::uint16_t>(bytes.size()));
  store64(buffer_.data() + time_offset, static_cast<std::uint64_t>(time.count()));
  buffer_.insert(buffer_.end(), bytes.begin(), bytes.end());
  append_checksum(buffer_);
}

void CaptureWriter::append_packet(CaptureKind kind, std::span<const std::uint8_t> bytes,
                                  CaptureTime time) {
  if (kind == CaptureKind::note) {
    comments_.emplace_back(bytes.begin(), bytes.end());
    return;
  }
  pcapng::append_packet(buffer_, wall_start_ + time, kind, bytes, comments_);
  comments_.clear();
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
    // A write that fits into the pipe does not block, so only wait_for_reader() waits.
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
  std::array<pollfd, 2> waiting{{{fd_, POLLOUT, {}}, {end_, POLLIN, {}}}};
  constexpr int forever = -1, patience = 1000;  // in ms
  int ready = 0;
  do {
    ready = ::poll(waiting.data(), waiting.size(), forever);
  } while (ready < 0 && errno == EINTR && end_ >= 0);
  if (ready > 0 && waiting[0].revents == 0) ready = ::poll(waiting.data(), 1, patience);
  // write() reports errors of the other side.
  if (ready > 0) return true;
  if (ready < 0) {
    fail(errno);
  } else {
    error_ = {std::make_error_code(std::errc::timed_out),
              "The capture " + path_ + " is incomplete: its reader has stopped reading."};
  }
  return false;
}

Error CaptureWriter::fail(int reason) {
  const std::error_code code(reason, std::generic_category());
  return error_ = {code, "The capture " + path_ + " cannot be written: " + code.message() + "."};
}

}  // namespace sbgc::io
