#include "look/monitor/recording.hpp"

#include <utility>

#include <fmt/chrono.h>
#include <fmt/format.h>

namespace sbgc::tools {

bool Recording::is_on() const {
  const std::lock_guard lock(mutex_);
  return file_ && !file_->error();
}

std::string Recording::begin_or_end(const std::string& line) {
  const std::lock_guard lock(mutex_);
  if (file_) {
    const io::Error problem = file_->error();
    file_.reset();
    return problem ? problem.message : "recorded in " + name_;
  }
  const auto now =
      std::chrono::time_point_cast<std::chrono::seconds>(std::chrono::system_clock::now());
  name_ = fmt::format("monitor-{:%Y%m%dT%H%M%S}Z.capture", now);
  io::CaptureWriter file;
  if (const io::Error problem = file.open(name_)) return problem.message;
  file.write_note(line, Clock::now());
  file_ = std::move(file);
  marks_ = 0;
  return "recording to " + name_;
}

std::string Recording::mark() {
  const std::lock_guard lock(mutex_);
  if (!file_) return "nothing is recorded: r begins";
  const std::string text = fmt::format("mark {}", ++marks_);
  const io::Error& problem = file_->write_note(text, Clock::now());
  return problem ? problem.message : text;
}

void Recording::on_read(std::span<const std::uint8_t> bytes) {
  add(io::CaptureKind::from_board, bytes);
}

void Recording::on_written(std::span<const std::uint8_t> bytes) {
  add(io::CaptureKind::to_board, bytes);
}

void Recording::on_line_set(const LineSettings& settings) {
  const std::lock_guard lock(mutex_);
  if (file_) file_->write_note("line: " + io::to_string(settings), Clock::now());
}

void Recording::add(io::CaptureKind kind, std::span<const std::uint8_t> bytes) {
  const std::lock_guard lock(mutex_);
  if (file_) file_->write(kind, bytes, Clock::now());
}

}  // namespace sbgc::tools
